// The embedding diagram over the picture: studio/embedding.h, seen obliquely from above.
#pragma once
#include "viewer/overlay.h"

namespace nullscope::viewer {

// With the probe's ray; nothing where there is too little room for it.
extern const Overlay kEmbeddingOverlay;

}  // namespace nullscope::viewer
