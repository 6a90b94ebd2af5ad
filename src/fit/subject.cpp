#include "fit/subject.h"

#include <utility>

namespace nullscope::fit {
namespace {

constexpr double kSettledSearch = 1;  // change of chi^2: all data are fitted afterwards

}  // namespace

Result<Fitted> fit_subject(Subject& subject, const std::vector<FreeParameter>& free, const FitOptions& options) {
    const Problem problem{subject.data, *subject.model, free, options.free_flux, options.loss};
    std::optional<Problem> coarse;
    if (subject.coarse_data)
        coarse.emplace(Problem{*subject.coarse_data, *subject.coarse_model, free, options.free_flux, options.loss,
                               kSettledSearch});
    return run_fit(problem, coarse ? &*coarse : nullptr, options.search, subject.finer);
}

void make_finer(Subject& subject, std::optional<int> samples, std::unique_ptr<PaintedModel> model) {
    if (!samples) subject.finer = [model = model.get()] { return model->finer(); };
    subject.samples = [model = model.get()] { return model->samples(); };
    subject.model = std::move(model);
}

}  // namespace nullscope::fit
