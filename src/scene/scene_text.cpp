#include "scene/scene_text.h"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <type_traits>

namespace nullscope {
namespace {

// Every part is taken apart by a structured binding of all its members: a member that is added does not compile until
// it has its line here.
class Lines {
public:
    std::vector<SceneLine> lines;

    template <class T>
    void add(const std::string& name, const T& value) {
        if constexpr (std::is_same_v<T, double>)
            put(name, fmt::format("{:.17g}", value));
        else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, int>)
            put(name, fmt::format("{}", value));
        else if constexpr (std::is_enum_v<T>)
            put(name, fmt::format("{}", static_cast<int>(value)));
        else if constexpr (std::is_same_v<T, std::string>)
            put(name, value);
        else if constexpr (std::is_same_v<T, std::filesystem::path>)
            lines.push_back({name, value.string(), value});
        else if constexpr (std::is_same_v<T, Vec3>)
            put(name, fmt::format("{:.17g} {:.17g} {:.17g}", value.x, value.y, value.z));
        else
            parts_of(name, value);
    }

private:
    void put(const std::string& name, std::string value) { lines.push_back({name, std::move(value), {}}); }

    // Members by name, in order. "": the member's own lines stand directly in the part.
    template <std::size_t N, class... T>
    void members(const std::string& part, const std::array<std::string_view, N>& names, const T&... values) {
        static_assert(N == sizeof...(T));
        std::size_t i = 0;
        (member(part, names[i++], values), ...);
    }
    template <class T>
    void member(const std::string& part, std::string_view name, const T& value) {
        add(part.empty() || name.empty() ? fmt::format("{}{}", part, name) : fmt::format("{}.{}", part, name), value);
    }
    template <std::size_t N>
    using Names = std::array<std::string_view, N>;

