// Pictures and ray data of frames.
#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/complex.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <optional>
#include <variant>

#include "base/assets.h"
#include "command/arguments.h"
#include "command/band_pictures.h"
#include "command/fits_header.h"
#include "command/session.h"
#include "command/shot.h"
#include "command/stereo_capture.h"
#include "compare/rotation_measure.h"
#include "compare/stokes_measures.h"
#include "image/image_formats.h"
#include "image/picture_texts.h"
#include "module/arrays.h"
#include "module/call.h"
#include "module/module.h"
#include "reference/reference.h"
#include "render/display.h"
#include "scene/projection.h"
#include "scenefile/photo_sphere.h"
#include "scenefile/picture_scene.h"
#include "telescope/flux.h"

namespace nullscope::python {
namespace {

struct Asked {
    std::string size, renderer, method, context;
    std::optional<double> max_error, time;
    std::optional<int> samples, frame;
};

Status check(const Asked& asked) {
    if (asked.renderer != "gl" && asked.renderer != "reference")
        return bad_key("renderer", fmt::format("'{}' is none of them", asked.renderer), "gl, reference");
    if (asked.context != "auto" && asked.context != "egl" && asked.context != "osmesa")
        return bad_key("context", fmt::format("'{}' is none of them", asked.context), "auto, egl, osmesa");
    if (asked.samples && (*asked.samples < 1 || *asked.samples > 16))
        return bad_key("samples", fmt::format("{} is out of range", *asked.samples), "[1, 16]");
    if (asked.max_error && !(*asked.max_error >= 1e-12 && *asked.max_error <= 1e6))
        return bad_key("max_error", fmt::format("{} is out of range", *asked.max_error), "[1e-12, 1e6]");
    if (asked.time && !(*asked.time >= -1e9 && *asked.time <= 1e9))
        return bad_key("time", fmt::format("{} is out of range", *asked.time), "[-1e9, 1e9]");
    if (asked.renderer == "reference" && (asked.method != "auto" || asked.max_error || asked.context != "auto"))
        return bad_input("method, max_error and context: the reference tracer does not use the shader or OpenGL",
                         "with renderer=\"gl\"");
    return Done{};
}

// The scene as asked for, with its path; and the frame of it.
Result<cli::Shot> shot_of(const Scene& scene, const Asked& asked, const cli::Listener& listener) {
    if (Status good = check(asked); !good) return good.error();
    TRY(sized, cli::sized(scene, asked.size));
    cli::Shot shot{std::move(*sized)};
    if (asked.time) shot.scene.time = *asked.time;
    if (asked.samples && asked.renderer == "gl") shot.scene.picture.samples = *asked.samples;
    if (shot.scene.path) {
        TRY(path, CameraPath::make(shot.scene));
        shot.path = std::move(*path);
    }
    const int frames = shot.path ? shot.path->frames() : 1, frame = asked.frame.value_or(0);
    if (frame < 0 || frame >= frames)
        return bad_key("frame", fmt::format("{}: the path has {} frames", frame, shot.path ? frames : 0),
                       fmt::format("[0, {}]", frames - 1));
    if (asked.renderer == "gl") {
        TRY(method, cli::chosen_method(asked.method, asked.max_error, shot.scene, listener));
        shot.method = *method;
    }
    return shot;
}

// Kept in its thread, where its context is current: the next picture finds the programs and the sky.
struct Kept {
    std::string context;
    cli::Session session;
};
std::optional<Kept>& kept() {
    thread_local std::optional<Kept> session;
    return session;
}

// draw(session or null, shot, frame) with the method set; what goes wrong in between leaves no session.
template <class Draw>
auto with_session(const cli::Shot& shot, const Asked& asked, const Draw& draw) -> decltype(draw(nullptr)) {
    if (asked.renderer != "gl") return draw(nullptr);
    TRY(session, session_of(asked.context));
    (*session)->renderer->set_method(shot.method);
    (*session)->renderer->limit_tiles(cli::worth_tiles(shot, 1) ? Tiles::kTraced : Tiles::kBodies);
    try {
        return draw(*session);
    } catch (...) {
        forget_session();
        throw;
    }
}

template <class T>
auto image_array(Image<T>& image) {
    const auto height = static_cast<std::size_t>(image.height), width = static_cast<std::size_t>(image.width);
    return array_of(std::move(image.data), {height, width, static_cast<std::size_t>(image.channels)});
}

// in_bands: as a large picture is drawn, which then has no Stokes parameters. camera: becomes the picture's.
cli::Captured captured(const Scene& scene, const Asked& asked, const nb::object& progress, bool in_bands,
                       CameraSpec& camera) {
    return run(progress, [&](Watch& watch) -> Result<cli::Captured> {
        cli::DrawOptions options;
        options.listener = watch.listener();
        options.in_bands = in_bands, options.stokes = true, options.bands = in_bands;
        if (asked.renderer == "reference") options.samples = asked.samples;
        TRY(shot, shot_of(scene, asked, options.listener));
        TRY(stereo, cli::check_stereo(shot->scene, options, false));
        if (shot->path) {
            const int frame = asked.frame.value_or(0);
            TRY(eyes, cli::check_stereo_frames(*shot->path, shot->scene, frame, frame + 1));
        }
        return with_session(*shot, asked, [&](cli::Session* session) {
            const Exposure shown = cli::exposure_in(*shot, 0.0, asked.frame.value_or(0));
            camera = shown.scene.camera;
            return cli::draw_shot(*shot, session, shown, options, false);
        });
    });
}

template <class T>
nb::object array_or_none(Image<T>& image) {
    return image.empty() ? nb::object(nb::none()) : nb::cast(image_array(image));
}

// Frequency, light, Stokes parameters or None, Jy a pixel of light 1 or None, of each.
nb::list bands_of(const Scene& scene, bool several, std::vector<BandPicture>& bands) {
    nb::list list;
    const auto units = cli::band_units(scene, several);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        nb::object jansky = nb::none();
        if (units[i]) jansky = nb::cast(units[i]->jansky);
        list.append(nb::make_tuple(bands[i].frequency_GHz, image_array(bands[i].light), array_or_none(bands[i].stokes),
                                   jansky));
    }
    return list;
}

// Light; Stokes parameters and the net fraction, the resolved one and beta_2, each None where there are none; bands, and of polarised ones the
// rotation measure of each pixel or None.
nb::tuple capture(const Scene& scene, const Asked& asked, const nb::object& progress) {
    CameraSpec camera;
    cli::Captured drawn = captured(scene, asked, progress, true, camera);
    nb::object measures = nb::none();
    if (!drawn.stokes.empty()) {
        const auto [x, y] = line_of_sight(camera);
        const StokesMeasures found = stokes_measures(drawn.stokes, x, y);
        measures = nb::make_tuple(found.net, found.resolved, found.beta_2);
    }
    Image<float> rotation = rotation_measure_image(drawn.bands);
    Scene seen = scene;
    seen.camera = camera;
    const nb::list bands = bands_of(seen, false, drawn.bands);
    return nb::make_tuple(image_array(drawn.linear), array_or_none(drawn.stokes), measures, bands,
                          array_or_none(rotation));
}

// Twelve doubles a pixel, in the order of the channels.
auto raydata(const Scene& scene, const Asked& asked, const nb::object& progress) {
    auto frame = run(progress, [&](Watch& watch) -> Result<RayFrame> {
        cli::DrawOptions options;
        options.listener = watch.listener();
        options.raydata = true;
        TRY(shot, shot_of(scene, asked, options.listener));
        if (shot->scene.split)
            return bad_input("--raydata works for one spacetime only; leave out [split] of the scene");
        TRY(stereo, cli::check_stereo(shot->scene, options, false));
        const Scene now = cli::scene_at(*shot, 0.0, asked.frame.value_or(0));
        return with_session(*shot, asked, [&](cli::Session* session) -> Result<RayFrame> {
            if (session == nullptr) {
                const long long pixels = static_cast<long long>(now.camera.width) * now.camera.height;
                return reference::trace_frame(now, options.listener.progress("reference ray data", pixels));
            }
            cli::begin_drawing(*session, options);
            if (Status ready = session->renderer->prepare(now); !ready) return ready.error();
            cli::tell_notes(*session, options.listener);
            return session->renderer->ray_data();
        });
    });
    std::vector<double> values;
    values.reserve(frame.pixels.size() * 12);
    for (const RayPixel& p : frame.pixels)
        values.insert(values.end(), {static_cast<double>(p.fate), p.sky.x, p.sky.y, p.sky.z, p.g, p.delay, p.angle,
                                     static_cast<double>(p.order), static_cast<double>(p.hit), p.u, p.v, p.w});
    return array_of(std::move(values),
                    {static_cast<std::size_t>(frame.height), static_cast<std::size_t>(frame.width), 12});
}

using Linear = nb::ndarray<const float, nb::shape<-1, -1, 3>, nb::c_contig, nb::device::cpu>;

// As the command line shows the reference's pictures, without letters.
Image<unsigned char> displayed(const Scene& scene, const Linear& light) {
    Image<float> image(static_cast<int>(light.shape(1)), static_cast<int>(light.shape(0)), 3);
    if (image.empty()) throw Refused(bad_input("a picture without pixels"));
    std::copy_n(light.data(), image.data.size(), image.data.begin());
    return display_encoded(image, scene.camera.exposure_ev, scene.picture);
}

Asked asked_of(const nb::dict& options) {
    const auto take = [&]<class T>(const char* name, T& to) {
        if (!options.contains(name) || nb::handle(options[name]).is_none()) return;
        if (is_boolean(options[name]) || !nb::try_cast(nb::handle(options[name]), to))
            throw Refused(
                bad_key(name, std::string(Py_TYPE(nb::handle(options[name]).ptr())->tp_name) + " is of another kind",
                        std::is_same_v<T, std::string>          ? "text"
                        : std::is_same_v<T, std::optional<int>> ? "a whole number"
                                                                : "a number"));
    };
    Asked asked{{}, "gl", "auto", "auto", {}, {}, {}, {}};
    take("size", asked.size), take("renderer", asked.renderer), take("method", asked.method);
    take("context", asked.context), take("max_error", asked.max_error), take("time", asked.time);
    take("samples", asked.samples), take("frame", asked.frame);
    return asked;
}

// Of a picture that there is: without what only drawing needs.
Result<cli::Shot> shown_shot(const Scene& scene, const Asked& asked) {
    TRY(sized, cli::sized(scene, asked.size));
    cli::Shot shot{std::move(*sized)};
    if (asked.time) shot.scene.time = *asked.time;
    if (shot.scene.path) {
        TRY(path, CameraPath::make(shot.scene));
        shot.path = std::move(*path);
    }
    return shot;
}

// The XMP of a panorama; none of an array of another size than was drawn.
std::string packet_of(const cli::Shot& shot, int frame, const Linear& light) {
    const CameraSpec camera = cli::scene_at(shot, 0.0, frame).camera;
    const bool whole = light.shape(1) == static_cast<std::size_t>(camera.width) &&
                       light.shape(0) == static_cast<std::size_t>(camera.height);
    return whole && !shot.scene.split ? photo_sphere_packet(camera) : "";
}

nb::dict on_sky(const Scene& scene, const Asked& asked) {
    const cli::Shot shot = value_of(shown_shot(scene, asked));
    const Scene now = cli::scene_at(shot, 0.0, asked.frame.value_or(0));
    const bool several = shot.scene.split || now.camera.stereo != Stereo::kOff;
    FitsHeader header;
    cli::add_coordinates(now, several, header);
    cli::add_scene(now, header);
    header.cards.push_back({"WIDTH", static_cast<long long>(now.camera.width), ""});
    header.cards.push_back({"HEIGHT", static_cast<long long>(now.camera.height), ""});
    if (const auto flux = flux_unit(now, several)) {
        header.cards.push_back({"FREQ", 1e9 * flux->frequency_GHz, ""});
        header.cards.push_back({"JANSKY", flux->jansky, ""});
        header.cards.push_back({"LUMINANC", flux->luminance_jansky, ""});
        header.cards.push_back({"CHANNEL", static_cast<long long>(flux->channel), ""});
    }
    nb::dict cards;
    for (const FitsCard& card : header.cards)
        cards[card.keyword.c_str()] = std::visit([](const auto& value) { return nb::cast(value); }, card.value);
    return cards;
}

}  // namespace

