// The renderer that window, file and test share. Needs a current OpenGL 3.3 core context whose functions are loaded
// (gl::load_functions); knows of no window system.
#pragma once
#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "image/image.h"
#include "render/bloom.h"
#include "render/compute_picture.h"
#include "render/frame_inputs.h"
#include "render/frame_tables.h"
#include "render/light_lattice.h"
#include "render/picture_edges.h"
#include "render/picture_layers.h"
#include "render/picture_tiles.h"
#include "render/ray_patches.h"
#include "render/star_field.h"
#include "render/uniform_blocks.h"
#include "scene/ray.h"
#include "scene/scene.h"
#include "shaderlib/passes.h"

namespace nullscope {

// A drawn picture whose bytes are on their way; RGB, display-encoded, rows from the top.
struct PictureRead {
    int width = 0, height = 0;
    std::function<Image<unsigned char>()> take;  // waits for them; once, in the context that has drawn it
};

class Renderer {
public:
    Renderer();

    // Makes ready what the scene calls for and drops what it does not: tables, textures, uniforms. Cheap when little changed:
    // a moved camera costs a strip (and an orbit table if there are objects), a turned one nothing.
    // Errors: an image that cannot be read, a camera where no static frame is, a size the driver cannot draw.
    Status prepare(const Scene& scene);
    // The same in pieces, for who has other work between them, as a sky takes up to a second to paint on one thread: first all but the skies, then
    // a piece of these at least, until goes_on() says no: whether all is ready. After an error it is begun anew.
    Status begin_prepare(const Scene& scene);
    Result<bool> prepare_skies(const std::function<bool()>& goes_on);

    // Keeps a sky finer than a frame needs, so that zooming out and in does not hitch; pictures then depend on what was drawn
    // before. For windows only.
    void keep_finer_sky() { inputs_.keep_finer_sky(); }

    // Tables of a camera whose radius changes little from picture to picture are made for less (LightPath::follows_camera). For windows, and
    // for pictures that are drawn by many cameras next to each other.
    void follow_camera(bool wanted = true) { tables_.follow_camera(wanted); }

    // The longest side of the textures of images from the next prepare() on; larger images are made smaller while they are read.
    // Without it: the driver's limit, at most kLargestPicture.
    static constexpr int kLargestPicture = FrameInputs::kLargestPicture;
    void limit_pictures(int largest) { inputs_.limit_pictures(largest); }
    // What was done to images since the last call, a line each, for people.
    std::vector<std::string> take_notes();

    // How rays are traced from the next prepare() on. Errors (by prepare): a method that the metric does not have.
    void set_method(const Method& method) { method_ = method; }
    const Method& method() const { return method_; }

    // How much of a picture may be drawn in tiles (shaderlib/passes.h), for pictures of many pixels or many of them.
    void limit_tiles(Tiles most) { most_tiles_ = most; }
    // The same, once build_next() has made all of the programs; until then Tiles::kBodies. Where light of matter is interpolated at once:
    // to compile two programs more takes less than to trace it.
    void limit_tiles_once_built(Tiles most) { most_built_tiles_ = most; }
    Tiles most_tiles() const { return std::max(most_tiles_, most_built_tiles_); }  // of both, once all is built
    // One program of those that are not there, some 0.1 s on software drivers; of a prepared scene. Returns whether one was left. Where the
    // driver compiles beside other work it returns at once, to be called again.
    bool build_next();

    // Whether the vertex shader hands on the frame's numbers (shaderlib/flat_frame.h): the same picture. As made: where the driver is llvmpipe,
    // whose frames cost less by it. Before the first picture.
    void flatten_frame(bool wanted) { flat_frame_ = wanted; }

    // Whether pictures and rays are traced by compute shaders, where a stage and the driver have them (shaderlib's computes(), gl::computes()):
    // the same functions, the same light. Else by fragments, and take_notes() says why. patches: pixels on edges too, which have more rays; each
    // of a picture's programs then has a group for all of them.
    void compute(bool wanted) { computed_.want(wanted, gl::skips_groups()); }
    void compute(bool wanted, bool patches) { computed_.want(wanted, patches); }
    const ComputePicture& computed() const { return computed_; }

