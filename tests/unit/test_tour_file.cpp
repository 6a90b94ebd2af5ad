// Tours: those that ship, what a file may say, and the line, the key and a part of the message of each that is broken.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

#include "base/assets.h"
#include "observer/landmarks.h"
#include "scenefile/scene_file.h"
#include "scenefile/tour_file.h"
#include "spacetime/registry.h"
#include "support/temporary_folder.h"

using namespace nullscope;

namespace {

constexpr const char* kHead = "title = \"A\"\ndescription = \"B.\"\n";  // two lines
constexpr const char* kTourFileStep = "[[step]]\nscene = \"kerr\"\ntext = \"C.\"\n";

Result<Tour> parse_tour_text(const std::string& text) { return parse_tour(text, "dir/tour.toml", "/nowhere"); }

struct TourFileBroken {
    std::string text;
    int line;
    std::string key;
    std::string part;  // of the message
};

std::string step(const std::string& lines) { return kHead + ("[[step]]\n" + lines) + "\n"; }  // its lines begin at 4
std::string good_step(const std::string& line) { return step("scene = \"kerr\"\ntext = \"C.\"\n" + line); }  // at 6

const TourFileBroken kTourFileBroken[] = {
    {"", 1, "title", "missing"},
    {"[[step]\n", 1, "", ""},
    {"title = \"\xFF\"\n", 1, "", ""},
    {std::string(kLargestSceneFile + 1, ' '), 0, "", "larger than"},
    {"a" + std::string(5000, '.') + "a = 1", 1, "", "dots"},
    {"title = 5\n", 1, "title", "must be a string"},
    {std::string("title = \"A\"\ndescription = \" \"\n") + kTourFileStep, 2, "description", "is empty"},
    {kHead, 1, "step", "missing; allowed: 1 to 100 sections [[step]]"},
    {std::string(kHead) + "step = []", 3, "step", "must be a list of sections"},
    {std::string(kHead) + "step = 5", 3, "step", "must be a list of sections"},
    {std::string(kHead) + "[step]", 3, "step", "must be a list of sections"},
    {std::string(kHead) + "step = [5]", 3, "step", "must be a list of sections"},
    {std::string(kHead) + "speed = 5\n" + kTourFileStep, 3, "speed", "unknown key; allowed: title, description, step"},
    {"titel = \"A\"\n", 1, "titel", "nearest known key: title"},
    {std::string(kHead) + "\"\\u001b[2J\" = 1\n" + kTourFileStep, 3, "?[2J", "unknown key"},
    {step("text = \"C.\""), 3, "step[1].scene", "missing"},
    {step("scene = \"kerr\""), 3, "step[1].text", "missing"},
    {step("scene = 5\ntext = \"C.\""), 4, "step[1].scene", "must be a string"},
    {step("scene = \"kerrr\"\ntext = \"C.\""), 4, "step[1].scene", "nearest: kerr"},
    {step("scene = \"no/such.toml\"\ntext = \"C.\""), 4, "step[1].scene", "no such file"},
    {step("scene = \"/\"\ntext = \"C.\""), 4, "step[1].scene", "a folder"},
    {step("scene = \"kerr\\u0000\"\ntext = \"C.\""), 4, "step[1].scene", "no such file"},
    {step("scene = \"kerr\"\ntext = \"" + std::string(kLongestTourText + 1, 'x') + '"'), 5, "step[1].text",
     "2001 bytes; allowed: text of 1 to 2000 bytes"},
    {step("scene = \"kerr\"\ntext = [\"C.\"]"), 5, "step[1].text", "must be a string"},
    {good_step("veiw = \"x\""), 6, "step[1].veiw", "nearest known key: view"},
    {good_step("view = 5"), 6, "step[1].view", "no view; allowed: camera = {"},
    {good_step("view = \"r = 5\""), 6, "step[1].view", "no view"},
    {good_step("view = 'camera = { r = -5 }'"), 6, "step[1].view", "camera.r: "},
    {good_step("view = 'camera = { foov = 5 }'"), 6, "step[1].view", "nearest known key: camera.fov"},
    {good_step("view = 'camera = {'"), 6, "step[1].view", ""},
    {good_step("view = \"camera = { r = 5 }\\nname = 'x'\\u0007\"\noff = 5"), 7, "step[1].off", "must be a list"},
    {good_step("off = [5]"), 6, "step[1].off", "not a string"},
    {good_step("off = [\"lensing\"]"), 6, "step[1].off", "allowed: spin"},
    {good_step("off = [\"no\\u001bword\"]"), 6, "step[1].off", "no?word"},
    {std::string(kHead) + kTourFileStep + "[[step]]\nscene = \"kerr\"\n", 6, "step[2].text", "missing"},
};

}  // namespace

