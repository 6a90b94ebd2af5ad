#include "cli/ray_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/atomic_file.h"
#include "base/csv.h"
#include "base/text.h"
#include "scene/bodies.h"
#include "spacetime/spherical_metric.h"

namespace nullscope::cli {
namespace {

enum Column { kR, kTheta, kPhi, kNr, kNtheta, kNphi, kFrame, kQ, kZeta0, kS, kAtAngle, kColumnCount };
constexpr std::array<std::string_view, kColumnCount> kNames = {"r",     "theta", "phi",   "n_r", "n_theta", "n_phi",
                                                               "frame", "q",     "zeta0", "s",   "at_angle"};
constexpr std::string_view kForms =
    "r,theta,phi,n_r,n_theta,n_phi[,frame] or q,zeta0,s (wormholes: q,l0,s); either with at_angle";

constexpr double kLargestRadius = 1e30;  // r_s; squares of r and 1/r stay within a double
constexpr double kLeastQ = 1e-30, kLargestQ = 1e30;
// q^2 may lie this far (relative) below V(zeta0): rounding of a ray that starts at its turning point.
constexpr double kTurningSlack = 1e-14;

// A file's own words, made safe for a one-line message.
std::string shown(std::string_view text) {
    constexpr std::size_t kMost = 40;
    std::string out(text.substr(0, kMost));
    std::replace_if(
        out.begin(), out.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return "\"" + out + (text.size() > kMost ? "\"..." : "\"");
}

Error fault(const std::string& file, int line, std::string_view column, std::string_view what,
            std::string_view allowed) {
    return Error{ErrorKind::kBadInput, std::string(what), std::string(allowed), std::string(column), file, line};
}

struct Header {
    int line = 0;
    std::size_t fields = 0;
    std::array<std::optional<std::size_t>, kColumnCount> at;  // field number of each known column
    bool reduced = false;
};

std::string missing(const Header& header, Column first, Column last) {
    std::string list;
    for (std::size_t c = first; c <= static_cast<std::size_t>(last); ++c)
        if (!header.at[c]) list += (list.empty() ? "" : ", ") + std::string(kNames[c]);
    return list;
}

// by_length: wormholes, where l0 is the column's name.
Result<Header> read_header(const std::string& file, int line, std::string_view text, bool by_length) {
    const auto fields = csv_fields(text);
    if (!fields) return fault(file, line, "header", "a quote is not closed, or something follows it", kForms);
    Header header;
    header.line = line;
    header.fields = fields->size();
    for (std::size_t i = 0; i < fields->size(); ++i) {
        const auto known = std::ranges::find(kNames, by_length && (*fields)[i] == "l0" ? "zeta0" : (*fields)[i]);
        if (known == kNames.end()) continue;
        auto& place = header.at[static_cast<std::size_t>(known - kNames.begin())];
        if (place) return fault(file, line, *known, "this column is there twice", "once");
        place = i;
    }
    const std::string general = missing(header, kR, kNphi), reduced = missing(header, kQ, kS);
    if (general.empty() && reduced.empty())
        return fault(file, line, "header", "columns of both forms of a ray", kForms);
    if (!general.empty() && !reduced.empty()) {
        const bool meant_reduced = reduced.size() < std::string("q, zeta0, s").size();
        return fault(file, line, "header", "missing: " + (meant_reduced ? reduced : general), kForms);
    }
    header.reduced = reduced.empty();
    return header;
}

// One row's fields, looked up by column and checked; the first fault is kept.
struct RowReader {
    const std::string& file;
    int line;
    const Header& header;
    const std::vector<std::string>& fields;
    std::optional<Error> error{};

    bool given(Column column) const { return header.at[column] && !field(column).empty(); }
    const std::string& field(Column column) const { return fields[*header.at[column]]; }
    // Empty fields are faults like any other.
    double number(Column column, double low, double high, std::string_view allowed) {
        const auto value = parse_number(field(column));
        if (value && *value >= low && *value <= high) return *value;
        report(column, fmt::format("{} {}", shown(field(column)), value ? "is out of range" : "is not a finite number"),
               allowed);
        return low;
    }
    void report(Column column, const std::string& what, std::string_view allowed) {
        if (!error) error = fault(file, line, kNames[column], what, allowed);
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
    if (std::fabs(s) != 1.0) row.report(kS, shown(row.field(kS)) + " is no direction", kEitherWay);
    ray.s = s > 0.0 ? 1 : -1;
    const double given_q = ray.q;
    if (by_length) ray.zeta0 *= spacetime.length_unit(), ray.q /= spacetime.length_unit();
    const double least = std::pow(planar == nullptr ? 0.0 : planar->root_v(by_length ? ray.zeta0 : 1.0 / ray.zeta0), 2);
    if (ray.q * ray.q < least * (1 - kTurningSlack))
        row.report(
            kQ, fmt::format("{} is too small: no such ray passes through zeta0 = {}", shown(row.field(kQ)), ray.zeta0),
            fmt::format("q >= {:.17g}", std::sqrt(least) * (given_q / ray.q)));
    query.orbit = ray;
}

void read_general(RowReader& row, const Spacetime& spacetime, RayQuery& query) {
    query.r = !spacetime.by_proper_length() ? row.number(kR, 1 / kLargestRadius, kLargestRadius, "r from 1e-30 to 1e30")
                                            : row.number(kR, -kLargestRadius, kLargestRadius, "r from -1e30 to 1e30");
    query.r *= spacetime.length_unit();
    query.theta = row.number(kTheta, 0, M_PI, "theta in [0, pi]");
    query.phi = row.number(kPhi, -1e6, 1e6, "phi in [-1e6, 1e6] rad");
    const auto component = [&](Column c) {
        return row.number(c, -1e300, 1e300, "a component of the view direction, [-1e300, 1e300]");
    };
    const Vec3 n{component(kNr), component(kNtheta), component(kNphi)};
    const double largest = std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)});
    if (largest > 0.0)
        query.n = normalized(n / largest);
    else
        row.report(kNr, "the view direction is zero", "n_r, n_theta, n_phi not all zero");
    if (row.given(kFrame)) {
        const std::string& frame = row.field(kFrame);
        query.frame = frame == "rain" ? LocalFrame::kRain : LocalFrame::kStatic;
        if (frame != "rain" && frame != "static")
            row.report(kFrame, shown(frame) + " is no frame", "static, rain or nothing");
    }
    if (query.frame == LocalFrame::kRain && !spacetime.planar_rays())
        row.report(kFrame, "rain: not about a rotating hole", "static or nothing");
    if (query.frame == LocalFrame::kStatic && !camera_can_rest(spacetime, query.r))
        row.report(kR, fmt::format("{} is not outside the horizon, where the static frame is", shown(row.field(kR))),
                   fmt::format("{}, or frame = rain", allowed_radii(spacetime)));
}

Result<RayRow> read_row(const std::string& file, int line, std::string_view text, const Header& header,
                        const Spacetime& spacetime) {
    const auto fields = csv_fields(text);
    if (!fields)
        return fault(file, line, "row", "a quote is not closed, or something follows it",
                     "\"...\" around whole fields");
    if (fields->size() != header.fields)
        return fault(file, line, "row", fmt::format("{} fields", fields->size()),
                     fmt::format("{}, as many as the header of line {} names", header.fields, header.line));
    RowReader reader{file, line, header, *fields};
    RayRow row{line, std::string(text), {}};
    if (header.reduced)
        read_reduced(reader, spacetime, row.query);
    else
        read_general(reader, spacetime, row.query);
    if (reader.given(kAtAngle))
        row.query.at_angle = reader.number(kAtAngle, 0, 1e6, "an angle in [0, 1e6] rad, or nothing");
    if (reader.error) return *reader.error;
    return row;
}

std::string fate_name(const RayRecord& record, const Scene& scene) {
    constexpr std::array<std::string_view, 4> kFates = {"escaped", "captured", "other_side", "no_sky"};
    if (record.fate != Fate::kHit) return std::string(kFates[static_cast<std::size_t>(record.fate)]);
    return record.hit == 0 ? "no_sky" : "hit:" + object_name(scene, record.hit);
}

void append(std::string& line, double value) {
    line += ',';
    if (std::isfinite(value)) fmt::format_to(std::back_inserter(line), "{:.17g}", value);
}

}  // namespace