    // Whether pixels on edges get more rays, where the scene calls for it; the programs are the same.
    void refine(bool wanted) { refining_ = wanted; }

    // Whether the light of matter is interpolated for pictures in motion: to 5 %, between rays 4 px apart as their neighbours allow, in place of
    // 0.5 %, with samples twice as long but in gas. The programs are the same.
    void draft(bool wanted) { lattice_.draft(wanted); }

    // How the images of point stars in a new view about a rotating hole are found, from the next prepare() on.
    void search_stars(StarField::Search search) { star_search_ = std::move(search); }
    // Whether that search is what a new view waits for; of the prepared scene.
    bool searches_stars() const { return stars_.searches(); }

    // From the next prepare() on: ray data say how long light takes, whether the scene asks for it or not, where the metric can tell.
    void want_delays(bool wanted) { tables_.want_delays(wanted); }
    // From the next prepare() on the disc is drawn where a ray has crossed its plane so often before: without the direct image, 1.
    void pass_crossings(int number) { tables_.pass_crossings(number); }

    // Automatic exposure: how far it moves to what a picture asks for, (0, 1]; 1 (at once) where pictures stand for themselves. In a
    // window 1 - exp(-dt/tau) a frame.
    void set_adaptation(double share) { adaptation_ = share; }

    // Draws the prepared scene's picture to a framebuffer of this size (0: the window). kLinear: one with float colours and alpha.
    void draw(unsigned framebuffer, int width, int height, Output output);

    // The same in pieces, each finished before the next: rows counted from the bottom.
    void draw_rows(unsigned framebuffer, int width, int height, Output output, int first, int last);

    // The same pass by pass, for who has other work between them: many drivers compile a program when it first draws, and a page stands still
    // meanwhile. Until the last one nothing else may be asked of the renderer, nor of the context but what leaves its bindings as they are.
    struct Drawing {
        std::vector<Pass> passes;
        unsigned framebuffer;
        int width, height, first, last;  // px; rows, counted from the bottom
        std::size_t next = 0;            // of the passes
        std::size_t refined = 0;         // parts of the one that refines: edges, then pixels of each number of rays
    };
    Drawing begin_rows(unsigned framebuffer, int width, int height, Output output, int first, int last);
    bool draw_next(Drawing& drawing);  // whether there is more
    // Whether the driver has compiled the programs of the next picture, for drivers that do it beside other work; each call begins one that is
    // missing. Who does not ask waits for each when it draws.
    bool is_compiled(Output output);

    // A baseline: one fetch of the sky a pixel. Needs a prepared scene with a sky.
    void draw_bare_fetch(unsigned framebuffer, int width, int height);

    // The prepared scene, read back; rows from the top.
    Image<unsigned char> picture8();  // RGB, display-encoded
    PictureRead begin_picture8();     // the same, handed over while other things are prepared and drawn
    Image<float> picture();           // RGB, linear light
    // What picture8() makes of this light, of the prepared scene's size, in the place of the scene's.
    Image<unsigned char> displayed(const Image<float>& light);
    // One layer of it, or shares. kAll comes first: which pixels have more rays is found in it (draw_layers()).
    Image<float> layer(PictureLayer shown);
    // Where rays are interpolated: the sky's direction, and 1 (escapes) or 2 (captured); elsewhere 0. Rows from the top, four channels.
    Image<float> interpolated_rays() { return interpolated(Stage::kInterpolated, Stage::kInterpolatedRays); }
    // Where they cross the disc, of tiles where they do so once: x and y in its plane, r_s, the delay of the light from there, and 1 more than the number
    // of crossings of the plane before it; elsewhere 0.
    Image<float> interpolated_places() { return interpolated(Stage::kInterpolatedDisc, Stage::kInterpolatedPlaces); }
    // Of the first thing that each pixel's ray meets, top row first, 0 where there is none or the metric has no light times (wormholes, zooms):
    // the affine parameter, r_s, of a photon of unit frequency in the camera; on a thermal disc the camera's frequency over its matter's.
    // Where there is a medium, of its light that is in front of what ends the ray: the mean place on the ray (r_s, world axes) and the
    // affine parameter there; else empty.
    struct RayDepths {
        std::vector<float> depth, g, medium;
        std::vector<Vec3> medium_place;
    };
    RayDepths ray_depths();               // want_delays(true) first
    RayFrame ray_data(int row_step = 1);  // row_step: draws and reads only rows 0, row_step, ...; the same bits there

