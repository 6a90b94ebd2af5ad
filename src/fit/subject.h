// Data with the model that predicts them, whatever they are: what a fit is of.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "fit/fitter.h"
#include "fit/model.h"
#include "fit/painted_model.h"
#include "fit/picture_data.h"
#include "fit/scene_painter.h"

namespace nullscope::fit {

struct Subject {
    Observed data;
    std::unique_ptr<Model> model;
    std::optional<Observed> coarse_data{};  // the same data, fewer, for the search
    std::unique_ptr<Model> coarse_model{};
    std::function<bool()> finer{};   // of the model, as of run_fit()
    std::function<int()> samples{};  // that it has now: rays along each side of a pixel; none: it draws no picture
};

struct FitOptions {
    bool free_flux = false;
    Loss loss = Loss::kHuber;
    SearchOptions search{};
};
Result<Fitted> fit_subject(Subject& subject, const std::vector<FreeParameter>& free, const FitOptions& options);

// The model of `subject`, made finer as long as that moves the answer, where nobody said how many samples.
void make_finer(Subject& subject, std::optional<int> samples, std::unique_ptr<PaintedModel> model);

// A picture; samples: rays along each side of a pixel, nothing: as many as it takes for the answer to stay.
Result<Subject> picture_subject(const std::shared_ptr<ScenePainter>& painter, const PictureSources& sources,
                                std::optional<int> samples);
Result<Subject> picture_subject(const std::shared_ptr<ScenePainter>& painter, const PictureData& data,
                                const std::string& name, std::optional<int> samples);

}  // namespace nullscope::fit
