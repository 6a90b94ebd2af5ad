// Fits of scenes to data, and likelihoods for samplers.
#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "command/json.h"
#include "fit/data_sources.h"
#include "fit/likelihood.h"
#include "fit/nuisance.h"
#include "fit/report.h"
#include "module/arrays.h"
#include "module/call.h"
#include "module/module.h"

namespace nullscope::python {
namespace {

using Plane = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

// What nullscope/_fits.py hands over: DataSources, and what is free.
struct FitAsked {
    std::string free, nuisance, loss = "huber", context = "auto";
    fit::DataSources sources;
    std::optional<int> starts, seed;
};

Image<double> plane_of(const nb::handle& given) {
    const auto plane = nb::cast<Plane>(given);
    Image<double> image(static_cast<int>(plane.shape(1)), static_cast<int>(plane.shape(0)), 1);
    std::copy_n(plane.data(), image.data.size(), image.data.begin());
    return image;
}

FitAsked fit_asked(const nb::dict& options) {
    const auto take = [&]<class T>(const char* name, T& to) {
        if (options.contains(name) && !nb::handle(options[name]).is_none()) to = nb::cast<T>(options[name]);
    };
    FitAsked asked;
    take("free", asked.free), take("nuisance", asked.nuisance), take("loss", asked.loss);
    take("context", asked.context), take("starts", asked.starts), take("seed", asked.seed);
    take("data", asked.sources.data), take("sigma", asked.sources.sigma), take("mask", asked.sources.mask);
    take("samples", asked.sources.samples), take("table", asked.sources.table);
    if (options.contains("light"))
        asked.sources.picture = fit::PictureData{plane_of(options["light"]), plane_of(options["deviation"])};
    return asked;
}

struct OpenedFit {
    fit::FreeScene free;
    fit::Subject subject;
};
Result<OpenedFit> open_fit(const std::string& scene, FitAsked& asked) {
    TRY(fixed, fit::SceneFamily::of_text(scene, {}));
    TRY(free, fit::free_scene(*fixed, asked.free, asked.nuisance));
    asked.sources.free_flux = free->flux;
    const fit::SessionSource sessions = [context = asked.context] { return session_of(context); };
    TRY(subject, fit::open_subject(free->family, sessions, asked.sources));
    return OpenedFit{std::move(*free), std::move(*subject)};
}

// JSON of `nullscope fit --json` with all digits, and the best scene.
nb::tuple fitted(const Scene& scene, const nb::dict& options, const nb::object& progress) {
    FitAsked asked = fit_asked(options);
    const auto* loss = std::ranges::find(fit::kLossNames, asked.loss);
    if (loss == std::end(fit::kLossNames))
        throw Refused(bad_key("loss", fmt::format("'{}' is none of them", asked.loss), "none, huber, cauchy"));
    const auto [text, scene_found] =
        run(progress, [&, scene = pickled(scene)](Watch& watch) -> Result<std::pair<std::string, Scene>> {
            TRY(opened, open_fit(scene, asked));
            fit::FitOptions fitting;
            fitting.free_flux = opened->free.flux, fitting.loss = static_cast<fit::Loss>(loss - fit::kLossNames);
            fitting.search.starts = asked.starts.value_or(fitting.search.starts);
            if (asked.seed) fitting.search.seed = static_cast<std::uint64_t>(*asked.seed);
            fitting.search.progress = watch.listener().progress;
            const std::vector<fit::FreeParameter>& free = opened->free.family.free();
            TRY(found, fit::fit_subject(opened->subject, free, fitting));
            const auto& samples = opened->subject.samples;
            const fit::Reported reported{*found, free, opened->subject.data.what,
                                         samples ? std::optional(samples()) : std::nullopt, opened->free.flux};
            TRY(best, opened->free.family.at(found->best.values));
            return std::pair(fit::fit_json(reported).dump(), std::move(*best));
        });
    return nb::make_tuple(text, scene_found);
}

std::unique_ptr<fit::Likelihood> likelihood(const Scene& scene, const nb::dict& options,
                                            const std::vector<double>& around) {
    FitAsked asked = fit_asked(options);
    return run(nb::none(), [&, scene = pickled(scene)](Watch&) -> Result<std::unique_ptr<fit::Likelihood>> {
        TRY(opened, open_fit(scene, asked));
        const std::vector<fit::FreeParameter> free = opened->free.family.free();
        if (!around.empty() && around.size() != free.size())
            return bad_key("around", fmt::format("{} numbers", around.size()), fmt::format("{}", free.size()));
        TRY(made, fit::Likelihood::make(std::move(opened->subject), free, opened->free.flux, around));
        return std::make_unique<fit::Likelihood>(std::move(*made));
    });
}

using Values = std::vector<double>;

void check_count(const fit::Likelihood& likelihood, const Values& values) {
    if (values.size() != likelihood.free().size())
        throw Refused(
            bad_key("values", fmt::format("{} numbers", values.size()), fmt::format("{}", likelihood.free().size())));
}

nb::tuple value_and_slope(fit::Likelihood& likelihood, const Values& values, bool with_slope) {
    check_count(likelihood, values);
    auto found = run(nb::none(), [&](Watch&) { return likelihood.at(values, with_slope); });
    const std::size_t count = found.slope.size();
    return nb::make_tuple(found.log, array_of(std::move(found.slope), {count}));
}

auto prediction(fit::Likelihood& likelihood, const Values& values) {
    check_count(likelihood, values);
    auto found = run(nb::none(), [&](Watch&) { return likelihood.predict(values); });
    const std::size_t count = found.size();
    return array_of(std::move(found), {count});
}

auto derivatives(fit::Likelihood& likelihood, const Values& values) {
    check_count(likelihood, values);
    const auto found = run(nb::none(), [&](Watch&) { return likelihood.derivatives(values); });
    Values flat;
    for (const fit::Prediction& column : found) flat.insert(flat.end(), column.begin(), column.end());
    return array_of(std::move(flat), {found.size(), likelihood.data().value.size()});
}

}  // namespace

void add_fit(nb::module_& m) {
    nb::class_<fit::Likelihood>(m, "Likelihood", "Of data, by a scene; nullscope.likelihood() makes it.")
        .def("at", value_and_slope, nb::arg("values"), nb::arg("with_slope"),
             "The logarithm, and its derivatives or an empty array.")
        .def("predict", prediction, nb::arg("values"), "A number for each datum.")
        .def("derivatives", derivatives, nb::arg("values"), "Of each datum's prediction, shape (values, data).")
        .def_prop_ro("keys",
                     [](const fit::Likelihood& l) {
                         std::vector<std::string> keys;
                         for (const auto& one : l.free()) keys.push_back(one.key);
                         return keys;
                     })
        .def_prop_ro("bounds",
                     [](const fit::Likelihood& l) {
                         std::vector<std::pair<double, double>> bounds;
                         for (const auto& one : l.free()) bounds.emplace_back(one.low, one.high);
                         return bounds;
                     })
        .def("data", [](const fit::Likelihood& l) { return array_of(Values(l.data().value), {l.data().value.size()}); })
        .def("sigma",
             [](const fit::Likelihood& l) { return array_of(Values(l.data().sigma), {l.data().sigma.size()}); });
    m.def("likelihood", likelihood, nb::arg("scene"), nb::arg("options"), nb::arg("around"),
          "Options as of nullscope/_fits.py; around: values, or empty.");
    m.def("fit", fitted, nb::arg("scene"), nb::arg("options"), nb::arg("progress").none(),
          "What `nullscope fit --json` prints, and the best scene.");
}

}  // namespace nullscope::python
