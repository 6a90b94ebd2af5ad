// What people type: methods, sizes, ranges of frames, numbers.
#include <cmath>

#include "base/text.h"
#include "command/arguments.h"
#include "fuzz.h"
#include "shaderlib/method.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace nullscope;
    const std::string text(fuzz::text_of(data, size));
    if (const auto method = parse_method(text)) {
        fuzz::must(method->step > 0 && method->most_steps >= 0, "a method within its ranges");
        const auto again = parse_method(method_name(*method));
        fuzz::must(again && *again == *method, "a method's name names it");
    }
    if (const auto wanted = cli::parse_size(text))
        fuzz::must(wanted->width >= 1 && wanted->height >= 1 && wanted->width <= 65536 && wanted->height <= 65536,
                   "size");
    if (const auto frames = cli::parse_frames(text))
        fuzz::must(0 <= frames->first && frames->first < frames->end, "frames");
    if (const auto number = parse_number(text)) fuzz::must(std::isfinite(*number), "a number is finite");
    static_cast<void>(nearest_word(text, {"capture", "trace", "compare", ""}));
    return 0;
}
