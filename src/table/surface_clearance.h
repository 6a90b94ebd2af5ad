// How far places are from the solids that formulas give, so that rays pass over what is empty in one step instead of many: a grid of cells
// about each solid, made once for a formula, at all times.
#pragma once
#include <compare>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace nullscope {

inline constexpr int kClearanceCells =
    64;  // a side of the cube [-bound, bound]^3; CLEARANCE_CELLS of object/surface.glsl
inline constexpr int kClearanceWidth = 1024;  // of the texture; CLEARANCE_WIDTH there
// Solids of different formula or bound: 1 MB each; more are marched step by step.
inline constexpr int kMostClearances = 16;

struct SolidFormula {
    std::string formula;                                    // f(x, y, z, t), below 0 inside
    double bound;                                           // radius about the centre beyond which it is cut off, r_s
    auto operator<=>(const SolidFormula&) const = default;  // NOLINT(modernize-use-nullptr): no pointer
};

class SurfaceClearances {
public:
    // Whether a grid was added or dropped. Cost: none where the solids are the same as before, else 3 to 100 ms for a new one.
    bool update(const std::set<SolidFormula>& solids);

    // Where its cells begin, x fastest; -1: it has none.
    int first_cell(const SolidFormula& solid) const;
    // For each cell how many cells on the nearest lies, by the largest of its distances along x, y and z, that a part of the solid may be in:
    // 0 for such a cell itself. Rows of kClearanceWidth, the last one filled up with 0.
    const std::vector<float>& cells() const { return cells_; }
    int rows() const { return static_cast<int>(cells_.size()) / kClearanceWidth; }

private:
    std::map<SolidFormula, int> first_;
    std::vector<float> cells_;
};

}  // namespace nullscope
