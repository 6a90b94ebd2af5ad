#include "render/frame_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

#include "render/body_numbers.h"
#include "render/frame_numbers.h"

namespace nullscope {

Status FrameTables::update(const Scene& scene) {
    TRY(planned, plan_frame(scene, delays_wanted_, path_ != nullptr ? &plan_ : nullptr));
    if (crossings_wanted_ && planned->matter->can_have_disc()) planned->effects.insert(Effect::kDisc);
    planned->passed = passed_;
    TRY(balls, nullscope::ball_paths(*planned->matter, scene));
    ball_paths_ = std::move(*balls);
    std::set<SolidFormula> solids;
    for (const Body& body : scene.bodies)
        if (const auto* surface = std::get_if<SurfaceSpec>(&body.shape)) solids.insert(solid_of(*surface));
    if (clearances_.update(solids)) ++clearances_revision_;
    const FramePlan before = std::exchange(plan_, std::move(*planned));
    if (before.light != plan_.light) {
        path_ = make_light_path(plan_.light);
        ++revision_;
    }
    path_->follows_camera = follows_camera_;
    if (path_->update(plan_)) ++revision_;
    return Done{};
}

const TexelGrid* FrameTables::texels(std::string_view name) const {
    for (const NamedTexels& table : path_->tables())
        if (table.name == name) return table.texels;
    return nullptr;
}

CoreInput FrameTables::core_input() const {
    CoreInput input;
    input.frame = frame_numbers(plan_, *path_, {}, ball_paths_);
    input.aberration = plan_.effects.contains(Effect::kAberration);
    input.zoom = plan_.effects.contains(Effect::kZoom);
    path_->give(plan_, input);
    return input;
}

void FrameTables::list_rays(bool in_double, const ListedCrossings& asked, std::span<const RayNumbers> rays,
                            ListedRay* found) const {
    constexpr std::size_t kBlock = 256;  // rays: setting up the core costs as much as a fraction of one
    const CoreInput input = core_input();
    tbb::parallel_for(std::size_t{0}, (rays.size() + kBlock - 1) / kBlock, [&](std::size_t block) {
        const std::size_t first = block * kBlock;
        const auto part = rays.subspan(first, std::min(kBlock, rays.size() - first));
        (in_double ? list_core64 : list_core32)(input, asked, part, found + first);
    });
}

}  // namespace nullscope
