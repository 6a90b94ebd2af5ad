#include "reference/ray_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

#include "reference/bodies.h"
#include "reference/plane_stretch.h"
#include "reference/ray_stretch.h"
#include "scene/disc_shape.h"
#include "scene/leaning_disc.h"
#include "spacetime/registry.h"

namespace nullscope::reference {
namespace {

using TenPlaces = boost::math::quadrature::gauss<double, 10>;
constexpr double kCurveAbove = 0.01;  // of its radius: there curves of captured rays end
constexpr double kSizeRatio = 2;      // of sizes at the ends of a piece: ten places leave 1e-15 of 1/u^2
constexpr int kMostCurvePieces = 2000, kPieceHalvings = 100;
constexpr int kDiscCrossings =
    40;  // of an opaque disc's plane: as the ray's windings, 12 half turns in double precision

// Integrals along a ray.
struct Sums {
    double affine = 0, even = 0, t = 0, mino = 0;
    Sums& operator+=(const Sums& more) {
        affine += more.affine, even += more.even, t += more.t, mino += more.mino;
        return *this;
    }
};
Sums rates(const StretchPlace& place) {
    return {place.affine_rate, std::hypot(place.affine_rate / std::hypot(place.size, 1), place.turn_rate), place.t_rate,
            place.affine_rate / place.sigma};
}

Sums between(const RayStretch& stretch, double low, double high) {
    const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
    Sums sums;
    for (std::size_t i = 0; i < TenPlaces::abscissa().size(); ++i)
        for (const double side : {-1.0, 1.0}) {
            const Sums rate = rates(stretch.at(middle + side * half * TenPlaces::abscissa()[i]));
            const double weight = half * TenPlaces::weights()[i];
            sums += {weight * rate.affine, weight * rate.even, weight * rate.t, weight * rate.mino};
        }
    return sums;
}

// What a ray is within.
struct Bounds {
    double farthest, least, last;  // r; r of a captured ray's end; along
    CurveSpec spec;
};

// Where in a piece a coordinate first has a value, or `to`: also where it comes there and turns back.
template <class Coordinate, class Rate>
double first_at(const RayStretch& stretch, double from, double to, double value, Coordinate coordinate, Rate rate) {
    const auto off = [&](double along) { return coordinate(stretch.at(along)) - value; };
    const auto rises = [&](double along) { return rate(stretch.motion(along)) > 0; };
    constexpr double kOff = 1e-6;  // of the piece: a ray that begins there leaves it first
    const double start = off(from) == 0 ? from + kOff * (to - from) : from;
    const bool above = off(start) > 0;
    const auto beyond = [&](double along) { return (off(along) > 0) != above; };
    double low = start, high = to;
    if (!beyond(high)) {
        if (rises(low) != above && rises(high) == above) {
            for (int i = 0; i < kPieceHalvings && !beyond(high); ++i) {  // the nearest that it comes
                const double middle = 0.5 * (low + high);
                if (!(middle > low && middle < high)) return to;
                if (beyond(middle))
                    high = middle;
                else
                    (rises(middle) == above ? high : low) = middle;
            }
            low = start;
        }
        if (!beyond(high)) return to;
    }
    for (int i = 0; i < kPieceHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        (beyond(middle) ? high : low) = middle;
    }
    return high;
}

// The first look at a ray: how long it is, in pieces that are smooth.
class CurveLength {
public:
    struct Node {
        double along;
        Sums sums;
        double even_rate;
    };
    explicit CurveLength(const Bounds& bounds) : bounds_(bounds) {}
    const std::vector<Node>& nodes() const { return nodes_; }
    bool whole() const { return ended_ && nodes_.size() > 1; }

