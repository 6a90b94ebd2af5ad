// A picture as the subject of a fit: the search is of means over squares of pixels.
#include <algorithm>
#include <filesystem>
#include <utility>

#include "fit/picture_model.h"
#include "fit/subject.h"

namespace nullscope::fit {
namespace {

constexpr int kFewestPixels = 24;  // along a side of the search's picture

std::optional<PictureData> for_search(const PictureData& data) {
    for (int factor = std::min(data.light.width, data.light.height) / kFewestPixels; factor > 1; --factor)
        if (auto coarse = coarser(data, factor)) return coarse;
    return {};
}

}  // namespace

Result<Subject> picture_subject(const std::shared_ptr<ScenePainter>& painter, const PictureSources& sources,
                                std::optional<int> samples) {
    TRY(data, load_picture_data(sources));
    return picture_subject(painter, *data, std::filesystem::path(sources.data).filename().string(), samples);
}

Result<Subject> picture_subject(const std::shared_ptr<ScenePainter>& painter, const PictureData& data,
                                const std::string& name, std::optional<int> samples) {
    Subject subject{data.observed(name), nullptr};
    auto model = std::make_unique<PictureModel>(painter, data, samples.value_or(kFirstSamples));
    if (const auto coarse = for_search(data)) {
        subject.coarse_data = coarse->observed("");
        subject.coarse_model = std::make_unique<PictureModel>(painter, *coarse, kFirstSamples);
    }
    make_finer(subject, samples, std::move(model));
    return subject;
}

}  // namespace nullscope::fit
