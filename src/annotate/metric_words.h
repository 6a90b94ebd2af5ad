// A spacetime in a few words, for labels.
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope {

// "Kerr, a = 0.9 M": the metric, with the parameters that tell it from `other`: of another metric those that name it,
// of the same one those whose values differ. A metric that is not known here goes by the words of its key and those of
// its parameters that are given.
std::string metric_words(const SpacetimeSpec& spec, const SpacetimeSpec& other);

}  // namespace nullscope
