// The gallery: every scene that ships as a picture with its sentence, found by words, and files of one's own.
#pragma once
#include <string>
#include <vector>

#include "scenefile/scene_file.h"
#include "scenefile/tour_file.h"
#include "viewer/card_pictures.h"

namespace nullscope::viewer {

class Gallery {
public:
    // scenes, tours: those that ship.
    void open(const std::vector<SceneInfo>& scenes, const std::vector<TourInfo>& tours);
    void close() { open_ = false; }
    bool is_open() const { return open_; }
    // Pictures are still to be read: another frame is due. Each takes 10 ms, one a frame.
    bool loading() const { return open_ && pictures_.loading(); }

    // Between NewFrame and Render, between `top` and `bottom` of the window. What shall be opened, a tour or what load_scene takes, or "". all:
    // pictures are not left for later frames. escape: the key was pressed. throws gl::GlError.
    std::string draw(float top, float bottom, const std::vector<std::string>& recent, bool all, bool escape);

    bool browse_pressed = false;  // the button that asks for the desktop's dialog; for the viewer to take

private:
    std::string draw_head(const std::vector<std::string>& recent, bool escape);
    std::string draw_tours();
    std::string draw_cards(const SceneGroup& group, bool all);
    bool draw_card(const SceneInfo& scene, float width, bool all);
    bool matches(const SceneInfo& scene, const SceneGroup& group) const;

    bool open_ = false, opened_now_ = false;
    std::vector<SceneGroup> groups_;
    std::vector<TourInfo> tours_;
    CardPictures pictures_;
    std::string words_, path_;
};

}  // namespace nullscope::viewer
