// Visibilities as the data of a fit: a table (CSV) as `nullscope visibility` writes it (docs/telescope.md), and what a scene's picture has there.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "fit/data_sources.h"

namespace nullscope::fit {

// Real and imaginary part of each line; where the table has none, its amplitude. The picture has the scene's own size; samples: as
// picture_subject(). Errors (bad input): file, line and column of the first fault; the picture has no scale on the sky; of table and picture one is in
// Jy, and the flux is not free.
Result<Subject> visibility_subject(const std::shared_ptr<ScenePainter>& painter, const TableSource& source,
                                   std::optional<int> samples);

}  // namespace nullscope::fit
