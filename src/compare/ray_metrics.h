// Measures between a tested frame of ray data and the exact one: forward error, screen error, fate errors.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "compare/ray_errors.h"
#include "scene/projection.h"
#include "scene/ray.h"
#include "scene/scene.h"

namespace nullscope {

// A pixel whose fate differs is forgiven if the exact fate becomes the tested one within this distance, px: what a float can
// resolve of a 4K frame's position, with a margin. Rims of objects have a wider band, by their extra interpolation.
inline constexpr double kFateBand_px = 0.01, kSilhouetteBand_px = 0.05;

// Where neighbours leave more than this, px, displaced rays say how the exact answer moves: small against any feature, 1e7 roundings of a
// 4K position.
inline constexpr double kDisplaceAbove_px = 1e-3, kDisplaced_px = 1e-4;

// Exact rays at any positions (column, row from the top, centres at +0.5): the reference, or a stand-in of a test.
using ExactTrace = std::function<std::vector<RayPixel>(const std::vector<std::array<double, 2>>& positions)>;

// What floats hold of a direction, rad. Of frames that went through floats pass it as least_rad: a pixel counts as at least as wide. In zooms
// a pixel spans less, and along the ring, where the answer hardly moves, no float can have it to a pixel.
inline constexpr double kFloatDirection_rad = 0x1p-23;

struct RayMeasures {
    int width = 0, height = 0, row_step = 1;  // as of the frame that was measured
    std::vector<PixelErrors> pixels;          // top row first
    long long fate_errors = 0, forgiven = 0, not_finite = 0;
    Spread forward_rad, sky_px, place_px, angle_px, g_px;  // over the pixels that have such a value in both frames

    const PixelErrors& at(int x, int y) const { return pixels[static_cast<std::size_t>(y / row_step) * width + x]; }
};

// Compares every pixel (of every row_step-th row, at least the frame's own step) with the exact trace. The motion per pixel comes from the neighbours, and
// where that leaves more than refine_above_px, from displaced rays. Memory: 24 bytes a pixel and 64 rows of exact
// pixels; cost: that of the trace and some 0.2 core-microseconds a pixel.
RayMeasures measure_rays(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& trace, int row_step = 1,
                         double refine_above_px = kDisplaceAbove_px, double least_rad = 0);

// The same, number by number, of the pixels of rectangles of the frame, on the calling thread alone. Costs the rays of each
// rectangle and of one pixel around it, corners apart: five for a single pixel. Those of all are asked for at once.
struct PixelRect {
    int left, top, right, bottom;  // half-open, inside the frame
};
struct TileErrors {
    PixelRect rect;
    std::vector<PixelErrors> pixels;  // top row first
    PixelErrors& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y - rect.top) * (rect.right - rect.left) + x - rect.left];
    }
};
std::vector<TileErrors> measure_tiles(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& trace,
                                      const std::vector<PixelRect>& rects, double refine_above_px = kDisplaceAbove_px);

// The exact answer at pixel (x, y) and displaced by 1e-4 px.
ExactPixel exact_pixel(const CameraSpec& camera, const ExactTrace& trace, int x, int y);

// Compares two frames of one size when nothing can be traced: motion from the exact frame's neighbours, no pixel forgiven.
// angle_of: the angle that a pixel spans, rad; camera: place of the camera.
RayMeasures measure_ray_frames(const RayFrame& tested, const RayFrame& exact,
                               const std::function<double(int x, int y)>& angle_of, Vec3 camera);

// The same where rays of the exact frame can be traced: beside pixels whose neighbours leave more than refine_above_px, if the trace finds in
// their middle what `exact` has there, to a float or to refine_above_px. (It does not if the frame has another camera or time.) Five rays a
// pixel, of the kMostDisplaced worst at most: the others keep what their neighbours say.
inline constexpr std::size_t kMostDisplaced = 20000;
RayMeasures measure_ray_frames(const RayFrame& tested, const RayFrame& exact, const CameraSpec& camera,
                               const ExactTrace& trace, double refine_above_px = kDisplaceAbove_px,
                               double least_rad = 0);

Vec3 camera_place(const CameraSpec& camera);

// For cameras that are not known: the median of how far the exact sky moves per pixel.
double estimated_pixel_angle(const RayFrame& exact);

}  // namespace nullscope
