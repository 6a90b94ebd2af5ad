// A scene to be drawn, frame by frame: its camera's path, what stands beside it, the method.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "command/arguments.h"
#include "command/capture_picture.h"
#include "image/sphere_film.h"
#include "observer/path.h"
#include "scene/exposure.h"
#include "scene/scene.h"
#include "shaderlib/method.h"

namespace nullscope::cli {

struct Shot {
    Scene scene;
    std::optional<Scene> split{};      // beside it, instead of what the scene itself has there
    std::optional<CameraPath> path{};  // CameraPath::make(scene), where it has one
    int time_frame = 0;                // that has the scene's time
    Method method{};                   // of the shader
};

// time_step: scene time from frame to frame, r_s/c, where the path does not say it.
Scene scene_at(const Shot& shot, double time_step, double frame);
Exposure exposure_in(const Shot& shot, double time_step, int frame);
// Of all pictures that these frames are made of; empty where none is of a simulation's dumps. And whether there are dumps for each of
// them: an error says file, frame and the times that are allowed.
std::vector<double> times_in(const Shot& shot, double time_step, Frames frames);
Status check_times(const Shot& shot, double time_step, Frames frames, const std::string& file);

// What all of these frames show of the sphere, for a film's file. Nothing: they are none of it, or their fields of view differ.
std::optional<FilmSphere> sphere_in(const Shot& shot, double time_step, Frames frames);

// By its name, or "auto": the cheapest that was measured to keep max_error (px); said to the listener.
Result<Method> chosen_method(const std::string& name, std::optional<double> max_error, const Scene& scene,
                             const Listener& listener);

// Do the programs of a picture in tiles, a few tenths of a second to compile, save more than that? By what there is to draw, whether it
// is drawn now or was before: pictures do not depend on it but for rounding.
bool worth_tiles(const Shot& shot, int frames);

// Its picture, with what is beside it: two spacetimes, two eyes. lettered: labels and scale bar on what is display-encoded. next: as of
// capture_picture. session: null: the reference draws.
Result<Captured> draw_shot(const Shot& shot, Session* session, const Exposure& shown, const DrawOptions& options,
                           bool lettered, const Scene* next = nullptr);

}  // namespace nullscope::cli