Result<cli::Session*> session_of(const std::string& context) {
    if (kept() && kept()->context == context) return &kept()->session;
    kept().reset();
    TRY(opened, cli::open_session(context));
    kept().emplace(context, std::move(*opened));
    return &kept()->session;
}

void forget_session() { kept().reset(); }

namespace {

void add_astronomy(nb::module_& m) {
    m.def(
        "stokes",
        [](const Scene& scene, const nb::dict& options, const nb::object& progress) {
            CameraSpec camera;
            cli::Captured drawn = captured(scene, asked_of(options), progress, false, camera);
            return image_array(drawn.stokes);
        },
        nb::arg("scene"), nb::arg("options"), nb::arg("progress").none(),
        "I, Q, U, V as in an EXR, shape (height, width, 4); (0, 0, 0) where light is not polarised.");
    m.def(
        "on_sky", [](const Scene& scene, const nb::dict& options) { return on_sky(scene, asked_of(options)); },
        nb::arg("scene"), nb::arg("options"),
        "Keywords of the picture's FITS file, of coordinates and scene; WIDTH and HEIGHT; of a flux FREQ, and JANSKY, "
        "Jy a pixel of light 1 "
        "in the plane CHANNEL, and LUMINANC, of luminance 1.");
}

}  // namespace

