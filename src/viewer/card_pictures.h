// Pictures of cards, read from files while the panels are drawn, one a frame.
#pragma once
#include <imgui.h>

#include <filesystem>
#include <map>

#include "gl/gl.h"

namespace nullscope::viewer {

struct CardPicture {
    static constexpr float kShape = 9.0f / 16.0f;  // height over width, of the cards
    gl::Texture texture;
    float shape = kShape;
};

class CardPictures {
public:
    void begin_frame() { loading_ = read_in_this_frame_ = false; }
    // A picture was left for a later frame since begin_frame().
    bool loading() const { return loading_; }
    // nullptr: it cannot be read, or not yet; one is read in a frame, which takes 10 ms. all: none is left for later. throws gl::GlError.
    const CardPicture* find(const std::filesystem::path& file, bool all);

private:
    bool loading_ = false, read_in_this_frame_ = false;
    std::map<std::filesystem::path, CardPicture> pictures_;  // without a texture: it could not be read
};

// A picture, which may be nullptr, in a black frame of that width; over: with a bright edge. Between Begin and End of a window.
void draw_card_picture(const CardPicture* picture, ImVec2 at, float width, bool over);

}  // namespace nullscope::viewer
