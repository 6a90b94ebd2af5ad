#include "compare/ray_metrics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tbb/parallel_for.h>

namespace nullscope {
namespace {

constexpr int kBandRows = 64;     // exact rows held at a time
constexpr float kJump_px = 1.0f;  // a place on the disc this far off is another image of the disc, beyond a rim
constexpr int kBearings = 16;     // of displaced rays round a pixel: 0.98 of the band is covered in every direction

// Exact pixels of a rectangle.
struct Band {
    const RayPixel* pixels;
    PixelRect rect;
    const RayPixel& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y - rect.top) * (rect.right - rect.left) + (x - rect.left)];
    }
    bool has(int x, int y) const { return x >= rect.left && x < rect.right && y >= rect.top && y < rect.bottom; }
};

// The exact pixels of rectangles of the frame, of one pixel around each; corners, which nothing asks for, are left empty. All are traced
// together.
std::vector<std::vector<RayPixel>> exact_around(const ExactTrace& trace, const std::vector<PixelRect>& inner,
                                                const std::vector<PixelRect>& outer) {
    std::vector<std::array<double, 2>> positions;
    std::vector<RayPixel*> places;
    std::vector<std::vector<RayPixel>> pixels(inner.size());
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const PixelRect &in = inner[i], &out = outer[i];
        pixels[i].resize(static_cast<std::size_t>(out.right - out.left) * (out.bottom - out.top));
        RayPixel* place = pixels[i].data();
        for (int y = out.top; y < out.bottom; ++y)
            for (int x = out.left; x < out.right; ++x, ++place) {
                if ((x < in.left || x >= in.right) && (y < in.top || y >= in.bottom)) continue;
                positions.push_back({x + 0.5, y + 0.5});
                places.push_back(place);
            }
    }
    const std::vector<RayPixel> traced = trace(positions);
    for (std::size_t i = 0; i < traced.size(); ++i) *places[i] = traced[i];
    return pixels;
}

double motion2(const RayPixel& a, const RayPixel& b) {
    const Vec3 sky = b.sky - a.sky;
    const double u = b.u - a.u, v = b.v - a.v, w = b.w - a.w, angle = b.angle - a.angle;
    return dot(sky, sky) + u * u + v * v + w * w + angle * angle;
}

// The one of the two neighbours that ends alike and moves less: next to an edge the motion then is not overstated.
void add_neighbour(const Band& band, int x, int y, int dx, int dy, RayPixel& beside, double& displacement) {
    const RayPixel& here = band.at(x, y);
    double least = INFINITY;
    for (const int side : {1, -1}) {
        if (!band.has(x + side * dx, y + side * dy)) continue;
        const RayPixel& other = band.at(x + side * dx, y + side * dy);
        if (!same_end(here, other)) continue;
        const double moved = motion2(here, other);
        if (moved < least) least = moved, beside = other, displacement = side;
    }
}

ExactPixel with_neighbours(const Band& band, int x, int y) {
    ExactPixel exact;
    exact.here = band.at(x, y);
    add_neighbour(band, x, y, 1, 0, exact.right, exact.right_px);
    add_neighbour(band, x, y, 0, 1, exact.down, exact.down_px);
    return exact;
}

void set_camera(ExactPixel& exact, const CameraSpec& camera, int x, int y, double least_rad) {
    exact.pixel_angle = std::max(least_rad, pixel_angle(camera, x + 0.5, y + 0.5));
    exact.camera = camera_place(camera);
}

// Right, below, left, above.
std::array<std::array<double, 2>, 4> displaced(int x, int y) {
    const double u = x + 0.5, v = y + 0.5;
    return {{{u + kDisplaced_px, v}, {u, v + kDisplaced_px}, {u - kDisplaced_px, v}, {u, v - kDisplaced_px}}};
}

// Rays at displaced(x, y) of pixel i, whose own is heres[i]: those to the left and above are traced only where one of the others ends
// differently, and are else as the others.
std::vector<std::array<RayPixel, 4>> trace_displaced(const ExactTrace& trace,
                                                     const std::vector<std::array<int, 2>>& pixels,
                                                     const std::vector<RayPixel>& heres) {
    std::vector<std::array<double, 2>> positions;
    for (const auto& [x, y] : pixels) {
        const auto beside = displaced(x, y);
        positions.insert(positions.end(), {beside[0], beside[1]});
    }
    const std::vector<RayPixel> first = trace(positions);
    std::vector<std::array<RayPixel, 4>> moved(pixels.size());
    std::vector<std::size_t> edges;
    positions.clear();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const RayPixel &right = first[2 * i], &below = first[2 * i + 1];
        moved[i] = {right, below, right, below};
        if (same_end(right, heres[i]) && same_end(below, heres[i])) continue;
        const auto beside = displaced(pixels[i][0], pixels[i][1]);
        positions.insert(positions.end(), {beside[2], beside[3]});
        edges.push_back(i);
    }
    if (edges.empty()) return moved;
    const std::vector<RayPixel> second = trace(positions);
    for (std::size_t k = 0; k < edges.size(); ++k)
        moved[edges[k]][2] = second[2 * k], moved[edges[k]][3] = second[2 * k + 1];
    return moved;
}

