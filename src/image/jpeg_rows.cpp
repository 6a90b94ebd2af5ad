// libjpeg leaves by longjmp: no function that calls setjmp here has an object with a destructor.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs FILE and size_t first, jerror.h (the codes of its warnings) jpeglib.h.
#include <jpeglib.h>

#include <jerror.h>

#include <array>
#include <csetjmp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/orientation.h"

namespace nullscope {
namespace {

// Each costs as much time as the whole picture, and takes a dozen bytes to ask for. (An encoder makes one a component,
// or about ten where the picture comes in progressively.)
constexpr int kMostScans = 256;

// A number of Google's photo sphere schema in XMP: GPano:key="12" or <GPano:key>12<. 0: it is not there.
int sphere_number(std::string_view xmp, const std::string& key) {
    const std::size_t at = xmp.find("GPano:" + key);
    if (at == std::string_view::npos) return 0;
    const std::string rest(xmp.substr(at + 6 + key.size(), 16));
    return std::atoi(rest.c_str() + std::min(rest.find_first_of("0123456789"), rest.size()));
}

// Of a picture that is a part of a panorama; empty: it is none.
std::string part_words(std::string_view xmp) {
    const int width = sphere_number(xmp, "FullPanoWidthPixels"), height = sphere_number(xmp, "FullPanoHeightPixels"),
              across = sphere_number(xmp, "CroppedAreaImageWidthPixels"),
              down = sphere_number(xmp, "CroppedAreaImageHeightPixels");
    if (width <= 0 || height <= 0 || (across == width && down == height)) return "";
    return fmt::format("GPano: {}x{} px of a panorama of {}x{} px; taken for the whole", across, down, width, height);
}

class JpegRows : public RowReader {
public:
    explicit JpegRows(ByteSource source) : source_(std::move(source)) {
        for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = on_error;
        errors_.emit_message = [](j_common_ptr jpeg, int) {  // other warnings are of no consequence
            if (jpeg->err->msg_code == JWRN_HUFF_BAD_CODE || jpeg->err->msg_code == JWRN_HIT_MARKER) on_error(jpeg);
        };
        progress_.progress_monitor = [](j_common_ptr jpeg) {
            if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > kMostScans)
                of(jpeg).leave("too many scans");
        };
    }
    ~JpegRows() override { jpeg_destroy_decompress(&jpeg_); }  // knows what was never created
    JpegRows(const JpegRows&) = delete;
    JpegRows& operator=(const JpegRows&) = delete;

    Status open() {
        if (!read_head()) return bad_input(error_);
        read_markers();
        width = static_cast<int>(jpeg_.image_width);
        height = static_cast<int>(jpeg_.image_height);
        channels = 3;
        bytes_.resize(static_cast<std::size_t>(width) * (inks_ ? 4 : 3));
        if (jpeg_has_multiple_scans(&jpeg_))
            whole = "a progressive JPEG of this size cannot be read row by row; save it as a baseline one";
        return Done{};
    }

