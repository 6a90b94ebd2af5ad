#include "image/sphere_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <istream>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

constexpr std::size_t kBoxHead = 8, kLongBoxHead = 16;
constexpr std::size_t kPictureEntry = 86;           // a VisualSampleEntry with its head, before the boxes in it
constexpr std::uint64_t kLargestMoov = 256u << 20;  // ten million pictures have some 20 bytes each

std::string bytes_of(std::uint64_t number, std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t i = count; i-- > 0; number >>= 8) bytes[i] = static_cast<char>(number & 255);
    return bytes;
}

std::string film_box(const std::string& type, const std::string& body) {
    return bytes_of(kBoxHead + body.size(), 4) + type + body;
}
std::string film_full_box(const std::string& type, const std::string& body) {  // version 0, without flags
    return film_box(type, bytes_of(0, 4) + body);
}

std::string sphere_boxes(const FilmSphere& sphere) {
    const auto share = [](double of_all) {  // 0.32 fixed point
        return bytes_of(static_cast<std::uint64_t>(std::llround(std::clamp(std::ldexp(of_all, 32), 0.0, 4294967295.0))),
                        4);
    };
    const std::string bounds = share(sphere.top) + share(sphere.bottom) + share(sphere.left) + share(sphere.right);
    const std::string projection =
        film_full_box("prhd", std::string(12, '\0')) + film_full_box("equi", bounds);  // not turned
    const std::string eyes = bytes_of(static_cast<std::uint64_t>(sphere.eyes), 1);
    return (sphere.eyes == FilmEyes::kOne ? "" : film_full_box("st3d", eyes)) +
           film_box("sv3d", film_full_box("svhd", std::string("nullscope\0", 10)) + film_box("proj", projection));
}

Error not_a_film(const std::string& what) { return failed("not an MP4 or QuickTime film as expected: " + what); }

struct Box {
    std::size_t at, body, end;
    std::string_view type;
};

// Within moov, where sizes have 32 bits.
Result<Box> box_at(std::string_view moov, std::size_t at, std::size_t end) {
    if (end - at < kBoxHead) return not_a_film(fmt::format("a box of {} bytes", end - at));
    const std::size_t size = big_endian(moov.substr(at, 4));
    const std::string_view type = moov.substr(at + 4, 4);
    if (size < kBoxHead || size > end - at)
        return not_a_film(without_controls(
            fmt::format("a box {} of {} bytes, where {} are left", in_quotes(std::string(type)), size, end - at)));
    return Box{at, at + kBoxHead, at + size, type};
}

// What is to be changed in a moov, as places in its bytes.
struct Places {
    struct Table {
        std::size_t at, end, width;
    };
    std::vector<Table> offsets{};      // in the file, of pictures and sound
    std::vector<std::size_t> sizes{};  // of the boxes about `entry`
    std::optional<std::size_t> entry{};
};

Status add_table(std::string_view moov, const Box& box, std::size_t width, Places& places) {
    const std::size_t first = box.body + 8;
    if (first > box.end || big_endian(moov.substr(box.body + 4, 4)) * width != box.end - first)
        return not_a_film("a table of offsets of another size than it says");
    places.offsets.push_back({first, box.end, width});
    return Done{};
}

// Behind what a decoder needs, before what may be left out: colours, shape of the pixels.
Status add_entry(std::string_view moov, const Box& stsd, const std::vector<std::size_t>& about, Places& places) {
    if (stsd.end - stsd.body < 8) return not_a_film("'stsd' without entries");
    if (places.entry || big_endian(moov.substr(stsd.body + 4, 4)) != 1)
        return not_a_film("it has several kinds of pictures");
    TRY(entry, box_at(moov, stsd.body + 8, stsd.end));
    if (entry->end - entry->at < kPictureEntry) return not_a_film("its entry for pictures is cut off");
    std::size_t to = entry->at + kPictureEntry;
    for (std::size_t at = to; entry->end - at >= kBoxHead;) {
        TRY(child, box_at(moov, at, entry->end));
        at = child->end;
        if (child->type == "st3d" || child->type == "sv3d")
            return not_a_film("it says already what it shows of the sphere");
        if (child->type.back() == 'C' || child->type == "esds") to = at;
    }
    places.entry = to, places.sizes = about;
    places.sizes.insert(places.sizes.end(), {stsd.at, entry->at});
    return Done{};
}

constexpr std::array<std::string_view, 5> kWay{"moov", "trak", "mdia", "minf", "stbl"};

Result<bool> shows_pictures(std::string_view moov, const Box& minf) {
    for (std::size_t at = minf.body; at < minf.end;) {
        TRY(child, box_at(moov, at, minf.end));
        if (child->type == "vmhd") return true;
        at = child->end;
    }
    return false;
}

