#include "shaderlib/pattern_text.h"

#include <fmt/format.h>

#include "expr/formula.h"
#include "shaderlib/preprocess.h"
#include "shaderlib/shader_source.h"

namespace nullscope {

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

std::string statements(const std::string& text, const std::vector<std::string>& variables, const char* otherwise) {
    const auto formula = expr::Formula::parse(text, variables);
    return formula ? formula->glsl("value") : otherwise;
}

std::string pattern_text(const std::string& name, const Material& material, const char* mapping, bool solid,
                         int image) {
    constexpr const char* kTextures[] = {"TEXTURE_PLAIN", "TEXTURE_CHECKER", "TEXTURE_GRID", "TEXTURE_STRIPES",
                                         "TEXTURE_NOISE", "TEXTURE_FORMULA", "TEXTURE_IMAGE"};
    std::vector<std::string> defines = {kTextures[static_cast<int>(material.texture)], mapping};
    if (material.texture >= TextureKind::kChecker && material.texture <= TextureKind::kStripes)
        defines.emplace_back("TEXTURE_PATTERN");
    if (solid) defines.emplace_back("MAPPING_OUTSIDE");
    std::string text = resolved_branches(shader_file("object/pattern.glsl"), defines);
    if (material.texture == TextureKind::kFormula)
        text = replaced(std::move(text), "BODY_STATEMENTS\n",
                        statements(material.formula, {"u", "v", "x", "y", "z"}, "    float value = 0.0;\n"));
    text = replaced(std::move(text), "IMAGE", fmt::format("body_image_{}", image));
    return replaced(std::move(text), "BODY", name);
}

std::string materials_of(const Scene& scene) {
    std::string text;
    if (scene.disc && scene.disc->material.texture < TextureKind::kImage)
        text += pattern_text("disc_material", scene.disc->material, "MAPPING_POLAR", false, 0);
    const Material sky = sky_material(scene.sky);
    if (is_procedural(scene.sky.kind)) text += pattern_text("sky", sky, "MAPPING_INSIDE", false, 0);
    return text;
}

}  // namespace nullscope
