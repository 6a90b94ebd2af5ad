// libpng leaves by longjmp: no function that calls setjmp here has an object with a destructor.
#include <fmt/format.h>
#include <png.h>

#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/colour_space.h"
#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/orientation.h"
#include "image/picture_formats.h"

namespace nullscope {
namespace {

constexpr png_uint_32 kMostSide = 1'000'000;       // px: a row of 16 MB
constexpr png_alloc_size_t kMostChunk = 8u << 20;  // bytes of a chunk that is no picture (profiles, words)

constexpr png_byte kColourCodes[] = {'c', 'I', 'C', 'P', 0};

class PngRows : public RowReader {
public:
    explicit PngRows(ByteSource source) : source_(std::move(source)) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    }
    ~PngRows() override { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngRows(const PngRows&) = delete;
    PngRows& operator=(const PngRows&) = delete;

    Status open() {
        if (info_ == nullptr) return failed("out of memory");
        if (!read_head()) return bad_input(error_);
        read_colours();
        read_orientation();
        if (png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE)
            whole = "an interlaced PNG of this size cannot be read row by row; save it without interlacing";
        width = static_cast<int>(png_get_image_width(png_, info_));
        height = static_cast<int>(png_get_image_height(png_, info_));
        channels = png_get_channels(png_, info_);
        sixteen_ = png_get_bit_depth(png_, info_) == 16;
        const std::size_t codes = sixteen_ ? 65536 : 256;
        table_.resize(codes);
        for (std::size_t i = 0; i < codes; ++i)
            table_[i] = linear_of(static_cast<float>(i) / static_cast<float>(codes - 1));
        row_bytes_ = static_cast<std::size_t>(width) * channels * (sixteen_ ? 2 : 1);
        if ((channels != 3 && channels != 4) || png_get_rowbytes(png_, info_) != row_bytes_)
            return bad_input("an unknown kind of PNG");
        return Done{};
    }

    Status next(float* row) override {
        if (row_ == 0) bytes_.resize(whole != nullptr ? row_bytes_ * height : row_bytes_);
        const png_byte* from = line(row_);
        if (!read_row()) return bad_input(error_);
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
    // A profile that libpng does not take would be gone without a word.
    static void on_warning(png_structp png, png_const_charp words) {
        PngRows& self = *static_cast<PngRows*>(png_get_error_ptr(png));
        const std::string_view warning = words;
        if (!warning.starts_with("iCCP") || warning.find("sRGB") != std::string_view::npos) return;
        try {  // nothing may be thrown through libpng
            self.unused.push_back(fmt::format("colour profile ({}): read as sRGB", warning));
        } catch (const std::bad_alloc&) {
            self.error_ = "out of memory";
        }
    }
    static void on_read(png_structp png, png_bytep to, png_size_t size) {
        auto& self = *static_cast<PngRows*>(png_get_io_ptr(png));
        if (self.source_(reinterpret_cast<char*>(to), size) != size) png_error(png, "the file is too short");
    }
    float linear_of(float code) const { return power_ > 0.0f ? std::pow(code, power_) : linear_from_srgb(code); }

    // What the file says of its colours, by rank: cICP, iCCP, sRGB, gAMA and cHRM (PNG, third edition, 4.3).
    void read_colours() {
        png_unknown_chunkp chunks = nullptr;
        const int count = png_get_unknown_chunks(png_, info_, &chunks);
        for (int i = 0; i < count; ++i)
            if (chunks[i].size == 4 && !(chunks[i].data[0] == 1 && (chunks[i].data[1] == 1 || chunks[i].data[1] == 13)))
                unused.push_back(fmt::format("cICP (primaries {}, transfer {}): read as sRGB", chunks[i].data[0],
                                             chunks[i].data[1]));
        png_charp title = nullptr;
        png_bytep profile = nullptr;
        png_uint_32 size = 0;
        int compression = 0;
        if (png_get_iCCP(png_, info_, &title, &compression, &profile, &size) != 0) {
            if (!is_srgb_profile({reinterpret_cast<const char*>(profile), size}))
                unused.push_back(fmt::format("colour profile (iCCP) \"{}\": read as sRGB", title));
            return;
        }
        if (count > 0 || png_get_valid(png_, info_, PNG_INFO_sRGB) != 0) return;
        constexpr png_fixed_point kOne = 100000, kUsual = 45455, kNear = 500;  // 1/2.2 stands for sRGB
        png_fixed_point gamma = 0;
        if (png_get_gAMA_fixed(png_, info_, &gamma) != 0 && gamma > 0 && std::abs(gamma - kUsual) > kNear)
            power_ = static_cast<float>(kOne) / static_cast<float>(gamma);
        Primaries p;
        if (png_get_cHRM(png_, info_, &p.white.x, &p.white.y, &p.red.x, &p.red.y, &p.green.x, &p.green.y, &p.blue.x,
                         &p.blue.y) != 0)
            to_rec709 = rec709_from(p);
    }
    void read_orientation() {
#ifdef PNG_eXIf_SUPPORTED
        png_uint_32 size = 0;
        png_bytep exif = nullptr;
        if (png_get_eXIf_1(png_, info_, &size, &exif) != 0)
            orientation = exif_orientation({reinterpret_cast<const char*>(exif), size});
#endif
    }

    // Whatever the file has becomes 8 or 16 bits of red, green, blue and perhaps alpha.
    bool read_head() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        png_set_read_fn(png_, this, on_read);
        png_set_user_limits(png_, kMostSide, kMostSide);
        png_set_chunk_malloc_max(png_, kMostChunk);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS, kColourCodes, 1);
        png_read_info(png_, info_);
        png_set_expand(png_);
        png_set_gray_to_rgb(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }
    bool read_row() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        if (whole == nullptr) png_read_row(png_, line(row_), nullptr);
        if (whole != nullptr && row_ == 0)
            for (int pass = 0; pass < PNG_INTERLACE_ADAM7_PASSES; ++pass)
                for (int y = 0; y < height; ++y) png_read_row(png_, line(y), nullptr);
        if (++row_ == height) png_read_end(png_, nullptr);
        return true;
    }
    png_bytep line(int y) { return bytes_.data() + (whole != nullptr ? row_bytes_ * y : 0); }

