// A light curve as the data of a fit: a table (CSV) as `nullscope lightcurve` writes it, and what a scene's pictures have at these times.
#pragma once
#include <memory>
#include <optional>

#include "base/result.h"
#include "fit/data_sources.h"
#include "fit/subject.h"

namespace nullscope::fit {

// Jy of each line, at one frequency or at several, where table and scene have them; else the flux, luminance times solid angle. Times are those of
// the scene, r_s/c (time), or seconds from the scene's own time on (time_s), by the object's mass. The picture has the scene's own size; samples: as
// picture_subject(). Errors (bad input): file, line and column of the first fault; a scene where nothing changes with time, or in another unit.
Result<Subject> curve_subject(const std::shared_ptr<ScenePainter>& painter, const TableSource& source,
                              std::optional<int> samples);

}  // namespace nullscope::fit
