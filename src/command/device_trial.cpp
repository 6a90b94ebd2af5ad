#include "command/device_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <type_traits>

#include "base/stopwatch.h"
#include "command/child.h"
#include "command/json.h"
#include "command/session.h"
#include "gl/driver_death.h"
#include "platform/usage.h"

namespace nullscope::cli {
namespace {

constexpr double kSlowPicture_ms = 1e4;  // such a picture is not drawn again
constexpr int kLaterPictures = 3;

// In a child: {"failure": why} in the place of what `ask` could not find out.
template <class Ask>
int told(int pipe, const Ask& ask) {
    gl::leave_death_unnamed();
    const auto fail = [&](const std::string& why) { write_all(pipe, Json{{"failure", why}}.dump() + "\n"); };
    try {
        if (const Status asked = ask(); !asked) fail(asked.error().message());
    } catch (const std::exception& error) {
        fail(error.what());
    }
    return 0;
}

// What a child has told: a line of JSON, and bytes.
struct Told {
    Json json;
    std::string_view bytes{};
};

Told told_by(const ChildAnswer& answer) {
    const std::size_t end = answer.bytes.find('\n');
    Json json = end == std::string::npos ? Json() : Json::parse(answer.bytes.substr(0, end), nullptr, false);
    if (!answer.end.empty() || json.is_discarded() || json.is_null())
        return {Json{{"failure", fmt::format("the driver ended its process: {}", answer.end)}}};
    return {std::move(json), std::string_view(answer.bytes).substr(end + 1)};
}

Status tell_facts(int pipe, int device) {
    TRY(session, open_session(ContextChoice::of_device(device)));
    const gl::Info& info = session->renderer->info();
    const gl::Abilities can = gl::abilities();
    write_all(pipe, Json{{"version", info.version},
                         {"renderer", info.renderer},
                         {"vendor", info.vendor},
                         {"glsl", info.glsl},
                         {"texture", info.max_texture_size},
                         {"target", info.max_renderbuffer_size},
                         {"layers", info.max_layers},
                         {"software", can.software},
                         {"vector_bits", can.vector_bits},
                         {"computes", can.computes},
                         {"float_targets", can.float_targets},
                         {"timer", can.timer}}
                            .dump(-1, ' ', false, Json::error_handler_t::replace) +
                        "\n");
    return Done{};
}

DeviceFacts facts_of(const Json& json) {
    DeviceFacts facts;
    if (json.contains("failure")) return facts.failure = json["failure"], facts;
    facts.info = {json["version"], json["renderer"], json["vendor"], json["glsl"],
                  json["texture"], json["target"],   json["layers"]};
    facts.can = {json["software"], json["vector_bits"], json["computes"], json["float_targets"], json["timer"]};
    return facts;
}

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

template <class T>
bool take_bytes(std::string_view& bytes, std::vector<T>& values) {
    const std::size_t size = values.size() * sizeof(T);
    if (bytes.size() < size) return false;
    std::memcpy(static_cast<void*>(values.data()), bytes.data(), size);
    bytes.remove_prefix(size);
    return true;
}

Status tell_trial(int pipe, int device, const Scene& scene) {
    TRY(session, open_session(ContextChoice::of_device(device)));
    Renderer& renderer = *session->renderer;
    const auto core_ms = [] { return 1e3 * platform::process_cpu_seconds(); };
    const Stopwatch first;
    const double begun_core_ms = core_ms();
    TRY(ready, renderer.prepare(scene));
    const Image<unsigned char> picture = renderer.picture8();
    const double first_ms = first.ms();
    double frame_ms = first_ms, frame_core_ms = core_ms() - begun_core_ms;
    const gl::Target target = gl::make_target(scene.camera.width, scene.camera.height, gl::Format::kRgba8);
    for (int i = 0; i < kLaterPictures && first_ms < kSlowPicture_ms; ++i) {
        gl::finish();
        const double later_core_ms = core_ms();
        const Stopwatch later;
        renderer.draw(target.framebuffer.id(), target.width, target.height, Output::kDisplay);
        gl::finish();
        frame_ms = std::min(frame_ms, later.ms());
        frame_core_ms = std::min(frame_core_ms, core_ms() - later_core_ms);
    }
    const RayFrame rays = renderer.ray_data(kTrialRowStep);
    write_all(
        pipe,
        Json{{"first_ms", first_ms}, {"frame_ms", frame_ms}, {"core_ms", frame_core_ms}, {"pixels", rays.pixels.size()}}
                .dump() +
            "\n");
    write_all(pipe, bytes_of(rays.pixels));
    write_all(pipe, bytes_of(picture.data));
    return Done{};
}

}  // namespace

Result<std::vector<DeviceFacts>> device_facts(double limit_s) {
    TRY(listed, answer_of_child(
                    [](int pipe) {
                        return told(pipe, [&]() -> Status {
                            Json list = Json::array();
                            for (const ContextDevice& d : context_devices()) list.push_back({d.kind, d.place, d.file});
                            write_all(pipe, list.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
                            return Done{};
                        });
                    },
                    limit_s));
    const Told list = told_by(*listed);
    if (!list.json.is_array())
        return failed(fmt::format("the list of devices: {}", list.json["failure"].get<std::string>()));
    std::vector<DeviceFacts> all;
    for (const Json& device : list.json) {
        const int number = static_cast<int>(all.size());
        TRY(answer,
            answer_of_child([&](int pipe) { return told(pipe, [&] { return tell_facts(pipe, number); }); }, limit_s));
        all.push_back(facts_of(told_by(*answer).json));
        all.back().device = {device[0], device[1], device[2]};
    }
    return all;
}

Result<DeviceTrial> device_trial(int device, const Scene& scene, double limit_s) {
    TRY(answer, answer_of_child([&](int pipe) { return told(pipe, [&] { return tell_trial(pipe, device, scene); }); },
                                limit_s));
    Told told = told_by(*answer);
    DeviceTrial trial;
    if (told.json.contains("failure")) return trial.failure = told.json["failure"], trial;
    const int width = scene.camera.width, height = scene.camera.height;
    trial.rays = {width, height, std::vector<RayPixel>(told.json["pixels"].get<std::size_t>()), kTrialRowStep};
    trial.picture = Image<unsigned char>(width, height, 3);
    trial.first_ms = told.json["first_ms"], trial.frame_ms = told.json["frame_ms"];
    trial.frame_core_ms = told.json["core_ms"];
    if (!take_bytes(told.bytes, trial.rays.pixels) || !take_bytes(told.bytes, trial.picture.data))
        trial.failure = "the driver ended its process before all was told";
    return trial;
}

}  // namespace nullscope::cli
