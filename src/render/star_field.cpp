#include "render/star_field.h"

#include <cmath>

#include "base/assets.h"
#include "render/frame_tables.h"
#include "scene/projection_table.h"
#include "scene/warp_mesh.h"

namespace nullscope {

Status StarField::update(const Scene& scene, const FrameTables& tables, const Search& search) {
    if (!tables.effects().contains(Effect::kPointStars)) {
        *this = {};
        return Done{};
    }
    const bool bolometric = scene.light.bolometric, found = tables.path().finds_star_images();
    const auto key = std::make_tuple(scene.sky, bolometric, found);
    if (sky_key_ != key) {
        TRY(stars, point_stars(scene.sky, assets_directory()));
        mesh_.reset();
        view_key_.reset();
        if (found) {
            mesh_.emplace(*stars, bolometric);
        } else {
            const std::vector<StarLight> lights = star_lights(*stars, bolometric);
            std::vector<float> values;
            for (std::size_t i = 0; i < lights.size(); ++i) {
                const Vec3 v = (*stars)[i].direction;
                for (const double value : {v.x, v.y, v.z, lights[i].light, lights[i].temperature})
                    values.push_back(static_cast<float>(value));
            }
            vertices_ = gl::make_vertex_list(values, {3, 2});
        }
        sky_key_ = key;
    }
    if (found) find_images(scene, tables, search);
    return Done{};
}

void StarField::find_images(const Scene& scene, const FrameTables& tables, const Search& search) {
    CameraSpec whole = scene.camera;
    if (whole.part) whole.width = whole.part->width, whole.height = whole.part->height, whole.part.reset();
    const auto key = std::make_tuple(scene.spacetime, whole, scene.light);
    if (view_key_ == key && (search.quick || !quick_)) return;
    const double magnitude_limit = std::log2(kFaintestPoint / point_peak()) - scene.camera.exposure_ev +
                                   2.0 * std::log2(smallest_warp_share(scene.camera));
    CoreInput input = tables.core_input();  // rays to the sky, whatever is in their way
    input.frame.disc_x.w = 1e30, input.frame.disc_y.w = 0.0;
    input.spin_delay = false;
    const auto give_up = [&] { return search.give_up && search.give_up(); };
    const std::vector<MeshImage> images =
        mesh_->images(input, mesh_area(scene.camera, kPointMargin_px),
                      {scene.light.shift, scene.light.beaming, magnitude_limit, search.quick}, give_up);
    if (give_up()) return;
    std::vector<float> values;
    for (const MeshImage& image : images)
        for (const double value : {image.x, image.y, image.g,
                                   mesh_->light(image.star).light - std::log2(image.area * scene.camera.pixel_aspect),
                                   mesh_->light(image.star).temperature})
            values.push_back(static_cast<float>(value));
    vertices_ = gl::make_vertex_list(values, {3, 2});
    view_key_ = key;
    quick_ = search.quick;
}

void StarField::draw(const gl::Program& program, unsigned framebuffer, int width, int height, int images,
                     Projection projection) const {
    const ProjectionRow& row = projection_row(projection);
    const int copies = row.faces ? kFacesOfCube : row.round && !searches() ? 2 : 1;
    for (int image = 0; image < images; ++image) {
        gl::set_integer(program, "image_order", image);
        gl::draw_points(program, vertices_, vertices_.count, copies, framebuffer, width, height, kPointMargin_px);
    }
}

}  // namespace nullscope
