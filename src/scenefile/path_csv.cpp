#include "scenefile/path_csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "base/csv.h"
#include "base/text.h"
#include "observer/observer.h"
#include "observer/path.h"
#include "observer/pose.h"
#include "observer/turn.h"
#include "scene/projection.h"
#include "scenefile/scene_check.h"
#include "scenefile/scene_keys.h"
#include "scenefile/scene_value.h"
#include "scenefile/scene_writer.h"
#include "scenefile/toml_text.h"

namespace nullscope {
namespace {

using Row = std::vector<std::string>;

// What a column is of.
constexpr std::string_view kKeyColumns[] = {"r",           "theta",          "phi",       "yaw",     "pitch",
                                            "roll",        "observer",       "fall_from", "energy",  "fov",
                                            "plane_width", "focal_distance", "shift_x",   "shift_y", "exposure",
                                            "depth",       "angle"};
constexpr std::string_view kVelocity[] = {"velocity_r", "velocity_theta", "velocity_phi"};
constexpr std::string_view kPlace[] = {"x", "y", "z"};
constexpr std::string_view kLookUp[] = {"look_x", "look_y", "look_z", "up_x", "up_y", "up_z"};
constexpr std::string_view kQuaternion[] = {"qw", "qx", "qy", "qz"};
constexpr std::string_view kAngles[] = {"yaw", "pitch", "roll"};
constexpr double Vec3::*kAxes[] = {&Vec3::x, &Vec3::y, &Vec3::z};
constexpr KeyRange kFrames = closed(0.0, 1e6), kTimes = closed(-1e9, 1e9), kPlaces = closed(-1e9, 1e9);
constexpr double kQuaternionTolerance = 1e-3;  // of its length: what is printed with four digits is one
constexpr double kLeastUpAngle = 1e-6;         // rad, from look and from its opposite
constexpr double kAxesTolerance = 1e-4;        // of axes beside angles: of tables that keep four digits

bool is_zoom(std::string_view column) { return column == "depth" || column == "angle"; }

const SceneKey& key_of(std::string_view column) {
    const std::string name = fmt::format("{}.{}", is_zoom(column) ? "zoom" : "camera", column);
    return *std::ranges::find_if(scene_keys(), [&](const SceneKey& key) { return full_name(key) == name; });
}

std::vector<std::string> all_columns() {
    std::vector<std::string> names{"frame", "time"};
    names.insert(names.end(), std::begin(kKeyColumns), std::end(kKeyColumns));
    names.insert(names.end(), std::begin(kVelocity), std::end(kVelocity));
    names.insert(names.end(), std::begin(kPlace), std::end(kPlace));
    names.insert(names.end(), std::begin(kLookUp), std::end(kLookUp));
    names.insert(names.end(), std::begin(kQuaternion), std::end(kQuaternion));
    return names;
}

class PathReader {
public:
    PathReader(const std::string& label, const Scene& scene) : label_(label), scene_(scene), warp_(scene.camera.warp) {
        scene_.bodies.clear(), scene_.spots.clear(), scene_.disc.reset(), scene_.medium.reset(),
            scene_.path.reset();  // of the camera's check they are none
    }
    Result<PathTable> read(const std::string& text);

private:
    Error fault(std::string_view column, std::string_view what, std::string_view allowed) const {
        return without_controls(
            Error{ErrorKind::kBadInput, std::string(what), std::string(allowed), std::string(column), label_, line_});
    }
    bool has(std::string_view column) const { return std::ranges::find(columns_, column) != columns_.end(); }
    bool by_axes() const { return has("qw") || (has("look_x") && !has("yaw")); }
    Status check_groups() const;
    Status read_header(std::string_view text);
    Status read_row(const Row& row);
    Result<double> number(const Row& row, std::string_view column, const KeyRange& range) const;
    Status set_key(const Row& row, std::string_view column);
    Status set_place(const Row& row);
    Status set_velocity(const Row& row);
    Status set_axes_of(const Row& row);
    Result<Vec3> vector(const Row& row, std::span<const std::string_view, 3> columns) const;
    Result<Mat3> axes_by_look(const Row& row) const;
    Result<Mat3> axes_by_quaternion(const Row& row) const;
    const std::string& field(const Row& row, std::string_view column) const {
        return row[static_cast<std::size_t>(std::ranges::find(columns_, column) - columns_.begin())];
    }

