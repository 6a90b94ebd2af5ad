#include "command/ray_trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "command/options.h"
#include "command/shader_rays.h"
#include "observer/pose.h"
#include "reference/disc_light.h"
#include "reference/disc_polarisation.h"
#include "reference/ray_plane.h"
#include "reference/reference.h"
#include "scene/leaning_disc.h"
#include "scene/projection.h"

namespace nullscope::cli {
namespace {

// Windings before double precision cannot tell the ray from the critical one: about 12 half turns.
constexpr int kAllCrossings = 40;

// Whether the disc's matter moves and shines by itself.
bool has_matter(const Scene& scene, const Spacetime& spacetime) {
    return scene.disc && scene.disc->emission == DiscEmission::kThermal && spacetime.can_have_disc();
}

// Ends the ray on the scene's disc if that is opaque; everything along the light ray itself stays.
void stop_at_disc(const Scene& scene, const RayQuery& query, RayRecord& record) {
    const DiscSpec& disc = *scene.disc;
    const Vec3 n = query.orbit ? Vec3{0, 0, 1} : query.n;  // the reduced form lies in the equatorial plane
    const reference::RayPlane plane(query.orbit ? M_PI / 2 : query.theta, query.orbit ? 0.0 : query.phi, n,
                                    disc_plane_of(scene).normal);
    for (std::size_t k = 0; k < record.crossings.size(); ++k) {
        const double r = record.crossings[k].r;
        if (!(r >= disc.inner && r <= disc.outer)) continue;
        record.fate = Fate::kHit;
        record.hit = kDiscHit;
        if (std::isfinite(record.angle))
            record.angle = plane.crossing(static_cast<int>(k) + 1);  // of a ray that stays in a plane
        record.theta_inf = record.phi_inf = record.delay = kNotANumber;
        return;
    }
}

void add_polarisation(const reference::DiscPolarisation& polarised, const RayQuery& query, int most,
                      RayRecord& record) {
    if (query.orbit) return;
    const int count = std::min(most, static_cast<int>(record.crossings.size()));
    for (int k = 0; k < count; ++k) {
        const auto found = polarised.at(query, k + 1);
        if (!found) return;
        RayRecord::Crossing& crossing = record.crossings[static_cast<std::size_t>(k)];
        crossing.chi = found->angle, crossing.p = found->fraction;
    }
}

Status trace_with_reference(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                            int crossings, const TraceOutput& output) {
    const bool opaque = scene.disc && scene.disc->opacity >= 1.0;
    TRY(metric, reference::make_metric(scene.spacetime));
    std::optional<reference::DiscLight> matter;
    std::optional<reference::DiscPolarisation> polarised;
    if (crossings > 0 && has_matter(scene, spacetime)) {
        matter.emplace(**metric, *scene.disc, scene.light);
        if (has_polarised_disc(scene)) {
            TRY(made, reference::DiscPolarisation::make(scene));
            polarised.emplace(std::move(*made));
        }
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const int listed = opaque ? std::max(crossings, kAllCrossings) : crossings;
        auto record = reference::trace_ray(scene, rays[i], listed, matter ? &*matter : nullptr);
        if (!record) return output.error(i, record.error());
        if (polarised) add_polarisation(*polarised, rays[i], crossings, *record);
        if (opaque) stop_at_disc(scene, rays[i], *record);
        output.take(i, std::move(*record));
        output.done(1);
    }
    return Done{};
}

Result<Method> method_of(const TraceOptions& options) {
    if (options.method == "auto") return Method{};
    auto method = parse_method(options.method);
    if (!method) return bad_input("--method: " + method.error().message());
    if (options.with == "gl" || method->kind == MethodKind::kStrip || options.method == "table") return method;
    return bad_input(fmt::format("--method {}: not with --with {}", options.method, options.with),
                     "auto, strip and table, or --with gl");
}

}  // namespace

std::vector<RayQuery> rays_of(const CameraSpec& camera) {
    const Mat3 axes = static_from_camera(camera);
    std::vector<RayQuery> rays;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            rays.push_back({camera.r, camera.theta, camera.phi,
                            normalized(axes * pixel_direction(camera, x + 0.5, y + 0.5)), LocalFrame::kStatic,
                            std::nullopt, std::nullopt});
    return rays;
}

std::vector<CrossingColumn> crossing_columns(const Scene& scene, const Spacetime& spacetime) {
    using Crossing = RayRecord::Crossing;
    std::vector<CrossingColumn> columns = {{"r", &Crossing::r, true}, {"phi", &Crossing::phi, false}};
    if (!has_matter(scene, spacetime)) return columns;
    columns.push_back({"g", &Crossing::g, false});
    if (has_polarised_disc(scene))
        columns.insert(columns.end(), {{"chi", &Crossing::chi, false}, {"p", &Crossing::p, false}});
    return columns;
}

Status trace_rays(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                  const TraceOptions& options, const TraceOutput& output) {
    if (options.with != "gl" && !options.context.is_auto())
        return bad_input(fmt::format("{}: --with {} does not use OpenGL", option_of(options.context), options.with),
                         "--with gl");
    if (options.with == "reference" && options.method != "auto")
        return bad_input("--method: the reference tracer has its own", "--with gl");
    if (options.with != "gl" && options.stage != TraceOptions{}.stage)
        return bad_input(fmt::format("--stage: --with {} does not use OpenGL", options.with), "--with gl");
    TRY(method, method_of(options));
    if (options.with == "reference") return trace_with_reference(scene, spacetime, rays, options.crossings, output);
    return trace_with_shader(scene, spacetime, rays,
                             {options.with, *method, options.context, options.stage == "compute", options.crossings,
                              has_matter(scene, spacetime), has_matter(scene, spacetime) && has_polarised_disc(scene)},
                             output);
}

std::string left_out_note(std::size_t left_out, std::size_t of, const TraceOptions& options) {
    if (left_out == 0) return {};
    return fmt::format("{} of {} rays left empty: --with {} needs rays of a static or rain observer with r up to {:g}",
                       left_out, of, options.with, kFarthestCamera);
}

std::string no_places_note(const Scene& scene, const Spacetime& spacetime, std::span<const RayQuery> rays,
                           const TraceOptions& options) {
    const auto asks_place = [](const RayQuery& ray) { return ray.at_angle.has_value(); };
    if (options.with == "reference" || spacetime.can_have_disc() ||
        !(options.crossings > 0 || std::ranges::any_of(rays, asks_place)))
        return {};
    return fmt::format(
        "crossings and at left empty: --with {} does not compute them in metric {}; allowed: --with reference",
        options.with, scene.spacetime.metric);
}

}  // namespace nullscope::cli