// moved: rays at displaced(x, y). Those to the left and above serve where the others end differently.
ExactPixel with_displaced(const CameraSpec& camera, int x, int y, const RayPixel& here, const RayPixel* moved,
                          double least_rad = 0) {
    ExactPixel exact;
    exact.here = here;
    set_camera(exact, camera, x, y, least_rad);
    for (const int i : {2, 3, 0, 1}) {
        if (!same_end(moved[i], here)) continue;
        (i % 2 == 0 ? exact.right : exact.down) = moved[i];
        (i % 2 == 0 ? exact.right_px : exact.down_px) = i < 2 ? kDisplaced_px : -kDisplaced_px;
    }
    return exact;
}

// Pixels of one frame against an exact trace.
class Judge {
public:
    Judge(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& trace, double refine_above_px,
          double least_rad)
        : tested_(tested), camera_(camera), trace_(trace), refine_above_px_(refine_above_px), least_rad_(least_rad) {}

    // Compares the pixels of rectangles; on all cores, or on the calling thread alone.
    std::vector<TileErrors> tiles(const std::vector<PixelRect>& rects, bool parallel) const {
        std::vector<PixelRect> around;
        around.reserve(rects.size());
        for (const PixelRect& rect : rects)
            around.push_back({std::max(0, rect.left - 1), std::max(0, rect.top - 1),
                              std::min(tested_.width, rect.right + 1), std::min(tested_.height, rect.bottom + 1)});
        const std::vector<std::vector<RayPixel>> pixels = exact_around(trace_, rects, around);
        std::vector<TileErrors> tiles;
        tiles.reserve(rects.size());
        std::vector<Doubt> doubts;
        for (std::size_t i = 0; i < rects.size(); ++i) {
            const Band band{pixels[i].data(), around[i]};
            judge(band, tiles.emplace_back(TileErrors{rects[i], {}}), parallel);
            for (int y = rects[i].top; y < rects[i].bottom; ++y)
                for (int x = rects[i].left; x < rects[i].right; ++x)
                    if (PixelErrors& errors = tiles[i].at(x, y); errors.worst_px() > refine_above_px_)
                        doubts.push_back({x, y, &band.at(x, y), &errors});
        }
        if (!doubts.empty()) refine(doubts, parallel), judge_edges(doubts);
        return tiles;
    }

private:
    struct Doubt {
        int x, y;
        const RayPixel* here;
        PixelErrors* errors;
    };
    void judge(const Band& band, TileErrors& tile, bool parallel) const {
        const PixelRect& rect = tile.rect;
        tile.pixels.resize(static_cast<std::size_t>(rect.right - rect.left) * (rect.bottom - rect.top));
        const auto judge_row = [&](int y) {
            for (int x = rect.left; x < rect.right; ++x) {
                ExactPixel exact = with_neighbours(band, x, y);
                set_camera(exact, camera_, x, y, least_rad_);
                tile.at(x, y) = pixel_errors(tested_.at(x, y), exact);
            }
        };
        if (parallel)
            tbb::parallel_for(rect.top, rect.bottom, judge_row);
        else
            for (int y = rect.top; y < rect.bottom; ++y) judge_row(y);
    }

    void refine(const std::vector<Doubt>& doubts, bool parallel) const {
        std::vector<std::array<int, 2>> pixels;
        std::vector<RayPixel> heres;
        std::vector<PixelErrors*> errors;
        for (const Doubt& d : doubts) {
            if (d.errors->end == RayEnd::kDiffers) continue;
            pixels.push_back({d.x, d.y});
            heres.push_back(*d.here);
            errors.push_back(d.errors);
        }
        const auto moved = trace_displaced(trace_, pixels, heres);
        const auto judge_one = [&](std::size_t i) {
            const auto [x, y] = pixels[i];
            *errors[i] =
                pixel_errors(tested_.at(x, y), with_displaced(camera_, x, y, heres[i], moved[i].data(), least_rad_));
        };
        if (parallel)
            tbb::parallel_for(std::size_t{0}, pixels.size(), judge_one);
        else
            for (std::size_t i = 0; i < pixels.size(); ++i) judge_one(i);
    }

