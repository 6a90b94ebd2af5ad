// What is asked of a ray and what is known of it afterwards: shared by reference, shader core, GL and comparison.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"

namespace nullscope {

inline constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();  // "empty" in records, never in pixels

enum class Fate { kEscaped = 0, kCaptured = 1, kOtherSide = 2, kNoSky = 3, kHit = 4 };

// A ray traced backward in time from a camera.
// General form: position (r, theta, phi) and unit view direction n = (n_r, n_theta, n_phi) in the local static frame.
// In wormholes r is the proper distance l from the throat, negative on the far side.
// Reduced form (orbit set): q = E r_s / L, zeta0 = r_s / r, s = +1 towards the hole, -1 away; the orbital plane is then the
// equatorial plane, the camera at phi = 0 and the ray moves towards growing phi. Wormholes: q = 1 over impact parameter, zeta0
// holds l0, s = +1 towards the throat.
struct ReducedRay {
    double q = 0, zeta0 = 0;
    int s = 1;
};
enum class LocalFrame { kStatic, kRain };
struct RayQuery {
    double r = 1, theta = M_PI / 2, phi = 0;
    Vec3 n{-1, 0, 0};
    LocalFrame frame = LocalFrame::kStatic;
    std::optional<ReducedRay> orbit;
    std::optional<double> at_angle;  // a swept angle at which the position along the ray is asked for, rad
};

// The answer. Empty values are NaN (kNotANumber).
struct RayRecord {
    Fate fate = Fate::kNoSky;
    double theta_inf = kNotANumber,
           phi_inf = kNotANumber;  // direction on the sky; phi unwrapped (phi_camera + what was swept)
    Vec3 sky{kNotANumber, kNotANumber, kNotANumber};  // the same as a unit vector in world axes
    // Swept in the orbital plane from the camera to the end (sky, or horizon), windings kept.
    double angle = kNotANumber;
    double delay = kNotANumber;  // T = v_cam - v_inf, in r_s/c; escaped rays
    double g = kNotANumber;      // camera frequency over frequency at infinity
    double turn = kNotANumber;   // zeta at the turning point on the traced part; empty if none
    double at = kNotANumber;     // zeta at at_angle; empty if the ray has ended before
    int hit = 0;                 // number of what the ray ended on, as RayPixel::hit: fate kHit
    struct Crossing {
        double r, phi;
        double g = kNotANumber;  // camera frequency over frequency in the disc's matter there; where it was asked for
        // of the light of a polarised disc there: angle from the screen's right towards up, rad, (-pi/2, pi/2]; polarised fraction. Right is
        // towards growing phi, up towards the north, for a camera that looks at the centre; the ray's own are turned with it by the shortest way.
        double chi = kNotANumber, p = kNotANumber;
    };
    std::vector<Crossing>
        crossings;  // of the equatorial plane after leaving the camera, before the end (horizon included)
};

// Numbers of what rays hit: the first sphere, cylinder, ball and surface of a scene have 2 to 5, later kinds 7 and on (scene/bodies.h
// has all bodies).
inline constexpr int kDiscHit = 1, kSphereHit = 2, kCylinderHit = 3, kBallHit = 4, kSurfaceHit = 5, kStarHit = 6;
// Matter along the ray, in layers alone: ray data do not know it. No body has this number: a second disc would.
inline constexpr int kMediumHit = 9;

// One pixel of the ray data of a frame (docs/ray-data.md). Finite always; 0 where a value does not exist.
struct RayPixel {
    Fate fate = Fate::kNoSky;  // kHit: ended on an opaque object
    Vec3 sky{0, 0, 0};         // unit direction on the celestial sphere, world axes; escaped rays
    double g = 0;              // camera frequency over frequency at infinity
    double delay = 0;          // r_s/c; 0 unless delay is called for
    double angle = 0;          // swept from the camera to the end (sky, horizon or hit), rad
    int order = 0;             // image order: floor(angle / pi)
    int hit = 0;  // number of the first object hit (object_name()), 0 for none, also for a translucent object
    // That the tracer took, where it takes steps; of the shader core, and of methods that count them (shaderlib/method.h).
    int steps = 0;
    double
        u = 0,
        v = 0,
        w = 0;  // place of the first hit: x, y, z in r_s, world axes; on the disc w = 0; star: longitude and latitude, rad
};

struct RayFrame {
    int width = 0, height = 0;
    std::vector<RayPixel> pixels;  // top row first
    int row_step = 1;              // the pixels are those of rows 0, row_step, 2 row_step, ... only
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y / row_step) * width + x;
    }  // y: a row that is there
    const RayPixel& at(int x, int y) const { return pixels[index(x, y)]; }
};

}  // namespace nullscope
