// MP4 and QuickTime films of the sphere: what players and sites of 360-degree films ask the file for (Google, "Spherical Video V2 RFC").
#pragma once
#include <iosfwd>

#include "base/result.h"

namespace nullscope {

enum class FilmEyes { kOne = 0, kLeftAbove = 1, kLeftBeside = 2 };  // as stereo_mode of the box st3d

// An equirectangular film, the line of sight in the panorama's middle. What lies beyond a side of an eye's picture: of the panorama's width or
// height, [0, 1); of opposite sides together less than 1.
struct FilmSphere {
    FilmEyes eyes = FilmEyes::kOne;
    double top = 0.0, bottom = 0.0, left = 0.0, right = 0.0;
    friend bool operator==(const FilmSphere&, const FilmSphere&) = default;
};

// Copies a film with one track of pictures, and puts boxes that say so into its sample entry: sv3d, for two eyes st3d before it. Places in the
// file that it names are moved. film can be sought in; what is held in memory is its box moov. Errors: a structure that is not as ISO/IEC
// 14496-12 has it, fragments, several tracks of pictures, boxes of this kind that are there; a film that cannot be read. What is written then is
// no film. Errors of writing are film_with_sphere's state.
Status copy_with_sphere(std::istream& film, const FilmSphere& sphere, std::ostream& film_with_sphere);

}  // namespace nullscope
