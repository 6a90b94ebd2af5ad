// Writes the shader core's text, C++: shaders/stage/ray_list.glsl with all that it includes, once for each combination
// of effects, each in a namespace (src/shadercore/core_precision.inl). A program of the build alone.
//
//     nullscope_coretexts SHADERS OUTPUT
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "shaderlib/preprocess.h"
#include "shaderlib/projection_text.h"

namespace {

using namespace nullscope;

struct Variant {
    std::string name;
    std::vector<std::string> defines;
    const char* path;  // folder of shaders/
};

// BLOCK_... of every #ifdef.
std::vector<std::string> block_names(const std::string& block) {
    constexpr std::string_view kIf = "\n#ifdef ";
    std::vector<std::string> names;
    for (std::size_t at = block.find(kIf); at != std::string::npos; at = block.find(kIf, at + 1))
        names.push_back(block.substr(at + kIf.size(), block.find('\n', at + 1) - at - kIf.size()));
    return names;
}

// The code of discs and of all projections is always compiled, and that of rays that pass the critical direction: where they end in a horizon
// they fetch nothing.
std::vector<Variant> variants(const std::string& block) {
    std::vector<std::string> always = {"__cplusplus", "EFFECT_DISC"};
    for (std::string& name : block_names(block)) always.push_back(std::move(name));  // FrameData has all members
    std::vector<Variant> all;
    for (const char* name : {"flat", "lensed", "cubic"}) {
        Variant plane{name, always, "planar"};
        for (const char* define : {"NEEDS_LIGHT_TIMES", "EFFECT_INNER", "EFFECT_INNER_HORIZON", "EFFECT_BOUNCE",
                                   "EFFECT_STAR", "NEEDS_PHI_END", "NEEDS_ZETA_SLOPE"})
            plane.defines.emplace_back(define);
        if (plane.name != "flat") plane.defines.emplace_back("EFFECT_LENSING");
        all.push_back(plane);
    }
    for (const bool ring : {false, true})  // next to it
        for (const bool falling : {false, true}) {
            Variant rotating{ring ? "rotating_ring" : "rotating", always, "mino"};
            rotating.defines.emplace_back("NEEDS_FINE_AZIMUTH");
            if (ring)
                rotating.defines.insert(rotating.defines.end(),
                                        {"EFFECT_SPIN_RING", "EFFECT_ZOOM"});  // no zoom: it adds 0
            if (falling) rotating.name += "_falling", rotating.defines.emplace_back("EFFECT_SPIN_FALL");
            all.push_back(rotating);
            rotating.name += "_delayed";
            rotating.defines.emplace_back("NEEDS_LIGHT_TIMES");
            all.push_back(rotating);
        }
    const auto moving = [](Variant variant) {
        variant.name += "_moving";
        variant.defines.emplace_back("EFFECT_ABERRATION");
        return variant;
    };
    for (std::size_t i = all.size(); i-- > 0;) {
        all.push_back(moving(all[i]));
        if (all[i].path != std::string_view("mino")) {
            if (all[i].name != "lensed") continue;
            all.push_back(all.back());
            all.back().name = "zoomed_moving";
            all.back().defines.emplace_back("EFFECT_ZOOM");
        } else if (all[i].name.ends_with("_delayed")) {  // next to the horizon: times and a speed of 0 add nothing
            all.push_back(all.back());
            all.back().name = all[i].name.substr(0, all[i].name.rfind('_')) + "_near";
            all.back().defines.emplace_back("EFFECT_SPIN_NEAR");
        }
    }
    return all;
}

// Macros know no namespace: #undef of every #define.
std::string undefs(const std::string& text) {
    constexpr std::string_view kDefine = "\n#define ";
    std::string lines;
    for (std::size_t at = text.find(kDefine); at != std::string::npos; at = text.find(kDefine, at + 1)) {
        const std::size_t name = at + kDefine.size();
        lines += "#undef " + text.substr(name, text.find_first_of(" (\n", name) - name) + "\n";
    }
    return lines;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    const std::filesystem::path shaders = argv[1];
    std::map<std::string, std::string, std::less<>> files;
    const char* path = "";
    const ShaderReader read = [&](std::string_view name) -> std::string_view {
        std::string& text = files[std::string(name)];
        if (name.starts_with(kPathPrefix)) return text = path_line(path, name);
        std::ifstream file(shaders / name);
        if (text.empty()) text.assign(std::istreambuf_iterator<char>(file), {});
        if (!text.empty()) return text;
        std::fprintf(stderr, "core texts: no shaders/%s\n", std::string(name).c_str());
        std::exit(1);
    };
    std::vector<Projection> wide;
    for (int i = 1; i < kProjections; ++i) wide.push_back(static_cast<Projection>(i));
    const ProjectionText projection = projection_text(wide);
    files["generated/projection"] = projection.files;
    files["generated/projection_view"] = projection.view;
    std::string all;
    for (const Variant& variant : variants(std::string(read("shared/frame_block.glsl")))) {
        path = variant.path;
        const std::string method = variant.name.starts_with("cubic") ? "strip_cubic" : "strip";
        files["generated/method"] = "#include \"method/" + method + ".glsl\"\n";
        const std::string text = resolved_text("stage/ray_list.glsl", variant.defines, read);
        all += "namespace " + variant.name + " {\n" + text + "#include \"shadercore/core_variant.inl\"\n}\n" +
               undefs(text);
    }
    std::ofstream output(argv[2], std::ios::binary);
    output << all;
    return output.flush() ? 0 : 1;
}
