// What Renderer draws to be read back: pictures in floats and bytes, ray data, lists of rays.
#include <algorithm>
#include <memory>
#include <utility>

#include "gl/pixel_read.h"
#include "render/ray_list_target.h"
#include "render/renderer.h"
#include "scene/bodies.h"

namespace nullscope {

namespace {

// RGB of four channels; rows from the top, of rows from the bottom.
template <class T>
Image<T> turned(int w, int h, const T* rgba) {
    Image<T> image(w, h, 3);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            std::copy_n(rgba + 4 * (static_cast<std::size_t>(h - 1 - y) * w + x), 3, image.at(x, y));
    return image;
}

}  // namespace

// The target's colours, read by `read`; rows from the top.
template <class T, class Read>
Image<T> Renderer::read_back(const gl::Target& target, Read read) {
    std::vector<T> rgba(static_cast<std::size_t>(target.width) * target.height * 4);
    read(target, rgba.data());
    return turned(target.width, target.height, rgba.data());
}

gl::Target Renderer::picture_target(gl::Format format) const {
    return gl::make_target(tables_.plan().scene.camera.width, tables_.plan().scene.camera.height, format);
}

Image<unsigned char> Renderer::picture8() {
    const gl::Target target = picture_target(gl::Format::kRgba8);
    draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay);
    return read_back<unsigned char>(target, gl::read_rgba8);
}

PictureRead Renderer::begin_picture8() {
    const gl::Target target = picture_target(gl::Format::kRgba8);
    draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay);
    const auto read = std::make_shared<gl::PixelRead>(target);  // functions are copied
    return {target.width, target.height, [read] {
                Image<unsigned char> image;
                read->take([&](const unsigned char* rgba) { image = turned(read->width(), read->height(), rgba); });
                return image;
            }};
}

Image<float> Renderer::picture() { return drawn(Output::kLinear); }

Image<float> Renderer::drawn(Output output) {
    const gl::Target target = picture_target(gl::Format::kRgba32F);
    draw(target.framebuffer.id(), target.width, target.height, output);
    return read_back<float>(target, [](const gl::Target& from, float* out) { gl::read_rgba32f(from, 0, out); });
}

Image<unsigned char> Renderer::displayed(const Image<float>& light) {
    const gl::Target target = picture_target(gl::Format::kRgba8);
    const int w = target.width, h = target.height;
    std::vector<float> rgba(static_cast<std::size_t>(w) * h * 4, 1.0f);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            std::copy_n(light.at(x, h - 1 - y), 3, rgba.data() + 4 * (static_cast<std::size_t>(y) * w + x));
    gl::Target given{w, h, {}, {}};
    given.colours.push_back(gl::make_number_texture(w, h, 4, rgba.data(), true));
    std::swap(linear_, given);
    bind_inputs();
    if (scatters_or_meters()) bloom_.resize(w, h);
    for (const Stage stage : {Stage::kBloomDown, Stage::kBloomUp, Stage::kMeter, Stage::kDevelop}) {
        const bool wanted = stage == Stage::kBloomUp     ? tables_.effects().contains(Effect::kBloom)
                            : stage == Stage::kMeter     ? tables_.effects().contains(Effect::kAutoExposure)
                            : stage == Stage::kBloomDown ? scatters_or_meters()
                                                         : true;
        if (wanted) draw_pass({stage, Output::kDisplay, {}, {}}, target.framebuffer.id(), w, h);
    }
    std::swap(linear_, given);
    return read_back<unsigned char>(target, gl::read_rgba8);
}

Image<float> Renderer::layer(PictureLayer shown) {
    layer_ = shown;
    Image<float> image = drawn(Output::kLayers);
    layer_ = PictureLayer::kAll;
    return image;
}

// Of a picture that a stage has a part in, what another one tells of it.
Image<float> Renderer::interpolated(Stage drawn, Stage told) {
    const int w = tables_.plan().scene.camera.width, h = tables_.plan().scene.camera.height;
    Image<float> image(w, h, 4);
    const std::vector<Pass> list = passes_with(Tiles::kInterpolated, Output::kLinear);
    if (std::ranges::find(list, drawn, &Pass::stage) == list.end()) return image;
    const gl::Target target = gl::make_target(w, h, gl::Format::kRgba32F);
    gl::clear(target);
    picture_tiles_.resize(list, w, h, tables_.effects());
    bind_inputs();
    for (const Stage stage : {Stage::kRays, Stage::kTilesInterpolated}) find_tiles(stage, Output::kLinear);
    gl::draw_tiles(program(told, Output::kLinear), empty_, target.framebuffer.id(), w, h, tile_side(tables_.effects()),
                   0, h);
    for (int y = 0; y < h; ++y) gl::read_rgba32f_row(target, 0, h - 1 - y, image.at(0, y));
    return image;
}

