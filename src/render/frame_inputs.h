// What the shaders of a frame read besides the uniform block: tables of rays, skies, images, matter, each in its texture unit. Loads what
// the prepared scene calls for and drops what it does not. Needs a current context, as the renderer, whose part it is.
#pragma once
#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "image/large_image.h"
#include "light/electron_energies.h"
#include "render/body_images.h"
#include "render/frame_numbers.h"
#include "render/frame_tables.h"
#include "render/medium_texture.h"
#include "render/sky_faces.h"
#include "render/sky_textures.h"
#include "render/warp_texture.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {

// A texture as a driver was given it.
struct TextureLine {
    std::string name;
    int width, height;
    std::size_t bytes;
};

class FrameInputs {
public:
    // Units of textures by the samplers' names; those of the images on bodies follow.
    static constexpr const char* kSamplers[] = {
        "strip_texture",      "orbit_texture",     "sky_texture",        "disc_texture",
        "table_texture",      "ends_texture",      "other_side_texture", "disc_matter_texture",
        "black_body_texture", "star_lens_texture", "clearance_texture",  "ball_path_texture",
        "warp_texture",       "medium_texture",    "electron_texture",   "disc_warp_texture"};
    static constexpr int unit_of(std::string_view sampler) {
        return static_cast<int>(std::ranges::find(kSamplers, sampler) - std::begin(kSamplers));
    }
    static constexpr int kBodyUnit = static_cast<int>(std::size(kSamplers));
    static constexpr int kFreeUnit = kBodyUnit + kMostBodyImages;  // the first that is not an input's
    static void name(const gl::Program& program);                  // the units of its samplers

    explicit FrameInputs(gl::Info info) : info_(std::move(info)) {}

    // Renderer::keep_finer_sky(), limit_pictures().
    void keep_finer_sky() { keep_finer_sky_ = true; }
    void limit_pictures(int largest) { largest_picture_ = std::min(largest, info_.max_texture_size); }
    static constexpr int kLargestPicture = 16384;  // px: 1.1 GB with mip levels for an image twice as wide as high

    // All of the tables' scene but its skies, which get ready meanwhile. notes: for people, a line each. Errors: a file that cannot be read, a
    // grid that the driver cannot hold.
    Status begin(const FrameTables& tables, const Method& method, std::vector<std::string>& notes);
    // SkyTextures::finish().
    Result<bool> finish(std::vector<std::string>& notes, const std::function<bool()>& goes_on) {
        return skies_.finish(notes, goes_on);
    }
    // For lists of rays: tables of rays alone.
    void load_rays(const FrameTables& tables, const Method& method);
    // Where along its ray a thing is, for programs that ask though no picture does.
    void load_ends(const FrameTables& tables);

    void bind() const;
    TextureFacts facts() const;
    double table_ms() const { return table_ms_; }  // time of the last table of method kTable
    std::vector<TextureLine> lines(const FrameTables& tables) const;

private:
    void begin_skies(const FrameTables& tables, std::vector<std::string>& notes);
    void load_tables(const FrameTables& tables, const Method& method);
    void load_table(const FrameTables& tables, const Method& method);
    void load_heat(const FrameTables& tables);
    void load_black_body(const EffectSet& effects);
    void load_disc_warp(const FrameTables& tables);
    void load_electrons(const FrameTables& tables);

    gl::Info info_;
    int largest_picture_ = std::min(info_.max_texture_size, kLargestPicture);
    int rows_revision_ = -1, clearances_revision_ = 0;
    gl::Texture strip_, ends_, orbit_table_, ball_paths_, clearances_, table_, disc_flow_, black_body_, star_lens_,
        electrons_, disc_warp_;
    std::optional<ElectronEnergies> electrons_key_;              // of electrons_
    std::optional<std::pair<SpacetimeSpec, Method>> table_key_;  // of table_
    std::size_t table_bytes_ = 0;
    double table_ms_ = 0.0;
    WarpTexture warp_;
    MediumTexture medium_;
    std::string medium_told_;
    BodyImages body_images_;
    PictureTexture disc_;
    SkyTextures skies_;
    std::optional<SkyAsked> sky_asked_;
    SkyFaces sky_faces_;  // of it
    bool keep_finer_sky_ = false;
    std::optional<
        std::tuple<SpacetimeSpec, Sense, std::optional<double>, double, double, bool, bool, bool, EmissivitySpec>>
        flow_key_;  // of disc_flow_: its sense and radii, parts of g, its heat
    std::optional<std::tuple<double, double, DiscWarp>> disc_warp_key_;  // of disc_warp_: radii, rows
    struct Hottest {                                                     // ring of the disc, where accretion heats it
        std::optional<AccretionSpec> by;
        SpacetimeSpec about;
        Sense sense = Sense::kEastward;
        double temperature_K = 0.0;
    } hottest_;
};

// Of the numbers of rays of a list, which show no sky; of the picture that a pass works on.
inline constexpr int kListUnit = FrameInputs::unit_of("sky_texture");
inline constexpr int kPictureUnit = FrameInputs::unit_of("clearance_texture");

// The image of the disc: the scene's, or the one that ships.
Result<FittedImage> load_disc_image(const DiscSpec& disc);

}  // namespace nullscope
