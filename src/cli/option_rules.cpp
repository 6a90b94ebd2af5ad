#include "cli/option_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/text.h"
#include "cli/frame_store.h"
#include "scene/medium_bands.h"

namespace nullscope::cli {
namespace {

using OptionNames = std::vector<std::string_view>;

// An option, or what else is asked for, that rules name; and whether it is.
struct OptionAsked {
    std::string_view name;
    bool (*is)(const CaptureOptions& options, const Scene& scene);
};
constexpr OptionAsked kAsked[] = {
    {"--half", [](const CaptureOptions& o, const Scene&) { return o.half; }},
    {"--raydata", [](const CaptureOptions& o, const Scene&) { return o.raydata; }},
    {"--derivatives", [](const CaptureOptions& o, const Scene&) { return !o.derivatives.empty(); }},
    {"--layers", [](const CaptureOptions& o, const Scene&) { return o.layers; }},
    {"--st-map", [](const CaptureOptions& o, const Scene&) { return !o.st_map.empty(); }},
    {"--split,--beside", [](const CaptureOptions& o, const Scene&) { return !o.split.empty(); }},
    {"--renderer", [](const CaptureOptions& o, const Scene&) { return o.renderer == "reference"; }},
    {"--method", [](const CaptureOptions& o, const Scene&) { return o.method != "auto"; }},
    {"--max-error", [](const CaptureOptions& o, const Scene&) { return o.max_error.has_value(); }},
    {"--context", [](const CaptureOptions& o, const Scene&) { return o.context.kind != "auto"; }},
    {"--device", [](const CaptureOptions& o, const Scene&) { return o.context.device.has_value(); }},
    {"--tiles", [](const CaptureOptions& o, const Scene&) { return o.tiles != "auto"; }},
    {"--stage", [](const CaptureOptions& o, const Scene&) { return o.stage != "fragment"; }},
    {"--largest-texture", [](const CaptureOptions& o, const Scene&) { return o.largest_texture.has_value(); }},
    {"--samples", [](const CaptureOptions& o, const Scene&) { return o.samples.has_value(); }},
    {"--quality", [](const CaptureOptions& o, const Scene&) { return o.quality.has_value(); }},
    {"--bits", [](const CaptureOptions& o, const Scene&) { return !o.bits.empty(); }},
    {"8 bits of TIFF",
     [](const CaptureOptions& o, const Scene&) {
         return o.bits == "8" && o.format() != nullptr && o.format()->sample == Sample::kWord;
     }},
    {"16 bits of a film", [](const CaptureOptions& o, const Scene&) { return o.bits == "16" && o.to_film(); }},
    {"10 bits of a picture", [](const CaptureOptions& o, const Scene&) { return o.bits == "10" && !o.to_film(); }},
    {"--colour", [](const CaptureOptions& o, const Scene&) { return o.colour != CaptureOptions{}.colour; }},
    {"--colour display", [](const CaptureOptions& o, const Scene&) { return o.colour == "display"; }},
    {"--workers", [](const CaptureOptions& o, const Scene&) { return o.workers > 1; }},
    {"--resume", [](const CaptureOptions& o, const Scene&) { return o.resume; }},
    {"one picture", [](const CaptureOptions& o, const Scene&) { return o.to_one_picture(); }},
    {"[split]", [](const CaptureOptions&, const Scene& s) { return s.split.has_value(); }},
    {"frames of several frequencies",
     [](const CaptureOptions& o, const Scene& s) { return has_bands(s) && o.format() == &kFitsFormat; }},
    {"picture.shutter", [](const CaptureOptions&, const Scene& s) { return s.picture.shutter > 0.0; }},
};

struct OptionRule {
    std::string_view option;
    OptionNames others;  // each of which cannot stand beside it
    bool has_format;     // it is of files of a format (PictureFormat::options)
    const char* what;    // {0}: the other one that was given; {1}: the method
    const char* allowed = "";
};

// The first that is broken is said.
const std::vector<OptionRule>& option_rules() {
    static const std::vector<OptionRule> rules = {
        {"--raydata",
         {"--split,--beside", "[split]"},
         false,
         "--raydata works for one spacetime only; leave out --split, or [split] of the scene"},
        {"--layers",
         {"[split]"},
         false,
         "--layers and --st-map work for one spacetime only; leave out [split] of the scene"},
        {"--st-map",
         {"[split]"},
         false,
         "--layers and --st-map work for one spacetime only; leave out [split] of the scene"},
        {"picture.shutter",
         {"--raydata", "--layers", "--st-map"},
         false,
         "--raydata, --layers and --st-map are for one instant, but picture.shutter averages several",
         "scenes without it"},
        {"frames of several frequencies",
         {"--resume", "--workers"},
         false,
         "{0}: a FITS of several frequencies is a file for each",
         "-o NAME%05d.exr, or one process that draws all frames"},
        {"--half", {"[split]"}, false, "--half works for one picture only; leave out [split] of the scene"},
        {"--workers",
         {"one picture"},
         false,
         "--workers: one picture is drawn by one process; give --frames A:B or a film"},
        {"--quality", {}, true, "--quality is for JPEG; give -o FILE.jpg"},
        {"8 bits of TIFF", {"--bits"}, false, "--bits 8: a .tif has 16 bits a colour", "16"},
        {"16 bits of a film", {"--bits"}, false, "--bits 16: a film has 8 or 10 bits a colour", "8, 10"},
        {"--bits", {}, true, "--bits is for PNG, TIFF and films; give -o FILE.png, -o FILE.tif or a film"},
        {"10 bits of a picture", {"--bits"}, false, "--bits 10 is for films", "8, 16"},
        {"--colour", {"--st-map"}, true, "--colour is for the colours of an .exr", "-o FILE.exr, without --st-map"},
        {"--colour display",
         {"--raydata", "--layers"},
         false,
         "--colour display: layers and ray data go with light as it arrives",
         "rec709, acescg"},
        {"--layers",
         {"--split,--beside", "--renderer"},
         true,
         "--layers requires an .exr drawn by the shader",
         "-o FILE.exr, without --split and --renderer reference"},
        {"--st-map",
         {"--split,--beside", "--raydata", "--layers"},
         true,
         "--st-map requires an .exr",
         "-o FILE.exr, without --split, --raydata and --layers"},
        {"--half",
         {"--raydata", "--layers", "--st-map", "--split,--beside", "--renderer"},
         true,
         "--half requires an EXR colour image drawn by the shader",
         "-o FILE.exr, without --raydata, --layers, --st-map, --split and --renderer reference"},
        {"--max-error", {"--method"}, false, "--max-error: no effect with --method {1}", "--method auto"},
        {"--resume",
         {"one picture"},
         false,
         "--resume: no effect on one picture",
         "with --frames A:B, or -o NAME%05d.png"},
        {"--samples", {"--st-map"}, false, "--samples: an ST map has one ray a pixel", "without --st-map"},
        {"--raydata", {}, true, "--raydata goes into an .exr; give -o FILE.exr"},
        {"--derivatives",
         {"--half", "--st-map", "--layers", "--split,--beside"},
         true,
         "--derivatives go with --raydata into an .exr",
         "-o FILE.exr, without --half, --st-map, --layers and --split"},
        {"--renderer",
         {"--method", "--max-error", "--context", "--device", "--tiles", "--stage", "--largest-texture"},
         false,
         "{0}: the reference tracer does not use the shader or OpenGL",
         "with --renderer gl"},
    };
    return rules;
}

}  // namespace

Status check_rules(const CaptureOptions& options, const Scene& scene) {
    const auto asked = [&](std::string_view name) {
        return std::ranges::find(kAsked, name, &OptionAsked::name)->is(options, scene);
    };
    for (const OptionRule& rule : option_rules()) {
        if (!asked(rule.option)) continue;
        const auto other = std::ranges::find_if(rule.others, asked);
        if (other == rule.others.end() && !(rule.has_format && !options.format_has(rule.option))) continue;
        const std::string_view name = other != rule.others.end() ? *other : rule.option;
        return bad_input(fmt::format(fmt::runtime(rule.what), name, options.method), rule.allowed);
    }
    return Done{};
}

OptionNames excluded_by(std::string_view option) {
    OptionNames names;
    for (const OptionRule& rule : option_rules()) {
        if (rule.option == option) names.insert(names.end(), rule.others.begin(), rule.others.end());
        if (std::ranges::find(rule.others, option) != rule.others.end()) names.push_back(rule.option);
    }
    return names;
}

OptionNames without_place(const CaptureOptions& options) {
    OptionNames names;
    for (const OptionRule& rule : option_rules())
        if (rule.has_format && !options.format_has(rule.option)) names.push_back(rule.option);
    return names;
}

}  // namespace nullscope::cli
