// The feature of electrons that are not thermal (medium.electrons), with their keys.
#pragma once
#include "plan/feature.h"

namespace nullscope {

Feature electrons_feature();

}  // namespace nullscope
