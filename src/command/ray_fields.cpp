#include "command/ray_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "spacetime/spherical_metric.h"

namespace nullscope::cli {
namespace {

constexpr double kLargestRadius = 1e30;  // r_s; squares of r and 1/r stay within a double
constexpr double kLeastQ = 1e-30, kLargestQ = 1e30;
// q^2 may lie this far (relative) below V(zeta0): rounding of a ray that starts at its turning point.
constexpr double kTurningSlack = 1e-14;

// Words of others, made safe for a one-line message.
std::string shown(std::string_view text) {
    constexpr std::size_t kMost = 40;
    std::string out(text.substr(0, kMost));
    std::replace_if(
        out.begin(), out.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return "\"" + out + (text.size() > kMost ? "\"..." : "\"");
}

std::string missing(const std::array<bool, kRayColumns>& there, std::initializer_list<RayColumn> needed) {
    std::string list;
    for (const RayColumn c : needed)
        if (!there[c]) list += (list.empty() ? "" : ", ") + std::string(kRayColumnNames[c]);
    return list;
}

// One ray's fields, checked; the first fault is kept.
struct RowReader {
    const RayFields& fields;
    std::optional<Error> error{};

    // Empty fields are faults like any other.
    double number(RayColumn column, double low, double high, std::string_view allowed) {
        const auto value = fields.number(column);
        if (value && *value >= low && *value <= high) return *value;
        report(column, fmt::format("{} {}", shown_field(column), value ? "is out of range" : "is not a finite number"),
               allowed);
        return low;
    }
    std::string shown_field(RayColumn column) const { return shown(fields.text(column)); }
    void report(RayColumn column, const std::string& what, std::string_view allowed) {
        if (!error) error = bad_key(std::string(kRayColumnNames[column]), what, std::string(allowed));
    }
};

void read_reduced(RowReader& row, const Spacetime& spacetime, RayQuery& query) {
    ReducedRay ray;
    ray.q = row.number(kQ, kLeastQ, kLargestQ, "q from 1e-30 to 1e30");
    const SphericalMetric* planar = spacetime.spherical();
    if (planar == nullptr)
        row.report(kQ, "a ray about a rotating hole needs more than these", "r, theta, phi, n_r, n_theta, n_phi");
    const bool by_length = spacetime.by_proper_length();  // wormholes: l0 instead
    ray.zeta0 = by_length ? row.number(kZeta0, -kLargestRadius, kLargestRadius, "l0 from -1e30 to 1e30")
                          : row.number(kZeta0, 1 / kLargestRadius, kLargestRadius, "zeta0 from 1e-30 to 1e30");
    constexpr std::string_view kEitherWay = "1 (towards the hole) or -1 (away)";
    const double s = row.number(kS, -1, 1, kEitherWay);
    if (std::fabs(s) != 1.0) row.report(kS, row.shown_field(kS) + " is no direction", kEitherWay);
    ray.s = s > 0.0 ? 1 : -1;
    const double given_q = ray.q;
    if (by_length) ray.zeta0 *= spacetime.length_unit(), ray.q /= spacetime.length_unit();
    const double least = std::pow(planar == nullptr ? 0.0 : planar->root_v(by_length ? ray.zeta0 : 1.0 / ray.zeta0), 2);
    if (ray.q * ray.q < least * (1 - kTurningSlack))
        row.report(
            kQ, fmt::format("{} is too small: no such ray passes through zeta0 = {}", row.shown_field(kQ), ray.zeta0),
            fmt::format("q >= {:.17g}", std::sqrt(least) * (given_q / ray.q)));
    query.orbit = ray;
}

void read_general(RowReader& row, const Spacetime& spacetime, RayQuery& query) {
    query.r = !spacetime.by_proper_length() ? row.number(kR, 1 / kLargestRadius, kLargestRadius, "r from 1e-30 to 1e30")
                                            : row.number(kR, -kLargestRadius, kLargestRadius, "r from -1e30 to 1e30");
    query.r *= spacetime.length_unit();
    query.theta = row.number(kTheta, 0, M_PI, "theta in [0, pi]");
    query.phi = row.number(kPhi, -1e6, 1e6, "phi in [-1e6, 1e6] rad");
    const auto component = [&](RayColumn c) {
        return row.number(c, -1e300, 1e300, "a component of the view direction, [-1e300, 1e300]");
    };
    const Vec3 n{component(kNr), component(kNtheta), component(kNphi)};
    const double largest = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
    if (largest > 0.0)
        query.n = normalized(n / largest);
    else
        row.report(kNr, "the view direction is zero", "n_r, n_theta, n_phi not all zero");
    if (row.fields.given(kFrame)) {
        const std::string frame = row.fields.text(kFrame);
        query.frame = frame == "rain" ? LocalFrame::kRain : LocalFrame::kStatic;
        if (frame != "rain" && frame != "static")
            row.report(kFrame, shown(frame) + " is no frame", "static, rain or nothing");
    }
    if (query.frame == LocalFrame::kRain && !spacetime.planar_rays())
        row.report(kFrame, "rain: not about a rotating hole", "static or nothing");
    if (query.frame == LocalFrame::kStatic && !camera_can_rest(spacetime, query.r))
        row.report(kR, fmt::format("{} is not outside the horizon, where the static frame is", row.shown_field(kR)),
                   fmt::format("{}, or frame = rain", allowed_radii(spacetime)));
}

// What alpha, beta and lambda are counted in, r_s.
double screen_unit(RowReader& row, const Spacetime& spacetime) {
    const std::string unit = row.fields.given(kUnit) ? row.fields.text(kUnit) : "r_s";
    if (unit != "M" && unit != "r_s") row.report(kUnit, shown(unit) + " is no unit", "M, r_s or nothing");
    if (unit == "M" && spacetime.by_proper_length()) row.report(kUnit, "M: a wormhole has none", "r_s or nothing");
    return unit == "M" ? 0.5 : spacetime.length_unit();
}

constexpr double kFarthestOff = 1e4;  // r_s: squares of the ray's slope stay below roundings

void look_from_infinity(RowReader& row, const Spacetime& spacetime, double alpha, double beta, RayQuery& query) {
    query.r = kFarObserver;
    if (row.fields.given(kPhi)) query.phi = row.number(kPhi, -1e6, 1e6, "phi in [-1e6, 1e6] rad");
    query.n = normalized({-1.0, -beta / kFarObserver, alpha / kFarObserver});
    if (!camera_can_rest(spacetime, kFarObserver) || std::fabs(spacetime.lapse_squared(kFarObserver) - 1.0) > 1e-6)
        row.report(kTheta, "this metric has no observer at infinity",
                   "metrics that are flat there, or r and n_r, n_theta, n_phi");
}

// Photons that reach the observer at alpha to the right and beta up of the centre have L_z = -alpha sin(theta) and p_theta = beta per unit of energy
// there (Bardeen 1973).
void read_at_infinity(RowReader& row, const Spacetime& spacetime, RayQuery& query) {
    constexpr std::string_view kPlace = "a place on the observer's screen, [-1e4, 1e4] r_s, or M";
    query.theta = row.number(kTheta, 0, M_PI, "theta in [0, pi]");
    const double unit = screen_unit(row, spacetime),
                 alpha = row.number(kAlpha, -kFarthestOff, kFarthestOff, kPlace) * unit,
                 beta = row.number(kBeta, -kFarthestOff, kFarthestOff, kPlace) * unit;
    look_from_infinity(row, spacetime, alpha, beta, query);
}

// lambda = L_z/E and Carter's eta = Q/E^2: p_theta^2 = eta + a^2 cos^2(theta) - lambda^2 cot^2(theta) (Carter 1968).
void read_conserved(RowReader& row, const Spacetime& spacetime, RayQuery& query) {
    constexpr double kSlack = 1e-13;  // of the largest term: p_theta = 0 but for rounding
    query.theta = row.number(kTheta, 0, M_PI, "theta in [0, pi]");
    const double unit = screen_unit(row, spacetime);
    const double lambda = row.number(kLambda, -kFarthestOff, kFarthestOff, "L_z/E, [-1e4, 1e4]") * unit,
                 eta =
                     row.number(kEta, -kFarthestOff * kFarthestOff, kFarthestOff * kFarthestOff, "Q/E^2, [-1e8, 1e8]") *
                     unit * unit;
    const double up = row.fields.given(kUp) ? row.number(kUp, -1, 1, "1 or -1") : 1;
    if (std::fabs(up) != 1) row.report(kUp, row.shown_field(kUp) + " is no sense", "1: beta > 0, or -1: beta < 0");
    const double sine = std::sin(query.theta), cosine = std::cos(query.theta);
    const bool on_axis = sine < 1e-9;
    if (on_axis && lambda != 0)
        row.report(kLambda, row.shown_field(kLambda) + " does not reach an observer on the axis", "0");
    const double across = on_axis ? 0 : lambda * cosine / sine, drag = spacetime.a() * cosine;
    const double square = eta + drag * drag - across * across, largest = std::max(std::fabs(eta), across * across);
    if (square < -kSlack * largest)
        row.report(
            kEta, fmt::format("{} is too small: no such light comes to theta = {}", row.shown_field(kEta), query.theta),
            fmt::format("eta >= {:.17g}", (across * across - drag * drag) / (unit * unit)));
    look_from_infinity(row, spacetime, on_axis ? 0 : -lambda / sine, up * std::sqrt(std::max(square, 0.0)), query);
}

}  // namespace

std::optional<RayColumn> ray_column(std::string_view name, const Spacetime& spacetime) {
    const auto known =
        std::ranges::find(kRayColumnNames, spacetime.by_proper_length() && name == "l0" ? "zeta0" : name);
    if (known == kRayColumnNames.end()) return std::nullopt;
    return static_cast<RayColumn>(known - kRayColumnNames.begin());
}

Result<RayForm> ray_form(const std::array<bool, kRayColumns>& there) {
    struct Form {
        RayForm form;
        bool meant;  // a column of it alone is there
        std::string missing;
    };
    const auto any = [&](std::initializer_list<RayColumn> columns) {
        return std::ranges::any_of(columns, [&](RayColumn c) { return there[c]; });
    };
    const Form forms[] = {
        {RayForm::kGeneral, any({kR, kNr, kNtheta, kNphi}), missing(there, {kR, kTheta, kPhi, kNr, kNtheta, kNphi})},
        {RayForm::kAtInfinity, any({kAlpha, kBeta}), missing(there, {kAlpha, kBeta, kTheta})},
        {RayForm::kConserved, any({kLambda, kEta}), missing(there, {kLambda, kEta, kTheta})},
        {RayForm::kReduced, any({kQ, kZeta0, kS}), missing(there, {kQ, kZeta0, kS})}};
    if (std::ranges::count(forms, true, &Form::meant) > 1)
        return bad_key("header", "columns of several forms of a ray", std::string(kRayForms));
    const auto meant = std::ranges::find(forms, true, &Form::meant);
    const Form& form = meant != std::end(forms) ? *meant : forms[0];
    if (!form.missing.empty()) return bad_key("header", "missing: " + form.missing, std::string(kRayForms));
    return form.form;
}

Result<RayQuery> ray_query(const RayFields& fields, RayForm form, const Spacetime& spacetime) {
    RowReader row{fields};
    RayQuery query;
    switch (form) {
        case RayForm::kGeneral: read_general(row, spacetime, query); break;
        case RayForm::kAtInfinity: read_at_infinity(row, spacetime, query); break;
        case RayForm::kConserved: read_conserved(row, spacetime, query); break;
        case RayForm::kReduced: read_reduced(row, spacetime, query); break;
    }
    if (fields.given(kAtAngle)) query.at_angle = row.number(kAtAngle, 0, 1e6, "an angle in [0, 1e6] rad, or nothing");
    if (row.error) return *row.error;
    return query;
}

}  // namespace nullscope::cli
