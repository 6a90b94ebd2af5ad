// One picture of a scene, drawn by the shader or by the reference.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "command/capture_layers.h"
#include "command/draw_options.h"
#include "command/session.h"
#include "image/band_picture.h"
#include "image/image.h"
#include "scene/exposure.h"
#include "scene/ray.h"

namespace nullscope::cli {

struct Captured {
    Image<float> linear;                   // with Sample::kLight, and of the reference
    Image<unsigned char> bytes;            // with Sample::kByte: display-encoded
    std::optional<PictureRead> coming;     // with options.in_flight, in the place of bytes until they are taken
    Image<unsigned short> words;           // with Sample::kWord: the same
    std::optional<RayFrame> rays;          // with options.raydata
    std::optional<LayeredPicture> layers;  // with options.layers
    Image<float> stokes;  // PictureLayers::stokes; with options.stokes or layers, of scenes whose light is polarised
    std::vector<BandPicture> bands;  // with options.bands, of matter that is seen at several frequencies
    std::string made_by;

    void arrive();  // takes the bytes that are coming, if there are
    // Of what is display-encoded; 0: nothing is.
    int width() const;
    int height() const;
};

// Of displayed pictures. Errors: bad input.
Status check_size8(int width, int height);

// session: what the shader draws on; null: the reference draws. next: the next frame's scene, for motion vectors; null: there is none.
Result<Captured> capture_picture(Session* session, const Exposure& shown, const DrawOptions& options,
                                 const Scene* next = nullptr);

// The same for many pictures of what this scene shows: of it by other cameras, or at other times.
using PictureDrawer = std::function<Result<Captured>(const Exposure&)>;
Result<PictureDrawer> picture_drawer(Session* session, const Scene& scene, const DrawOptions& options);

// What comes before and after drawing by the session itself.
void begin_drawing(Session& session, const DrawOptions& options);
std::string made_by(const Session& session);
void tell_notes(Session& session, const Listener& listener);

}  // namespace nullscope::cli