TEST_CASE("tours: each broken one is one line that names file, line, key and what is allowed") {
    for (const TourFileBroken& broken : kTourFileBroken) {
        CAPTURE(broken.text.substr(0, 200));
        const auto tour = parse_tour_text(broken.text);
        REQUIRE_FALSE(tour);
        const Error& error = tour.error();
        CAPTURE(error.message());
        CHECK(error.kind == ErrorKind::kBadInput);
        CHECK(error.line == broken.line);
        CHECK(error.key == broken.key);
        CHECK(error.file == "dir/tour.toml");
        CHECK(error.message().find(broken.part) != std::string::npos);
        for (const char c : error.message()) CHECK(static_cast<unsigned char>(c) >= 0x20);
    }
    std::string many = kHead;
    for (std::size_t i = 0; i <= kMostTourSteps; ++i) many += kTourFileStep;
    const auto tour = parse_tour_text(many);
    REQUIRE_FALSE(tour);
    CHECK(tour.error().message().find("step: 101 steps") != std::string::npos);
}

TEST_CASE("tours: lines are joined, paragraphs and the view stay, and effects are switched off") {
    const auto tour =
        parse_tour_text(step("scene = \"first-light\"\nview = 'camera = { r = 30, fov = 50 }'\noff = [\"disc\"]\n"
                             "text = \"\"\"\nOne\nline.\n\n\nAnother,\\u0007 \n it ends.\n\"\"\""));
    REQUIRE_MESSAGE(tour, tour.error().message());
    const TourStep& first = tour->steps.front();
    CHECK(first.text == "One line.\nAnother,? it ends.");
    CHECK(first.scene == "first-light");
    REQUIRE(first.view);
    CHECK(first.view->r == 30.0);
    CHECK(first.view->theta == CameraSpec{}.theta);  // as a whole, not changes to the scene's
    CHECK(first.off == EffectSet{Effect::kDisc});
}

TEST_CASE("tours: a scene file is found from the tour's folder, and only tours are taken for tours") {
    const TemporaryFolder folder("tours");
    const auto write = [&](const std::string& name, const std::string& text) {
        std::ofstream(folder.path / name) << text;
        return folder.path / name;
    };
    const auto scene = write("mine.toml", "[camera]\nr = 9\n");
    const auto tour = write("tour.toml", step("scene = \"mine.toml\"\ntext = \"C.\""));
    const auto loaded = load_tour(tour);
    REQUIRE_MESSAGE(loaded, loaded.error().message());
    CHECK(loaded->steps.front().scene == scene.string());
    CHECK(is_tour_file(tour));
    CHECK(is_tour_file(write("without-steps.toml", kHead)));
    for (const auto& other : {scene, folder.path, folder.path / "none.toml", write("no.toml", "title = "),
                              assets_directory() / "scenes" / "kerr.toml"})
        CHECK_FALSE(is_tour_file(other));
    CHECK_FALSE(load_tour(folder.path / "none.toml"));
    CHECK_FALSE(load_tour(folder.path));
}

TEST_CASE(
    "tours that ship: each has its title, five to eight steps, and every scene, view and effect of them is there") {
    const auto tours = shipped_tours();
    CHECK(tours.size() >= 3);
    CHECK(std::ranges::is_sorted(tours, {}, &TourInfo::path));
    for (const TourInfo& info : tours) {
        const auto tour = load_tour(info.path);
        REQUIRE_MESSAGE(tour, tour.error().message());
        CHECK(is_tour_file(info.path));
        CHECK(tour->title == info.title);
        CHECK(tour->description.ends_with("."));
        CHECK(tour->steps.size() == info.steps);
        CHECK(tour->steps.size() >= 5);
        CHECK(tour->steps.size() <= 8);
        for (const TourStep& one : tour->steps) {
            CAPTURE(one.text);
            CHECK(one.text.find('\n') == std::string::npos);  // one paragraph
            CHECK((one.text.ends_with(".") || one.text.ends_with("?")));
            CHECK(load_scene(one.scene));
        }
    }
}

// The angles that the tour of the shadow says are those of the section Numbers.
TEST_CASE("tours that ship: the shadow's angular radius at rest is what the text says") {
    const auto tour = load_tour(assets_directory() / "tours" / "1-shadow.toml");
    REQUIRE(tour);
    const std::pair<std::size_t, const char*> said[] = {{1, "9.6"}, {2, "3.7"}, {3, "45"}, {5, "135"}};
    for (const auto& [number, degrees] : said) {
        const TourStep& one = tour->steps[number];
        const auto scene = load_scene(one.scene);
        REQUIRE(scene);
        const auto spacetime = make_spacetime(scene->spacetime.metric, scene->spacetime.parameters);
        const auto shadow = camera_numbers(**spacetime, one.view.value_or(scene->camera)).shadow;
        REQUIRE(shadow);
        const double there = *shadow * 180.0 / std::numbers::pi;
        CHECK(fmt::format("{:.{}f}", there, there < 10.0 ? 1 : 0) == degrees);
        CHECK(one.text.find(fmt::format("{} degrees", degrees)) != std::string::npos);
    }
}
