// A scene in words: each changes it and hands it on, so that a case of a list is a line.
#pragma once
#include <string>
#include <utility>

#include "scene/bodies.h"
#include "scene/scene.h"

namespace nullscope::test {

struct Draft {
    Scene scene{};
    operator Scene() const { return scene; }

    Draft& metric(std::string name, MetricParameters parameters = {}) {
        scene.spacetime = {std::move(name), std::move(parameters)};
        return *this;
    }
    Draft& spin(double a) { return scene.spacetime.parameters["spin"] = a, *this; }
    Draft& sky(SkyKind kind) { return scene.sky.kind = kind, *this; }
    Draft& at_time(double t) { return scene.time = t, *this; }
    Draft& disc(double inner, double outer) {
        return scene.disc.emplace().inner = inner, scene.disc->outer = outer, *this;
    }
    // Of the camera.
    Draft& size(int width, int height) { return scene.camera.width = width, scene.camera.height = height, *this; }
    Draft& r(double r) { return scene.camera.r = r, *this; }
    Draft& place(double r, double theta) { return scene.camera.r = r, scene.camera.theta = theta, *this; }
    Draft& plane(double width) { return scene.camera.plane_width = width, *this; }
    Draft& yaw(double yaw) { return scene.camera.yaw = yaw, *this; }
    Draft& by(ObserverKind observer) { return scene.camera.observer = observer, *this; }
    Draft& moving(Vec3 velocity) { return scene.camera.velocity = velocity, *this; }
    // Bodies; far: on the other side of a wormhole.
    template <class Shape>
    Draft& body(Shape shape, bool far = false) {
        return add_body(scene, std::move(shape)).far = far, *this;
    }
    Draft& sphere(double radius) { return body(SphereSpec{.radius = radius}); }
    Draft& ball(Vec3 at, double radius, bool far = false) {
        return body(BallSpec{.position = at, .radius = radius}, far);
    }
    Draft& cylinder(double inner, double outer, double height, bool far = false) {
        return body(CylinderSpec{inner, outer, height}, far);
    }
    Draft& surface(std::string shape, double bound, bool far = false) {
        return body(SurfaceSpec{.shape = std::move(shape), .bound = bound}, far);
    }
};

}  // namespace nullscope::test