    // Pixels that end elsewhere, or on another image of the disc: does the exact answer become the tested one close by?
    void judge_edges(const std::vector<Doubt>& doubts) const {
        std::vector<Doubt> edges;
        std::vector<std::array<double, 2>> positions;
        for (const Doubt& d : doubts) {
            const bool differs = d.errors->end == RayEnd::kDiffers;
            if (!differs && !(d.errors->place_px > kJump_px)) continue;
            const bool rim = !differs || tested_.at(d.x, d.y).hit != d.here->hit;
            const double reach = rim ? kSilhouetteBand_px : kFateBand_px;
            edges.push_back(d);
            for (int k = 0; k < kBearings; ++k) {
                const double bearing = 2 * M_PI * k / kBearings;
                positions.push_back({d.x + 0.5 + reach * std::cos(bearing), d.y + 0.5 + reach * std::sin(bearing)});
            }
        }
        const std::vector<RayPixel> around = trace_(positions);
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (int k = 0; k < kBearings; ++k)
                if (explains(around[i * kBearings + static_cast<std::size_t>(k)], *edges[i].here,
                             tested_.at(edges[i].x, edges[i].y)))
                    edges[i].errors->end = RayEnd::kForgiven;
    }

    bool explains(const RayPixel& beside, const RayPixel& here, const RayPixel& tested) const {
        if (!same_end(beside, tested) || !all_finite(tested)) return false;
        if (!same_end(here, tested) || tested.hit == 0) return true;
        // Both met the disc, on different images of it: the ray beside must meet the tested one.
        constexpr double kCloser = 0.25;  // of the distance between the images
        const auto distance = [&](const RayPixel& other) {
            return std::hypot(other.u - tested.u, other.v - tested.v, other.w - tested.w);
        };
        return distance(beside) < kCloser * distance(here);
    }

    const RayFrame& tested_;
    const CameraSpec& camera_;
    const ExactTrace& trace_;
    double refine_above_px_, least_rad_;
};

void summarise(const RayFrame& tested, RayMeasures& m) {
    m.not_finite =
        std::count_if(tested.pixels.begin(), tested.pixels.end(), [](const RayPixel& p) { return !all_finite(p); });
    std::vector<float> forward, sky, place, angle, g;
    for (auto* values : {&forward, &sky, &angle, &g}) values->reserve(m.pixels.size());
    for (const PixelErrors& e : m.pixels) {
        m.fate_errors += e.end == RayEnd::kDiffers;
        m.forgiven += e.end == RayEnd::kForgiven;
        if (e.end != RayEnd::kSame) continue;
        angle.push_back(e.angle_px);
        if (e.hit) place.push_back(e.place_px);
        if (!e.escaped) continue;
        forward.push_back(e.forward_rad);
        sky.push_back(e.sky_px);
        g.push_back(e.g_px);
    }
    const std::array<std::pair<Spread*, std::vector<float>*>, 5> all = {
        {{&m.forward_rad, &forward}, {&m.sky_px, &sky}, {&m.place_px, &place}, {&m.angle_px, &angle}, {&m.g_px, &g}}};
    tbb::parallel_for(std::size_t{0}, all.size(),
                      [&](std::size_t i) { *all[i].first = spread_of(std::move(*all[i].second)); });
}

RayMeasures empty_measures(const RayFrame& tested) {
    RayMeasures measures;
    measures.width = tested.width;
    measures.height = tested.height;
    measures.row_step = tested.row_step;
    measures.pixels.resize(tested.pixels.size());
    return measures;
}

}  // namespace

Vec3 camera_place(const CameraSpec& camera) {
    const double s = std::sin(camera.theta);
    return camera.r * Vec3{s * std::cos(camera.phi), s * std::sin(camera.phi), std::cos(camera.theta)};
}

ExactPixel exact_pixel(const CameraSpec& camera, const ExactTrace& trace, int x, int y) {
    std::vector<std::array<double, 2>> positions{{x + 0.5, y + 0.5}};
    for (const auto& position : displaced(x, y)) positions.push_back(position);
    const std::vector<RayPixel> pixels = trace(positions);
    return with_displaced(camera, x, y, pixels[0], pixels.data() + 1);
}

RayMeasures measure_rays(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& trace, int row_step,
                         double refine_above_px, double least_rad) {
    RayMeasures measures = empty_measures(tested);
    const Judge judge(tested, camera, trace, refine_above_px, least_rad);
    const int step = std::max(row_step, tested.row_step), rows = step == 1 ? kBandRows : 1;
    for (int y = 0; y < tested.height; y += std::max(rows, step)) {
        const TileErrors band = judge.tiles({{0, y, tested.width, std::min(y + rows, tested.height)}}, true).front();
        std::copy(band.pixels.begin(), band.pixels.end(),
                  measures.pixels.begin() + static_cast<std::ptrdiff_t>(tested.index(0, y)));
    }
    summarise(tested, measures);
    return measures;
}

