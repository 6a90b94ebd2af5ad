// The strip of bookmarks above the window's bottom: pictures to open, rename and delete.
#pragma once
#include <string>

#include "studio/bookmarks.h"
#include "viewer/card_pictures.h"

namespace nullscope::viewer {

class BookmarkPanel {
public:
    struct Chosen {
        std::string file;          // to open, or ""
        bool camera_only = false;  // what is shown stays, the camera goes where that scene's is
    };
    // Between NewFrame and Render, from `left` to `right` where there is room for a card, above `bottom`. all:
    // nothing is left for later frames. escape: the key was pressed. open: false once it was closed. throws gl::GlError.
    Chosen draw(bool& open, Bookmarks& bookmarks, float left, float right, float bottom, bool all, bool escape);
    float height() const {
        return height_;
    }               // that it took in its last frame, with the gap below; 0 while it is hidden
    void forget();  // in a frame without it
    bool loading() const { return loading_; }  // files are still to be read: another frame is due

    bool add_pressed = false;  // taken by who keeps the view
    std::string message;       // likewise: what was done, or why it was not

private:
    void read_one(Bookmarks& bookmarks, bool all);
    void draw_buttons(bool& open, Bookmarks& bookmarks);
    Chosen draw_cards(Bookmarks& bookmarks, float width, bool all, bool escape);
    Chosen draw_card(Bookmarks& bookmarks, const Bookmark& bookmark, float width, bool all, bool escape);
    bool draw_name(Bookmarks& bookmarks, const Bookmark& bookmark, float width);
    void rename(Bookmarks& bookmarks, const std::string& stem);

    bool shown_ = false, loading_ = false, rename_begins_ = false;
    float height_ = 0.0f;
    CardPictures pictures_;
    std::string first_;               // of the cards
    std::string renamed_, new_name_;  // whose name is being typed, or ""
    std::string deleted_;             // when the cards are drawn
};

}  // namespace nullscope::viewer
