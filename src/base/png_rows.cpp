// libpng leaves by longjmp: no function that calls setjmp here has an object with a destructor.
#include <png.h>

#include <csetjmp>
#include <limits>
#include <string>
#include <utility>

#include "base/image_file.h"
#include "base/row_reader.h"

namespace nullscope {
namespace {

constexpr png_uint_32 kMostSide = 1'000'000;       // px: a row of 16 MB
constexpr png_alloc_size_t kMostChunk = 8u << 20;  // bytes of a chunk that is no picture (profiles, words)

class PngRows : public RowReader {
public:
    explicit PngRows(ByteSource source) : source_(std::move(source)) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    }
    ~PngRows() override { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    Status open() {
        if (info_ == nullptr) return failed("out of memory");
        if (!read_head()) return bad_input(error_);
        if (png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE)
            return bad_input("an interlaced PNG of this size cannot be read row by row; save it without interlacing");
        width = static_cast<int>(png_get_image_width(png_, info_));
        height = static_cast<int>(png_get_image_height(png_, info_));
        channels = png_get_channels(png_, info_);
        sixteen_ = png_get_bit_depth(png_, info_) == 16;
        bytes_.resize(png_get_rowbytes(png_, info_));
        const std::size_t codes = sixteen_ ? 65536 : 256;
        table_.resize(codes);
        for (std::size_t i = 0; i < codes; ++i)
            table_[i] = linear_from_srgb(static_cast<float>(i) / static_cast<float>(codes - 1));
        if ((channels != 3 && channels != 4) ||
            bytes_.size() != static_cast<std::size_t>(width) * channels * (sixteen_ ? 2 : 1))
            return bad_input("an unknown kind of PNG");
        return Done{};
    }

    Status next(float* row) override {
        if (!read_row()) return bad_input(error_);
        const png_byte* from = bytes_.data();
        const auto code = [&]() -> std::size_t {
            const std::size_t high = *from++;
            return sixteen_ ? high << 8 | *from++ : high;
        };
        const auto most = static_cast<float>(table_.size() - 1);
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) *row++ = table_[code()];
            if (channels == 4) *row++ = static_cast<float>(code()) / most;
        }
        return Done{};
    }

private:
    [[noreturn]] static void on_error(png_structp png, png_const_charp words) {
        static_cast<PngRows*>(png_get_error_ptr(png))->error_ = words;
        longjmp(png_jmpbuf(png), 1);  // NOLINT
    }
    static void on_read(png_structp png, png_bytep to, png_size_t size) {
        auto& self = *static_cast<PngRows*>(png_get_io_ptr(png));
        if (self.source_(reinterpret_cast<char*>(to), size) != size) png_error(png, "the file is too short");
    }
    // Whatever the file has becomes 8 or 16 bits of red, green, blue and perhaps alpha.
    bool read_head() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        png_set_read_fn(png_, this, on_read);
        png_set_user_limits(png_, kMostSide, kMostSide);
        png_set_chunk_malloc_max(png_, kMostChunk);
        png_read_info(png_, info_);
        png_set_expand(png_);
        png_set_gray_to_rgb(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read_row() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        png_read_row(png_, bytes_.data(), nullptr);
        return true;
    }

    ByteSource source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::string error_;
    std::vector<png_byte> bytes_;
    std::vector<float> table_;
    bool sixteen_ = false;
};

}  // namespace

Result<std::unique_ptr<RowReader>> open_png_rows(ByteSource source) {
    auto rows = std::make_unique<PngRows>(std::move(source));
    if (Status opened = rows->open(); !opened) return opened.error();
    return std::unique_ptr<RowReader>(std::move(rows));
}

}  // namespace nullscope
