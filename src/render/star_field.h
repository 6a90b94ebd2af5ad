// Point stars on the GPU: the vertices of a sky, and their drawing, one pass an image (table/star_lens.h). About a rotating hole the
// vertices are images, found on the host for every camera (render/star_mesh.h), and one pass draws them.
#pragma once
#include <functional>
#include <optional>
#include <tuple>

#include "base/result.h"
#include "gl/gl.h"
#include "render/star_mesh.h"
#include "scene/scene.h"

namespace nullscope {

class FrameTables;

class StarField {
public:
    // Loads what the scene's sky calls for unless it is loaded; where no effect wants stars it drops them. Errors: the catalogue cannot
    // be read. Some 30 ms for the catalogue, 100 ms for a million stars; about a rotating hole half a second of two cores for every new view (docs/light.md).
    // search: of the images of a new view.
    struct Search {
        bool quick = false;             // StarMesh::Seeing
        std::function<bool()> give_up;  // then this view is not ready: what draws it asks the same
    };
    Status update(const Scene& scene, const FrameTables& tables, const Search& search);
    // Adds the stars to a picture in linear light whose alpha says what shines through. images: how many of each star.
    void draw(const gl::Program& program, unsigned framebuffer, int width, int height, int images,
              Projection projection) const;
    bool searches() const { return mesh_.has_value(); }  // for images, in every new view
    int count() const { return vertices_.count; }
    std::size_t bytes() const { return static_cast<std::size_t>(vertices_.count) * 5 * sizeof(float); }

private:
    void find_images(const Scene& scene, const FrameTables& tables, const Search& search);

    std::optional<std::tuple<SkySpec, bool, bool>> sky_key_;  // of the stars: bolometric; images found on the host
    std::optional<std::tuple<SpacetimeSpec, CameraSpec, LightSpec>> view_key_;  // of images found on the host
    bool quick_ = false;                                                        // they were
    gl::VertexList vertices_;
    std::optional<StarMesh> mesh_;
};

}  // namespace nullscope
