// libpng leaves by longjmp: no function that calls setjmp here has an object with a destructor.
#include "base/png_encoder.h"

#include <png.h>

#include <csetjmp>
#include <new>
#include <vector>

namespace nullscope {
namespace {

constexpr int kDeflateLevel = 2;  // of 9; the third takes half as long again for 4 % fewer bytes

class Encoder {
public:
    // texts: outlives the encoder; libpng changes none of it.
    explicit Encoder(const std::map<std::string, std::string>& texts) : Encoder() {
        for (const auto& [keyword, text] : texts) {
            png_text& chunk = texts_.emplace_back();
            chunk.compression = PNG_ITXT_COMPRESSION_NONE;
            chunk.key = const_cast<char*>(keyword.c_str());
            chunk.text = const_cast<char*>(text.c_str());
        }
    }
    Encoder()
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {})) {
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    }
    ~Encoder() { png_destroy_write_struct(&png_, &info_); }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    bool encode(const Image<unsigned char>& image) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        png_set_write_fn(png_, this, on_write, nullptr);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                     image.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
        png_set_compression_level(png_, kDeflateLevel);
        png_set_compression_buffer_size(png_, kChunk);
        png_set_text(png_, info_, texts_.data(), static_cast<int>(texts_.size()));
        png_write_info(png_, info_);
        for (int y = 0; y < image.height; ++y) png_write_row(png_, image.at(0, y));
        png_write_end(png_, info_);
        return true;
    }
    std::string& bytes() { return bytes_; }
    const std::string& error() const { return error_; }

private:
    static constexpr std::size_t kChunk = 1u << 18;  // bytes of a file's piece

    [[noreturn]] static void on_error(png_structp png, png_const_charp words) {
        static_cast<Encoder*>(png_get_error_ptr(png))->error_ = words;
        longjmp(png_jmpbuf(png), 1);  // NOLINT
    }
    static void on_write(png_structp png, png_bytep data, png_size_t size) {
        auto& self = *static_cast<Encoder*>(png_get_io_ptr(png));
        bool written = true;
        try {  // nothing may be thrown through libpng
            self.bytes_.append(reinterpret_cast<const char*>(data), size);
        } catch (const std::bad_alloc&) {
            written = false;
        }
        if (!written) png_error(png, "out of memory");
    }

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::vector<png_text> texts_;
    std::string bytes_, error_ = "out of memory";
};

}  // namespace

Result<std::string> encode_png(const Image<unsigned char>& image, const std::map<std::string, std::string>& texts) {
    Encoder encoder(texts);
    if (!encoder.encode(image)) return failed(encoder.error());
    return std::move(encoder.bytes());
}

}  // namespace nullscope
