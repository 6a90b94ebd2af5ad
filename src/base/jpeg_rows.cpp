// libjpeg leaves by longjmp: no function that calls setjmp here has an object with a destructor.
#include <cstdio>
// jpeglib.h needs FILE and size_t first.
#include <jpeglib.h>

#include <array>
#include <csetjmp>
#include <string>
#include <utility>

#include "base/image_file.h"
#include "base/row_reader.h"

namespace nullscope {
namespace {

class JpegRows : public RowReader {
public:
    explicit JpegRows(ByteSource source) : source_(std::move(source)) {
        for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = on_error;
        errors_.output_message = [](j_common_ptr) {};
        jpeg_.client_data = this;
    }
    ~JpegRows() override { jpeg_destroy_decompress(&jpeg_); }  // knows what was never created
    JpegRows(const JpegRows&) = delete;
    JpegRows& operator=(const JpegRows&) = delete;

    Status open() {
        if (!read_head()) return bad_input(error_);
        if (whole_needed_)
            return bad_input("a progressive JPEG of this size cannot be read row by row; save it as a baseline one");
        width = static_cast<int>(jpeg_.output_width);
        height = static_cast<int>(jpeg_.output_height);
        channels = 3;
        if (jpeg_.output_components != 3) return bad_input("not a JPEG of grey or of red, green and blue");
        bytes_.resize(static_cast<std::size_t>(width) * 3);
        return Done{};
    }

    Status next(float* row) override {
        if (!read_row()) return bad_input(error_);
        for (const JSAMPLE byte : bytes_) *row++ = table_[byte];
        return Done{};
    }

private:
    static JpegRows& of(j_common_ptr jpeg) { return *static_cast<JpegRows*>(jpeg->client_data); }
    [[noreturn]] static void on_error(j_common_ptr jpeg) {
        std::array<char, JMSG_LENGTH_MAX> words{};
        jpeg->err->format_message(jpeg, words.data());
        of(jpeg).error_ = words.data();
        longjmp(of(jpeg).jump_, 1);  // NOLINT
    }
    static boolean on_fill(j_decompress_ptr jpeg) {
        JpegRows& self = of(reinterpret_cast<j_common_ptr>(jpeg));
        const std::size_t got = self.source_(self.buffer_.data(), self.buffer_.size());
        if (got == 0) {
            self.error_ = "the file is too short";
            longjmp(self.jump_, 1);  // NOLINT
        }
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
        manager_.init_source = [](j_decompress_ptr) {};
        manager_.fill_input_buffer = on_fill;
        manager_.skip_input_data = on_skip;
        manager_.resync_to_restart = jpeg_resync_to_restart;
        manager_.term_source = [](j_decompress_ptr) {};
        manager_.bytes_in_buffer = 0;
        jpeg_read_header(&jpeg_, TRUE);
        jpeg_.out_color_space = JCS_RGB;
        whole_needed_ = jpeg_has_multiple_scans(&jpeg_) != 0;
        if (!whole_needed_) jpeg_start_decompress(&jpeg_);
        return true;
    }
    bool read_row() {
        if (setjmp(jump_) != 0) return false;  // NOLINT
        JSAMPROW row = bytes_.data();
        return jpeg_read_scanlines(&jpeg_, &row, 1) == 1;
    }

    ByteSource source_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_source_mgr manager_{};
    std::jmp_buf jump_{};
    std::array<char, 65536> buffer_{};
    std::array<float, 256> table_{};
    std::string error_;
    std::vector<JSAMPLE> bytes_;
    bool whole_needed_ = false;
};

}  // namespace

Result<std::unique_ptr<RowReader>> open_jpeg_rows(ByteSource source) {
    auto rows = std::make_unique<JpegRows>(std::move(source));
    if (Status opened = rows->open(); !opened) return opened.error();
    return std::unique_ptr<RowReader>(std::move(rows));
}

}  // namespace nullscope
