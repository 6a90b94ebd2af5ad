// What a panel "Telescope" keeps between pictures: what is wished, the array's day, what was found in the last picture.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "telescope/beam.h"
#include "telescope/live_view.h"

namespace nullscope {

enum class SeenThrough {
    kNothing,
    kBeam,
    kBaselines
};  // the picture: as it is, by `beam`, by what the longest baseline resolves

struct TelescopeWish {
    double angle_deg = 90;        // of the curve's baselines, from north through east
    double longest_glambda = 12;  // [0.1, 100]
    std::size_t triangle = 0;     // of LiveTelescope::triangles()
    SeenThrough through = SeenThrough::kNothing;
    double beam_uas = 20, beam_ratio = 1, beam_angle_deg = 0;  // the longer axis; the shorter one over it, (0, 1]
    friend bool operator==(const TelescopeWish&, const TelescopeWish&) = default;
};

struct TimedPhase {
    double hours = 0, phase = 0;  // of the scene's clock; rad
};

class LiveTelescope {
public:
    explicit LiveTelescope(std::vector<Station> stations) : stations_(std::move(stations)) {}

    // A picture's linear light, RGB; scene: with its size. Errors: live_source()'s; then nothing is found.
    // quick: the curve and the plane have half of their points.
    Status look(const Scene& scene, Image<float> linear, bool quick);
    void want(const TelescopeWish& wish);  // finds anew what it changes

    bool has_light() const { return !linear_.empty() && view_.amplitudes.front() > 0; }
    const TelescopeWish& wish() const { return wish_; }
    const std::vector<Station>& stations() const { return stations_; }
    std::string triangle_words(std::size_t index) const;  // "ALMA-LMT-SMA"

    // Of the last picture.
    const LiveSource& source() const { return source_; }
    const Image<float>& linear() const { return linear_; }
    const LiveView& view() const { return view_; }
    const Observation& day() const { return day_; }
    const std::vector<Triangle>& triangles() const { return triangles_; }
    // Where the scene's time goes on: the chosen triangle's closure phase at that time, of each picture, by the baselines of its middle scan. Two or
    // more, or empty.
    std::span<const TimedPhase> by_time() const {
        return std::span(by_time_).subspan(by_time_.size() > 1 ? 0 : by_time_.size());
    }

    std::optional<Beam> beam() const;         // that the picture is wished through
    Image<float> through(const Beam&) const;  // linear light
    int changes() const { return changes_; }  // of what is above

private:
    void find();
    void add_time(double time);

    std::vector<Station> stations_;
    TelescopeWish wish_;
    LiveSource source_;
    Image<float> linear_;
    SkyPicture picture_;
    Observation day_;
    std::vector<Triangle> triangles_;
    LiveView view_;
    std::vector<TimedPhase> by_time_;
    double time_ = 0;
    bool quick_ = false;
    int changes_ = 0;
};

}  // namespace nullscope
