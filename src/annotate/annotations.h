// What is written over a displayed picture: labels of a split screen's halves, a scale bar. Never over linear light or
// ray data.
#pragma once
#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/split.h"

namespace nullscope {

struct ScaleBarMark {
    double length_px = 0.0;
    std::string words;  // "20 µas"
    friend bool operator==(const ScaleBarMark&, const ScaleBarMark&) = default;
};

struct Annotations {
    bool divided = false;     // in two halves: a line between them
    std::string left, right;  // labels; empty: none
    std::optional<ScaleBarMark> bar;
    bool empty() const { return !divided && !bar; }
    friend bool operator==(const Annotations&, const Annotations&) = default;
};

// scene: with the camera and the size that are drawn; halves: of a split screen, else nothing. Labels are those of
// scene.split_labels, by default what differs between the halves: their spacetimes, what is left out of light's
// propagation, and where that is the same the scenes' names. The bar is the longest of 1, 2 or 5 times a power of ten
// that takes at most a quarter of the width (a third of a half's), in its unit of scene.picture.scale_bar; nothing
// where the picture has no scale (observer/picture_scale.h).
Annotations annotations_of(const Scene& scene, const std::optional<Halves>& halves);

// How many r_s one microarcsecond is at the object's distance: (1e-6"/1 rad) D c^2/(2 G M).
double length_of_microarcsecond(double mass_suns, double distance_pc);
std::optional<double> length_of_microarcsecond(const ObjectSpec& object);  // nothing: a mass or a distance is not known

}  // namespace nullscope
