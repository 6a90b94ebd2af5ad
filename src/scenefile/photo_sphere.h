// What viewers of panoramas ask a file for: which part of the sphere it is, of pictures as XMP (ISO 16684-1) of Google's namespace GPano.
#pragma once
#include <optional>
#include <string>

#include "image/sphere_film.h"
#include "scene/scene.h"

namespace nullscope {

// Of an equirectangular picture all round or of a part of the sphere, with the line of sight in the panorama's middle, but of a picture that would
// go across its sides its own middle. Empty: it is none (another projection, a mesh, a part of a picture, both eyes, beyond a pole).
std::string photo_sphere_packet(const CameraSpec& camera);

// The same of a film, also of both eyes, whose odd sizes lose a column or row (cli/film.h). Nothing: it is none.
std::optional<FilmSphere> film_sphere(const CameraSpec& camera);

}  // namespace nullscope
