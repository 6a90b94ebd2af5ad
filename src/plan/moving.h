// What in a scene depends on time.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/scene_fault.h"

namespace nullscope {

// The keys that make something move, as a plan names them: "disc.flow", "spot.r". Empty: every time looks the same.
std::vector<std::string> moving_parts(const Scene& scene);

// The first of them, and how many more there are; empty where nothing moves.
std::string moving_words(const Scene& scene);

// Whether pictures of other times differ: by what moves, or by matter of dumps, which is of one time in all of a picture and not seen late.
bool changes_with_time(const Scene& scene);

// Balls in free fall about a rotating hole that are seen at times which would take too long to follow them to.
std::vector<SceneFault> late_fall_faults(bool rotates, const Scene& scene);

bool surface_moves(const SurfaceSpec& surface);  // whether its formula asks for t

// Radius within which no part of a body that moves is seen, and no ball whose middle is there, r_s; 0: none. Followed back in time, rays stay
// above the horizon for ever: what they would meet there came out of it, or is not seen any more. From a hundredth of its radius above it matter that falls has g of 0.005, and
// matter at rest of 0.1. Where all that moves has a temperature, and so fades: from 5e-4 of its radius. Of cameras farther out; where light is delayed and bent.
double unseen_radius(const Scene& scene, std::optional<double> horizon);

}  // namespace nullscope