void add_picture(nb::module_& m) {
    add_astronomy(m);
    m.def(
        "capture",
        [](const Scene& scene, const nb::dict& options, const nb::object& progress) {
            return capture(scene, asked_of(options), progress);
        },
        nb::arg("scene"), nb::arg("options"), nb::arg("progress").none());
    m.def(
        "raydata",
        [](const Scene& scene, const nb::dict& options, const nb::object& progress) {
            return raydata(scene, asked_of(options), progress);
        },
        nb::arg("scene"), nb::arg("options"), nb::arg("progress").none());
    m.def(
        "displayed",
        [](const Scene& scene, const Linear& light) {
            Image<unsigned char> image = displayed(scene, light);
            return image_array(image);
        },
        nb::arg("scene"), nb::arg("light"),
        "8 bits a colour, shape (height, width, 3): bloom, exposure, tone curve, sRGB.");
    m.def(
        "png",
        [](const Scene& scene, const Linear& light, const std::string& options, const nb::dict& asked) {
            PictureOrigin origin{scene, {".", assets_directory() / "scenes"}};
            origin.options = options, origin.version = NULLSCOPE_VERSION;
            const Asked drawn = asked_of(asked);
            const cli::Shot shot = value_of(shown_shot(scene, drawn));
            const int frame = drawn.frame.value_or(0);
            origin.times = cli::times_in(shot, 0.0, {frame, frame + 1});
            auto words = value_of(picture_words(origin));
            if (std::string packet = packet_of(shot, frame, light); !packet.empty())
                words[kXmpWord] = std::move(packet);
            words.insert({{"Title", scene.name}, {"Software", "nullscope " NULLSCOPE_VERSION}});
            const std::string bytes = value_of(encode_png(displayed(scene, light), words));
            return nb::bytes(bytes.data(), bytes.size());
        },
        nb::arg("scene"), nb::arg("light"), nb::arg("options") = "", nb::arg("asked") = nb::dict(),
        "The same as the bytes of a PNG file. options: of the command line, with which it was drawn; asked: of "
        "capture().");
    m.def("forget_session", forget_session,
          "Closes the OpenGL context that pictures of this thread keep, and frees what is in it.");
}

}  // namespace nullscope::python
