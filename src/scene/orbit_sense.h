// Which way the words of a scene are about a hole.
#pragma once
#include "scene/medium_spec.h"
#include "spacetime/circular_orbit.h"

namespace nullscope {

inline Sense sense_about(const Spacetime& spacetime, OrbitSense sense) {
    const bool turns_westward = spacetime.a() < 0.0;
    switch (sense) {
        case OrbitSense::kEastward: return Sense::kEastward;
        case OrbitSense::kWestward: return Sense::kWestward;
        case OrbitSense::kPrograde: return turns_westward ? Sense::kWestward : Sense::kEastward;
        case OrbitSense::kRetrograde: break;
    }
    return turns_westward ? Sense::kEastward : Sense::kWestward;
}

}  // namespace nullscope