    void look(const RayStretch& stretch) {
        double from = stretch.from;
        if (ended_ || !(from < bounds_.last)) return;
        StretchPlace begin = stretch.at(from);
        if (!(begin.size > 0)) return;
        double width = std::min(stretch.longest, begin.size);
        while (!ended_ && from < stretch.to && pieces_ < kMostCurvePieces) {
            const double limit = std::min(stretch.to, bounds_.last);
            double to = std::min(from + width, limit);
            StretchPlace end = stretch.at(to);
            for (int i = 0; i < kPieceHalvings && !smooth(begin, end); ++i)
                to = from + 0.5 * (to - from), end = stretch.at(to);
            if (!(to > from)) break;
            take(stretch, {from, to, begin, end});
            width = std::min(2 * (to - from), stretch.longest);
            from = to, begin = end, ++pieces_;
        }
    }

private:
    struct Piece {
        double from, to;
        StretchPlace begin, end;
    };
    static bool smooth(const StretchPlace& a, const StretchPlace& b) {
        const auto close = [](double x, double y) { return x <= kSizeRatio * y && y <= kSizeRatio * x; };
        return close(a.size, b.size) && close(a.lapse2, b.lapse2);
    }
    bool far(const StretchPlace& place) const { return std::abs(place.r) > bounds_.farthest; }
    // Where r passes a bound.
    static double passes(const RayStretch& stretch, Piece piece, double bound) {
        const bool above = std::abs(piece.begin.r) > bound;
        for (int i = 0; i < kPieceHalvings; ++i) {
            const double middle = 0.5 * (piece.from + piece.to);
            if (!(middle > piece.from && middle < piece.to)) break;
            ((std::abs(stretch.at(middle).r) > bound) == above ? piece.from : piece.to) = middle;
        }
        return piece.to;
    }
    void take(const RayStretch& stretch, const Piece& piece) {
        double from = piece.from, to = piece.to;
        if (nodes_.empty()) {
            if (far(piece.end)) return;
            if (far(piece.begin)) from = passes(stretch, piece, bounds_.farthest);
            nodes_.push_back({from, {}, rates(stretch.at(from)).even});
        } else if (far(piece.end)) {
            to = passes(stretch, piece, bounds_.farthest), ended_ = true;
        }
        if (bounds_.least > 0 && piece.end.r < bounds_.least) to = passes(stretch, piece, bounds_.least), ended_ = true;
        if (to >= bounds_.last) ended_ = true;
        to = stopped(stretch, from, to);
        if (!(to > from)) return;
        Sums sums = nodes_.back().sums;
        nodes_.push_back({to, sums += between(stretch, from, to), rates(stretch.at(to)).even});
    }
    // Where the curve is asked to end, if that is before `to`.
    double stopped(const RayStretch& stretch, double from, double to) {
        const CurveSpec& spec = bounds_.spec;
        const double whole = to;
        if (spec.to_r)
            to = first_at(
                stretch, from, to, *spec.to_r, [](const StretchPlace& p) { return p.r; },
                [](const StretchMotion& m) { return m.r; });
        if (spec.to_theta && to > from)
            to = first_at(
                stretch, from, to, *spec.to_theta, [](const StretchPlace& p) { return p.theta; },
                [](const StretchMotion& m) { return m.theta; });
        if (spec.to_mino && to > from) to = at_mino(stretch, from, to, *spec.to_mino - nodes_.back().sums.mino);
        ended_ = ended_ || to < whole;
        return to;
    }
    static double at_mino(const RayStretch& stretch, double from, double to, double left) {
        if (between(stretch, from, to).mino < left) return to;
        double low = from, high = to;
        for (int i = 0; i < kPieceHalvings; ++i) {
            const double middle = 0.5 * (low + high);
            if (!(middle > low && middle < high)) break;
            (between(stretch, from, middle).mino < left ? low : high) = middle;
        }
        return high;
    }

    Bounds bounds_;
    std::vector<Node> nodes_;
    bool ended_ = false;
    int pieces_ = 0;
};

// The second look: points between the nodes.
class CurvePoints {
public:
    CurvePoints(const std::vector<CurveLength::Node>& nodes, int count)
        : nodes_(nodes), points_(static_cast<std::size_t>(count)) {}
    std::vector<CurvePoint> take() && {
        return next_ == points_.size() ? std::move(points_) : std::vector<CurvePoint>();
    }

