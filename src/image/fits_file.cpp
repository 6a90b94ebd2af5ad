#include <fitsio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/atomic_file.h"
#include "image/image_file.h"
#include "image/image_formats.h"
#include "image/picture_formats.h"

namespace nullscope {
namespace {

constexpr std::size_t kBlock = 2880, kCard = 80;  // bytes; a file is blocks, a header is cards

std::string ascii(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue;  // of a character that has its mark
        plain += c >= 0x20 && c < 0x7f ? c : '?';
    }
    return plain;
}

// A file in memory, which CFITSIO makes larger as it needs.
class MemoryFile {
public:
    explicit MemoryFile(std::size_t size) : size_(size), bytes_(std::malloc(size)) {
        if (bytes_ == nullptr) throw std::bad_alloc();
        fits_create_memfile(&file_, &bytes_, &size_, kBlock, std::realloc, &status_);
    }
    ~MemoryFile() {
        int ignored = 0;
        if (file_ != nullptr) fits_close_file(file_, &ignored);
        std::free(bytes_);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    fitsfile* file() { return file_; }
    int* status() { return &status_; }  // once it is not 0 CFITSIO's functions do nothing
    std::string_view finish() {
        LONGLONG header = 0, data = 0, end = 0;
        fits_flush_file(file_, &status_);
        fits_get_hduaddrll(file_, &header, &data, &end, &status_);
        return status_ == 0 ? std::string_view(static_cast<const char*>(bytes_), static_cast<std::size_t>(end)) : "";
    }
    std::string reason() const {
        std::array<char, FLEN_STATUS> words{};
        fits_get_errstatus(status_, words.data());
        return words.data();
    }

private:
    std::size_t size_;
    void* bytes_;
    fitsfile* file_ = nullptr;
    int status_ = 0;
};

// CFITSIO would write others by a convention of its own, and numbers that are none.
bool is_standard(const FitsCard& card) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    constexpr std::size_t kLongest = 8;
    const auto* number = std::get_if<double>(&card.value);
    return !card.keyword.empty() && card.keyword.size() <= kLongest &&
           card.keyword.find_first_not_of(kLetters) == std::string::npos &&
           (number == nullptr || std::isfinite(*number));
}

void write_card(MemoryFile& to, const FitsCard& card) {
    const std::string comment = ascii(card.comment);
    const char *key = card.keyword.c_str(), *words = comment.c_str();
    constexpr int kDigits = -15;  // significant ones
    if (const auto* number = std::get_if<double>(&card.value))
        fits_write_key_dbl(to.file(), key, *number, kDigits, words, to.status());
    else if (const auto* whole = std::get_if<long long>(&card.value))
        fits_write_key_lng(to.file(), key, *whole, words, to.status());
    else
        fits_write_key_longstr(to.file(), key, ascii(std::get<std::string>(card.value)).c_str(), words, to.status());
}

void write_header(MemoryFile& to, const Image<float>& image, const FitsHeader& header, std::string_view name) {
    std::array<long, 3> sides = {image.width, image.height, image.channels};
    fits_create_img(to.file(), FLOAT_IMG, image.channels == 1 ? 2 : 3, sides.data(), to.status());
    if (!name.empty()) write_card(to, {"EXTNAME", std::string(name), "Rec. 709 primary, linear light"});
    write_card(to, {"BUNIT", header.unit, header.unit_comment});
    if (image.channels == 4) {
        write_card(to, {"CTYPE3", "STOKES", "I, Q, U, V; angles from north through east"});
        for (const char* key : {"CRPIX3", "CRVAL3", "CDELT3"}) write_card(to, {key, 1.0, ""});
    }
    for (const FitsCard& card : header.cards) write_card(to, card);
    for (const std::string& comment : header.comments)
        fits_write_comment(to.file(), ascii(comment).c_str(), to.status());
}

// One channel: the bottom row first.
void write_plane(MemoryFile& to, const Image<float>& image, int channel, int plane) {
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    for (int y = image.height - 1; y >= 0; --y)
        for (int x = 0; x < image.width; ++x) values.push_back(image.at(x, y)[channel]);
    const auto count = static_cast<LONGLONG>(values.size());
    fits_write_img_flt(to.file(), 1, plane * count + 1, count, values.data(), to.status());
}

// DATASUM and CHECKSUM (FITS Standard 4.0, appendix J) of the part that is written, with comments that have no date, as CFITSIO's own have.
void write_checksum(MemoryFile& to) {
    constexpr const char *kSum = "CHECKSUM", *kDataSum = "DATASUM";
    write_card(to, {kSum, std::string(16, '0'), "of this part: its 32-bit words add up to -0"});
    write_card(to, {kDataSum, std::string("0"), "of its data"});
    unsigned long data = 0, all = 0;
    const auto add_up = [&] {
        fits_flush_file(to.file(), to.status());  // with the header's end
        fits_get_chksum(to.file(), &data, &all, to.status());
    };
    add_up();
    fits_modify_key_str(to.file(), kDataSum, fmt::format("{}", data).c_str(), "&", to.status());
    add_up();
    std::array<char, 17> encoded{};
    constexpr int kComplement = 1;
    fits_encode_chksum(all, kComplement, encoded.data());
    fits_modify_key_str(to.file(), kSum, encoded.data(), "&", to.status());
}

bool has_size(const Image<float>& image) {
    const auto side = [](int n) { return static_cast<std::size_t>(std::max(n, 0)); };
    return !image.data.empty() && image.data.size() == side(image.width) * side(image.height) * side(image.channels);
}

// HISTORY cards of the primary header.
Result<Texts> fits_texts_of(std::istream& file) {
    constexpr std::size_t kName = 8;  // characters of a card's keyword
    std::vector<std::string> history;
    std::size_t size = 0;
    for (auto card = bytes_from(file, kCard); card; card = bytes_from(file, kCard)) {
        if (card->starts_with("END     ")) return texts_of_cards(history);
        if ((size += kCard) > kMostTextBytes) return texts_too_long();
        if (!card->starts_with("HISTORY ")) continue;
        card->erase(card->find_last_not_of(' ') + 1);
        history.push_back(card->size() > kName ? card->substr(kName) : "");
    }
    return texts_cut_off();
}

}  // namespace

