#include "annotate/lettering.h"

#include <fmt/format.h>
#include <ft2build.h>
// FreeType's headers are named by its macros.
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <system_error>
#include <utility>

namespace nullscope {
namespace {

// Of common distributions.
constexpr const char* kFonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/google-noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Supplemental/Arial.ttf",
    "C:/Windows/Fonts/segoeui.ttf",
};

constexpr FT_Int32 kLoad = FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT;
constexpr char32_t kReplacement = 0xfffd;

// The character at the front of text, which loses its bytes.
char32_t take_character(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
    char32_t character = length == 1 ? first : first & (0x7f >> length);
    bool good = length > 0 && length <= text.size();
    for (std::size_t i = 1; good && i < length; ++i) {
        good = (byte(i) & 0xc0) == 0x80;
        character = character << 6 | (byte(i) & 0x3f);
    }
    text.remove_prefix(good ? length : 1);
    return good ? character : kReplacement;
}

}  // namespace

std::optional<std::filesystem::path> sans_font_file() {
    std::error_code ignored;
    if (const char* set = std::getenv("NULLSCOPE_FONT"); set != nullptr && *set != 0) {
        if (std::filesystem::is_regular_file(set, ignored)) return set;
        return std::nullopt;
    }
    for (const char* file : kFonts)
        if (std::filesystem::is_regular_file(file, ignored)) return file;
    return std::nullopt;
}

struct Lettering::Face {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    Face() = default;
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;
    ~Face() {
        if (face != nullptr) FT_Done_Face(face);
        if (library != nullptr) FT_Done_FreeType(library);
    }

    // f(x of the pen) for each glyph, which is in face->glyph then; where the pen ends.
    int walk(std::string_view text, const std::function<void(int)>& f) const {
        FT_UInt before = 0;
        int pen = 0;
        while (!text.empty()) {
            const FT_UInt glyph = FT_Get_Char_Index(face, take_character(text));
            FT_Vector kerning{};
            if (before != 0 && glyph != 0) FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kerning);
            pen += static_cast<int>(kerning.x / 64);
            before = glyph;
            if (FT_Load_Glyph(face, glyph, kLoad) != 0) continue;
            f(pen);
            pen += static_cast<int>(face->glyph->advance.x / 64);
        }
        return pen;
    }
};

Lettering::Lettering(std::unique_ptr<Face> face) : face_(std::move(face)) {}
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;
Lettering::~Lettering() = default;

Result<Lettering> Lettering::open(double size_px) {
    const auto file = sans_font_file();
    if (!file) return failed("no sans font is installed (Debian: fonts-dejavu-core) or named by NULLSCOPE_FONT");
    auto face = std::make_unique<Face>();
    if (FT_Init_FreeType(&face->library) != 0 ||
        FT_New_Face(face->library, file->string().c_str(), 0, &face->face) != 0 ||
        FT_Set_Char_Size(face->face, 0, static_cast<FT_F26Dot6>(std::lround(64.0 * std::max(size_px, 1.0))), 72, 72) !=
            0)
        return failed(fmt::format("'{}' is not a font that FreeType reads", file->string()));
    return Lettering(std::move(face));
}

int Lettering::ascent() const { return static_cast<int>((face_->face->size->metrics.ascender + 63) / 64); }
int Lettering::height() const { return ascent() + static_cast<int>((63 - face_->face->size->metrics.descender) / 64); }
int Lettering::width(std::string_view utf8) const {
    return face_->walk(utf8, [](int) {});
}

Image<unsigned char> Lettering::line(std::string_view utf8) const {
    Image<unsigned char> image(std::max(width(utf8), 1), height(), 1);
    face_->walk(utf8, [&](int pen) {
        const FT_GlyphSlot glyph = face_->face->glyph;
        const FT_Bitmap& bitmap = glyph->bitmap;
        if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY) return;
        for (int row = 0; row < static_cast<int>(bitmap.rows); ++row)
            for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
                const int x = pen + glyph->bitmap_left + column, y = ascent() - glyph->bitmap_top + row;
                if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
                unsigned char& to = *image.at(x, y);
                to = std::max(to, bitmap.buffer[row * bitmap.pitch + column]);
            }
    });
    return image;
}

}  // namespace nullscope
