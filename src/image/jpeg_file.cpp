// JPEG that is written. libjpeg leaves by longjmp: no function that calls setjmp here has an object with a destructor.
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs FILE and size_t first.
#include <fmt/format.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <string>
#include <vector>

#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/picture_formats.h"

namespace nullscope {
namespace {

class JpegEncoder {
public:
    JpegEncoder() {
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = [](j_common_ptr jpeg) {
            JpegEncoder& self = *static_cast<JpegEncoder*>(jpeg->client_data);
            jpeg->err->format_message(jpeg, self.words_.data());
            longjmp(self.jump_, 1);  // NOLINT
        };
        errors_.emit_message = [](j_common_ptr, int) {};
        jpeg_.client_data = this;
    }
    ~JpegEncoder() {
        jpeg_destroy_compress(&jpeg_);  // knows what was never created
        std::free(bytes_);              // NOLINT: libjpeg allocates it by malloc
    }
    JpegEncoder(const JpegEncoder&) = delete;
    JpegEncoder& operator=(const JpegEncoder&) = delete;

    bool encode(const Image<unsigned char>& image, const std::vector<std::string>& comments, int quality,
                const std::string& xmp) {
        if (setjmp(jump_) != 0) return false;  // NOLINT
        jpeg_create_compress(&jpeg_);
        jpeg_.client_data = this;
        jpeg_mem_dest(&jpeg_, &bytes_, &size_);
        jpeg_.image_width = static_cast<JDIMENSION>(image.width);
        jpeg_.image_height = static_cast<JDIMENSION>(image.height);
        jpeg_.input_components = 3;
        jpeg_.in_color_space = JCS_RGB;
        jpeg_set_defaults(&jpeg_);
        jpeg_set_quality(&jpeg_, quality, TRUE);
        jpeg_.comp_info[0].h_samp_factor = jpeg_.comp_info[0].v_samp_factor = 1;  // colours at full resolution
        jpeg_.optimize_coding = TRUE;
        jpeg_start_compress(&jpeg_, TRUE);
        if (!xmp.empty())
            jpeg_write_marker(&jpeg_, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(xmp.data()),
                              static_cast<unsigned>(xmp.size()));
        for (const std::string& comment : comments)
            jpeg_write_marker(&jpeg_, JPEG_COM, reinterpret_cast<const JOCTET*>(comment.data()),
                              static_cast<unsigned>(comment.size()));
        while (jpeg_.next_scanline < jpeg_.image_height) {
            // libjpeg changes none of it.
            JSAMPROW row = const_cast<JSAMPROW>(image.at(0, static_cast<int>(jpeg_.next_scanline)));
            jpeg_write_scanlines(&jpeg_, &row, 1);
        }
        jpeg_finish_compress(&jpeg_);
        return true;
    }
    std::string bytes() const { return {reinterpret_cast<const char*>(bytes_), size_}; }
    const char* error() const { return words_.data(); }

private:
    jpeg_compress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    std::jmp_buf jump_{};
    unsigned char* bytes_ = nullptr;
    unsigned long size_ = 0;
    std::array<char, JMSG_LENGTH_MAX> words_{};
};

// Comments whose first line is a keyword.
Result<Texts> jpeg_texts_of(std::istream& file) {
    file.seekg(2);
    constexpr std::size_t kScan = 0xda, kEnd = 0xd9, kComment = 0xfe;
    Texts texts;
    std::size_t size = 0;
    for (auto mark = bytes_from(file, 2); mark; mark = bytes_from(file, 2)) {
        if ((*mark)[0] != '\xff') return bad_input("its markers are damaged");
        if ((*mark)[1] == '\xff') {  // fill bytes
            file.seekg(-1, std::ios::cur);
            continue;
        }
        const std::size_t kind = big_endian(mark->substr(1));
        if (kind == kScan || kind == kEnd) return texts;
        const auto length = bytes_from(file, 2);
        if (!length || big_endian(*length) < 2) return texts_cut_off();
        const std::size_t left = big_endian(*length) - 2;
        if (kind != kComment) {
            file.seekg(static_cast<std::streamoff>(left), std::ios::cur);
            continue;
        }
        if ((size += left) > kMostTextBytes) return texts_too_long();
        const auto comment = bytes_from(file, left);
        if (!comment) return texts_cut_off();
        const std::size_t line = comment->find('\n');
        if (comment->starts_with(kOwnTexts) && line != std::string::npos)
            texts[comment->substr(0, line)] = comment->substr(line + 1);
    }
    return texts_cut_off();
}

}  // namespace

Result<std::string> encode_jpeg(const Image<unsigned char>& image, const std::vector<std::string>& comments,
                                int quality, const std::string& xmp) {
    JpegEncoder encoder;
    const std::string marked = xmp.empty() ? "" : std::string(kXmpMark) + xmp;
    if (marked.size() > kMostMarkerBytes) return failed("its XMP is too long");
    if (!encoder.encode(image, comments, quality, marked)) return failed(encoder.error());
    return encoder.bytes();
}

const PictureFormat kJpegFormat = {
    .name = "JPEG",
    .ending = ".jpg",
    .other = ".jpeg",
    .sample = Sample::kByte,
    .help = "the same in a small file",
    .options = "--quality",
    .is = [](std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); },
    .texts = jpeg_texts_of,
    .save =
        [](const std::filesystem::path& path, const DisplayedPicture& picture) {
            return save_jpeg(path, picture.bytes, fmt::format("{}\n{}", picture.title, picture.software),
                             picture.quality.value_or(kJpegQuality), picture.texts);
        },
};

}  // namespace nullscope
