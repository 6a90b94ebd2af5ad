// Segments of ITU-T T.81, annex B: FF, a marker, for most markers a length of two bytes that counts itself.
#include "base/jpeg_check.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nullscope {
namespace {

constexpr unsigned kProgressive = 0xC2, kHuffmanTables = 0xC4, kScan = 0xDA, kEnd = 0xD9;
constexpr unsigned kAcTable = 0x10;  // class and number of a table in one byte; class 0 is DC
constexpr std::size_t kCounts = 16;  // of a table: how many codes of 1, 2 ... 16 bits
constexpr unsigned kMostCodes = 256;
constexpr int kMostScans = 256;

// Between segments lie a scan's data, where FF 00 stands for FF, and restarts and padding: none is a segment.
bool no_segment(unsigned marker) { return marker <= 0x01 || (marker >= 0xD0 && marker <= 0xD8) || marker == 0xFF; }

class Check {
public:
    explicit Check(std::string_view bytes) : bytes_(bytes) {}
    Status run();

private:
    // 0 beyond the end, as stb_image reads on: segments that are cut off, or longer than they say, are read too.
    unsigned byte(std::size_t i) const { return i < bytes_.size() ? static_cast<unsigned char>(bytes_[i]) : 0; }
    bool read_tables(std::size_t at, std::size_t end);
    bool has_tables_of_scan(std::size_t at) const;

    std::string_view bytes_;
    std::array<bool, 256> known_{};  // tables, by class and number
    bool progressive_ = false;
    int scans_ = 0;
};

// Each table is a byte of class and number, the counts, and a byte for every code.
bool Check::read_tables(std::size_t at, std::size_t end) {
    while (at < end) {
        unsigned codes = 0;
        for (std::size_t i = 1; i <= kCounts; ++i) codes += byte(at + i);
        if (codes > kMostCodes) return false;
        known_[byte(at)] = true;
        at += 1 + kCounts + codes;
    }
    return true;
}

// Number of components, each one's name and its tables (DC, AC: four bits each), first and last coefficient, precision.
bool Check::has_tables_of_scan(std::size_t at) const {
    const unsigned components = byte(at);
    const std::size_t after = at + 1 + 2 * components;
    const bool from_dc = byte(after) == 0, refines = byte(after + 2) >> 4 != 0;
    const bool dc = !progressive_ || (from_dc && !refines), ac = !progressive_ || !from_dc;
    for (unsigned i = 0; i < components; ++i) {
        const unsigned tables = byte(at + 2 + 2 * i);
        if ((dc && !known_[tables >> 4]) || (ac && !known_[kAcTable | (tables & 15)])) return false;
    }
    return true;
}

Status Check::run() {
    for (std::size_t at = 0; at + 1 < bytes_.size();) {
        const unsigned marker = byte(at + 1);
        if (byte(at) != 0xFF || no_segment(marker)) {
            ++at;
            continue;
        }
        if (marker == kEnd) return Done{};
        const std::size_t value = at + 4, end = at + 2 + std::max(byte(at + 2) << 8 | byte(at + 3), 2u);
        if (marker == kProgressive) progressive_ = true;
        if (marker == kHuffmanTables && !read_tables(value, end))
            return bad_input("a Huffman table has too many codes");
        if (marker == kScan && !has_tables_of_scan(value)) return bad_input("a scan's Huffman table is missing");
        if (marker == kScan && ++scans_ > kMostScans) return bad_input("too many scans");
        at = end;
    }
    return bad_input("the file is too short, it ends before its picture does");
}

}  // namespace

Status check_jpeg(std::string_view bytes) { return Check(bytes).run(); }

}  // namespace nullscope