    ByteSource source_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::string error_;
    std::vector<png_byte> bytes_;
    std::vector<float> table_;
    std::size_t row_bytes_ = 0;
    bool sixteen_ = false;
    int row_ = 0;
    float power_ = 0.0f;  // of codes, for linear light; 0: sRGB
};

// Reads nothing but texts: of a file that has them between a header and pixels that never come.
class PngTexts {
public:
    explicit PngTexts(std::string_view chunks) : bytes_(kHead) {
        bytes_.append(chunks).append(kPixels);
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    }
    ~PngTexts() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngTexts(const PngTexts&) = delete;
    PngTexts& operator=(const PngTexts&) = delete;

    bool read() {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        png_set_read_fn(png_, this, on_read);
        png_set_chunk_malloc_max(png_, kMostText);
        png_set_chunk_cache_max(png_, kMostTexts);
        png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        png_read_info(png_, info_);
        return true;
    }
    Texts texts() const {
        Texts texts;
        png_textp first = nullptr;
        const int count = png_get_text(png_, info_, &first, nullptr);
        for (int i = 0; i < count; ++i)
            if (first[i].key != nullptr && first[i].text != nullptr) texts[first[i].key] = first[i].text;
        return texts;
    }
    const std::string& error() const { return error_; }

private:
    using View = std::string_view;
    static constexpr View kHead =
        View("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\x01\0\0\0\x01\x08\x02\0\0\0\x90\x77\x53\xde", 33);
    static constexpr View kPixels = View("\0\0\0\0IDAT", 8);
    static constexpr png_uint_32 kMostTexts = 100;
    static constexpr png_alloc_size_t kMostText = 2u << 20;  // bytes of one, unpacked

