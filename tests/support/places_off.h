// What the driver's rays of several views are off by: places, fates and hits, against the reference's.
#pragma once
#include <algorithm>
#include <cstddef>
#include <string_view>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "support/gpu_session.h"

namespace nullscope::test {

struct PlacesOff {
    double most_px = 0, median = 0;
    long long views = 0, rays = 0, places = 0, fates = 0, forgiven = 0, wrong_hits = 0;
    // One view more, all of whose places are to be off by less than `most` px.
    void add(GpuSession& session, const Scene& scene, double most) {
        const RayFrame drawn = gl_ray_data(session, scene);
        const ExactTrace trace = remembered(reference_trace(scene));
        const RayMeasures m = measure_rays(drawn, scene.camera, trace);
        const RayFrame exact = exact_frame(scene.camera, trace);
        for (std::size_t i = 0; i < exact.pixels.size(); ++i) wrong_hits += exact.pixels[i].hit != drawn.pixels[i].hit;
        if (m.place_px.count > 0)
            most_px = std::max(most_px, m.place_px.max), median = std::max(median, m.place_px.median);
        CHECK(m.place_px.max < most);
        CHECK(m.not_finite == 0);
        ++views, places += m.place_px.count, fates += m.fate_errors, forgiven += m.forgiven,
            rays += static_cast<long long>(exact.pixels.size());
    }
    // of: whose they are. No fate differs, and hits only next to edges, of more than `least` places.
    void check(std::string_view of, long long least) const {
        fmt::print(
            "{}: {} views, {} rays, {} places: {:.1e} px at most, medians {:.1e}; fate errors {}, others at edges "
            "{} of {} forgiven\n",
            of, views, rays, places, most_px, median, fates, wrong_hits, forgiven);
        CHECK(fates == 0);
        CHECK(wrong_hits <= forgiven);
        CHECK(places > least);
    }
};

}  // namespace nullscope::test