    Status next(float* row) override {
        if (!read_row()) return bad_input(error_);
        const JSAMPLE* from = bytes_.data();
        for (int x = 0; x < width; ++x, from += inks_ ? 4 : 3)
            for (int c = 0; c < 3; ++c) *row++ = table_[inks_ ? (lit(from[c]) * lit(from[3]) + 127) / 255 : from[c]];
        return Done{};
    }

private:
    int lit(JSAMPLE ink) const { return jpeg_.saw_Adobe_marker != FALSE ? ink : 255 - ink; }
    static JpegRows& of(j_common_ptr jpeg) { return *static_cast<JpegRows*>(jpeg->client_data); }
    [[noreturn]] void leave(const char* words) {
        error_ = words;
        longjmp(jump_, 1);  // NOLINT
    }
    [[noreturn]] static void on_error(j_common_ptr jpeg) {
        std::array<char, JMSG_LENGTH_MAX> words{};
        jpeg->err->format_message(jpeg, words.data());
        of(jpeg).leave(words.data());
    }
    static boolean on_fill(j_decompress_ptr jpeg) {
        JpegRows& self = of(reinterpret_cast<j_common_ptr>(jpeg));
        const std::size_t got = self.source_(self.buffer_.data(), self.buffer_.size());
        if (got == 0) self.leave("the file is too short");
        self.manager_.next_input_byte = reinterpret_cast<const JOCTET*>(self.buffer_.data());
        self.manager_.bytes_in_buffer = got;
        return TRUE;
    }
    static void on_skip(j_decompress_ptr jpeg, long bytes) {
        jpeg_source_mgr& manager = of(reinterpret_cast<j_common_ptr>(jpeg)).manager_;
        while (bytes > static_cast<long>(manager.bytes_in_buffer)) {
            bytes -= static_cast<long>(manager.bytes_in_buffer);
            on_fill(jpeg);
        }
        if (bytes <= 0) return;
        manager.next_input_byte += bytes;
        manager.bytes_in_buffer -= static_cast<std::size_t>(bytes);
    }
    bool read_head() {
        if (setjmp(jump_) != 0) return false;  // NOLINT
        jpeg_create_decompress(&jpeg_);
        jpeg_.client_data = this;
        jpeg_.src = &manager_;
        jpeg_.progress = &progress_;
        manager_.init_source = [](j_decompress_ptr) {};
        manager_.fill_input_buffer = on_fill;
        manager_.skip_input_data = on_skip;
        manager_.resync_to_restart = jpeg_resync_to_restart;
        manager_.term_source = [](j_decompress_ptr) {};
        manager_.bytes_in_buffer = 0;
        for (const int marker : {JPEG_APP0 + 1, JPEG_APP0 + 2}) jpeg_save_markers(&jpeg_, marker, 0xffff);
        jpeg_read_header(&jpeg_, TRUE);
        inks_ = jpeg_.num_components == 4;
        jpeg_.out_color_space = inks_ ? JCS_CMYK : JCS_RGB;
        return true;
    }
    void read_markers() {
        constexpr std::string_view kExif("Exif\0\0", 6), kProfile("ICC_PROFILE\0", 12);
        std::string profile;  // in pieces of 64 KB
        for (const jpeg_marker_struct* marker = jpeg_.marker_list; marker != nullptr; marker = marker->next) {
            const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
            if (data.starts_with(kExif)) orientation = exif_orientation(data.substr(kExif.size()));
            if (data.starts_with(kProfile)) profile += data.substr(kProfile.size());
            if (const std::string part = data.starts_with(kXmpMark) ? part_words(data) : ""; !part.empty())
                unused.push_back(part);
        }
        if (!profile.empty() && !is_srgb_profile(profile)) unused.emplace_back("colour profile (ICC): read as sRGB");
    }
    bool read_row() {
        if (setjmp(jump_) != 0) return false;  // NOLINT
        if (jpeg_.output_scanline == 0) jpeg_start_decompress(&jpeg_);
        JSAMPROW row = bytes_.data();
        if (jpeg_read_scanlines(&jpeg_, &row, 1) != 1) return false;
        if (jpeg_.output_scanline == jpeg_.output_height) jpeg_finish_decompress(&jpeg_);
        return true;
    }

    ByteSource source_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_source_mgr manager_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf jump_{};
    std::array<char, 65536> buffer_{};
    std::array<float, 256> table_{};
    std::string error_;
    std::vector<JSAMPLE> bytes_;
    bool inks_ = false;  // cyan, magenta, yellow and black: with Adobe's marker 255 is none of it, without it 0
};

}  // namespace

Result<std::unique_ptr<RowReader>> open_jpeg_rows(ByteSource source) {
    auto rows = std::make_unique<JpegRows>(std::move(source));
    TRY(opened, rows->open());
    return std::unique_ptr<RowReader>(std::move(rows));
}

}  // namespace nullscope
