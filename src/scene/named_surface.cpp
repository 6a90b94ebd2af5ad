#include "scene/named_surface.h"

#include <fmt/format.h>

namespace nullscope {

std::string surface_shape(const SurfaceSpec& surface) {
    const NamedSurface& named = kNamedSurfaces[static_cast<std::size_t>(surface.kind)];
    if (named.kind == SurfaceKind::kFormula) return surface.shape;
    std::string text;
    for (const char c : named.formula) {
        if (c >= 'X' && c <= 'Z')
            text += fmt::format("({} / {:.17g})", static_cast<char>(c - 'X' + 'x'), surface.size);
        else
            text += c;
    }
    return text;
}

}  // namespace nullscope