    const std::string& label_;
    Scene scene_;  // with the row's camera
    std::filesystem::path warp_;
    int line_ = 1;
    Row columns_;
    std::vector<PathKey> keys_;
};

Status PathReader::read_header(std::string_view text) {
    const auto fields = csv_fields(text);
    if (!fields) return fault("header", "a quote is not closed, or something follows it", "names of columns");
    columns_ = *fields;
    const std::vector<std::string> known = all_columns();
    for (const std::string& column : columns_) {
        if (std::ranges::find(known, column) == known.end()) {
            const std::string nearest = nearest_word(column, known);
            return fault("header", fmt::format("unknown column {}", in_quotes(column)),
                         fmt::format("{}{}", fmt::join(known, ", "),
                                     nearest.empty() ? "" : fmt::format(" (nearest: {})", nearest)));
        }
        if (std::ranges::count(columns_, column) > 1) return fault(column, "this column is there twice", "once");
    }
    return check_groups();
}

// Columns that go together, and those that say the same.
Status PathReader::check_groups() const {
    using Columns = std::span<const std::string_view>;
    const auto given = [&](Columns columns) { return std::ranges::count_if(columns, [&](auto c) { return has(c); }); };
    for (const Columns whole : {Columns(kVelocity), Columns(kPlace), Columns(kLookUp), Columns(kQuaternion)})
        if (const auto there = given(whole); there != 0 && there != std::ssize(whole))
            return fault("header", fmt::format("not all of {}", fmt::join(whole, ", ")), "all or none");
    if (has("x") && (has("r") || has("theta") || has("phi")))
        return fault("header", "both x, y, z and r, theta, phi are given", "one of both");
    const bool both = given(kAngles) == std::ssize(kAngles) && given(kLookUp) > 0 && given(kQuaternion) == 0;
    if ((given(kLookUp) > 0) + (given(kQuaternion) > 0) + (given(kAngles) > 0) > 1 && !both)
        return fault("header", "the camera's axes are given twice",
                     "one of yaw, pitch, roll; look_x, look_y, look_z, up_x, up_y, up_z; qw, qx, qy, qz; or all of the "
                     "first two");
    if ((by_axes() || both) && (scene_.camera.zoom || has("depth") || has("angle")))
        return fault(has("qw") ? "qw" : "look_x", "there is a [zoom], whose depth and angle turn the camera",
                     "without [zoom]");
    return Done{};
}

Result<double> PathReader::number(const Row& row, std::string_view column, const KeyRange& range) const {
    const std::string allowed = fmt::format("[{}, {}]", range.low, range.high);
    const auto value = parse_number(field(row, column));
    if (!value) return fault(column, fmt::format("{} is no number", in_quotes(field(row, column))), allowed);
    if (!range.contains(*value)) return fault(column, fmt::format("{} is out of range", *value), allowed);
    return *value;
}

Status PathReader::set_key(const Row& row, std::string_view column) {
    const SceneKey& key = key_of(column);
    const std::string& text = field(row, column);
    if (is_zoom(column) && !scene_.camera.zoom) scene_.camera.zoom.emplace();
    const auto number = parse_number(text);
    if (!number && key.type == KeyType::kNumber)
        return fault(column, fmt::format("{} is no number", in_quotes(text)), allowed_text(key));
    const auto value = number ? check_value(key, toml::value<double>(*number), {})
                              : check_value(key, toml::value<std::string>(text), {});
    if (!value) return fault(column, value.error().what, allowed_text(key));
    key.member.set(scene_, *value);
    return Done{};
}

Status PathReader::set_place(const Row& row) {
    Vec3 place;
    for (std::size_t i = 0; i < 3; ++i) {
        TRY(value, number(row, kPlace[i], kPlaces));
        place.*kAxes[i] = *value;
    }
    const double across = std::hypot(place.x, place.y);
    scene_.camera.r = std::hypot(across, place.z);
    if (scene_.camera.r == 0.0) return fault("x", "the centre has no direction", "another place");
    scene_.camera.theta = std::atan2(across, place.z), scene_.camera.phi = std::atan2(place.y, place.x);
    return Done{};
}

Status PathReader::set_velocity(const Row& row) {
    toml::array components;
    for (const auto column : kVelocity) {
        TRY(value, number(row, column, closed(-1.0, 1.0)));
        components.push_back(*value);
    }
    const SceneKey& key = key_of("velocity");
    const auto value = check_value(key, components, {});
    if (!value) return fault("velocity_r", value.error().what, allowed_text(key));
    key.member.set(scene_, *value);
    return Done{};
}

Result<Vec3> PathReader::vector(const Row& row, std::span<const std::string_view, 3> columns) const {
    Vec3 of;
    for (std::size_t i = 0; i < 3; ++i) {
        TRY(value, number(row, columns[i], kPlaces));
        of.*kAxes[i] = *value;
    }
    if (of == Vec3{}) return fault(columns[0], fmt::format("{} are 0", fmt::join(columns, ", ")), "not all of them 0");
    return normalized(of);
}

Result<Mat3> PathReader::axes_by_look(const Row& row) const {
    TRY(look, vector(row, std::span(kLookUp).first<3>()));
    TRY(up, vector(row, std::span(kLookUp).last<3>()));
    const Vec3 across = cross(*look, *up);
    if (!(length(across) >= kLeastUpAngle))
        return fault("up_x", "up_x, up_y, up_z are along look_x, look_y, look_z",
                     fmt::format("{} rad or more from it and its opposite", kLeastUpAngle));
    const Vec3 right = normalized(across);
    return Mat3{right, cross(right, *look), -*look};
}

Result<Mat3> PathReader::axes_by_quaternion(const Row& row) const {
    std::array<double, 4> q{};
    for (std::size_t i = 0; i < 4; ++i) {
        TRY(value, number(row, kQuaternion[i], closed(-1.0 - kQuaternionTolerance, 1.0 + kQuaternionTolerance)));
        q[i] = *value;
    }
    const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(std::fabs(size - 1.0) <= kQuaternionTolerance))
        return fault("qw", fmt::format("qw, qx, qy, qz have the length {}", size),
                     fmt::format("[{}, {}]", 1.0 - kQuaternionTolerance, 1.0 + kQuaternionTolerance));
    return axes_of({q[0] / size, q[1] / size, q[2] / size, q[3] / size});
}

// Axes beside angles say the same again: the angles, which know of whole turns, are taken; but the axes where x and y are 0, which tell no phi,
// from which angles count.
Status PathReader::set_axes_of(const Row& row) {
    if (!has("look_x") && !has("qw")) return Done{};
    TRY(axes, has("qw") ? axes_by_quaternion(row) : axes_by_look(row));
    if (by_axes() || (has("x") && scene_.camera.theta == 0.0)) {
        set_world_axes(scene_.camera, *axes);
        return Done{};
    }
    const Mat3 angles = world_from_camera(scene_.camera);
    const double off = std::max(length(axes->b - angles.b), length(axes->c - angles.c));
    if (!(off <= kAxesTolerance))
        return fault("look_x", fmt::format("the axes are {:.2g} rad from those of yaw, pitch, roll", off),
                     fmt::format("within {} rad; or leave either out", kAxesTolerance));
    return Done{};
}

Status PathReader::read_row(const Row& row) {
    if (row.size() != columns_.size())
        return fault("row", fmt::format("{} fields", row.size()), fmt::format("{}, as in the header", columns_.size()));
    if (keys_.size() == kMostPathRows) return fault("row", "one too many", fmt::format("{} at most", kMostPathRows));
    PathKey key{keys_.empty() ? 0.0 : keys_.back().frame + 1.0, {}, 0.0};
    for (const std::string& column : columns_) {
        if (column != "frame" && column != "time") continue;
        TRY(value, number(row, column, column == "time" ? kTimes : kFrames));
        (column == "time" ? key.time : key.frame) = *value;
    }
    for (const auto column : kKeyColumns) {
        if (!has(column)) continue;
        if (Status set = set_key(row, column); !set) return set;
    }
    if (has("x")) {
        if (Status set = set_place(row); !set) return set;
        if (!keys_.empty()) unwrap_angles(keys_.back().camera, scene_.camera);
    }
    if (Status set = set_axes_of(row); !set) return set;
    if (has("velocity_r"))
        if (Status set = set_velocity(row); !set) return set;
    if (!keys_.empty() && !(key.frame > keys_.back().frame))
        return fault("frame", fmt::format("{} is not after the row before", key.frame), "frames that grow");
    const auto faults = check_camera(scene_, [this](const std::string& name) {
        const std::size_t dot = name.find('.');
        return dot != std::string::npos && has(std::string_view(name).substr(dot + 1));
    });
    if (!faults.empty()) {
        const std::string& name = faults.front().key;
        return fault(name.substr(name.find('.') + 1), faults.front().what, faults.front().allowed);
    }
    key.camera = scene_.camera;
    key.camera.warp = warp_;
    scene_.camera.warp.clear();  // which is a file: it has been checked once
    keys_.push_back(std::move(key));
    return Done{};
}

Result<PathTable> PathReader::read(const std::string& text) {
    CsvLines lines(text);
    for (bool header = true; lines.next(); header = false) {
        line_ = lines.number;
        if (header) {
            if (Status read = read_header(lines.line); !read) return read.error();
            continue;
        }
        const auto fields = csv_fields(lines.line);
        if (!fields)
            return fault("row", "a quote is not closed, or something follows it", "\"...\" around whole fields");
        if (Status read = read_row(*fields); !read) return read.error();
    }
    if (keys_.size() < 2) return fault("row", "fewer than two rows", "a header and two rows or more");
    return PathTable{std::move(keys_), by_axes()};
}

// Whether all rows have what a camera has that is told nothing of it.
bool is_default(const std::vector<PathKey>& keys, const SceneKey& key) {
    Scene there, blank;
    for (const PathKey& each : keys) {
        there.camera = each.camera, blank.camera.zoom = there.camera.zoom ? std::optional(ZoomSpec{}) : std::nullopt;
        const KeyValue a = key.member.get(there), b = key.member.get(blank);
        if (a.number != b.number || a.choice != b.choice) return false;
    }
    return true;
}

std::vector<std::string> columns_of(const std::vector<PathKey>& keys, PathPlaces places) {
    std::vector<std::string> columns{"frame", "time"};
    if (places == PathPlaces::kCartesian)
        columns.insert(columns.end(), std::begin(kPlace), std::end(kPlace));
    else
        columns.insert(columns.end(), {"r", "theta", "phi"});
    columns.insert(columns.end(), {"yaw", "pitch", "roll", "observer"});
    columns.insert(columns.end(), std::begin(kVelocity), std::end(kVelocity));
    const CameraSpec& first = keys.front().camera;
    const bool by_plane =
        std::ranges::any_of(keys, [](const PathKey& key) { return key.camera.focal_distance != 1.0; });
    if (!projection_of(first).faces && !by_plane) columns.emplace_back("fov");
    Scene meaning;
    meaning.camera = first;
    for (const auto name : kKeyColumns) {
        const bool is_plane = name == "plane_width" || name == "focal_distance";
        const bool is_place = name == "r" || name == "theta" || name == "phi";
        if (is_place || (is_zoom(name) && !first.zoom) || (is_plane && !by_plane)) continue;
        const SceneKey& key = key_of(name);
        if (std::ranges::find(columns, name) == columns.end() && key.member.readable() &&
            (key.meant == nullptr || key.meant(meaning)) && (is_plane || is_zoom(name) || !is_default(keys, key)))
            columns.emplace_back(name);
    }
    if (!first.zoom) columns.insert(columns.end(), std::begin(kLookUp), std::end(kLookUp));
    return columns;
}

std::string field_text(const PathKey& key, std::string_view column) {
    const CameraSpec& camera = key.camera;
    if (column == "frame" || column == "time") return fmt::format("{}", column == "frame" ? key.frame : key.time);
    if (column == "fov") return field_of_view_text(camera);
    if (column == "observer") return observer_name(camera.observer);
    const std::array<double, 3> place = {camera.r * std::sin(camera.theta) * std::cos(camera.phi),
                                         camera.r * std::sin(camera.theta) * std::sin(camera.phi),
                                         camera.r * std::cos(camera.theta)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (column == kPlace[i]) return fmt::format("{}", place[i]);
        if (column == kVelocity[i]) return fmt::format("{}", camera.velocity.*kAxes[i]);
    }
    const Mat3 axes = world_from_camera(camera);
    for (std::size_t i = 0; i < 3; ++i) {
        if (column == kLookUp[i]) return fmt::format("{}", 0.0 - axes.c.*kAxes[i]);
        if (column == kLookUp[i + 3]) return fmt::format("{}", 0.0 + axes.b.*kAxes[i]);
    }
    Scene there;
    there.camera = camera;
    const SceneKey& row = key_of(column);
    const double number = row.member.get(there).number;
    return row.unit == "deg" ? degrees_text(number) : fmt::format("{}", number);
}

}  // namespace

