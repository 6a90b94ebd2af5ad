// How the shader finds where a ray goes: one choice a program, compiled in. All methods share ray set-up, verdict (escaped or
// captured, by the critical angle) and everything after the swept angle.
#pragma once
#include <compare>
#include <string>

#include "base/result.h"

namespace nullscope {

enum class MethodKind {
    kStrip,       // the deflection table's row for the camera's radius, as polynomials: the default
    kTable,       // the two-dimensional deflection table on the GPU
    kClosedForm,  // elliptic integrals, no table; Schwarzschild only
    kIntegrate,   // the orbit equation step by step
    kMino,        // a rotating hole's rays in Mino's time, as auto traces them there, by another step or order
    kKerrSchild,  // a rotating hole's rays in Cartesian Kerr-Schild coordinates step by step: a baseline, of skies alone
};
enum class Lookup { kHardware, kBilinear, kCubic, kHermite };  // of kTable

struct Method {
    MethodKind kind = MethodKind::kStrip;
    bool cubic = false;                // kStrip: two cubics instead of two lines
    int size = 128;                    // kTable: cells a side
    Lookup lookup = Lookup::kHermite;  // kTable
    int order = 6;                     // kIntegrate: 1, 4 or 6; kMino: 6 or, for skies alone, 4
    // kIntegrate: rad / sqrt(1 + 3 zeta); kMino: over the fastest rate; kKerrSchild: over the radius.
    double step = 0.6;
    int most_steps = 64;                                              // kIntegrate, kMino
    friend auto operator<=>(const Method&, const Method&) = default;  // NOLINT(modernize-use-nullptr): no pointer
};

// "strip", "strip:cubic", "table", "table:128:cubic", "closed-form", "integrate", "integrate:4:0.1", "euler:300" (300 steps over 5/2 pi rad), "mino", "mino:4:0.3",
// "kerr-schild:0.1". Errors: the allowed forms and ranges.
Result<Method> parse_method(const std::string& text);
std::string method_name(const Method& method);  // parse_method(method_name(m)) == m

// Of those for rotating holes: ray data of a sky alone know how many steps each ray took (RayPixel::steps).
inline bool counts_steps(const Method& method) {
    return method.kind == MethodKind::kMino || method.kind == MethodKind::kKerrSchild;
}

}  // namespace nullscope
