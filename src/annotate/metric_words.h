// A spacetime in a few words, for labels.
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope {

// "Kerr, a = 0.9 M": the metric, with the parameters that tell it from `other`: of another metric those that name it, of the same one those
// whose values differ. Metrics that are not known here go by their key and all their parameters that are given.
std::string metric_words(const SpacetimeSpec& spec, const SpacetimeSpec& other);

}  // namespace nullscope
