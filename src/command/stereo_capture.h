// Stereo pictures (scene/stereo.h): each eye's, put together.
#pragma once
#include <vector>

#include "base/result.h"
#include "command/capture_picture.h"
#include "observer/path.h"

namespace nullscope::cli {

// What stereo pictures cannot be asked for. split: for another scene beside it. Errors: bad input.
Status check_stereo(const Scene& scene, const DrawOptions& options, bool split);
// Whether there is a place for the eyes of all frames. A millisecond a frame.
Status check_stereo_frames(const CameraPath& path, const Scene& scene, int first, int end);

// The pictures that stand side by side: those of a pair's eyes, left eye first; of other scenes the one picture.
Result<std::vector<Exposure>> side_by_side_pictures(const Exposure& shown);

// Its camera's stereo is not kOff.
Result<Captured> capture_stereo(Session* session, const Exposure& shown, const DrawOptions& options);

}  // namespace nullscope::cli
