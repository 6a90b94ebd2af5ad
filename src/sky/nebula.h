// A sky that is no real one: an emission nebula by formula, with stars of its own. Gas is fractal noise with ridges, warped by itself; a few
// hot stars in it make oxygen shine near them and hydrogen farther off; dust absorbs, and reddens what is behind it.
#pragma once
#include <cstddef>
#include <vector>

#include "base/vec.h"
#include "scene/scene.h"
#include "sky/face_grid.h"
#include "sky/lattice_noise.h"
#include "sky/sky_rows.h"
#include "sky/star_catalogue.h"

namespace nullscope {

class Nebula {
public:
    // The same spec gives the same sky. For faces of this size, with a border. Cost: 10 ms; its stars 40 ms.
    Nebula(const NebulaSpec& spec, const Mat3& world_from_sky, double brightness, int size, int border);

    // Writes the rows. Any number of threads. Cost of all faces: 1.7 s on one core for faces of 512 and more.
    void paint(SkyRows& rows) const;

    // Its stars, of the sky's axes, brightest first; those behind dust are fainter and redder.
    std::vector<Star> stars() const;

    // The gas's linear RGB in a direction (unit; the sky's axes), before brightness.
    Vec3 light(Vec3 direction) const;

private:
    struct HotStar {
        Vec3 direction;
        double light, reach;  // of what it makes shine; rad
        double magnitude;
    };
    struct Matter {
        double gas, ridges, dust;  // dust: optical depth
        double wide;               // 0 to 1: how much of the nebula there is about that direction
    };
    Matter matter(Vec3 direction) const;

    NebulaSpec spec_;
    FaceGrid grid_;
    double brightness_;
    LatticeNoise noise_;
    Vec3 heart_{1.0, 0.0, 0.0};  // where most of it is: at azimuth and latitude 0 of the sky's axes
    std::vector<HotStar> hot_;
};

}  // namespace nullscope
