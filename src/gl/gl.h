// OpenGL objects with owners. A GL failure is a GlError with the driver's log; nothing here knows of scenes.
// Every object must die while the context that made it is current.
#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace nullscope::gl {

struct GlError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// throws GlError. In a page, where there are no exceptions, it ends the view.
[[noreturn]] void fail(const std::string& what);

// Loads the functions of the current context. throws GlError if it is older than 3.3.
void load_functions(void (*(*get_proc_address)(const char*, void*))(), void* user);

// The state that every context of ours begins with; load_functions does it for the one that is current.
void prepare_context();

struct Info {
    std::string version, renderer, vendor, glsl;
    int max_texture_size = 0, max_renderbuffer_size = 0, max_layers = 0;
    int max_varying = 0;  // numbers that a vertex shader may hand on
};
Info info();
void check(const char* where);  // throws GlError if glGetError has something to say

// Owns one GL name of a kind; movable.
template <void (*Delete)(unsigned)>
class Name {
public:
    Name() = default;
    explicit Name(unsigned id) : id_(id) {}
    ~Name() { reset(); }
    Name(Name&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        if (this != &other) reset(), id_ = std::exchange(other.id_, 0);
        return *this;
    }
    unsigned id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }

private:
    void reset() {
        if (id_ != 0) Delete(id_);
        id_ = 0;
    }
    unsigned id_ = 0;
};
void delete_program(unsigned id);
void delete_texture(unsigned id);
void delete_buffer(unsigned id);
void delete_framebuffer(unsigned id);
void delete_vertex_array(unsigned id);
void delete_renderbuffer(unsigned id);
void delete_query(unsigned id);
using Program = Name<delete_program>;
using Texture = Name<delete_texture>;
using Buffer = Name<delete_buffer>;
using Framebuffer = Name<delete_framebuffer>;
using VertexArray = Name<delete_vertex_array>;
using Renderbuffer = Name<delete_renderbuffer>;
using Query = Name<delete_query>;

// throws GlError with the driver's log, explained.
Program make_program(const std::string& vertex, const std::string& fragment);
// The same in two steps, for drivers that compile beside other work: begun, and finished once it is_compiled (where the driver cannot tell:
// at once; finishing waits).
Program begin_program(const std::string& vertex, const std::string& fragment);
bool is_compiled(const Program& program);
void finish_program(const Program& program, const std::string& vertex, const std::string& fragment);
// A driver's log of a shader with files and lines as they are written ("0:70012(3): error" becomes "core/trig.glsl:12(3):
// error"), and behind each line the line of the source that it is about. The source has lines from 10000 F on for its file
// F, and a comment "// NAME" before the first "#line" of each.
std::string explained_log(const std::string& log, const std::string& source);
void bind_uniform_block(const Program& program, const char* block, unsigned binding);

// Numbers in 1 or 4 channels, float, one level; linear: the hardware's own filter (its weights may have 8 bits), else nearest.
Texture make_number_texture(int width, int height, int channels, const float* values, bool linear);
// Layers of numbers in 4 channels, float, that are fetched. throws GlError if they are more, or larger, than the driver takes.
// nullptr: not set yet.
Texture make_number_layers(int width, int height, int layers, const float* values);
// Rows of all its layers, from `row` on.
void set_number_rows(const Texture& texture, int row, int width, int height, int layers, const float* values);
// A picture, linear light, as RGBA16F with all its mip levels, each side half of the one before (at least 1, rounded down); clamped, trilinear.
struct HalfTexels {
    int width, height;
    const std::uint16_t* rgba;  // half floats
};
Texture make_picture_texture(const std::vector<HalfTexels>& levels);
// Colours for the eye: RGBA8 as they are, nearest, one level, top row first.
Texture make_rgba8_texture(int width, int height, const unsigned char* rgba);
// Skies: texels that come packed, by fill_sky, of R11F_G11F_B10F or (halves) RGBA16F. Trilinear; each layer is a face. throws GlError where the driver has no memory for it.
Texture make_sky(int size, int levels, int layers, bool halves);
struct SkyTexels {
    int layer, level, first_row, rows, width;
    bool halves;
    const void* texels;
};
void fill_sky(const Texture& texture, const SkyTexels& texels);

