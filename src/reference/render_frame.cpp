#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "light/black_body.h"
#include "reference/body_shift.h"
#include "reference/disc_gas.h"
#include "reference/disc_light.h"
#include "reference/frame_tracer.h"
#include "reference/reference.h"
#include "reference/seen_light.h"
#include "reference/star_images.h"
#include "scene/medium_bands.h"
#include "scene/projection.h"
#include "scene/warp_mesh.h"

namespace nullscope::reference {
namespace {

double smoothstep(double edge, double x) {
    const double t = std::clamp(x / edge, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// What the disc has at this radius, which is on one of its rings, of its opacity.
double within_rims(const DiscSpec& disc, double r) {
    if (!(disc.edge > 0)) return 1.0;
    double depth = std::min(r - disc.inner, disc.outer - r);
    for (const double end : disc.warp.rings) depth = std::min(depth, std::abs(r - end));
    return smoothstep(disc.edge, depth / (disc.outer - disc.inner));
}

// Colour and coverage of the disc at (x, y): the image's square covers [-outer, outer]^2, turned by rotation, row 0 at
// the side +outer.
Paint disc_pattern(const DiscSpec& disc, const Image<float>* image, double x, double y) {
    const double c = std::cos(disc.rotation), s = std::sin(disc.rotation);
    const double u = (c * x + s * y) / disc.outer, v = (c * y - s * x) / disc.outer;
    const bool painted = disc.material.texture != TextureKind::kImage;
    Paint paint = painted ? Paint{disc_material(disc, x, y), 1}
                  : image ? sample_image(*image, 0.5 * (1 + u), 0.5 * (1 - v))
                          : Paint{{1, 1, 1}, 1};
    paint.colour = disc.brightness * paint.colour;
    paint.alpha *= disc.opacity * within_rims(disc, std::hypot(x, y));
    return paint;
}

// Gas: its light is spread over the opacity that a smooth disc would have, whatever gaps there are in it.
Paint gas_paint(const Metric& matter, const Scene& scene, const DiscHit& hit) {
    const DiscSpec& disc = *scene.disc;
    const double r = std::hypot(hit.x, hit.y), whole = within_rims(disc, r), opacity = disc.opacity * whole;
    const double sense = matter.sense(disc.sense);
    const auto rate = [&](double at) {
        return disc.flow == DiscFlowKind::kKepler ? matter.leaning_rate(at, sense, disc.lean.tilt) : 0.0;
    };
    const GasFactors gas = gas_at(disc, r, std::atan2(hit.y, hit.x), scene.time - hit.delay, whole, rate, sense);
    const double thin = 1 - opacity * gas.light, thick = (1 - opacity) * gas.gaps,
                 through = std::clamp(thin + opacity * opacity * (thick - thin), 0.0, 1.0);
    return {opacity * gas.light * disc.brightness * disc.material.colour, 1 - through};
}

// The pattern as two fading copies have it (docs/time.md), each wound by its rings' own rates: what of it is at (x, y) at time t.
Paint flowing_pattern(const DiscSpec& disc, const Image<float>* image, double rate, double t, double x, double y) {
    constexpr double kCopies = 4096, kGolden = 0.61803398875;
    const double lives = t / disc.flow_life, r = std::hypot(x, y), azimuth = std::atan2(y, x);
    Paint sum{{0, 0, 0}, 0};
    for (const double start : {0.0, 0.5}) {
        const double copy = std::floor(lives + start), part = lives + start - copy,
                     weight = part < 0.5 ? 2 * part : 2 - 2 * part;
        const double number = copy - kCopies * std::floor(copy / kCopies),
                     turn = kGolden * number - std::floor(kGolden * number);
        const double from = azimuth - rate * (part - 0.5) * disc.flow_life - 2 * M_PI * turn;
        const Paint one = disc_pattern(disc, image, r * std::cos(from), r * std::sin(from));
        sum = {sum.colour + weight * one.colour, sum.alpha + weight * one.alpha};
    }
    return sum;
}

// 24 squares around by 12 rings of equal height, the northern half blue, the southern one amber: the pattern of
// shaders/object/star.glsl, unfiltered.
Vec3 star_colour(Vec3 place) {
    constexpr double kSquare = M_PI / 12;
    const double longitude = std::atan2(place.y, place.x) + 2 * M_PI;
    const bool odd =
        (static_cast<int>(std::floor(longitude / kSquare)) + static_cast<int>(std::floor(6 * (place.z + 2)))) % 2 != 0;
    const Vec3 colour = place.z > 0 ? Vec3{0.20, 0.32, 0.62} : Vec3{0.62, 0.36, 0.16};
    return (odd ? 0.4 : 1.6) * colour;
}

// More hits than this add nothing: images beyond it are thinner than e^-200 of the disc.
constexpr int kMostHits = 64;

// What there is to see. far_sky, heat: where the scene has one.
struct Looks {
    const FrameTracer& tracer;
    const Scene& scene;
    const SkyCube& sky;
    const SkyCube* far_sky;
    const Pictures& pictures;
    const DiscLight* heat;
};

// Light of a picture, each primary changed as a black body of its temperature has it changed by g.
Vec3 shifted(Vec3 light, const std::optional<double>& temperature_K, const LightSpec& switches, double g) {
    if (!temperature_K || g == 1) return light;
    const Vec3 own = seen_black_body(*temperature_K, 1, switches), seen = seen_black_body(*temperature_K, g, switches);
    const auto changed = [](double a, double by, double of) { return of > 0 ? a * by / of : 0.0; };
    return {changed(light.x, seen.x, own.x), changed(light.y, seen.y, own.y), changed(light.z, seen.z, own.z)};
}

// Of a body without a temperature whatever g is.
Vec3 solid_colour(const Looks& looks, const TracedRay& ray, const BodyHit& hit) {
    const Scene& scene = looks.scene;
    const Material& material = scene.bodies[hit.body].material;
    const Vec3 light = body_light(scene, hit, looks.pictures.of(hit.body));
    if (!material.temperature_K) return light;
    const Shift own = body_shift(looks.tracer.matter(), ray, hit, scene.light.lensing),
                all{ray.shift.gravity * own.gravity, ray.shift.doppler * own.doppler};
    const double g = all.seen(scene.light);
    if (!(g > 0)) return {0, 0, 0};
    const double scale = std::exp2(-log2_brightness(*material.temperature_K, scene.light.bolometric));
    if (const CapSpec* cap = cap_at(scene, hit)) {
        const Vec3 heat = seen_black_body(cap->temperature_K, g, scene.light);
        return scale * cap->brightness * (1 - material.limb * (1 - hit.cosine)) *
               Vec3{cap->colour.x * heat.x, cap->colour.y * heat.y, cap->colour.z * heat.z};
    }
    if (material.texture == TextureKind::kImage) return shifted(light, material.temperature_K, scene.light, g);
    const Vec3 heat = seen_black_body(*material.temperature_K, g, scene.light);
    return scale * Vec3{light.x * heat.x, light.y * heat.y, light.z * heat.z};
}

// Its light is multiplied by its coverage already.
Paint pattern_at(const Looks& looks, const DiscHit& hit) {
    const DiscSpec& disc = *looks.scene.disc;
    if (disc.material.texture == TextureKind::kGas) return gas_paint(looks.tracer.matter(), looks.scene, hit);
    Paint paint =
        disc.flow == DiscFlowKind::kStill
            ? disc_pattern(disc, looks.pictures.disc, hit.x, hit.y)
            : flowing_pattern(disc, looks.pictures.disc,
                              looks.tracer.matter().leaning_rate(
                                  std::hypot(hit.x, hit.y), looks.tracer.matter().sense(disc.sense), disc.lean.tilt),
                              looks.scene.time - hit.delay, hit.x, hit.y);
    paint.colour = paint.alpha * paint.colour;
    return paint;
}

// A spot is a Gaussian about its middle, which moves on a circle: its frequency there is p . u, u = u^t (1, 0, 0, Omega).
Vec3 spot_colour(const Metric& matter, const Scene& scene, const SpotSpec& spot, const TracedRay& ray,
                 const DiscHit& hit) {
    const double tilt = scene.disc->lean.tilt, rate = matter.leaning_rate(spot.r, matter.sense(spot.sense), tilt),
                 t = scene.time - hit.delay, rest = matter.rest_lapse(spot.r);
    double least = INFINITY;
    for (int i = 0; i < spot.count; ++i) {
        const double at = spot.phase + rate * t + 2 * M_PI * i / spot.count;
        least = std::min(least, std::hypot(hit.x - spot.r * std::cos(at), hit.y - spot.r * std::sin(at)));
    }
    const double l = scene.light.lensing ? hit.l : hit.l / rest;
    const EquatorialMetric g = matter.equator(spot.r);
    const bool leans = tilt != 0 && matter.a() != 0;
    const double u_t = leans ? matter.leaning_u_t(spot.r, rate, tilt, hit.cosine)
                             : 1 / std::sqrt(-g.g_tt - rate * (2 * g.g_tphi + rate * g.g_phiphi)),
                 all = 1 / (u_t * (1 - rate * l));
    const Shift shift{ray.shift.gravity * rest, ray.shift.doppler * all / rest};
    const Vec3 light = seen_black_body(spot.temperature_K, shift.seen(scene.light), scene.light);
    return spot.brightness / std::exp2(log2_brightness(spot.temperature_K, scene.light.bolometric)) *
           std::exp(-0.5 * least * least / (spot.size * spot.size)) * light;
}

// Light and transmission of the matter along a ray, from the camera on, piece by piece.
class MatterAhead {
public:
    MatterAhead(const Looks& looks, const TracedRay& ray) : medium_(looks.tracer.medium()) {
        if (medium_ == nullptr) return;
        nodes_ = ray.medium_nodes();
        energy_ = 1 / (ray.shift.gravity * ray.shift.doppler);
        momentum_ = ray.l_z * energy_;
    }
    // Up to a place on the ray: adds to what is seen, and dims what lies behind.
    void pass(double until, Vec3& colour, double& through) {
        for (; next_ < nodes_.size() && nodes_[next_].along < until; ++next_) {
            const Medium::Light found = medium_->at(nodes_[next_], energy_, momentum_);
            colour = colour + through * found.light;
            through *= found.through;
        }
    }

private:
    const Medium* medium_;
    std::vector<MediumNode> nodes_;
    std::size_t next_ = 0;
    double energy_ = 1, momentum_ = 0;
};

Vec3 ray_colour(const Looks& looks, const TracedRay& ray) {
    const Scene& scene = looks.scene;
    Vec3 colour{0, 0, 0};
    double through = 1;
    const std::optional<BodyHit> body = ray.first_hit();
    MatterAhead matter(looks, ray);
    for (const DiscHit& hit : looks.tracer.disc_hits(ray, kMostHits)) {
        if (body && body->along < hit.along) break;
        matter.pass(hit.along, colour, through);
        Paint paint = pattern_at(looks, hit);
        if (looks.heat != nullptr) {
            const PhotonAtDisc photon{std::hypot(hit.x, hit.y), hit.l, hit.climb, hit.cosine, hit.across};
            const Vec3 light = looks.heat->colour(photon, ray.g * looks.heat->shift(photon).seen(scene.light));
            paint.colour = {paint.colour.x * light.x, paint.colour.y * light.y, paint.colour.z * light.z};
        }
        colour = colour + through * paint.colour;
        for (const SpotSpec& spot : scene.spots)
            colour = colour + through * spot_colour(looks.tracer.matter(), scene, spot, ray, hit);
        through *= 1 - paint.alpha;
    }
    matter.pass(body ? body->along : INFINITY, colour, through);
    if (body) return colour + through * solid_colour(looks, ray, *body);
    if (ray.fate() == Fate::kEscaped && through > 0) {
        const Vec3 at = ray.end_direction();
        colour =
            colour + through * (is_procedural(scene.sky.kind)
                                    ? sky_material_of(scene.sky, at)
                                    : shifted(sample_sky(looks.sky, at), scene.sky.temperature_K, scene.light, ray.g));
    }
    if (ray.fate() == Fate::kHit) colour = colour + through * star_colour(ray.end_direction());
    if (ray.fate() == Fate::kOtherSide && looks.far_sky != nullptr)
        colour = colour + through * sample_sky(*looks.far_sky, ray.end_direction());
    return colour;
}

// A polariser takes the half of unpolarised light, and of what is behind polarised matter nothing is.
Vec3 polarised_colour(const Looks& looks, const std::array<double, 2>& place, const Vec3& behind) {
    const auto stokes = looks.tracer.stokes(place[0], place[1]);
    if (!stokes) return behind;
    const auto& axis = looks.scene.picture.polariser;
    const double c = axis ? std::cos(2 * *axis) : 0, s = axis ? std::sin(2 * *axis) : 0;
    const auto passed = [&](double i, double q, double u) { return (axis ? 0.5 : 1) * (i + c * q + s * u); };
    const auto& through = stokes->through;
    return passed(stokes->light[0], stokes->light[1], stokes->light[2]) * looks.scene.medium->colour +
           passed(through[0][0], through[1][0], through[2][0]) * behind;
}

// The light of rays through places of the picture, in their order.
std::vector<Vec3> colours(const Looks& looks, const std::vector<std::array<double, 2>>& places) {
    const CameraSpec& camera = looks.scene.camera;
    std::vector<Vec3> found(places.size());
    for (std::size_t from = 0; from < places.size(); from += kRaysTogether) {
        std::vector<std::array<double, 2>> seen;
        std::vector<std::pair<std::size_t, double>> lights;  // of which place, and how much the warp mesh lets through
        for (std::size_t i = from; i < std::min(from + kRaysTogether, places.size()); ++i) {
            const auto& [x, y] = places[i];
            const double light = shows(camera, x, y) ? warp_light(camera, x, y) : 0.0;
            if (light != 0.0) seen.push_back(places[i]), lights.push_back({i, light});
        }
        const std::vector<RayPtr> rays = looks.tracer.rays(seen);
        for (std::size_t k = 0; k < rays.size(); ++k)
            found[lights[k].first] = lights[k].second * polarised_colour(looks, seen[k], ray_colour(looks, *rays[k]));
    }
    return found;
}

// What of a point behind shines through.
double transmission(const Looks& looks, double x, double y) {
    const RayPtr ray = looks.tracer.ray_of_many(x, y);
    if (ray->first_hit()) return 0;
    Vec3 light;
    double through = 1;
    MatterAhead(looks, *ray).pass(INFINITY, light, through);
    if (const auto stokes = looks.tracer.stokes(x, y)) through = stokes->through[0][0];
    for (const DiscHit& hit : looks.tracer.disc_hits(*ray, kMostHits)) through *= 1 - pattern_at(looks, hit).alpha;
    return through;
}

// Errors of what is to be drawn.
Status check_pictures(const Pictures& pictures, int samples) {
    if (samples < 1) return bad_input(fmt::format("samples = {} must be at least 1", samples));
    if (pictures.disc && (pictures.disc->empty() || pictures.disc->channels < 3 || pictures.disc->channels > 4))
        return bad_input("the disc's image must have 3 or 4 channels");
    return Done{};
}

std::optional<DiscLight> heat_of(const FrameTracer& tracer, const Scene& scene) {
    if (!scene.disc || scene.disc->emission != DiscEmission::kThermal) return std::nullopt;
    return std::optional<DiscLight>(std::in_place, tracer.matter(), *scene.disc, scene.light);
}

// Of the rays of some pixels of a row, pixel by pixel.
std::vector<std::array<double, 2>> places_of(int from, int to, int y, int samples) {
    std::vector<std::array<double, 2>> places;
    for (int x = from; x < to; ++x)
        for (int row = 0; row < samples; ++row)
            for (int i = 0; i < samples; ++i) places.push_back({x + (i + 0.5) / samples, y + (row + 0.5) / samples});
    return places;
}

// Means over the rays of a pixel, those of even and of odd number as on a chessboard.
std::array<Vec3, 2> pixel_halves(const Looks& looks, int x, int y, int samples) {
    std::array<Vec3, 2> sums{};
    std::array<int, 2> counts{};
    const std::vector<Vec3> found = colours(looks, places_of(x, x + 1, y, samples));
    for (int i = 0; i < samples * samples; ++i) {
        const auto half = static_cast<std::size_t>((i / samples + i % samples) % 2);
        sums[half] = sums[half] + found[static_cast<std::size_t>(i)];
        ++counts[half];
    }
    for (const std::size_t half : {0, 1}) sums[half] = sums[half] / std::max(counts[half], 1);
    return sums;
}

Vec3 in_colour(const Vec3& light, const Vec3& colour) {
    return {light.x * colour.x, light.y * colour.y, light.z * colour.z};
}

}  // namespace

Result<std::vector<PixelLight>> render_pixels(const Scene& scene, const SkyCube& sky, const Pictures& pictures,
                                              int samples, const std::vector<std::array<int, 2>>& pixels,
                                              const SkyCube* far_sky) {
    TRY(good, check_pictures(pictures, samples));
    if (samples % 2 != 0) return bad_input(fmt::format("samples = {} must be even", samples));
    if (shows_bands(scene)) {
        std::vector<PixelLight> sum(pixels.size());
        const std::vector<std::size_t> bands = bands_as_colours(*scene.medium);
        for (std::size_t i = 0; i < bands.size(); ++i) {
            TRY(one, render_pixels(at_band(scene, bands[i]), sky, pictures, samples, pixels, far_sky));
            const Vec3 colour = colour_of_band(i, bands.size());
            for (std::size_t k = 0; k < sum.size(); ++k) {
                sum[k].light = sum[k].light + in_colour((*one)[k].light, colour);
                sum[k].uncertainty = sum[k].uncertainty + in_colour((*one)[k].uncertainty, colour);
            }
        }
        return sum;
    }
    TRY(tracer, FrameTracer::make(scene));
    const std::optional<DiscLight> heat = heat_of(*tracer, scene);
    const Looks looks{*tracer, scene, sky, far_sky, pictures, heat ? &*heat : nullptr};
    std::vector<PixelLight> found(pixels.size());
    tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t i) {
        const auto [even, odd] = pixel_halves(looks, pixels[i][0], pixels[i][1], samples);
        found[i] = {0.5 * (even + odd), 0.5 * (even - odd)};
    });
    return found;
}

Result<Image<float>> render_frame(const Scene& scene, const SkyCube& sky, const Pictures& pictures, int samples,
                                  const std::function<void(long long)>& done, const SkyCube* far_sky,
                                  const std::vector<PointStar>& stars) {
    TRY(good, check_pictures(pictures, samples));
    if (shows_bands(scene)) {
        Image<float> sum(scene.camera.width, scene.camera.height, 3);
        const std::vector<std::size_t> bands = bands_as_colours(*scene.medium);
        for (std::size_t i = 0; i < bands.size(); ++i) {
            TRY(one, render_frame(at_band(scene, bands[i]), sky, pictures, samples, i == 0 ? done : nullptr, far_sky,
                                  stars));
            const Vec3 colour = colour_of_band(i, bands.size());
            const std::array<double, 3> shares{colour.x, colour.y, colour.z};
            for (std::size_t k = 0; k < sum.data.size(); ++k)
                sum.data[k] += static_cast<float>(shares[k % 3] * one->data[k]);
        }
        return sum;
    }
    TRY(tracer, FrameTracer::make(scene));
    const std::optional<DiscLight> heat = heat_of(*tracer, scene);
    const Looks looks{*tracer, scene, sky, far_sky, pictures, heat ? &*heat : nullptr};
    Image<float> image(scene.camera.width, scene.camera.height, 3);
    constexpr int kTold = 64;  // pixels; rows of large pictures take seconds, and who is told can stop it
    tbb::parallel_for(0, image.height, [&](int y) {
        std::vector<Vec3> found;
        for (int x = 0; x < image.width; ++x) {
            if (x % kTold == 0) {
                const int some = std::min(kTold, image.width - x);
                if (done) done(some);
                found = colours(looks, places_of(x, x + some, y, samples));
            }
            Vec3 sum{0, 0, 0};
            const auto count = static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
            for (std::size_t i = 0; i < count; ++i) sum = sum + found[static_cast<std::size_t>(x % kTold) * count + i];
            sum = sum / (static_cast<double>(samples) * samples);
            float* pixel = image.at(x, y);
            pixel[0] = static_cast<float>(sum.x);
            pixel[1] = static_cast<float>(sum.y);
            pixel[2] = static_cast<float>(sum.z);
        }
    });
    if (!stars.empty())
        add_point_stars(
            *tracer, scene, stars, [&](double x, double y) { return transmission(looks, x, y); }, image);
    return image;
}

}  // namespace nullscope::reference
