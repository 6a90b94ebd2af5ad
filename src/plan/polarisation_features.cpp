// Features of polarised light: that the disc's light is polarised, and a polariser before the camera.
#include <fmt/format.h>

#include <cmath>

#include "plan/feature.h"

namespace nullscope {
namespace {

constexpr std::string_view kPolarised =
                               "disc.polarisation = \"scattering\" or \"synchrotron\", or medium.polarisation = \"on\"",
                           kOfField = "polarisation = \"synchrotron\"";

bool is_thermal(const Scene& s) { return s.disc->emission == DiscEmission::kThermal; }
bool is_of_field(const Scene& s) { return s.disc->polarisation.by == Polarisation::kSynchrotron; }
void polarise(Scene& s) { s.disc->polarisation.by = Polarisation::kScattering; }

std::vector<SceneKey> keys_of_polarisation() {
    return {
        {"disc", "polarisation", KeyType::kChoice, "", "off", kNoRange, "off scattering synchrotron",
         "Linear polarisation of a thermal disc's light and of its hot spots': as of an atmosphere that scatters on "
         "electrons, or as of synchrotron light in an ordered field. Needs emission = \"thermal\".",
         [](auto& s) { return &s.disc->polarisation.by; }, is_thermal, "emission = \"thermal\""},
        {"disc", "field", KeyType::kChoice, "", "vertical", kNoRange, "vertical radial toroidal vector",
         "Magnetic field of synchrotron light in the frame of the matter; vector: disc.field_vector.",
         [](auto& s) { return &s.disc->polarisation.field; }, is_of_field, kOfField},
        {"disc", "field_vector", KeyType::kPoint, "", "[0, 0, 1]", closed(-1.0, 1.0), "",
         "Direction of the field: its radial, azimuthal (with growing phi) and vertical (north) component. Needs field "
         "= \"vector\".",
         [](auto& s) { return &s.disc->polarisation.vector; },
         [](const Scene& s) { return is_of_field(s) && s.disc->polarisation.field == DiscField::kVector; },
         "field = \"vector\""},
        {"disc", "spectral_index", KeyType::kNumber, "", "1", closed(0.0, 5.0), "",
         "alpha of synchrotron light of intensity nu^-alpha, of which (alpha + 1)/(alpha + 5/3) is polarised.",
         [](auto& s) { return &s.disc->polarisation.spectral_index; }, is_of_field, kOfField},
        {"disc", "polarised_fraction", KeyType::kNumber, "", "1", closed(0.0, 1.0), "",
         "Multiplies the polarised fraction of synchrotron light: below 1 the field is not quite ordered.",
         [](auto& s) { return &s.disc->polarisation.fraction; }, is_of_field, kOfField},
    };
}

}  // namespace

std::span<const Feature> polarisation_features() {
    static const auto features = std::to_array<Feature>({
        {{Effect::kPolarisation, "polarisation", "EFFECT_POLARISATION", "The light of disc and hot spots is polarised.",
          "disc.polarisation is \"scattering\" or \"synchrotron\"",
          "nothing for the picture; arithmetic a crossing for Stokes parameters and a polariser"},
         [](const FrameFacts& f) -> Reason {
             if (!has_polarised_disc(f.scene)) return kNot;
             return fmt::format("disc.polarisation = \"{}\"", f.scene.disc->polarisation.by == Polarisation::kScattering
                                                                  ? "scattering"
                                                                  : "synchrotron");
         },
         [](Scene& s) {
             if (s.disc) s.disc->polarisation.by = Polarisation::kOff;
         },
         glowing<false, false>,
         polarise,
         nullptr,
         keys_of_polarisation()},
        {{Effect::kPolariser, "polariser", "EFFECT_POLARISER", "The camera looks through a linear polariser.",
          "there is a picture.polariser, and a disc or a medium with a polarisation", "arithmetic a crossing"},
         [](const FrameFacts& f) -> Reason {
             if (!f.scene.picture.polariser || !is_polarised(f.scene)) return kNot;
             return fmt::format("picture.polariser = {:.6g}", *f.scene.picture.polariser * 180.0 / M_PI);
         },
         [](Scene& s) { s.picture.polariser.reset(); },
         [](Scene& s) { glowing<false, false>(s), polarise(s); },
         [](Scene& s) { s.picture.polariser = 0.5; },
         nullptr,
         {{"picture", "polariser", KeyType::kNumber, "deg", "", closed(-360.0, 360.0), "",
           "If set, the picture is seen through a linear polariser with this axis, counted from the picture's right "
           "towards up; it halves unpolarised light. Needs a disc.polarisation or medium.polarisation.",
           [](auto& s) { return &s.picture.polariser; }, is_polarised, kPolarised},
          on_off_key(
              "picture", "ticks", "off",
              "Whether ticks over the displayed picture lie along the electric vector of polarised light, as long as "
              "its fraction; "
              "needs a disc.polarisation or medium.polarisation, not in stereo pictures.",
              [](auto& s) { return &s.picture.ticks; }, is_polarised, kPolarised),
          on_off_key(
              "picture", "streamlines", "off",
              "Whether a texture of lines over the displayed picture runs along the electric vector of polarised "
              "light, with the more contrast the larger its fraction; needs a disc.polarisation or "
              "medium.polarisation, not in stereo "
              "pictures and split screens of the viewer, nor while the viewer's picture moves.",
              [](auto& s) { return &s.picture.streamlines; }, is_polarised, kPolarised)}},
    });
    return features;
}

}  // namespace nullscope