Buffer make_uniform_buffer(std::size_t bytes);
void upload_uniforms(const Buffer& buffer, const void* data, std::size_t bytes);
void bind_uniforms(const Buffer& buffer, unsigned binding);

// Vertices of float attributes, given once: attribute i has sizes[i] floats, in the order of the data.
struct VertexList {
    Buffer data;
    VertexArray layout;
    int count = 0;
};
VertexList make_vertex_list(const std::vector<float>& values, const std::vector<int>& sizes);

enum class Format { kRgba8, kRgba16F, kRgba32F };
// A framebuffer with `count` colour textures of one format.
struct Target {
    int width = 0, height = 0;
    std::vector<Texture> colours;
    Framebuffer framebuffer;
};
Target make_target(int width, int height, Format format, int count = 1);
// Of linear light that is filtered: floats, or what a browser can filter, halves, which end at 65504.
Format filtered_light();
std::size_t bytes_of(Format format);  // of a texel

// Marks on a target's pixels: what is drawn can be limited to the marked ones. The target must outlive them.
struct Marks {
    int width = 0, height = 0;
    unsigned of = 0;       // the target's framebuffer
    Texture seen;          // the same to be read
    Renderbuffer stencil;  // the target has it too
    Framebuffer framebuffer;
};
Marks make_marks(const Target& target);
void clear_marks(const Marks& marks);
// Marks, in the rows from first (counted from the bottom) up to but not including last, the pixels whose fragments the program does not
// discard; it writes 1 to them. seen: of these rows, a byte a pixel, above 0 where it is marked. Waits for the driver.
void mark_rows(const Program& program, const VertexArray& empty, const Marks& marks, int first, int last,
               unsigned char* seen);

void clear(const Target& target);                                                  // to zeros
void read_rgba8(const Target& target, unsigned char* out);                         // bottom row first
void read_rgba32f(const Target& target, int attachment, float* out);               // bottom row first
void read_rgba32f_row(const Target& target, int attachment, int row, float* out);  // row: from the bottom

VertexArray make_vertex_array();
// Draws one triangle over the viewport of the bound framebuffer. framebuffer 0: the window.
// share below 1: what is there moves so far towards what is drawn.
void draw_fullscreen(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height,
                     double share = 1.0);
// Which pixels (Marks) are drawn.
enum class Marked { kAny, kNot, kOnly };
// How what is drawn changes what is there.
struct Layer {
    double share = 1.0;     // below 1: so much of it is added to what is there ...
    bool replaces = false;  // ... or replaces it
    Marked marked = Marked::kAny;
};
// Of it the rows from first (counted from the bottom) up to but not including last.
void draw_rows(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height, int first,
               int last, const Layer& layer = {});
// Of it the tiles of `side` px, each a point of the program's (by its number, from below and from the left), that have a part in these rows.
void draw_tiles(const Program& program, const VertexArray& empty, unsigned framebuffer, int width, int height, int side,
                int first, int last, const Layer& layer = {});
// Points with attributes.
void draw_listed_points(const Program& program, const VertexList& vertices, unsigned framebuffer, int width, int height,
                        const Layer& layer = {});
// Adds points to what is in the framebuffer: colour += colour of the point x alpha that is there; alpha stays. The viewport is
// `margin` px wider on every side, so that a point whose middle is outside still shows its rim.
// copies: of every point, numbered by gl_InstanceID.
void draw_points(const Program& program, const VertexList& vertices, int count, int copies, unsigned framebuffer,
                 int width, int height, int margin);
void set_integer(const Program& program, const char* uniform,
                 int value);  // a sampler's is its unit; silent if there is none
void bind_texture_2d(int unit, const Texture& texture);
void bind_texture_layers(int unit, const Texture& texture);
void set_linear(const Texture& texture);  // of a 2D texture without mip levels: filtered between texels
// Copies a colour texture over a framebuffer of another size or the same (0: the window), or from column to_x on into it. The texture
// may be another context's. Columns of the framebuffer before left_edge stay as they are.
void blit(unsigned texture, int width, int height, unsigned framebuffer, int to_width, int to_height, int to_x = 0,
          int left_edge = 0);
void finish();
// Asks for the driver's time when everything before is done; from one to the other, ms, waiting for both. A driver without a clock: 0.
Query timestamp();
double milliseconds(const Query& from, const Query& to);

}  // namespace nullscope::gl
