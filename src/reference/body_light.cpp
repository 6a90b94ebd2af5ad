#include <algorithm>
#include <array>
#include <cmath>

#include "expr/formula.h"
#include "plan/body_kind.h"
#include "reference/bodies.h"
#include "scene/bodies.h"

namespace nullscope::reference {
namespace {

struct Covering {
    double u, v;
    bool beyond = false;  // outside of the band
};

// Azimuth from -1/2 to 1/2 turn; polar angle.
double turns(Vec3 d) { return std::atan2(d.y, d.x) / (2 * M_PI); }
double polar(Vec3 d) { return std::atan2(std::hypot(d.x, d.y), d.z); }

Covering on_caps(Vec3 d) {
    const bool south = d.z < 0;
    const double from_pole = (south ? M_PI - polar(d) : polar(d)) / (M_PI / 2), azimuth = std::atan2(d.y, d.x);
    const double right = from_pole * std::sin(azimuth), down = (south ? -1 : 1) * from_pole * std::cos(azimuth);
    return {(south ? 0.75 : 0.25) + 0.25 * right, 0.5 + 0.5 * down};
}

// Faces +x -x +y above -y +z -z, each seen from outside with z up (the polar faces: with +y to the right).
Covering on_cube(Vec3 d) {
    const double ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
    int column = 0, row = 0;
    double right = 0, down = 0, depth = 1;
    if (ax >= ay && ax >= az) {
        column = d.x < 0, depth = ax, right = d.x < 0 ? -d.y : d.y, down = -d.z;
    } else if (ay >= az) {
        column = d.y < 0 ? 0 : 2, row = d.y < 0, depth = ay, right = d.y < 0 ? d.x : -d.x, down = -d.z;
    } else {
        column = d.z < 0 ? 2 : 1, row = 1, depth = az, right = d.y, down = d.z < 0 ? -d.x : d.x;
    }
    return {(column + 0.5 + 0.5 * right / depth) / 3, (row + 0.5 + 0.5 * down / depth) / 2};
}

Covering covering(const Material& material, Vec3 d) {
    switch (material.mapping) {
        case BodyMapping::kEquirectangular: return {0.5 + turns(d), polar(d) / M_PI};
        case BodyMapping::kBand: {
            const double v = 0.5 - 0.5 * (M_PI / 2 - polar(d)) / material.band_latitude;
            return {0.5 + turns(d), v, v < 0 || v > 1};
        }
        case BodyMapping::kCaps: return on_caps(d);
        case BodyMapping::kCubeFaces: break;
    }
    return on_cube(d);
}

bool odd(double cells) { return std::fmod(std::floor(cells), 2.0) != 0.0; }

// From 0 (second colour) to 1 (first).
double mixture(const Material& material, const Covering& at, Vec3 turned, double size) {
    const double p = at.u * material.columns, q = at.v * material.rows;
    constexpr double kLine = 0.08;  // of a cell: width of a grid's lines
    switch (material.texture) {
        case TextureKind::kChecker: return odd(p) == odd(q) ? 1 : 0;
        case TextureKind::kStripes: return odd(q) ? 0 : 1;
        case TextureKind::kGrid:
            return std::min(std::abs(p - std::round(p)), std::abs(q - std::round(q))) < 0.5 * kLine ? 1 : 0;
        case TextureKind::kNoise: {
            double sum = 0, weight = 0.5, grains = material.columns / size;
            for (int octave = 0; octave < 4; ++octave, weight /= 2, grains *= 2)
                sum += weight * expr::noise(grains * turned.x, grains * turned.y, grains * turned.z);
            return sum / 0.9375;
        }
        default: return 1;
    }
}

}  // namespace

Paint sample_image(const Image<float>& image, double x, double y) {
    const double column = std::clamp(x * image.width - 0.5, 0.0, image.width - 1.0);
    const double row = std::clamp(y * image.height - 0.5, 0.0, image.height - 1.0);
    const int x0 = static_cast<int>(column), y0 = static_cast<int>(row);
    const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
    std::array<double, 4> sum{0, 0, 0, 0};
    const auto add = [&](int i, int j, double weight) {
        const float* texel = image.at(i, j);
        for (int c = 0; c < 3; ++c) sum[c] += weight * texel[c];
        sum[3] += weight * (image.channels == 4 ? texel[3] : 1.0f);
    };
    const double fx = column - x0, fy = row - y0;
    add(x0, y0, (1 - fx) * (1 - fy));
    add(x1, y0, fx * (1 - fy));
    add(x0, y1, (1 - fx) * fy);
    add(x1, y1, fx * fy);
    return {{sum[0], sum[1], sum[2]}, sum[3]};
}

Vec3 material_light(const Material& material, double u, double v, Vec3 at, Vec3 turned, double size) {
    double first = mixture(material, {u, v}, turned, size);
    if (material.texture == TextureKind::kFormula) {
        const auto formula = expr::Formula::parse(material.formula, {"u", "v", "x", "y", "z"});
        const double values[] = {u, v, at.x, at.y, at.z};
        first = formula ? std::clamp(formula->value(values), 0.0, 1.0) : 0.0;
    }
    return first * material.colour + (1 - first) * material.second_colour;
}

Vec3 disc_material(const DiscSpec& disc, double x, double y) {
    const double r = std::hypot(x, y), azimuth = std::remainder(std::atan2(y, x) - disc.rotation, 2 * M_PI);
    return material_light(disc.material, 0.5 + azimuth / (2 * M_PI), (r - disc.inner) / (disc.outer - disc.inner),
                          {x, y, 0}, {r * std::cos(azimuth), r * std::sin(azimuth), 0}, disc.outer);
}

// Turned back by yaw about z, then by tilt about x.
Vec3 sky_material_of(const SkySpec& sky, Vec3 d) {
    const double across = std::hypot(d.x, d.y), azimuth = std::atan2(d.y, d.x) - sky.yaw;
    const double x = across * std::cos(azimuth), y = across * std::sin(azimuth), height = std::hypot(y, d.z);
    const double slope = std::atan2(d.z, y) - sky.tilt;
    const Vec3 at{x, height * std::cos(slope), height * std::sin(slope)};
    return sky.brightness * material_light(sky_material(sky), 0.5 - turns(at), polar(at) / M_PI, at, at, 1);
}

const CapSpec* cap_at(const Scene& scene, const BodyHit& hit) {
    if (&scene.bodies[hit.body] != seen_sphere(scene)) return nullptr;
    const double theta = polar(hit.place), phi = std::atan2(hit.place.y, hit.place.x) - hit.turn;
    const CapSpec* found = nullptr;
    for (const CapSpec& cap : scene.caps) {  // haversines
        const double a = std::sin((theta - cap.colatitude) / 2), b = std::sin((phi - cap.azimuth) / 2),
                     half = a * a + std::sin(theta) * std::sin(cap.colatitude) * b * b;
        if (2 * std::asin(std::sqrt(std::min(half, 1.0))) <= cap.radius) found = &cap;
    }
    return found;
}

Vec3 body_light(const Scene& scene, const BodyHit& hit, const Image<float>* image) {
    const Body& body = scene.bodies[hit.body];
    const Material& material = body.material;
    const bool cylinder = std::holds_alternative<CylinderSpec>(body.shape);
    const double size = kind_of(body).size(body);
    const Vec3 at = hit.place - hit.middle;
    const double turn = material.rotation + hit.turn, c = std::cos(turn), s = std::sin(turn);
    const Vec3 turned{c * at.x + s * at.y, c * at.y - s * at.x, at.z};
    const Covering place =
        cylinder ? Covering{0.5 + 0.5 * turned.x / size, 0.5 - 0.5 * turned.y / size} : covering(material, turned);
    Vec3 light = material.second_colour;
    if (material.texture == TextureKind::kImage && !place.beyond) {
        const Vec3 t = image ? sample_image(*image, place.u, place.v).colour : Vec3{1, 1, 1};
        light = {material.colour.x * t.x, material.colour.y * t.y, material.colour.z * t.z};
    } else if (!place.beyond) {
        light = material_light(material, place.u, place.v, at, turned, size);
    }
    const Vec3 sun{std::cos(material.sun_latitude) * std::cos(material.sun_longitude),
                   std::cos(material.sun_latitude) * std::sin(material.sun_longitude), std::sin(material.sun_latitude)};
    const double day = std::max(dot(hit.normal, sun), 0.0);
    return material.brightness * (1 - material.limb * (1 - hit.cosine)) * (material.night * (1 - day) + day) * light;
}

}  // namespace nullscope::reference