    [[noreturn]] static void on_error(png_structp png, png_const_charp words) {
        static_cast<PngTexts*>(png_get_error_ptr(png))->error_ = words;
        longjmp(png_jmpbuf(png), 1);  // NOLINT
    }
    static void on_read(png_structp png, png_bytep to, png_size_t size) {
        auto& self = *static_cast<PngTexts*>(png_get_io_ptr(png));
        if (size > self.bytes_.size() - self.at_) png_error(png, "cut off");
        self.bytes_.copy(reinterpret_cast<char*>(to), size, self.at_);
        self.at_ += size;
    }

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::string bytes_, error_ = "out of memory";
    std::size_t at_ = 0;
};

constexpr int kDeflateLevel = 2;  // of 9; the third takes half as long again for 4 % fewer bytes

class PngEncoder {
public:
    // texts: outlives the encoder; libpng changes none of it.
    explicit PngEncoder(const std::map<std::string, std::string>& texts) {
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
        info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
        for (const auto& [keyword, text] : texts) {
            png_text& chunk = texts_.emplace_back();
            chunk.compression = PNG_ITXT_COMPRESSION_NONE;
            chunk.key = const_cast<char*>(keyword.c_str());
            chunk.text = const_cast<char*>(text.c_str());
        }
    }
    ~PngEncoder() { png_destroy_write_struct(&png_, &info_); }
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    template <class T>
    bool encode(const Image<T>& image) {
        if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT
        png_set_write_fn(png_, this, on_write, nullptr);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                     8 * static_cast<int>(sizeof(T)),
                     image.channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
        png_set_compression_level(png_, kDeflateLevel);
        png_set_compression_buffer_size(png_, kChunk);
        png_set_text(png_, info_, texts_.data(), static_cast<int>(texts_.size()));
        png_write_info(png_, info_);
        if (sizeof(T) > 1 && std::endian::native == std::endian::little) png_set_swap(png_);
        for (int y = 0; y < image.height; ++y) png_write_row(png_, reinterpret_cast<const png_byte*>(image.at(0, y)));
        png_write_end(png_, info_);
        return true;
    }
    std::string& bytes() { return bytes_; }
    const std::string& error() const { return error_; }

private:
    static constexpr std::size_t kChunk = 1u << 18;  // bytes of a file's piece

    [[noreturn]] static void on_error(png_structp png, png_const_charp words) {
        static_cast<PngEncoder*>(png_get_error_ptr(png))->error_ = words;
        longjmp(png_jmpbuf(png), 1);  // NOLINT
    }
    static void on_write(png_structp png, png_bytep data, png_size_t size) {
        auto& self = *static_cast<PngEncoder*>(png_get_io_ptr(png));
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

template <class T>
Result<std::string> encoded(const Image<T>& image, const std::map<std::string, std::string>& texts) {
    PngEncoder encoder(texts);
    if (!encoder.encode(image)) return failed(encoder.error());
    return std::move(encoder.bytes());
}

constexpr std::string_view kPngMark = "\x89PNG\r\n\x1a\n";

// tEXt, zTXt and iTXt chunks. What is not looked at is skipped; a file that ends in its pixels has said all before, or nothing.
Result<Texts> png_texts_of(std::istream& file) {
    file.seekg(static_cast<std::streamoff>(kPngMark.size()));
    std::string chunks;
    for (auto head = bytes_from(file, 8); head; head = bytes_from(file, 8)) {
        constexpr std::size_t kCheckSum = 4;
        const std::size_t length = big_endian(head->substr(0, 4));
        const std::string kind = head->substr(4);
        if (kind == "IEND") break;
        if (kind != "tEXt" && kind != "zTXt" && kind != "iTXt") {
            file.seekg(static_cast<std::streamoff>(length + kCheckSum), std::ios::cur);
            continue;
        }
        if (chunks.size() + length > kMostTextBytes) return texts_too_long();
        const auto body = bytes_from(file, length + kCheckSum);
        if (!body) return texts_cut_off();
        chunks += *head + *body;
    }
    PngTexts png(chunks);
    if (!png.read()) return bad_input(png.error());
    return png.texts();
}

}  // namespace

Result<std::unique_ptr<RowReader>> open_png_rows(ByteSource source) {
    auto rows = std::make_unique<PngRows>(std::move(source));
    TRY(opened, rows->open());
    return std::unique_ptr<RowReader>(std::move(rows));
}

Result<std::string> encode_png(const Image<unsigned char>& image, const std::map<std::string, std::string>& texts) {
    return encoded(image, texts);
}
Result<std::string> encode_png(const Image<unsigned short>& image, const std::map<std::string, std::string>& texts) {
    return encoded(image, texts);
}

const PictureFormat kPngFormat = {
    .name = "PNG",
    .ending = ".png",
    .other = "",
    .sample = Sample::kByte,
    .help = "8 or 16 bits, display-ready",
    .options = "--bits",
    .is = [](std::string_view bytes) { return bytes.starts_with(kPngMark); },
    .texts = png_texts_of,
    .save =
        [](const std::filesystem::path& path, const DisplayedPicture& picture) {
            Texts texts = picture.texts;
            texts.insert({{"Title", picture.title}, {"Software", picture.software}});
            return picture.words.empty() ? save_png(path, picture.bytes, texts)
                                         : save_png16(path, picture.words, texts);
        },
};

}  // namespace nullscope
