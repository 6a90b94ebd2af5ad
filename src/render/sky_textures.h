// The skies of a scene as one texture: the faces are layers, six for each side of a wormhole, so that a pixel fetches once
// (shaders/object/sky_face.glsl).
#pragma once
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "gl/gl.h"
#include "scene/scene.h"
#include "sky/packed_sky.h"
#include "sky/sky_painter.h"

namespace nullscope {

class SkyTextures {
public:
    // Starts to make ready what these skies need, on other threads, unless they are loaded. size: of a face; 0 without any sky.
    void begin(const std::optional<SkySpec>& near, const std::optional<SkySpec>& far, int size);
    // Paints and uploads what was begun, a piece at least, until goes_on() says no: whether all is there. Errors: SkyPainter::make's; nothing is
    // loaded then. notes: for people, a line each.
    Result<bool> finish(std::vector<std::string>& notes, const std::function<bool()>& goes_on);

    // Of near and far; units that no sky needs stay bare.
    void bind(int near_unit, int far_unit) const;

    int size() const { return size_; }                     // of a face
    double light() const { return 1.0 / packing_.scale; }  // of a texel of 1
    std::size_t texel_bytes() const { return nullscope::texel_bytes(packing_.format); }
    bool near() const { return near_.has_value(); }
    bool far() const { return far_.has_value(); }

private:
    Status make_next(std::vector<std::string>& notes);
    Status make_painters(std::vector<std::string>& notes);
    void upload_next(bool halves);

    gl::Texture layers_;                 // the near sky's first
    std::optional<SkySpec> near_, far_;  // that are loaded, or begun
    int size_ = 0;
    SkyPacking packing_;                                     // of both
    std::vector<std::future<Result<SkyPainter>>> painters_;  // begun
    std::vector<SkyPainter> left_;                           // whose skies are not all uploaded, the last first
    std::unique_ptr<SkyPacker> packer_;                      // of the last one's
};

}  // namespace nullscope