    // What may be missing has a line that says whether it is there.
    template <class T>
    void parts_of(const std::string& name, const std::optional<T>& value) {
        put(name, value ? "there" : "missing");
        if (value) add(name, *value);
    }
    void parts_of(const std::string& name, const SpacetimeSpec& v) {
        const auto& [metric, parameters] = v;
        add(name + ".metric", metric);
        for (const auto& [parameter, value] : parameters) add(fmt::format("{}.{}", name, parameter), value);
    }
    void parts_of(const std::string& name, const CameraSpec& v) {
        const auto& [r, theta, phi, yaw, pitch, roll, observer, fall_from, energy, velocity, plane_width,
                     focal_distance, width, height, exposure] = v;
        members(name,
                Names<15>{"r", "theta", "phi", "yaw", "pitch", "roll", "observer", "fall_from", "energy", "velocity",
                          "plane_width", "focal_distance", "size", "size", "exposure"},
                r, theta, phi, yaw, pitch, roll, observer, fall_from, energy, velocity, plane_width, focal_distance,
                width, height, exposure);
    }
    void parts_of(const std::string& name, const BodyLook& v) {
        const auto& [texture, mapping, image, formula, colour, second_colour, columns, rows, band_latitude, rotation,
                     limb, brightness] = v;
        members(name,
                Names<12>{"texture", "mapping", "image", "formula", "colour", "second_colour", "columns", "rows",
                          "band_latitude", "rotation", "limb", "brightness"},
                texture, mapping, image, formula, colour, second_colour, columns, rows, band_latitude, rotation, limb,
                brightness);
    }
    void parts_of(const std::string& name, const SkySpec& v) {
        const auto& [kind, mapping, image, north_cap, south_cap, band_latitude, yaw, tilt, brightness, temperature,
                     faintest, even_stars, look] = v;
        members(name,
                Names<13>{"kind", "mapping", "image", "north_cap", "south_cap", "band_latitude", "yaw", "tilt",
                          "brightness", "temperature", "faintest", "even_stars", ""},
                kind, mapping, image, north_cap, south_cap, band_latitude, yaw, tilt, brightness, temperature, faintest,
                even_stars, look);
    }
    void parts_of(const std::string& name, const AccretionSpec& v) {
        const auto& [mass, rate] = v;
        members(name, Names<2>{"mass", "accretion_rate"}, mass, rate);
    }
    void parts_of(const std::string& name, const DiscSpec& v) {
        const auto& [inner, outer, image, opacity, edge, rotation, brightness, emission, temperature, accretion, flow,
                     passed, flow_life, look] = v;
        members(name,
                Names<14>{"inner", "outer", "image", "opacity", "edge", "rotation", "brightness", "emission",
                          "temperature", "", "flow", "passed", "flow_life", ""},
                inner, outer, image, opacity, edge, rotation, brightness, emission, temperature, accretion, flow,
                passed, flow_life, look);
    }
    void parts_of(const std::string& name, const SpotSpec& v) {
        const auto& [r, phase, size, brightness, temperature, count] = v;
        members(name, Names<6>{"r", "phase", "size", "brightness", "temperature", "count"}, r, phase, size, brightness,
                temperature, count);
    }
    void parts_of(const std::string& name, const SphereSpec& v) {
        const auto& [radius, swing, period, look] = v;
        members(name, Names<4>{"radius", "swing", "period", ""}, radius, swing, period, look);
    }
    void parts_of(const std::string& name, const CylinderSpec& v) {
        const auto& [inner, outer, height, far, look] = v;
        members(name, Names<5>{"inner", "outer", "height", "side", ""}, inner, outer, height, far, look);
    }
    void parts_of(const std::string& name, const BallSpec& v) {
        const auto& [position, radius, far, motion, velocity, x, y, z, look] = v;
        members(name, Names<9>{"position", "radius", "side", "motion", "velocity", "x", "y", "z", ""}, position, radius,
                far, motion, velocity, x, y, z, look);
    }
    void parts_of(const std::string& name, const SurfaceSpec& v) {
        const auto& [kind, size, shape, bound, steps, far, look] = v;
        members(name, Names<7>{"kind", "size", "shape", "bound", "steps", "side", ""}, kind, size, shape, bound, steps,
                far, look);
    }
    void parts_of(const std::string& name, const LightSpec& v) {
        const auto& [shift, beaming, bolometric, doppler, gravity, aberration, delay, lensing] = v;
        members(name, Names<8>{"shift", "beaming", "band", "doppler", "gravity", "aberration", "delay", "lensing"},
                shift, beaming, bolometric, doppler, gravity, aberration, delay, lensing);
    }
    void parts_of(const std::string& name, const PictureSpec& v) {
        const auto& [tone, bloom, auto_exposure, dither] = v;
        members(name, Names<4>{"tone", "bloom", "auto_exposure", "dither"}, tone, bloom, auto_exposure, dither);
    }
    void parts_of(const std::string& name, const PathKey& v) {
        const auto& [frame, camera] = v;
        members(name, Names<2>{"frame", ""}, frame, camera);
    }
    void parts_of(const std::string& name, const PathSpec& v) {
        const auto& [kind, look, frames, rate, duration, keys] = v;
        members(name, Names<5>{"kind", "look", "frames", "rate", "duration"}, kind, look, frames, rate, duration);
        for (std::size_t i = 0; i < keys.size(); ++i) add(fmt::format("{}.key[{}]", name, i), keys[i]);
    }
    void parts_of(const std::string& part, const Scene& v) {
        const auto& [name, description, spacetime, beside, beside_delay, camera, sky, far_sky, disc, spot, sphere,
                     cylinder, ball, surface, light, picture, path, time] = v;
        members(part,
                Names<18>{"name", "description", "spacetime", "beside", "beside.delay", "camera", "sky", "far_sky",
                          "disc", "spot", "sphere", "cylinder", "ball", "surface", "light", "picture", "path", "time"},
                name, description, spacetime, beside, beside_delay, camera, sky, far_sky, disc, spot, sphere, cylinder,
                ball, surface, light, picture, path, time);
    }
};

}  // namespace

std::vector<SceneLine> scene_lines(const Scene& scene) {
    Lines lines;
    lines.add("", scene);
    return std::move(lines.lines);
}

}  // namespace nullscope