// about: where the boxes begin that hold this one, and it.
Status find_places(std::string_view moov, const Box& box, std::vector<std::size_t> about, bool pictures,
                   Places& places) {
    about.push_back(box.at);
    if (box.type == "minf") {
        TRY(shows, shows_pictures(moov, box));
        pictures = *shows;
    }
    for (std::size_t at = box.body; at < box.end;) {
        TRY(child, box_at(moov, at, box.end));
        at = child->end;
        Status found = Done{};
        if (about.size() < kWay.size())
            found =
                child->type == kWay[about.size()] ? find_places(moov, *child, about, pictures, places) : Status(Done{});
        else if (child->type == "stco" || child->type == "co64")
            found = add_table(moov, *child, child->type == "stco" ? 4 : 8, places);
        else if (child->type == "saio")
            found = not_a_film("it is encrypted");
        else if (child->type == "stsd" && pictures)
            found = add_entry(moov, *child, about, places);
        if (!found) return found;
    }
    return Done{};
}

// moov lay at first, up to end, in the file; what is behind it moves.
Status put_in(std::string& moov, const std::string& boxes, std::uint64_t first, std::uint64_t end) {
    Places places;
    TRY(whole, box_at(moov, 0, moov.size()));
    TRY(found, find_places(moov, *whole, {}, false, places));
    if (!places.entry) return not_a_film("it has no track of pictures");
    for (const Places::Table& table : places.offsets)
        for (std::size_t at = table.at; at < table.end; at += table.width) {
            const std::uint64_t offset = big_endian(std::string_view(moov).substr(at, table.width));
            if (offset < first) continue;
            const std::uint64_t most = table.width == 4 ? std::numeric_limits<std::uint32_t>::max()
                                                        : std::numeric_limits<std::uint64_t>::max();
            if (offset < end || offset > most - boxes.size())
                return not_a_film("pictures or sound at an impossible place");
            moov.replace(at, table.width, bytes_of(offset + boxes.size(), table.width));
        }
    for (const std::size_t at : places.sizes)
        moov.replace(at, 4, bytes_of(big_endian(std::string_view(moov).substr(at, 4)) + boxes.size(), 4));
    moov.insert(*places.entry, boxes);
    return Done{};
}

struct FileSpan {
    std::uint64_t first, end;
};

Result<std::string> read_span(std::istream& film, FileSpan span) {
    std::string bytes(span.end - span.first, '\0');
    film.seekg(static_cast<std::streamoff>(span.first));
    if (!film.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return failed("it cannot be read");
    return bytes;
}

Result<FileSpan> find_moov(std::istream& film, std::uint64_t size) {
    std::optional<FileSpan> moov;
    for (std::uint64_t at = 0; at < size;) {
        if (size - at < kBoxHead) return not_a_film("it is cut off");
        TRY(head, read_span(film, {at, at + std::min<std::uint64_t>(size - at, kLongBoxHead)}));
        const std::string type = head->substr(4, 4);
        std::uint64_t length = big_endian(std::string_view(*head).substr(0, 4));
        const bool is_long = length == 1 && head->size() == kLongBoxHead;
        if (is_long) length = big_endian(std::string_view(*head).substr(kBoxHead));
        if (length == 0) length = size - at;
        if (length < (is_long ? kLongBoxHead : kBoxHead) || length > size - at)
            return not_a_film(without_controls(
                fmt::format("a box {} of {} bytes, where {} are left", in_quotes(type), length, size - at)));
        if (type == "moof") return not_a_film("it is in fragments; leave out ffmpeg's -movflags for them");
        if (type == "moov") {
            if (moov || is_long || length > kLargestMoov)
                return not_a_film("its box 'moov' is there twice or too large");
            moov = FileSpan{at, at + length};
        }
        at += length;
    }
    return moov ? Result<FileSpan>(*moov) : not_a_film("it has no box 'moov'");
}

Status copy_span(std::istream& film, FileSpan span, std::ostream& to) {
    constexpr std::uint64_t kAtOnce = 1u << 20;
    for (std::uint64_t at = span.first; at < span.end && to; at += kAtOnce) {
        TRY(bytes, read_span(film, {at, std::min(span.end, at + kAtOnce)}));
        to.write(bytes->data(), static_cast<std::streamsize>(bytes->size()));
    }
    return Done{};
}

}  // namespace

Status copy_with_sphere(std::istream& film, const FilmSphere& sphere, std::ostream& film_with_sphere) {
    film.seekg(0, std::ios::end);
    const std::streamoff size = film.tellg();
    if (!film || size < 0) return failed("it cannot be read");
    const auto end = static_cast<std::uint64_t>(size);
    TRY(at, find_moov(film, end));
    TRY(moov, read_span(film, *at));
    TRY(put, put_in(*moov, sphere_boxes(sphere), at->first, at->end));
    TRY(before, copy_span(film, {0, at->first}, film_with_sphere));
    film_with_sphere.write(moov->data(), static_cast<std::streamsize>(moov->size()));
    return copy_span(film, {at->end, end}, film_with_sphere);
}

}  // namespace nullscope
