// How light runs in a frame: what is prepared for it on the host, its uniforms, its tables. A frame asks this of its light's path,
// never which metric it is. There are three kinds: straight, planar (orbits that stay in a plane, by tables) and Mino (about a
// rotating hole, step by step in Mino's time). No GL here.
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "plan/frame_plan.h"
#include "shadercore/core_trace.h"
#include "shadercore/polarised_light.h"
#include "shaderlib/method.h"
#include "table/deflection_table.h"
#include "table/ray_family.h"
#include "table/strip.h"

namespace nullscope {

struct NamedTexels {
    std::string_view name;  // as `nullscope plan` calls it
    const TexelGrid* texels;
};

class LightPath {
public:
    virtual ~LightPath() = default;
    // Tables of a camera that comes closer or goes away may be cubics between those of other radii (table/camera_tables.h): as exact, but
    // not the same bits as those of a camera that was always there.
    bool follows_camera = false;
    // Brings its tables up to date with the frame. True if one of them has changed or gone.
    virtual bool update(const FramePlan&) { return false; }

    // Axes that view directions and the camera's motion have in the uniform block, and the radial frame that rays start in.
    struct Start {
        Mat3 axes;
        RadialFrame radial;
    };
    virtual Start start(const FramePlan& plan, const Mat3& world) const { return {world, plan.observer.frame}; }
    // A ray of a list (shadercore/listed_ray.h) from this polar angle and azimuth; n: unit, in the observer's frame.
    virtual RayNumbers ray_numbers(const FramePlan& plan, double theta, double phi, Vec3 n) const;
    // The camera's frequency over that in matter which such a ray meets in the disc's plane. u: u^t, u^phi about the disc's axis, g_rr u^r.
    virtual double ray_g(const FramePlan& plan, const FrameData& frame, const RayNumbers& ray,
                         const ListedRay::Crossing& met, Vec3 u) const;
    // And that photon itself. number: which crossing it is, 1 for the first.
    virtual PolarisedPhoton photon_of(const FrameData& frame, const RayNumbers& ray, const ListedRay::Crossing& met,
                                      int number) const;
    virtual void write(const FramePlan&, FrameData&) const {}              // its own part of the uniform block
    virtual void give(const FramePlan& plan, CoreInput& input) const = 0;  // tables and kind, to the shader core as C++

    // What its shader fetches from, empty ones left out; views into this object.
    virtual std::vector<NamedTexels> tables() const { return {}; }
    virtual const RayFamily* family() const { return nullptr; }  // of the camera's radius, if its rays are a family
    virtual const DeflectionTable* table() const { return nullptr; }  // of the metric
    virtual bool finds_star_images() const { return false; }  // on the host; else the shader does, from the star lens

    // Errors: a method that cannot trace this frame, with those that can.
    virtual Status check(const Method& method, const FramePlan& plan) const = 0;
    double table_ms = 0.0, rows_ms = 0.0;  // time of the last deflection table, and of the last tables for a radius
};

// Of the light of this spacetime.
std::unique_ptr<LightPath> make_light_path(const std::shared_ptr<const Spacetime>& light);

// What a metric can be traced by: some methods need a shader of its own (shaders/method/closed_form, shaders/spacetime).
bool has_method(const Spacetime& spacetime, const Method& method);
std::string methods_of(const Spacetime& spacetime);  // "strip, strip:cubic, ..."
Error rotating_only(const Method& method);           // what a path says of a method that only Mino's has

}  // namespace nullscope