std::vector<TileErrors> measure_tiles(const RayFrame& tested, const CameraSpec& camera, const ExactTrace& trace,
                                      const std::vector<PixelRect>& rects, double refine_above_px) {
    return Judge(tested, camera, trace, refine_above_px, 0).tiles(rects, false);
}

namespace {

// As files hold them.
bool same_in_float(const RayPixel& a, const RayPixel& b) {
    const auto same = [](double x, double y) { return static_cast<float>(x) == static_cast<float>(y); };
    return same_end(a, b) && same(a.sky.x, b.sky.x) && same(a.sky.y, b.sky.y) && same(a.sky.z, b.sky.z) &&
           same(a.angle, b.angle) && same(a.u, b.u) && same(a.v, b.v) && same(a.w, b.w);
}

// measure_ray_frames but for the summary.
RayMeasures errors_by_neighbours(const RayFrame& tested, const RayFrame& exact,
                                 const std::function<double(int, int)>& angle_of, Vec3 camera) {
    RayMeasures measures = empty_measures(tested);
    const Band band{exact.pixels.data(), {0, 0, exact.width, exact.height}};
    tbb::parallel_for(0, exact.height, [&](int y) {
        for (int x = 0; x < exact.width; ++x) {
            ExactPixel pixel = with_neighbours(band, x, y);
            pixel.pixel_angle = angle_of(x, y);
            pixel.camera = camera;
            measures.pixels[static_cast<std::size_t>(y) * exact.width + x] = pixel_errors(tested.at(x, y), pixel);
        }
    });
    return measures;
}

}  // namespace

RayMeasures measure_ray_frames(const RayFrame& tested, const RayFrame& exact,
                               const std::function<double(int, int)>& angle_of, Vec3 camera) {
    RayMeasures measures = errors_by_neighbours(tested, exact, angle_of, camera);
    summarise(tested, measures);
    return measures;
}

RayMeasures measure_ray_frames(const RayFrame& tested, const RayFrame& exact, const CameraSpec& camera,
                               const ExactTrace& trace, double refine_above_px, double least_rad) {
    const auto angle_of = [&](int x, int y) { return std::max(least_rad, pixel_angle(camera, x + 0.5, y + 0.5)); };
    RayMeasures measures = errors_by_neighbours(tested, exact, angle_of, camera_place(camera));
    std::vector<PixelErrors*> doubts;
    for (PixelErrors& errors : measures.pixels)
        if (errors.end == RayEnd::kSame && errors.worst_px() > refine_above_px) doubts.push_back(&errors);
    if (doubts.size() > kMostDisplaced) {
        std::ranges::nth_element(
            doubts, doubts.begin() + kMostDisplaced,
            [](const PixelErrors* a, const PixelErrors* b) { return a->worst_px() > b->worst_px(); });
        doubts.resize(kMostDisplaced);
    }
    std::vector<std::array<double, 2>> positions;
    for (const PixelErrors* errors : doubts) {
        const auto at = static_cast<int>(errors - measures.pixels.data());
        const int x = at % exact.width, y = at / exact.width;
        positions.push_back({x + 0.5, y + 0.5});
        for (const auto& position : displaced(x, y)) positions.push_back(position);
    }
    const std::vector<RayPixel> traced = trace(positions);
    for (std::size_t i = 0; i < doubts.size(); ++i) {
        const RayPixel* pixels = traced.data() + 5 * i;
        const int x = static_cast<int>(positions[5 * i][0]), y = static_cast<int>(positions[5 * i][1]);
        const ExactPixel pixel = with_displaced(camera, x, y, pixels[0], pixels + 1, least_rad);
        if (same_in_float(pixel.here, exact.at(x, y)) ||
            pixel_errors(exact.at(x, y), pixel).worst_px() <= refine_above_px)
            *doubts[i] = pixel_errors(tested.at(x, y), pixel);
    }
    summarise(tested, measures);
    return measures;
}

double estimated_pixel_angle(const RayFrame& exact) {
    std::vector<float> motions;
    for (int y = 0; y < exact.height; ++y)
        for (int x = 0; x + 1 < exact.width; ++x)
            if (exact.at(x, y).fate == Fate::kEscaped && exact.at(x + 1, y).fate == Fate::kEscaped)
                motions.push_back(static_cast<float>(angle_between(exact.at(x, y).sky, exact.at(x + 1, y).sky)));
    return spread_of(std::move(motions)).median;
}

}  // namespace nullscope