    // Tables, numbers and program for lists of rays that start as this scene's camera; no picture of sky or disc is loaded. Needs a new
    // prepare() before the next picture. crossings: of the equatorial plane, and places, may be asked for. Errors: as prepare().
    Status prepare_list(const Scene& scene, bool crossings);
    // One draw for each 65,536 of them; as many answers as rays.
    void list_rays(const ListedCrossings& asked, std::span<const RayNumbers> rays, ListedRay* found);

    const FrameTables& tables() const { return tables_; }
    double gpu_table_ms() const { return inputs_.table_ms(); }  // time of the last table of method kTable
    int picture_programs() const;                               // of pictures, built so far while they were drawn
    const gl::Info& info() const { return info_; }

    // Part of the last picture's pixels that more rays were traced for (Effect::kRefine), 0 to 1.
    double refined_share() const;

    std::vector<TextureLine> textures() const;

private:
    using ProgramKey = ComputePicture::Key;
    ProgramKey program_key(Stage stage, Output output) const;
    ShaderSource source_of(Stage stage, Output output) const;
    const gl::Program& program(Stage stage, Output output);
    static void name_inputs(const gl::Program& program);
    const gl::Program* compute_program(Stage stage, Output output, gl::Stored stored);
    bool compute_picture(const Pass& pass, unsigned picture, int first, int last, const gl::Layer& layer);
    bool compute_patches(const Pass& pass, const gl::VertexList& pixels, const gl::Target& rays, int side);
    Image<float> interpolated(Stage drawn, Stage told);
    bool compute_nodes(Output output, const LightLattice::Tell& tell, const gl::Target& nodes, int first, int last);
    void tell_picture(const gl::Program& built, Output output) const;
    void find_tiles(Stage stage, Output output);
    bool is_compiled(Stage stage, Output output);  // begins it if it was not
    std::vector<Pass> passes_with(Tiles most, Output output) const;
    std::vector<Pass> picture_passes(Output output) const;
    template <class T, class Read>
    static Image<T> read_back(const gl::Target& target, Read read);
    gl::Target picture_target(gl::Format format) const;
    Image<float> drawn(Output output);
    void bind_inputs();
    void draw_pass(const Pass& pass, unsigned framebuffer, int width, int height);
    void find_before(const Pass& pass, int first, int last);
    void draw_rows_of(const Pass& pass, const Drawing& drawing, unsigned picture);
    void keep_light(const std::vector<Pass>& list, int width, int height, Output output);
    bool own_steps() const;
    bool scatters_or_meters() const;
    const gl::Program& picture_program(const Pass& pass);
    void draw_picture(const Pass& pass, unsigned picture, int width, int height, int first, int last,
                      const gl::Layer& layer);
    template <class Draw>
    void draw_samples(int samples, int at_once, Draw draw);
    void refine_rows(const Drawing& drawing);
    RayFrame draw_rays(const gl::Target& target, int row_step);
    std::vector<int> shader_numbers() const;

    gl::Info info_;
    FrameInputs inputs_;
    std::vector<std::string> notes_;
    gl::VertexArray empty_;
    bool flat_frame_;
    UniformBlocks blocks_;
    std::map<ProgramKey, gl::Program> programs_;
    ComputePicture computed_;
    std::map<ProgramKey, gl::Program> coming_;  // begun by is_compiled()
    Method method_;
    FrameTables tables_;
    StarField stars_;
    StarField::Search star_search_;
    Bloom bloom_;
    double adaptation_ = 1.0;
    Tiles most_tiles_ = Tiles::kBodies, most_built_tiles_ = Tiles::kNone;
    int built_ahead_ = 0;
    PictureTiles picture_tiles_;
    LightLattice lattice_;
    gl::Target linear_;  // what passes of light work on, if there are any
    gl::Format linear_format_ = gl::Format::kRgba16F;
    PictureEdges edges_;  // of linear_: pixels with more rays
    RayPatches patches_;
    bool refining_ = true;
    PictureLayer layer_ = PictureLayer::kAll;  // of Output::kLayers
    BodyText body_text_;
};

}  // namespace nullscope
