#include "telescope/live_telescope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nullscope {
namespace {

constexpr double kOneDegreeOfBeam = M_PI / 180, kUasOfBeam = M_PI / 180 / 3600e6;  // rad
constexpr std::size_t kMostTimes = 2000;

bool same_day(const LiveSource& one, const LiveSource& other) {
    return one.place.right_ascension_deg == other.place.right_ascension_deg &&
           one.place.declination_deg == other.place.declination_deg && one.frequency_GHz == other.frequency_GHz;
}

}  // namespace

Status LiveTelescope::look(const Scene& scene, Image<float> linear, bool quick) {
    auto source = live_source(scene);
    ++changes_;
    if (!source) {
        linear_ = {}, by_time_.clear();
        return source.error();
    }
    const bool new_day = day_.scans.empty() || !same_day(*source, source_);
    const double before = std::exchange(time_, scene.time);
    source_ = std::move(*source), linear_ = std::move(linear), quick_ = quick;
    picture_ = live_picture(linear_, source_);
    if (new_day) {
        day_ = live_day(stations_, source_);
        triangles_ = triangles_of(day_);
        wish_.triangle = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i)  // a large one, known of papers
            if (triangle_words(i) == "ALMA-LMT-SMA") wish_.triangle = i;
    }
    if (new_day || scene.time < before) by_time_.clear();
    find();
    return Done{};
}

void LiveTelescope::want(const TelescopeWish& wish) {
    if (wish == wish_) return;
    const TelescopeWish before = std::exchange(wish_, wish);
    wish_.triangle = std::min(wish_.triangle, std::max(triangles_.size(), std::size_t{1}) - 1);
    ++changes_;
    if (wish_.triangle != before.triangle) by_time_.clear();
    const bool curve = wish_.angle_deg != before.angle_deg || wish_.longest_glambda != before.longest_glambda;
    if (!linear_.empty() && (curve || wish_.triangle != before.triangle)) find();
}

void LiveTelescope::find() {
    LiveWish wish{kOneDegreeOfBeam * wish_.angle_deg, 1e9 * wish_.longest_glambda};
    if (quick_) wish.points = 97, wish.plane = 48;
    const bool seen = wish_.triangle < triangles_.size();
    if (seen) wish.triangle = triangles_[wish_.triangle];
    wish.whole_day = by_time_.size() < 2;
    view_ = live_view(picture_, day_, wish);
    if (seen) add_time(time_);
}

void LiveTelescope::add_time(double time) {
    if (view_.phases.empty()) return;
    const double hours = source_.hours(time), phase = view_.phases[view_.phases.size() / 2].phase;
    if (!by_time_.empty() && by_time_.back().hours >= hours) {
        by_time_.back() = {hours, phase};  // of another view at that time
        return;
    }
    if (by_time_.size() == kMostTimes) by_time_.erase(by_time_.begin(), by_time_.begin() + kMostTimes / 2);
    by_time_.push_back({hours, phase});
}

std::string LiveTelescope::triangle_words(std::size_t index) const {
    const auto [a, b, c] = triangles_[index];
    return fmt::format("{}-{}-{}", stations_[a].name, stations_[b].name, stations_[c].name);
}

std::optional<Beam> LiveTelescope::beam() const {
    switch (wish_.through) {
        case SeenThrough::kNothing: return std::nullopt;
        case SeenThrough::kBeam:
            return Beam{kUasOfBeam * wish_.beam_uas, kUasOfBeam * wish_.beam_uas * wish_.beam_ratio,
                        kOneDegreeOfBeam * wish_.beam_angle_deg};
        case SeenThrough::kBaselines: return beam_of_baseline(1e9 * wish_.longest_glambda);
    }
    return std::nullopt;
}

Image<float> LiveTelescope::through(const Beam& beam) const { return convolved(linear_, source_.pixel, beam); }

}  // namespace nullscope
