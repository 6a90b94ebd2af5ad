// Zooming into the photon ring by hand (ZoomSpec, observer/ring_view.h).
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope::viewer {

// Towards the ring, or back, by this much of zoom.depth. Without a zoom the one begins whose point of the ring is nearest to the picture's
// middle; one that is taken back beyond 0 ends. False: nothing changed. Error: why there is none, a line; else it is emptied.
bool zoom_by(Scene& scene, double depth, std::string& error);

// Along the ring, as what was under the pointer follows it: px to the right, and up. Of a scene with a zoom.
void zoom_along(Scene& scene, double right, double up);

// "zoom 10^37.0, image order 27": the magnification and the highest image order at the picture's corners. Empty without a zoom. Makes the
// spacetime and traces four rays: once for a picture.
std::string zoom_words(const Scene& scene);

// These words over the picture, if there is room between left and right; units of Dear ImGui.
void draw_zoom_overlay(const std::string& words, float left, float right, float top);

}  // namespace nullscope::viewer
