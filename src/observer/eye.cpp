#include "observer/eye.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "numeric/dormand_prince.h"
#include "observer/lorentz.h"
#include "observer/observer.h"
#include "observer/pose.h"
#include "observer/spin_frame.h"
#include "scene/stereo.h"
#include "spacetime/tortoise.h"

namespace nullscope {
namespace {

constexpr double kNoSpeed = 1e-10;       // c: rounding of a velocity that is 0
constexpr double kDifference = 2e-3;     // of the scale, for slopes
constexpr double kEyeTolerance = 1e-13;  // of a step, of the scale
constexpr double kShortest = 1e-4;       // of the way

using Four = std::array<double, 4>;
using Rows = std::array<Four, 4>;

Rows inverse(Rows m) {
    Rows out{};
    for (std::size_t i = 0; i < 4; ++i) out[i][i] = 1;
    for (std::size_t column = 0; column < 4; ++column) {
        std::size_t pivot = column;
        for (std::size_t i = column + 1; i < 4; ++i)
            if (std::fabs(m[i][column]) > std::fabs(m[pivot][column])) pivot = i;
        std::swap(m[column], m[pivot]), std::swap(out[column], out[pivot]);
        const double by = 1 / m[column][column];
        for (std::size_t j = 0; j < 4; ++j) m[column][j] *= by, out[column][j] *= by;
        for (std::size_t i = 0; i < 4; ++i) {
            const double times = i == column ? 0 : m[i][column];
            for (std::size_t j = 0; j < 4; ++j) m[i][j] -= times * m[column][j], out[i][j] -= times * out[column][j];
        }
    }
    return out;
}

struct EyePlace {
    double r, theta, phi;
};

// Coordinates that are regular on the axis and at a throat: ingoing v, and exp((r - middle)/scale) times the unit vector of theta and
// the ingoing phi. In these, a field of orthonormal frames that is there wherever a camera can be: of what falls with more energy than it
// needs, along world axes.
class FrameField {
public:
    FrameField(const Spacetime& spacetime, const CameraSpec& middle)
        : spacetime_(spacetime), middle_(middle), scale_(spacetime.areal_radius(middle.r)) {
        base_ = middle;
        base_.observer = ObserverKind::kThrow;
        base_.energy = 1 + 2 * std::sqrt(std::fmax(spacetime.lapse_squared(middle.r), 0.0));
        base_.yaw = base_.pitch = base_.roll = 0;
        base_.velocity = {};
    }

    Vec3 start() const { return world_from_static(middle_.theta, middle_.phi).a; }
    EyePlace place(Vec3 y) const {
        return {middle_.r + scale_ * std::log(length(y)), std::atan2(std::hypot(y.x, y.y), y.z), std::atan2(y.y, y.x)};
    }

