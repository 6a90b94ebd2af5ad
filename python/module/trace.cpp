// Lists of rays: columns of NumPy arrays in, rows of a structured array out, both where they are.
#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>

#include "command/ray_curves.h"
#include "command/ray_derivatives.h"
#include "command/ray_fields.h"
#include "command/ray_trace.h"
#include "module/call.h"
#include "module/module.h"
#include "scene/bodies.h"

namespace nullscope::python {
namespace {

// A column of another's array: doubles, or for words bytes. It stays as it is for as long as this is.
class Column {
public:
    explicit Column(const nb::handle& array) {
        if (PyObject_GetBuffer(array.ptr(), &view_, PyBUF_STRIDES) != 0) throw nb::python_error();
    }
    ~Column() { PyBuffer_Release(&view_); }
    Column(const Column&) = delete;
    Column& operator=(const Column&) = delete;
    std::size_t rows() const { return static_cast<std::size_t>(view_.shape[0]); }
    double number(std::size_t row) const {
        double value = 0;
        std::memcpy(&value, at(row), sizeof value);
        return value;
    }
    std::string word(std::size_t row) const {
        const auto most = static_cast<std::size_t>(view_.itemsize);
        return {at(row), strnlen(at(row), most)};
    }

private:
    const char* at(std::size_t row) const {
        return static_cast<const char*>(view_.buf) + static_cast<Py_ssize_t>(row) * view_.strides[0];
    }
    Py_buffer view_{};
};

using Columns = std::array<std::unique_ptr<Column>, cli::kRayColumns>;

class ArrayFields final : public cli::RayFields {
public:
    explicit ArrayFields(const Columns& columns) : columns_(columns) {}
    std::size_t row = 0;
    bool given(cli::RayColumn column) const override {
        if (!columns_[column]) return false;
        return cli::is_word(column) ? !columns_[column]->word(row).empty() : !std::isnan(columns_[column]->number(row));
    }
    std::optional<double> number(cli::RayColumn column) const override {
        const double value = columns_[column]->number(row);
        return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
    std::string text(cli::RayColumn column) const override {
        return cli::is_word(column) ? columns_[column]->word(row) : fmt::format("{}", columns_[column]->number(row));
    }

private:
    const Columns& columns_;
};

Error of_ray(std::size_t ray, Error error) {
    error.file = fmt::format("rays[{}]", ray);
    return error;
}

struct GivenRays {
    Columns columns;
    cli::RayForm form;
};

// The columns that rays have, by name; others are left alone.
GivenRays columns_of(const nb::dict& given, const Spacetime& spacetime) {
    Columns columns;
    std::array<bool, cli::kRayColumns> there{};
    for (const auto& [name, array] : given)
        if (const auto column = cli::ray_column(nb::cast<std::string>(name), spacetime)) {
            columns[*column] = std::make_unique<Column>(array);
            there[*column] = true;
        }
    const auto form = cli::ray_form(there);
    if (!form) {
        Error error = form.error();
        error.file = "rays", error.key.clear();
        throw Refused(error);
    }
    return {std::move(columns), *form};
}

Result<std::vector<RayQuery>> queries_of(const GivenRays& given, std::size_t count, const Spacetime& spacetime) {
    std::vector<RayQuery> queries;
    queries.reserve(count);
    for (ArrayFields fields(given.columns); fields.row < count; ++fields.row) {
        auto query = cli::ray_query(fields, given.form, spacetime);
        if (!query) return of_ray(fields.row, query.error());
        queries.push_back(*query);
    }
    return queries;
}

// A row of the answer: fate and hit, 32 bits each, then doubles.
class Rows {
public:
    Rows(std::uint8_t* data, int crossings, std::vector<cli::CrossingColumn> columns, double unit)
        : data_(data), crossings_(crossings), columns_(std::move(columns)), unit_(unit) {}
    std::size_t bytes() const { return 8 * (8 + static_cast<std::size_t>(crossings_) * columns_.size()); }
    void write(std::size_t row, const RayRecord& ray) const {
        const Fate fate = ray.fate == Fate::kHit && ray.hit == 0 ? Fate::kNoSky : ray.fate;
        const std::int32_t ends[] = {static_cast<std::int32_t>(fate), ray.hit};
        std::uint8_t* to = data_ + row * bytes();
        std::memcpy(to, ends, sizeof ends);
        to += sizeof ends;
        const auto put = [&](double value) { std::memcpy(to, &value, sizeof value), to += sizeof value; };
        for (const double value :
             {ray.theta_inf, ray.phi_inf, ray.angle, ray.delay / unit_, ray.g, ray.turn / unit_, ray.at / unit_})
            put(value);
        for (std::size_t k = 0; k < static_cast<std::size_t>(crossings_); ++k)
            for (const cli::CrossingColumn& column : columns_) {
                const double value = k < ray.crossings.size() ? ray.crossings[k].*column.value : kNotANumber;
                put(column.is_length ? value / unit_ : value);
            }
    }
    void write_empty(std::size_t row) const {
        RayRecord none;
        none.fate = static_cast<Fate>(-1);
        write(row, none);
    }

private:
    std::uint8_t* data_;
    int crossings_;
    std::vector<cli::CrossingColumn> columns_;
    double unit_;
};

using Bytes = nb::ndarray<std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

void trace(const Scene& scene, const nb::dict& rays, const Bytes& out, const cli::TraceOptions& options,
           const nb::object& progress) {
    const auto spacetime = space_of(scene.spacetime).metric;
    const GivenRays given = columns_of(rays, *spacetime);
    const Rows rows(out.data(), options.crossings, cli::crossing_columns(scene, *spacetime), spacetime->length_unit());
    const std::size_t count = out.shape(0) / rows.bytes();
    for (const auto& column : given.columns)
        if (column && column->rows() != count) throw Refused(bad_input("rays: columns of different lengths"));
    run(progress, [&](Watch& watch) -> Status {
        const cli::Listener listener = watch.listener();
        TRY(queries, queries_of(given, count, *spacetime));
        for (std::size_t i = 0; i < count; ++i) rows.write_empty(i);
        std::size_t traced = 0;
        const cli::TraceOutput output{[&](std::size_t i, RayRecord&& record) { rows.write(i, record), ++traced; },
                                      listener.progress("rays", static_cast<long long>(count)), of_ray};
        if (options.with == "gl") forget_session();  // tracing opens one of its own
        TRY(done, cli::trace_rays(scene, *spacetime, *queries, options, output));
        for (const std::string& note : {cli::left_out_note(count - traced, count, options),
                                        cli::no_places_note(scene, *spacetime, *queries, options)})
            if (!note.empty()) listener.note(note);
        return Done{};
    });
}

// Rows of points: ray, point, lambda to t_rate. NaN of rays without a curve. to: r, theta, Mino's time where curves end.
void curves(const Scene& scene, const nb::dict& rays,
            nb::ndarray<double, nb::ndim<3>, nb::c_contig, nb::device::cpu> out, double farthest,
            const std::array<std::optional<double>, 3>& to, const nb::object& progress) {
    constexpr double reference::CurvePoint::*kNumbers[] = {
        &reference::CurvePoint::affine,     &reference::CurvePoint::r,        &reference::CurvePoint::theta,
        &reference::CurvePoint::phi,        &reference::CurvePoint::t,        &reference::CurvePoint::r_rate,
        &reference::CurvePoint::theta_rate, &reference::CurvePoint::phi_rate, &reference::CurvePoint::t_rate};
    const auto spacetime = space_of(scene.spacetime).metric;
    const GivenRays given = columns_of(rays, *spacetime);
    const std::size_t count = out.shape(0), points = out.shape(1);
    double* data = out.data();
    run(progress, [&](Watch& watch) -> Status {
        const cli::Listener listener = watch.listener();
        TRY(queries, queries_of(given, count, *spacetime));
        std::fill_n(data, count * points * std::size(kNumbers), kNotANumber);
        std::size_t found = 0;
        const cli::CurveOutput output{[&](std::size_t i, cli::Curve&& curve) {
                                          double* next = data + i * points * std::size(kNumbers);
                                          for (const reference::CurvePoint& point : curve)
                                              for (const auto number : kNumbers) *next++ = point.*number;
                                          if (!curve.empty()) ++found;
                                      },
                                      listener.progress("rays", static_cast<long long>(count)), of_ray};
        TRY(done, cli::trace_curves(scene, spacetime->length_unit(), *queries,
                                    {static_cast<int>(points), farthest, to[0], to[1], to[2]}, output));
        const std::string note = cli::no_curve_note(count - found, count, farthest);
        if (!note.empty()) listener.note(note);
        return Done{};
    });
}

cli::DerivativeTracer derivative_tracer(const Scene& scene, const std::vector<std::string>& parameters, int crossings) {
    auto tracer = cli::DerivativeTracer::make(scene, parameters, crossings);
    if (!tracer) throw Refused(tracer.error());
    return std::move(*tracer);
}

// A row a ray: derivatives in the order of gradient_columns, and which of gradient_states it has.
void gradient(const Scene& scene, const nb::dict& rays, const std::vector<std::string>& parameters, int crossings,
              nb::ndarray<double, nb::ndim<2>, nb::c_contig, nb::device::cpu> out,
              nb::ndarray<std::int32_t, nb::ndim<1>, nb::c_contig, nb::device::cpu> states,
              const nb::object& progress) {
    const auto spacetime = space_of(scene.spacetime).metric;
    const GivenRays given = columns_of(rays, *spacetime);
    const cli::DerivativeTracer tracer = derivative_tracer(scene, parameters, crossings);
    const std::size_t count = out.shape(0), width = out.shape(1);
    double* data = out.data();
    std::int32_t* state = states.data();
    run(progress, [&](Watch& watch) -> Status {
        TRY(queries, queries_of(given, count, *spacetime));
        Status refused = Done{};
        const cli::TraceOutput output{[&](std::size_t i, RayRecord&& record) {
                                          const auto found = tracer.derivatives((*queries)[i], record);
                                          if (!found) {
                                              if (refused) refused = of_ray(i, found.error());
                                              return;
                                          }
                                          std::copy(found->values.begin(), found->values.end(), data + i * width);
                                          state[i] = static_cast<std::int32_t>(found->state);
                                      },
                                      watch.listener().progress("rays", static_cast<long long>(count)), of_ray};
        cli::TraceOptions options;
        options.crossings = crossings;
        TRY(done, cli::trace_rays(scene, *spacetime, *queries, options, output));
        return refused;
    });
}

Error unknown_word(const std::string& option, const std::string& word, const std::string& allowed) {
    return bad_key(option, fmt::format("'{}' is none of them", word), allowed);
}

cli::TraceOptions options_of(const std::string& with, const std::string& method, const std::string& context,
                             int crossings) {
    if (with != "reference" && with != "core64" && with != "core32" && with != "gl")
        throw Refused(unknown_word("with_", with, "reference, core64, core32, gl"));
    if (context != "auto" && context != "egl" && context != "osmesa")
        throw Refused(unknown_word("context", context, "auto, egl, osmesa"));
    if (crossings < 0 || crossings > 1000)
        throw Refused(bad_key("crossings", fmt::format("{} is out of range", crossings), "[0, 1000]"));
    return {with, method, context, crossings};
}

}  // namespace

void add_trace(nb::module_& m) {
    m.def(
        "trace",
        [](const Scene& scene, const nb::dict& rays, const Bytes& out, const std::string& with,
           const std::string& method, const std::string& context, int crossings, const nb::object& progress) {
            trace(scene, rays, out, options_of(with, method, context, crossings), progress);
        },
        nb::arg("scene"), nb::arg("rays"), nb::arg("out"), nb::arg("with_"), nb::arg("method"), nb::arg("context"),
        nb::arg("crossings"), nb::arg("progress").none());
    m.def("curves", &curves, nb::arg("scene"), nb::arg("rays"), nb::arg("out"), nb::arg("far"), nb::arg("to"),
          nb::arg("progress").none());
    m.def("gradient", &gradient, nb::arg("scene"), nb::arg("rays"), nb::arg("parameters"), nb::arg("crossings"),
          nb::arg("out"), nb::arg("states"), nb::arg("progress").none());
    m.def(
        "gradient_columns",
        [](const Scene& scene, const std::vector<std::string>& parameters, int crossings) {
            return derivative_tracer(scene, parameters, crossings).columns();
        },
        nb::arg("scene"), nb::arg("parameters"), nb::arg("crossings"), "d_NAME.x, ...");
    m.def(
        "gradient_states",
        [] { return std::vector<std::string>(std::begin(cli::kDerivativeStates), std::end(cli::kDerivativeStates)); },
        "Words of what gradient() says of a ray.");
    m.def(
        "crossing_columns",
        [](const Scene& scene) {
            nb::list names;
            for (const cli::CrossingColumn& column : cli::crossing_columns(scene, *space_of(scene.spacetime).metric))
                names.append(std::string(column.name));
            return names;
        },
        nb::arg("scene"), "What is listed of each crossing: r, phi, ...");
    m.def(
        "object_name", [](const Scene& scene, int hit) { return object_name(scene, hit); }, nb::arg("scene"),
        nb::arg("hit"), "What the number `hit` of ray data stands for: \"disc\", \"star\", a body's name.");
}

}  // namespace nullscope::python