Result<PathTable> read_path_csv(const std::string& text, const std::string& label, const Scene& scene) {
    return PathReader(label, scene).read(text);
}

Result<std::string> path_csv(const std::vector<PathKey>& given, PathPlaces places) {
    std::vector<PathKey> keys = given;
    for (std::size_t i = 1; i < keys.size(); ++i) unwrap_angles(keys[i - 1].camera, keys[i].camera);
    const std::vector<std::string> columns = columns_of(keys, places);
    std::string text = fmt::format("{}\n", fmt::join(columns, ","));
    for (const PathKey& key : keys) {
        if (places == PathPlaces::kCartesian && key.camera.r < 0.0)
            return bad_input("x, y, z: the path is on the other side of a wormhole, where l is below 0",
                             "r, theta, phi");
        Row row;
        for (const std::string& column : columns) row.push_back(field_text(key, column));
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (const auto turn = parse_number(row[i]);
                (columns[i] == "phi" || columns[i] == "yaw" || columns[i] == "roll") && turn &&
                !kAnyAngle.contains(*turn))
                return bad_input(fmt::format("frame {}: {} is {:.0f} degrees", key.frame, columns[i], *turn),
                                 "ten turns; write fewer frames into one file");
        text += fmt::format("{}\n", fmt::join(row, ","));
    }
    return text;
}

}  // namespace nullscope