    // e_0 and the three axes of a camera that is there, in these coordinates.
    Result<Rows> rows_of(const CameraSpec& camera, const EyePlace& at, Vec3 y) const {
        TRY(pair, ingoing_hat_pair(spacetime_, camera));
        const Mat3 world = world_from_static(at.theta, at.phi);
        Rows rows{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Four& row = pair->high[i];
            const Vec3 step = length(y) * (world * Vec3{row[1] / scale_, row[2], row[3]});
            rows[i] = {row[0], step.x, step.y, step.z};
        }
        return rows;
    }
    // Along e_r, e_theta, e_phi of an observer of this camera's kind.
    Result<Rows> static_rows(CameraSpec camera, const EyePlace& at, Vec3 y) const {
        camera.yaw = camera.pitch = camera.roll = 0;
        camera.velocity = {};
        TRY(rows, rows_of(camera, at, y));
        Rows turned{(*rows)[0], (*rows)[3], (*rows)[2], (*rows)[1]};
        for (double& x : turned[2]) x = -x;
        return turned;
    }
    Result<Rows> at(Vec3 y) const {
        CameraSpec camera = base_;
        const EyePlace there = place(y);
        camera.r = there.r, camera.theta = there.theta, camera.phi = there.phi;
        TRY(rows, static_rows(camera, there, y));
        const Mat3 local = transposed(world_from_static(there.theta, there.phi));  // columns: world axes
        Rows world{(*rows)[0]};
        std::size_t i = 1;
        for (const Vec3 axis : {local.a, local.b, local.c}) {
            for (std::size_t m = 0; m < 4; ++m)
                world[i][m] = axis.x * (*rows)[1][m] + axis.y * (*rows)[2][m] + axis.z * (*rows)[3][m];
            ++i;
        }
        return world;
    }

private:
    const Spacetime& spacetime_;
    const CameraSpec middle_;
    CameraSpec base_;
    double scale_;
};

constexpr double sign(std::size_t i) { return i == 0 ? -1 : 1; }

// nabla_along of the frame's vectors: change[c][a] is the component along F_a of that of F_c. By Koszul's formula from the commutators.
Result<Rows> turn_along(const FrameField& field, Vec3 y, const Four& along) {
    TRY(here, field.at(y));
    const Rows to_frame = inverse(*here);
    std::array<Rows, 3> slopes{};  // by y
    for (std::size_t k = 0; k < 3; ++k) {
        constexpr double kWeights[][2] = {{-2, 1. / 12}, {-1, -8. / 12}, {1, 8. / 12}, {2, -1. / 12}};
        for (const auto& [steps, weight] : kWeights) {
            const double by = steps * kDifference;
            TRY(there, field.at(y + Vec3{k == 0 ? by : 0, k == 1 ? by : 0, k == 2 ? by : 0}));
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t m = 0; m < 4; ++m) slopes[k][i][m] += weight / kDifference * (*there)[i][m];
        }
    }
    std::array<Rows, 4> commutator{};  // [F_b, F_c], lowered
    for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t c = 0; c < 4; ++c) {
            Four bracket{};
            for (std::size_t m = 0; m < 4; ++m)
                for (std::size_t k = 0; k < 3; ++k)
                    bracket[m] += (*here)[b][k + 1] * slopes[k][c][m] - (*here)[c][k + 1] * slopes[k][b][m];
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t m = 0; m < 4; ++m) commutator[b][c][a] += sign(a) * bracket[m] * to_frame[m][a];
        }
    Rows change{};
    for (std::size_t b = 0; b < 4; ++b)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t a = 0; a < 4; ++a)
                change[c][a] +=
                    sign(a) * along[b] * 0.5 * (commutator[b][c][a] - commutator[b][a][c] - commutator[c][a][b]);
    return change;
}

// v and y, then the camera's e_0 to e_3 along the frame, e_0 first.
constexpr std::size_t kSize = 20;
using State = std::array<double, kSize>;

Four eye_vector(const State& state, std::size_t i) {
    return {state[4 + 4 * i], state[5 + 4 * i], state[6 + 4 * i], state[7 + 4 * i]};
}

Result<State> slope(const FrameField& field, const State& state, Vec3 offset) {
    const Vec3 y{state[1], state[2], state[3]};
    const Four right = eye_vector(state, 1), up = eye_vector(state, 2), backward = eye_vector(state, 3);
    Four along{};
    for (std::size_t a = 0; a < 4; ++a) along[a] = offset.x * right[a] + offset.y * up[a] + offset.z * backward[a];
    TRY(frame, field.at(y));
    TRY(turn, turn_along(field, y, along));
    State change{};
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t m = 0; m < 4; ++m) change[m] += along[a] * (*frame)[a][m];
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t a = 0; a < 4; ++a) change[4 + 4 * i + a] -= state[4 + 4 * i + c] * (*turn)[c][a];
    return change;
}

