// Features of the disc and what is in it.
#include <fmt/format.h>

#include <cmath>

#include "plan/disc_shape_keys.h"
#include "plan/emissivity_keys.h"
#include "plan/feature.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "scene/projection.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {
namespace {

// A disc has one light at least: its own heat, once the other goes.
bool glows(const Scene& s) { return s.disc && s.disc->emission == DiscEmission::kThermal; }

bool is_pattern(TextureKind texture) { return texture != TextureKind::kImage && texture != TextureKind::kGas; }

bool is_gas(const Scene& s) { return s.disc && s.disc->material.texture == TextureKind::kGas; }

void without_disc_texture(Scene& s) {
    s.disc->material.texture = TextureKind::kImage;
    s.disc->image.clear();
}

// Of a disc's gas.
std::vector<SceneKey> gas_keys() {
    constexpr std::string_view kGas = "texture = \"gas\"";
    return {{"disc", "gas_contrast", KeyType::kNumber, "", "0.7", closed(0.0, 1.0), "",
             "How much brighter clumps of gas are than gaps; 0 is smooth. Needs texture = \"gas\".",
             [](auto& s) { return &s.disc->gas.contrast; }, is_gas, kGas},
            {"disc", "gas_winding", KeyType::kNumber, "rad", "4", closed(0.0, 30.0), "",
             "Azimuth by which filaments of gas trail for each factor of e in radius. Needs texture = \"gas\".",
             [](auto& s) { return &s.disc->gas.winding; }, is_gas, kGas}};
}

// Of its plane.
std::vector<SceneKey> plane_keys() {
    return {
        {"disc", "tilt", KeyType::kNumber, "deg", "0", closed(0.0, 180.0), "", "Angle between its axis and the z axis.",
         [](auto& s) { return &s.disc->lean.tilt; }},
        {"disc", "node", KeyType::kNumber, "deg", "0", kAnyAngle, "",
         "Azimuth of its ascending node at time 0: there what goes eastward round its axis comes up through the "
         "equatorial "
         "plane.",
         [](auto& s) { return &s.disc->lean.node; }},
        {"disc", "precession", KeyType::kNumber, "deg", "0", kAnyAngle, "",
         "By how much its node moves in a time of r_s/c, all of it together; the time that light takes is left out.",
         [](auto& s) { return &s.disc->lean.precession; }}};
}

Feature ring_rates() {
    return {{Effect::kRingRates, "ring-rates", "EFFECT_RING_RATES",
             "Orbital speeds of a disc's rings that no closed form of the shader has.",
             "disc.flow is \"kepler\" and spacetime.metric is \"formula\"", "a logarithm and twelve terms a ring"},
            [](const FrameFacts& f) {
                const bool flows = f.spacetime != nullptr && f.so_far.contains(Effect::kDiscFlow);
                return reason_if(flows && !has_circular_rate_numbers(*f.spacetime),
                                 fmt::format("spacetime.metric = \"{}\"", f.scene.spacetime.metric));
            },
            nullptr,
            moving_disc,
            [](Scene& s) {
                s.spacetime = {"formula", {}};
                s.spacetime.parameters.formulas["A"] = "1 - 1/r";
            }};
}

Feature leaning_disc() {
    return {{Effect::kDiscLean, "disc-lean", "EFFECT_DISC_LEAN",
             "The disc leans from the equator of a rotating hole, whose rays keep to no plane.",
             "disc.tilt is above 0 and the hole rotates",
             "a sine and a cosine at both ends of each step, Newton's steps by the azimuth too"},
            [](const FrameFacts& f) {
                const bool rotates = f.spacetime != nullptr && !f.planar;
                return reason_if(rotates && disc_leans(f.scene),
                                 fmt::format("disc.tilt = {:.4g}",
                                             disc_leans(f.scene) ? 180.0 / M_PI * f.scene.disc->lean.tilt : 0.0));
            },
            [](Scene& s) {
                if (s.disc) s.disc->lean.tilt = 0.0;
            },
            [](Scene& s) { s.spacetime.metric = "kerr", s.disc.emplace(); },
            [](Scene& s) { s.disc->lean.tilt = 0.5; }};
}

Feature warped_disc() {
    return {{Effect::kDiscWarp, "disc-warp", "EFFECT_DISC_WARP",
             "The disc is warped, each ring in a plane of its own, or has gaps.",
             "there are disc.warp_radii or disc.rings", "some 20 places along each ray, of six fetches each"},
            [](const FrameFacts& f) -> Reason {
                if (!disc_warps(f.scene)) return kNot;
                const DiscWarp& warp = f.scene.disc->warp;
                return warp.bends() ? fmt::format("disc.warp_radii, {} rows", warp.radii.size())
                                    : fmt::format("disc.rings, {} radii", warp.rings.size());
            },
            [](Scene& s) {
                if (s.disc) s.disc->warp = {};
            },
            still_disc,
            [](Scene& s) {
                s.disc->warp = {{4.0, 10.0}, {0.0, 20.0}, {0.0, 30.0}, {}};
            },
            nullptr,
            disc_shape_keys()};
}

// Whether some of its first image may lie between the rays of two pixels. Its rims are ellipses with half axes a and a |cos(theta)|, a in px
// by the camera's distance and theta its angle to the disc's axis: the ends of the outer one are narrower than a pixel where a/(8 b^2) px are left of its length, b the minor half
// axis; between the rims there are as many px above and below the hole as their minor half axes differ by.
bool is_narrow(const Scene& scene) {
    constexpr double kEnds_px = 0.5, kBand_px = 2.0;
    const CameraSpec& camera = scene.camera;
    const DiscSpec& disc = *scene.disc;
    const double across = std::sin(camera.theta);
    const Vec3 outward{across * std::cos(camera.phi), across * std::sin(camera.phi), std::cos(camera.theta)};
    const double pixel = camera.r * pixel_angle(camera, 0.5 * camera.width, 0.5 * camera.height),
                 slope = std::fabs(dot(disc_plane_of(scene).normal, outward));
    return 8.0 * kEnds_px * slope * slope * disc.outer < pixel || slope * (disc.outer - disc.inner) < kBand_px * pixel;
}

Feature narrow_disc() {
    return {{Effect::kNarrowDisc, "narrow-disc", "EFFECT_NARROW_DISC",
             "Pixels get more rays also where a disc narrower than a pixel lies between two rays.",
             "there is the effect refine, and a disc that looks narrow: by its radii, by camera.theta, or from afar",
             "a crossing more a ray"},
            [](const FrameFacts& f) {
                if (!f.so_far.contains(Effect::kRefine) || !f.so_far.contains(Effect::kDisc)) return kNot;
                return reason_if(
                    !disc_warps(f.scene) && is_narrow(f.scene),
                    fmt::format("camera.theta = {:.4g}, disc.inner = {:.4g}, disc.outer = {:.4g}",
                                180.0 / M_PI * f.scene.camera.theta, f.scene.disc->inner, f.scene.disc->outer));
            },
            nullptr,
            [](Scene& s) { still_disc(s), s.camera.theta = 1.0; },
            [](Scene& s) { s.camera.theta = 1.57; }};
}

}  // namespace

