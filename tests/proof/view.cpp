#include "proof/view.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scenefile/scene_file.h"
#include "spacetime/registry.h"

namespace nullscope::proof {
namespace {

double rounded(double value, int digits) {
    return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

// All digits, as TOML wants a float: "2.0", where fmt's # gives "2.0" or "2." by its version.
std::string toml_number(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

}  // namespace

std::string View::toml(const std::string& comment) const {
    std::string text = comment + "[spacetime]\n" + fmt::format("metric = \"{}\"\n", metric);
    for (const auto& [name, value] : parameters) text += fmt::format("{} = {}\n", name, toml_number(value));
    if (metric == "formula") text += "A = \"1 - 1/r\"\n";
    text += "\n[camera]\n";
    if (metric.starts_with("kerr")) text += "observer = \"zamo\"\n";  // at rest as near to the horizon as anywhere else
    for (const auto& [name, value] : {std::pair{"r", r},
                                      {"theta", theta},
                                      {"phi", phi},
                                      {"yaw", yaw},
                                      {"pitch", pitch},
                                      {"roll", roll},
                                      {"fov", fov}})
        text += fmt::format("{} = {}\n", name, toml_number(value));
    text += fmt::format("velocity = [{}, {}, {}]\nsize = [{}, {}]\n", toml_number(velocity[0]),
                        toml_number(velocity[1]), toml_number(velocity[2]), width, height);
    text += "\n[sky]\nkind = \"black\"\n";
    if (has_disc)
        text += fmt::format("\n[disc]\ninner = {}\nouter = {}\nopacity = {}\n", toml_number(inner), toml_number(outer),
                            toml_number(opacity));
    return text;
}

Scene View::scene() const {
    const auto parsed = parse_scene(toml(""), "view.toml", {});
    REQUIRE_MESSAGE(parsed, (parsed ? "" : parsed.error().message()), "\n", toml(""));
    return *parsed;
}

bool View::possible() const {
    const auto parsed = parse_scene(toml(""), "view.toml", {});
    return parsed && camera_can_rest(**make_spacetime(metric, parameters), r);
}

View random_view(Random& random) {
    View view;
    const auto metrics = metric_registry();
    const MetricEntry& entry =
        metrics[static_cast<std::size_t>(random.below(static_cast<int>(metrics.size() * 4))) % metrics.size()];
    view.metric = random.unit() < 0.75 ? "schwarzschild" : std::string(entry.key);
    do {  // until they go together
        if (view.metric == entry.key)
            for (const MetricParameter& p : entry.parameters)
                view.parameters[std::string(p.name)] = random.between(p.low, p.high);
    } while (!make_spacetime(view.metric, view.parameters));
    const auto spacetime = *make_spacetime(view.metric, view.parameters);
    const double horizon = std::max(spacetime->camera_range().low, 0.0);
    view.r = std::min(horizon + random.log_between(1e-4, 1e9), 1e9);
    const double place = random.unit();
    view.theta = place < 0.05   ? 0
                 : place < 0.1  ? 90
                 : place < 0.15 ? 180
                                : std::acos(random.between(-1, 1)) * 180 / M_PI;
    view.phi = random.between(-180, 180);
    view.fov = random.log_between(0.01, 179);
    if (random.unit() < 0.5) {  // at the shadow's edge, or at the hole if that is small in the picture
        const double sine = std::sqrt(6.75 * std::max(view.r - 1, 0.0) / view.r) / view.r;
        const double edge = std::asin(std::min(sine, 1.0)) * 180 / M_PI;
        view.yaw = (view.r > 1.5 ? edge : 180 - edge) + 0.3 * view.fov * random.between(-1, 1);
    } else {
        view.yaw = random.between(-180, 180);
        view.pitch = random.between(-90, 90);
    }
    view.roll = random.between(-180, 180);
    if (random.unit() < 0.5) {
        const double speed = 1 - random.log_between(1e-6, 1), z = random.between(-1, 1),
                     turn = random.between(0, 2 * M_PI);
        const double across = std::sqrt(1 - z * z);
        view.velocity = {speed * z, speed * across * std::cos(turn), speed * across * std::sin(turn)};
    }
    view.has_disc = random.unit() < 0.5 && spacetime->can_have_disc();
    view.inner = random.log_between(1.01, 100);
    view.outer = view.inner * random.log_between(1.01, 100);
    view.opacity = random.unit() < 0.5 ? 1 : 0.5;
    return view;
}

View shrunk(View view, const std::function<bool(const View&)>& fails) {
    const auto try_change = [&](const std::function<void(View&)>& change) {
        View changed = view;
        change(changed);
        if (changed.toml("") != view.toml("") && changed.possible() && fails(changed)) view = changed;
    };
    try_change([](View& v) { v.has_disc = false; });
    try_change([](View& v) { v.velocity = {}; });
    try_change([](View& v) { v.opacity = 1; });
    for (double View::*angle : {&View::phi, &View::roll, &View::pitch, &View::yaw})
        try_change([&](View& v) { v.*angle = 0; });
    for (const double theta : {90.0, 60.0}) try_change([&](View& v) { v.theta = theta; });
    for (double View::*number : {&View::r, &View::fov, &View::theta, &View::phi, &View::yaw, &View::pitch, &View::roll,
                                 &View::inner, &View::outer})
        for (const int digits : {10, 6, 4, 3, 2, 1})
            try_change([&](View& v) { v.*number = rounded(v.*number, digits); });
    for (const int digits : {9, 6, 3, 2})
        for (std::size_t i = 0; i < 3; ++i)
            try_change([&](View& v) { v.velocity[i] = rounded(v.velocity[i], digits); });
    for (std::size_t i = 0; i < 3; ++i) try_change([&](View& v) { v.velocity[i] = 0; });
    return view;
}

}  // namespace nullscope::proof
