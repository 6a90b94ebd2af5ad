// Images of a page: the browser has decoded them to RGBA of 8 bits, top row first, behind a head that page/images.js writes: 0x89, "RGBA",
// then width and height as four bytes each, lowest first.
#include <cstring>

#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/picture_texts.h"
#include "scene/disc_emissivity.h"
#include "scenefile/picture_scene.h"

namespace nullscope {
namespace {

class DecodedRows final : public RowReader {
public:
    explicit DecodedRows(ByteSource source) : source_(std::move(source)) {}

    bool open() {
        unsigned char head[13];
        if (source_(reinterpret_cast<char*>(head), sizeof head) != sizeof head || std::memcmp(head, "\x89RGBA", 5) != 0)
            return false;
        const auto number = [&](int at) {
            return head[at] | head[at + 1] << 8 | head[at + 2] << 16 | head[at + 3] << 24;
        };
        width = number(5), height = number(9), channels = 4;
        row_.resize(static_cast<std::size_t>(width) * 4);
        for (int code = 0; code < 256; ++code) linear_[code] = linear_from_srgb(static_cast<float>(code) / 255.0f);
        return width > 0 && height > 0;
    }
    Status next(float* row) override {
        if (source_(row_.data(), row_.size()) != row_.size()) return bad_input("it is cut off");
        for (std::size_t i = 0; i < row_.size(); ++i) {
            const auto code = static_cast<unsigned char>(row_[i]);
            row[i] = i % 4 == 3 ? static_cast<float>(code) / 255.0f : linear_[code];
        }
        return Done{};
    }

private:
    ByteSource source_;
    std::vector<char> row_;
    float linear_[256];
};

}  // namespace

Result<std::unique_ptr<RowReader>> open_png_rows(ByteSource source) {
    auto rows = std::make_unique<DecodedRows>(std::move(source));
    if (!rows->open()) return bad_input("the browser has not decoded it");
    return std::unique_ptr<RowReader>(std::move(rows));
}
Result<std::unique_ptr<RowReader>> open_jpeg_rows(ByteSource source) { return open_png_rows(std::move(source)); }

Result<ExrPicture> load_exr_picture(const std::filesystem::path&, long long, bool, const std::string&) {
    return bad_input("EXR is not read in a page");
}
bool is_tiff(std::string_view) { return false; }
Result<WholePicture> decode_tiff(std::string_view, long long) { return bad_input("TIFF is not read in a page"); }
Result<std::shared_ptr<const std::vector<EmissivityRow>>> load_emissivity(const std::filesystem::path&) {
    return bad_input("tables of emissivities are not read in a page");
}
void note_on_terminal(const std::string&) {}
bool is_picture_file(const std::filesystem::path&) { return false; }
Result<OpenedScene> open_picture(const std::string&, const Note&, const SceneOverrides&) {
    return bad_input("pictures are not opened in a page");
}

}  // namespace nullscope