Result<State> carried(const FrameField& field, State state, Vec3 offset) {
    Status status = Done{};
    const auto slope_or_nothing = [&](const State& at) {
        auto change = slope(field, at, offset);
        if (change) return *change;
        if (status) status = change.error();
        return State{};
    };
    double done = 0, h = 1;
    while (done < 1) {
        status = Done{};
        State wrong{};
        const State next = dormand_prince(state, h, slope_or_nothing, wrong);
        double error = status ? 0 : HUGE_VAL;
        for (const double one : wrong) error = std::fmax(error, std::fabs(one) / kEyeTolerance);
        if (error <= 1 || h <= kShortest) {
            if (!status) return status.error();
            state = next, done += h;
        }
        h = std::fmin(std::fmax(h * next_step_factor(error), kShortest), 1 - done);
    }
    return state;
}

// By how much Scene::time of this camera is behind v.
double behind(const Spacetime& spacetime, const CameraSpec& camera) {
    return camera.r + (falls(camera) ? 0.0 : time_ahead(spacetime, camera.r));
}

double azimuth_ahead_of(const Spacetime& spacetime, const CameraSpec& camera) {
    return falls(camera) ? 0.0 : spacetime.azimuth_ahead(camera.r);
}

}  // namespace

Result<Eye> eye_beside(const Spacetime& spacetime, const CameraSpec& camera, Vec3 offset) {
    if (offset == Vec3{}) return Eye{camera, 0};
    const double most = kFarthestEye * spacetime.areal_radius(camera.r);
    if (!(length(offset) <= most))
        return bad_key("camera.eye_distance", "the eyes are too far apart for their distance from the centre",
                       fmt::format("at most {:.6g} here", 2 * most));
    const FrameField field(spacetime, camera);
    const Vec3 start = field.start();
    TRY(rows, field.rows_of(camera, {camera.r, camera.theta, camera.phi}, start));
    TRY(frame, field.at(start));
    const Rows to_frame = inverse(*frame);
    State state{0, start.x, start.y, start.z};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t m = 0; m < 4; ++m) state[4 + 4 * i + a] += (*rows)[i][m] * to_frame[m][a];
    TRY(end, carried(field, state, offset));

    const Vec3 y{(*end)[1], (*end)[2], (*end)[3]};
    const EyePlace at = field.place(y);
    Eye eye{camera};
    eye.camera.r = at.r, eye.camera.theta = at.theta;
    eye.camera.phi = camera.phi + std::remainder(at.phi - camera.phi, 2 * M_PI) -
                     (azimuth_ahead_of(spacetime, eye.camera) - azimuth_ahead_of(spacetime, camera));
    if (camera.observer == ObserverKind::kFall) eye.camera.fall_from = std::fmax(camera.fall_from, at.r);
    eye.later = (*end)[0] - (behind(spacetime, eye.camera) - behind(spacetime, camera));
    TRY(there, field.at(y));
    TRY(own, field.static_rows(eye.camera, at, y));
    const Rows to_own = inverse(*own);
    Lorentz tetrad{};  // columns: the camera's, along the observer's own
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t m = 0; m < 4; ++m)
                for (std::size_t b = 0; b < 4; ++b)
                    tetrad[b][i] += (*end)[4 + 4 * i + a] * (*there)[a][m] * to_own[m][b];
    const BoostAndTurn parts = split(tetrad);
    const bool still = camera.velocity == Vec3{} && length(parts.velocity) <= kNoSpeed;
    eye.camera.velocity = still ? Vec3{} : parts.velocity;
    set_axes(eye.camera, parts.turn);
    return eye;
}

Status check_eyes(const Spacetime& spacetime, const CameraSpec& camera) {
    if (camera.stereo == Stereo::kOff) return Done{};
    const int places = camera.stereo == Stereo::kAllRound ? 8 : 1;
    for (int i = 0; i < places; ++i)
        for (const EyeSide side : {EyeSide::kLeft, EyeSide::kRight}) {
            const double x = (i + 0.5) * camera.width / places;
            if (const auto eye = eye_beside(spacetime, camera, eye_offset(camera, side, x)); !eye)
                return bad_key("camera.eye_distance", "no eye can be there: " + eye.error().what, eye.error().allowed);
        }
    return Done{};
}

}  // namespace nullscope