Error ray_error(const RayTable& table, const RayRow& row, const std::string& what) {
    return bad_input(fmt::format("{}:{}: {}", table.file, row.line, what));
}

Result<RayTable> parse_rays(std::string_view text, const std::string& file, const Spacetime& spacetime) {
    RayTable table{file, {}, {}};
    std::optional<Header> header;
    for (CsvLines csv(text); csv.next();) {
        if (!header) {
            TRY(read, read_header(file, csv.number, csv.line, spacetime.by_proper_length()));
            header = *read;
            table.header = csv.line;
            continue;
        }
        TRY(row, read_row(file, csv.number, csv.line, *header, spacetime));
        table.rows.push_back(std::move(*row));
    }
    if (!header) return fault(file, 1, "header", "there is none", kForms);
    return table;
}

Result<RayTable> read_rays(const std::string& path, const Spacetime& spacetime) {
    TRY(text, read_text(path, kLargestRayFile));
    return parse_rays(*text, path, spacetime);
}

std::string rays_text(const RayTable& table, const Scene& scene, const RayRecords& records, int crossings,
                      double length_unit, bool shifts) {
    std::string text = table.header + ",fate,theta_inf,phi_inf,angle,delay,g,turn,at";
    for (int k = 1; k <= crossings; ++k) {
        text += fmt::format(",r_{0},phi_{0}", k);
        if (shifts) text += fmt::format(",g_{}", k);
    }
    text += '\n';
    const std::size_t columns = 8 + (shifts ? 3 : 2) * static_cast<std::size_t>(crossings);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        text += table.rows[i].text;
        if (!records[i]) {
            text += std::string(columns, ',') + '\n';
            continue;
        }
        const RayRecord& ray = *records[i];
        text += ',' + fate_name(ray, scene);
        for (const double value : {ray.theta_inf, ray.phi_inf, ray.angle, ray.delay / length_unit, ray.g,
                                   ray.turn / length_unit, ray.at / length_unit})
            append(text, value);
        for (std::size_t k = 0; k < static_cast<std::size_t>(crossings); ++k) {
            const bool there = k < ray.crossings.size();
            append(text, there ? ray.crossings[k].r / length_unit : kNotANumber);
            append(text, there ? ray.crossings[k].phi : kNotANumber);
            if (shifts) append(text, there ? ray.crossings[k].g : kNotANumber);
        }
        text += '\n';
    }
    return text;
}

}  // namespace nullscope::cli
