// The light of matter on lattices of the picture, 16, 8 and 4 px apart (shaders/stage/lattice.glsl): a ray is followed at a node of a finer one only
// where the coarser does not tell its light. They are drawn with the picture, from below, as far as its rows need them.
#pragma once
#include <array>
#include <cstddef>
#include <functional>

#include "gl/gl.h"
#include "shaderlib/passes.h"

namespace nullscope {

class LightLattice {
public:
    // For a picture of this size by these passes; frees what they do not need. Binds textures of its own to unit 0. own_steps: of the matter
    // (plan/medium_model.h), whose drafts have no longer samples.
    void resize(const std::vector<Pass>& passes, int width, int height, bool own_steps);

    // How far the light that they tell may be off where it is compared with a ray's: thousandths of it. Of drafts, whose lattices have rays through
    // their nodes alone, and of their finest: how far cubic and line may differ, or a cell's nodes next to the shadow's edge (4 px of beads on the
    // ring without that). Drafts' rays have samples twice as long.
    static constexpr int kError = 5, kDraftError = 50, kFinestDraftError = 600;
    void draft(bool wanted) { draft_ = wanted; }

    // Before the picture is drawn.
    void begin();

    // Programs of the stages kLattice, kLatticeTold and kLatticeCells. compute: kLattice by compute, of these rows of a target, by programs that `tell`
    // is called for; false where it cannot.
    using Tell = std::function<void(const gl::Program&)>;
    struct Programs {
        std::function<bool(const Tell& tell, const gl::Target& nodes, int first, int last)> compute;
        std::function<const gl::Program&()> traced;
        const gl::Program &told, &cells;
        const gl::VertexArray& empty;
    };
    // So that it tells the picture's rows before `last`; after bind(). Cost: a ray in some thirty pixels where the light is smooth, one in eight
    // where it is not.
    void extend(const Programs& programs, int last);

    // The finest, to units from first on, in the order of kSamplers; and to a program that reads it, after extend().
    static constexpr const char* kSamplers[] = {"lattice_texture", "cell_texture"};
    void bind(int first);
    void tell(const gl::Program& program) const;

private:
    static constexpr std::array kSides = {16, 8, 4};  // px between nodes
    struct Level {
        gl::Target nodes, cells;
        int texels = 2;   // a node: it, and a place in its cell
        int columns = 0;  // of nodes
        int spread = 1;   // from a tile of texels to the next, in tiles
        int rows = 0;     // of the picture, that are told
    };
    void extend(std::size_t number, const Programs& programs, int last);
    void bind(const Level& level);
    void size(std::size_t number);  // the level's targets, for texels

    bool draft_ = false, longer_ = false;
    int first_ = 0, width_ = 0, height_ = 0;
    std::array<Level, kSides.size()> levels_;
    Level none_;  // read while the coarsest is drawn
};

}  // namespace nullscope
