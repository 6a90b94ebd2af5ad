// What viewers of panoramas ask a picture's file for: which part of the sphere it is, as XMP (ISO 16684-1) of Google's namespace GPano.
#pragma once
#include <string>

#include "scene/scene.h"

namespace nullscope {

// Of an equirectangular picture all round or of a part of the sphere, with the line of sight in the panorama's middle, but of a picture that would
// go across its sides its own middle. Empty: it is none (another projection, a mesh, a part of a picture, both eyes, beyond a pole).
std::string photo_sphere_packet(const CameraSpec& camera);

}  // namespace nullscope
