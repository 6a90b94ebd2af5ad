// Text as coverage of pixels, by FreeType (only here).
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace nullscope {

// The file of the sans font for labels and panels: $NULLSCOPE_FONT where that is set, else the first of the usual
// distributions' that exists; nothing if there is none.
std::optional<std::filesystem::path> sans_font_file();

class Lettering {
public:
    // size_px: of an em, at least 1. Errors: no font, not a font that FreeType reads.
    static Result<Lettering> open(double size_px);
    Lettering(Lettering&&) noexcept;
    Lettering& operator=(Lettering&&) noexcept;
    ~Lettering();

    int ascent() const;  // px from a line's top to its baseline
    int height() const;  // of a line
    int width(std::string_view utf8) const;
    // One line on one channel: width() by height(), 255: covered. Bytes that are no UTF-8 and characters that the font
    // lacks: its mark for these.
    Image<unsigned char> line(std::string_view utf8) const;

private:
    struct Face;
    explicit Lettering(std::unique_ptr<Face> face);
    std::unique_ptr<Face> face_;
};

}  // namespace nullscope