Renderer::RayDepths Renderer::ray_depths() {
    const int w = tables_.plan().scene.camera.width, h = tables_.plan().scene.camera.height;
    const bool medium = has_medium(tables_.effects());
    const gl::Target target = gl::make_target(w, h, gl::Format::kRgba32F, medium ? 2 : 1);
    inputs_.load_ends(tables_);
    const gl::Program& built = program(Stage::kRayDepth, Output::kLinear);
    bind_inputs();
    gl::draw_fullscreen(built, empty_, target.framebuffer.id(), w, h);
    RayDepths depths;
    std::vector<float> row(static_cast<std::size_t>(w) * 4);
    for (int y = 0; y < h; ++y) {
        gl::read_rgba32f_row(target, 0, h - 1 - y, row.data());
        for (std::size_t i = 0; i < row.size(); i += 4) depths.depth.push_back(row[i]), depths.g.push_back(row[i + 1]);
        if (!medium) continue;
        gl::read_rgba32f_row(target, 1, h - 1 - y, row.data());
        for (std::size_t i = 0; i < row.size(); i += 4) {
            depths.medium_place.push_back({row[i], row[i + 1], row[i + 2]});
            depths.medium.push_back(row[i + 3]);
        }
    }
    return depths;
}

RayFrame Renderer::ray_data(int row_step) {
    return draw_rays(
        gl::make_target(tables_.plan().scene.camera.width, tables_.plan().scene.camera.height, gl::Format::kRgba32F, 3),
        row_step);
}

void Renderer::list_rays(const ListedCrossings& asked, std::span<const RayNumbers> rays, ListedRay* found) {
    const gl::Program* computed = compute_program(Stage::kRayList, Output::kLinear, {});
    const gl::Program& built = computed != nullptr ? *computed : program(Stage::kRayList, Output::kLinear);
    gl::set_integer(built, "listed_first", asked.first);
    gl::set_integer(built, "listed_most", asked.most);
    RayListTarget target(asked, tables_.effects().contains(Effect::kDisc));
    for (std::span<const RayNumbers> rest = rays; !rest.empty();) {
        const auto now = rest.first(std::min(kRaysADraw, rest.size()));
        const gl::Texture numbers = target.begin(now);
        bind_inputs();
        gl::bind_texture_2d(kListUnit, numbers);
        if (computed != nullptr)
            gl::compute_rows(built, target.target(), kTileSide, 0, target.rows());
        else
            gl::draw_rows(built, empty_, target.target().framebuffer.id(), target.target().width,
                          target.target().height, 0, target.rows());
        target.read(shader_numbers(), found);
        rest = rest.subspan(now.size()), found += now.size();
    }
}

// Of bodies, in the shader's order.
std::vector<int> Renderer::shader_numbers() const {
    std::vector<int> numbers;
    for (const std::size_t i : shader_bodies(tables_.plan().scene))
        numbers.push_back(object_number(tables_.plan().scene, i));
    return numbers;
}

RayFrame Renderer::draw_rays(const gl::Target& target, int row_step) {
    const int w = target.width, h = target.height, rows = (h - 1) / row_step + 1;
    inputs_.load_ends(tables_);
    // A group of threads has several rows.
    const gl::Program* computed = row_step == 1 ? compute_program(Stage::kRayData, Output::kLinear, {}) : nullptr;
    const gl::Program& built = computed != nullptr ? *computed : program(Stage::kRayData, Output::kLinear);
    bind_inputs();
    if (computed != nullptr)
        gl::compute_rows(built, target, kTileSide, 0, h);
    else if (row_step == 1)
        gl::draw_fullscreen(built, empty_, target.framebuffer.id(), w, h);
    else
        for (int y = 0; y < h; y += row_step)
            gl::draw_rows(built, empty_, target.framebuffer.id(), w, h, h - 1 - y, h - y);
    RayFrame frame{w, h, std::vector<RayPixel>(static_cast<std::size_t>(w) * rows), row_step};
    const bool counted = counts_steps(method_);
    const std::vector<int> numbers = shader_numbers();
    std::vector<float> values(static_cast<std::size_t>(w) * 4);
    for (int attachment = 0; attachment < 3; ++attachment) {
        for (int y = 0; y < h; y += row_step) {
            gl::read_rgba32f_row(target, attachment, h - 1 - y, values.data());
            const float* row = values.data();
            for (int x = 0; x < w; ++x, row += 4) {
                RayPixel& pixel = frame.pixels[frame.index(x, y)];
                if (attachment == 0) {
                    pixel.fate = static_cast<Fate>(static_cast<int>(row[0]));
                    pixel.sky = {row[1], row[2], row[3]};
                } else if (attachment == 1) {
                    pixel.g = row[0], pixel.delay = row[1], pixel.angle = row[2];
                    pixel.order = static_cast<int>(row[3]);
                } else {
                    pixel.hit = static_cast<int>(row[0]);
                    if (pixel.hit >= kFirstBody) pixel.hit = numbers[static_cast<std::size_t>(pixel.hit - kFirstBody)];
                    pixel.u = row[1], pixel.v = row[2], pixel.w = row[3];
                    if (counted && pixel.hit == 0) pixel.steps = static_cast<int>(std::exchange(pixel.u, 0.0));
                }
            }
        }
    }
    return frame;
}

}  // namespace nullscope
