// Draws stars into the faces of a cube map.
//
// A star is a radiance on the sphere, not a pattern of texels: flux 10^(-0.4 V) times a point spread that depends on
// the angle to the star only. So it is as bright at a face's corner as in its middle, and crosses edges without a seam.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.h"
#include "sky/sky_rows.h"
#include "sky/star_catalogue.h"

namespace nullscope {

// Peak radiance of a star of V = 5 drawn with the core of a face of kReferenceFace texels. It scales stars and Milky Way together: at exposure 0
// as a long exposure shows them, the brightest clouds of the Milky Way (600 S10) at sRGB 0.38, stars of V = 6 saturated, V = 10 still seen.
constexpr double kPeakOfMagnitude5 = 3.0;
constexpr int kReferenceFace = 2048;

// Radius of the core in rad: 0.6 texels in the middle of a face, so that a star looks much the same wherever it lies
// between texel centres. Above kReferenceFace it stays what it is there (2 arc minutes, an eye's), so that the picture
// does not depend on the size of the face.
double core_sigma(int face_size);

// Flux of a star of that magnitude V: radiance times solid angle, sr.
double star_flux(double magnitude);

// The stars' radiance, each turned by world_from_sky and multiplied by brightness. The sum over texels, each with its solid angle, is a
// star's flux exactly; the result does not depend on the number of threads. Cost of the whole catalogue at face size 2048 on one core:
// 60 ms to find where each lies, and 100 ms to add them to all rows.
class StarPainter {
public:
    // For faces of this size, with a border. Parallel.
    StarPainter(const std::vector<Star>& stars, const Mat3& world_from_sky, double brightness, int size, int border);

    // Adds the light to the rows, in the catalogue's order.
    void add(SkyRows& rows) const;

    struct Light {
        Vec3 direction;           // world, unit
        double core = 0.0;        // radiance in the middle; its flux where it is not normalised yet
        double halo = 0.0;        // radiance of the halo in the middle
        double halo_reach = 0.0;  // rad; 0: none
        unsigned colour = 0;      // code
        // If not, all of its texels lie in one splat of one band, and are summed when they are drawn.
        bool normalised = true;
    };
    // A light's rectangle of texels in one face and its border, bounds inclusive.
    struct Splat {
        std::uint32_t light = 0;
        std::int16_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    };

private:
    struct Placed {
        std::size_t band;
        Splat splat;
    };
    void place(Light& light, std::uint32_t number, double magnitude, double brightness, std::vector<Placed>& out) const;
    void add_light(SkyRows& rows, const Light& light, const Splat& splat, int first, int end) const;
    void add_whole(SkyRows& rows, const Light& light, const Splat& splat, int first, int end) const;

    int size_, border_, bands_;
    double sigma_;
    std::vector<std::array<float, 3>> colours_;  // by code, luminance 1
    std::vector<Light> lights_;
    std::vector<std::vector<Splat>> splats_;  // by face and band of rows
};

}  // namespace nullscope