std::span<const Feature> disc_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kDisc, "disc", "EFFECT_DISC", "A flat disc lies in a plane through the centre.", "there is a [disc]",
          "where each ray crosses its plane: from tables four fetches a crossing"},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.disc) return kNot;
             return fmt::format("[disc] from {} to {}", f.scene.disc->inner, f.scene.disc->outer);
         },
         [](Scene& s) { s.disc.reset(); },
         nothing,
         [](Scene& s) { s.disc.emplace(); },
         nullptr,
         plane_keys()},
        {{Effect::kDiscImage, "disc-image", "EFFECT_DISC_IMAGE", "The disc carries an image.",
          "disc.texture is \"image\", and disc.emission too or there is a disc.image",
          "a picture with mip levels; one or two fetches a crossing"},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.disc || f.scene.disc->material.texture != TextureKind::kImage) return kNot;
             if (!f.scene.disc->image.empty())
                 return fmt::format("disc.image = \"{}\"", f.scene.disc->image.filename().string());
             if (f.thermal()) return kNot;
             return "disc.emission = \"image\", the one that ships";
         },
         [](Scene& s) { s.disc->image.clear(); },
         glowing<false, false>,
         [](Scene& s) { s.disc->image = example_image(); },
         glows},
        {{Effect::kDiscPattern, "disc-pattern", "EFFECT_DISC_PATTERN",
          "The disc is covered by a colour, a pattern or a formula.", "disc.texture is neither \"image\" nor \"gas\"",
          "arithmetic a crossing"},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.disc || !is_pattern(f.scene.disc->material.texture)) return kNot;
             return fmt::format("disc.texture = \"{}\"", texture_name(f.scene.disc->material.texture));
         },
         without_disc_texture,
         glowing<false, false>,
         [](Scene& s) { s.disc->material.texture = TextureKind::kPlain; },
         glows},
        {{Effect::kTranslucentDisc, "translucent-disc", "EFFECT_TRANSLUCENT_DISC",
          "What lies behind the disc shines through it.", "disc.opacity is below 1 or disc.edge is above 0",
          "every crossing is shaded, not only the first"},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.disc) return kNot;
             if (f.scene.disc->opacity < 1.0) return fmt::format("disc.opacity = {}", f.scene.disc->opacity);
             if (f.scene.disc->edge > 0.0) return fmt::format("disc.edge = {}", f.scene.disc->edge);
             return kNot;
         },
         [](Scene& s) {
             if (s.disc) s.disc->opacity = 1.0, s.disc->edge = 0.0;
         },
         [](Scene& s) { s.disc.emplace(); },
         [](Scene& s) { s.disc->opacity = 0.5; }},
        {{Effect::kThermalDisc, "thermal-disc", "EFFECT_THERMAL_DISC",
          "The disc's matter moves on geodesics and emits thermal light, by accretion or another disc.emissivity.",
          "disc.emission is \"thermal\"", "six fetches a crossing"},
         [](const FrameFacts& f) { return reason_if(f.thermal(), "disc.emission = \"thermal\""); },
         [](Scene& s) { s.disc->emission = DiscEmission::kImage; },
         bare_disc,
         glowing<false, false>,
         [](const Scene& s) {
             return s.disc && (!s.disc->image.empty() || s.disc->material.texture != TextureKind::kImage);
         },
         emissivity_keys()},
        {{Effect::kDiscFlow, "disc-flow", "EFFECT_DISC_FLOW",
          "Each ring of the disc's pattern moves at the orbital speed of the matter.", "disc.flow is \"kepler\"",
          "the pattern twice a crossing"},
         [](const FrameFacts& f) {
             return reason_if(f.scene.disc && f.scene.disc->flow == DiscFlowKind::kKepler, "disc.flow = \"kepler\"");
         },
         [](Scene& s) {
             if (s.disc) s.disc->flow = DiscFlowKind::kStill;
         },
         still_disc,
         [](Scene& s) { s.disc->flow = DiscFlowKind::kKepler; }},
        ring_rates(),
        narrow_disc(),
        {{Effect::kSpot,
          "spot",
          "EFFECT_SPOT",
          "Hot spots are on an orbit in the disc.",
          "there is a [spot] and a [disc]",
          "arithmetic a crossing",
          {Slot::kDiscGlow, "object/spot.glsl", "spot_light"}},
         [](const FrameFacts& f) -> Reason {
             return f.spot() ? Reason(fmt::format("[spot] at {}", f.scene.spots.front().r)) : kNot;
         },
         [](Scene& s) { s.spots.clear(); },
         [](Scene& s) { glowing<true, true>(s), s.light.delay = false; },
         [](Scene& s) { s.spots.emplace_back(); }},
        {{Effect::kLimbDarkening,
          "limb-darkening",
          "EFFECT_LIMB_DARKENING",
          "A thermal disc has limb darkening: brighter along its normal, dimmer towards grazing angles.",
          "disc.limb_darkening is \"on\" and disc.emission \"thermal\"",
          "two fetches, a logarithm and six terms a crossing",
          {Slot::kDiscLight, "effect/limb_darkening.glsl", "limb_darkening"}},
         [](const FrameFacts& f) {
             return reason_if(f.thermal() && f.scene.disc->effects.limb_darkening, "disc.limb_darkening = \"on\"");
         },
         [](Scene& s) {
             if (s.disc) s.disc->effects.limb_darkening = false;
         },
         glowing<false, false>,
         [](Scene& s) { s.disc->effects.limb_darkening = true; },
         nullptr,
         {on_off_key(
             "disc", "limb_darkening", "off",
             "Whether a thermal disc has the limb darkening of an electron-scattering atmosphere (Chandrasekhar's "
             "law); needs "
             "emission = \"thermal\".",
             [](auto& s) { return &s.disc->effects.limb_darkening; },
             [](const Scene& s) { return s.disc->emission == DiscEmission::kThermal; }, "emission = \"thermal\"")}},
        {{Effect::kDiscGas, "disc-gas", "EFFECT_DISC_GAS", "The disc is turbulent gas, wound up by its rotation.",
          "disc.texture is \"gas\"", "four hashes an octave, as many octaves as a crossing's footprint shows"},
         [](const FrameFacts& f) { return reason_if(is_gas(f.scene), "disc.texture = \"gas\""); },
         without_disc_texture,
         glowing<false, false>,
         [](Scene& s) { s.disc->material.texture = TextureKind::kGas; },
         glows,
         gas_keys()},
        leaning_disc(),
        warped_disc(),
    });
    return features;
}

}  // namespace nullscope