    void look(const RayStretch& stretch) {
        for (; next_ < points_.size(); ++next_) {
            const double goal =
                nodes_.back().sums.even * static_cast<double>(next_) / static_cast<double>(points_.size() - 1);
            while (piece_ + 2 < nodes_.size() && nodes_[piece_ + 1].sums.even < goal) ++piece_;
            const CurveLength::Node &begin = nodes_[piece_], &end = nodes_[piece_ + 1];
            if (begin.along < stretch.from || end.along > stretch.to) return;
            double along = next_ == 0 ? begin.along : end.along;
            if (next_ > 0 && next_ + 1 < points_.size()) along = place_of(begin, end, goal);
            Sums sums = begin.sums;
            add(stretch, along, sums += between(stretch, begin.along, along));
        }
    }

private:
    // Hermite's cubic of `along` by the even sum: as even as drawings need, without a look at the ray.
    static double place_of(const CurveLength::Node& begin, const CurveLength::Node& end, double goal) {
        const double width = end.sums.even - begin.sums.even, x = (goal - begin.sums.even) / width, y = 1 - x;
        const double curved = x * y * width * (y / begin.even_rate - x / end.even_rate);
        return std::clamp(std::lerp(begin.along, end.along, x * x * (1 + 2 * y)) + curved, begin.along, end.along);
    }
    void add(const RayStretch& stretch, double along, const Sums& sums) {
        const StretchPlace place = stretch.at(along);
        const StretchMotion motion = stretch.motion(along);
        if (next_ == 0) t0_ = place.t;
        points_[next_] = {sums.affine, place.r,      place.theta, place.phi, place.t - t0_ + sums.t,
                          motion.r,    motion.theta, motion.phi,  motion.t};
    }
    const std::vector<CurveLength::Node>& nodes_;
    std::vector<CurvePoint> points_;
    std::size_t next_ = 0, piece_ = 0;
    double t0_ = 0;
};

using Walk = std::function<void(const StretchWatch&)>;
std::vector<CurvePoint> points_along(const Walk& walk, const Bounds& bounds) {
    CurveLength length(bounds);
    walk([&](const RayStretch& stretch) { length.look(stretch); });
    if (!length.whole()) return {};
    CurvePoints points(length.nodes(), bounds.spec.points);
    walk([&](const RayStretch& stretch) { points.look(stretch); });
    return std::move(points).take();
}

struct End {
    double along = kNowhere, r = kNowhere;
};
// Of the first body and of the opaque disc.
End first_end(const TracedRay& ray, const Scene& scene, const std::optional<DiscShape>& shape) {
    End end;
    if (const auto hit = ray.first_hit()) end = {hit->along, length(hit->place)};
    if (scene.disc && scene.disc->opacity >= 1.0)
        for (const PlaneCrossing& c : ray.crossings(shape ? kDiscCrossings : 1, scene.disc->inner, scene.disc->outer))
            if (c.along < end.along && (!shape || shape->within(c.r) >= 0)) end = {c.along, c.r};
    return end;
}

}  // namespace

struct CurveTracer::Parts {
    Scene scene;
    std::shared_ptr<const Spacetime> spacetime;
    std::unique_ptr<Metric> metric;
    std::unique_ptr<const Bodies> bodies;
};

CurveTracer::CurveTracer(CurveTracer&&) noexcept = default;
CurveTracer::~CurveTracer() = default;

Result<CurveTracer> CurveTracer::make(const Scene& scene) {
    auto parts = std::make_unique<Parts>();
    parts->scene = scene;
    TRY(metric, make_metric(scene.spacetime));
    TRY(spacetime, make_spacetime(scene.spacetime.metric, scene.spacetime.parameters));
    parts->metric = std::move(*metric), parts->spacetime = *spacetime;
    if (Status followed = check_bodies(parts->scene, *parts->metric); !followed) return followed.error();
    parts->bodies = std::make_unique<const Bodies>(parts->scene, *parts->metric);
    CurveTracer tracer;
    tracer.parts_ = std::move(parts);
    return tracer;
}

Result<std::vector<CurvePoint>> CurveTracer::curve(const RayQuery& query, const CurveSpec& spec) const {
    const Parts& p = *parts_;
    RayTask task{p.bodies.get(), p.scene.light.delay, false, p.scene.disc ? kDiscCrossings : 0};
    task.plane = disc_plane_of(p.scene);
    const auto shape = disc_shape_of(p.scene);
    if (shape) task.shape = &*shape;
    TRY(traced, p.metric->ray(query, task));
    const End end = first_end(**traced, p.scene, shape);
    Bounds bounds{spec.farthest, 0, end.along, spec};
    if (const auto horizon = p.spacetime->horizon_radius()) bounds.least = *horizon * (1 + kCurveAbove);
    Walk walk;
    std::optional<PlaneStretch> flat;
    if (const PlaneRay* plane = (*traced)->in_plane()) {
        flat = plane_stretch(*plane, query, *p.spacetime, end.along, end.r);
        if (!flat) return std::vector<CurvePoint>();
        if (plane->photon().r < bounds.least) bounds.least = 0;
        bounds.last = flat->last;
        walk = [&](const StretchWatch& watch) { watch(flat->stretch); };
    } else {
        if (!((*traced)->g > 0)) return std::vector<CurvePoint>();
        if (query.r < bounds.least) bounds.least = 0;
        walk = [&](const StretchWatch& watch) { p.metric->stretches(query, 1 / (*traced)->g, watch); };
    }
    return points_along(walk, bounds);
}

std::vector<CurvePoint> pixel_curve(const FrameTracer& tracer, const Spacetime& spacetime, const PixelOnCurve& pixel,
                                    const CurveSpec& spec) {
    if (!(pixel.g > 0)) return {};
    const double least = spacetime.horizon_radius().value_or(0.0) * (1 + kCurveAbove);
    return points_along([&](const StretchWatch& watch) { tracer.stretches(pixel.x, pixel.y, 1 / pixel.g, watch); },
                        {spec.farthest, pixel.camera_r < least ? 0 : least, pixel.end, spec});
}

}  // namespace nullscope::reference
