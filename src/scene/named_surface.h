// Surfaces that a scene can name instead of giving a formula: each is one of docs/expressions.md, about the centre.
#pragma once
#include <array>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace nullscope {

struct NamedSurface {
    SurfaceKind kind;
    std::string_view key;
    std::string_view formula;  // of X, Y, Z: the place over surface.size; empty for kFormula
    std::string_view help;
};

// In the order of SurfaceKind.
inline constexpr std::array<NamedSurface, 8> kNamedSurfaces = {{
    {SurfaceKind::kFormula, "formula", "", "what surface.shape says"},
    {SurfaceKind::kTorus, "torus", "(length(X, Y) - 1)^2 + Z^2 - 0.09", "a ring of radius 1 and thickness 0.6"},
    {SurfaceKind::kEllipsoid, "ellipsoid", "length(X, Y / 0.8, Z / 0.5) - 1", "half axes 1, 0.8 and 0.5"},
    {SurfaceKind::kCube, "cube", "length(max(abs(X) - 0.5, 0), max(abs(Y) - 0.5, 0), max(abs(Z) - 0.5, 0)) - 0.08",
     "a cube of half width 0.58 with round edges"},
    {SurfaceKind::kOctahedron, "octahedron", "abs(X) + abs(Y) + abs(Z) - 1", "corners at distance 1"},
    {SurfaceKind::kHeart, "heart", "(X^2 + 2.25 * Y^2 + Z^2 - 1)^3 - X^2 * Z^3 - 0.1125 * Y^2 * Z^3",
     "Taubin's heart, 1.3 in height"},
    {SurfaceKind::kGyroid, "gyroid",
     "abs(sin(2 * pi * X) * cos(2 * pi * Y) + sin(2 * pi * Y) * cos(2 * pi * Z) + sin(2 * pi * Z) * cos(2 * pi * X)) - "
     "0.4",
     "Schoen's gyroid, a labyrinth of period 1, as far as surface.bound"},
    {SurfaceKind::kClebsch, "clebsch",
     "81 * (X^3 + Y^3 + Z^3) - 189 * (X^2 * (Y + Z) + Y^2 * (X + Z) + Z^2 * (X + Y)) + 54 * X * Y * Z"
     " + 126 * (X * Y + X * Z + Y * Z) - 9 * (X^2 + Y^2 + Z^2) - 9 * (X + Y + Z) + 1",
     "Clebsch's cubic, the one with 27 real lines, as far as surface.bound"},
}};

// f(x, y, z, t) of the surface as a formula's text.
std::string surface_shape(const SurfaceSpec& surface);

}  // namespace nullscope
