// Tour files: whatever the text, a tour within its bounds or one line that says what is wrong.
#include "fuzz.h"
#include "scenefile/tour_file.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const auto tour = parse_tour(fuzz::text_of(data, size), "tour.toml", "/nowhere");
    if (!tour) {
        fuzz::must_be_a_good_error(tour.error());
        fuzz::must(tour.error().message().starts_with("tour.toml:"), "the file is named");
        return 0;
    }
    fuzz::must(!tour->title.empty() && !tour->description.empty(), "a tour says what it is");
    fuzz::must(!tour->steps.empty() && tour->steps.size() <= kMostTourSteps, "a tour has 1 to 100 steps");
    for (const TourStep& step : tour->steps) {
        fuzz::must(!step.scene.empty() && !step.text.empty(), "a step has a scene and a text");
        fuzz::must(step.text.size() <= kLongestTourText, "texts are not too long");
        for (const char c : step.text)
            fuzz::must(c == '\n' || static_cast<unsigned char>(c) >= 0x20, "texts have no control characters");
    }
    return 0;
}