Status save_fits(const std::filesystem::path& path, const Image<float>& image, const FitsHeader& header,
                 const Image<float>& colours) {
    const auto invalid = [&](const std::string& reason) {
        return failed(fmt::format("cannot write '{}': {}", path.string(), reason));
    };
    if (!has_size(image) || (image.channels != 1 && image.channels != 4))
        return invalid(
            fmt::format("{} x {} pixels of {} channels are no FITS image", image.width, image.height, image.channels));
    if (!colours.empty() &&
        (!has_size(colours) || colours.channels != 3 || colours.width != image.width || colours.height != image.height))
        return invalid("its colours are no picture of the same size");
    for (const FitsCard& card : header.cards)
        if (!is_standard(card)) return invalid(fmt::format("'{}' is no keyword with a value", card.keyword));
    constexpr std::size_t kUsualHeader = 4 * kBlock;
    const std::vector<std::string> history = history_cards(header.texts);
    const std::size_t parts = colours.empty() ? 1 : 4;
    const std::size_t bytes_wanted = parts * (kUsualHeader + kBlock) + kCard * history.size() +
                                     (image.data.size() + colours.data.size()) * sizeof(float);
    MemoryFile file((bytes_wanted / kBlock + 1) * kBlock);
    write_header(file, image, header, "");
    for (const std::string& card : history) fits_write_history(file.file(), card.c_str(), file.status());
    for (int channel = 0; channel < image.channels; ++channel) write_plane(file, image, channel, channel);
    write_checksum(file);
    const Image<float> one(colours.width, colours.height, 1);
    for (int c = 0; c < colours.channels && !colours.empty(); ++c) {
        constexpr std::array<std::string_view, 3> kNames = {"RED", "GREEN", "BLUE"};
        write_header(file, one, header, kNames[static_cast<std::size_t>(c)]);
        write_plane(file, colours, c, 0);
        write_checksum(file);
    }
    const std::string_view bytes = file.finish();
    if (*file.status() != 0) return invalid("CFITSIO: " + file.reason());
    return write_text_atomically(path, bytes);
}

const PictureFormat kFitsFormat = {
    .name = "FITS",
    .ending = ".fits",
    .other = "",
    .sample = Sample::kLight,
    .help = "linear light, coordinates on the sky",
    .options = "",
    .is = [](std::string_view bytes) { return bytes.starts_with("SIMPLE  ="); },
    .texts = fits_texts_of,
};

}  // namespace nullscope
