#include "image/picture_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.h"
#include "image/image_formats.h"
#include "image/picture_formats.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMarkBytes = 9;  // by which a file's format is known

constexpr std::size_t kCardWords = 72;  // characters of a card

std::string without_escapes(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        unsigned code = 0;
        const char* digits = text.data() + i + 1;
        if (text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
            plain += static_cast<char>(code), i += 2;
        else
            plain += text[i];
    }
    return plain;
}

const PictureFormat* format_of(std::string_view bytes) {
    const auto found =
        std::ranges::find_if(kPictureFormats, [&](const PictureFormat* format) { return format->is(bytes); });
    return found != kPictureFormats.end() ? *found : nullptr;
}

// "PNG, JPEG, EXR or FITS"
std::string format_names() {
    std::string names;
    for (const PictureFormat* format : kPictureFormats)
        names += fmt::format("{}{}",
                             names.empty()                      ? ""
                             : format == kPictureFormats.back() ? " or "
                                                                : ", ",
                             format->name);
    return names;
}

// Of a line: pieces that a card holds.
std::vector<std::string> card_pieces(std::string_view line) {
    constexpr std::size_t kMost = kCardWords - 4;  // behind a mark, and a blank at the end takes two more
    std::vector<std::string> pieces(1);
    for (const char c : line) {
        const bool plain = c >= ' ' && c <= '~' && c != '%';
        const std::string written = plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
        if (pieces.back().size() + written.size() > kMost) pieces.emplace_back();
        pieces.back() += written;
    }
    for (std::string& piece : pieces)
        if (piece.ends_with(' ')) piece.replace(piece.size() - 1, 1, "%20");
    return pieces;
}

}  // namespace

std::optional<std::string> bytes_from(std::istream& file, std::size_t count) {
    std::string bytes(count, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(file.gcount()) != count) return std::nullopt;
    return bytes;
}

Error texts_cut_off() { return bad_input("its metadata are cut off"); }
Error texts_too_long() { return bad_input(fmt::format("its metadata are longer than {} bytes", kMostTextBytes)); }

bool is_picture_file(const fs::path& path) {
    std::array<char, 16> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    return format_of({bytes.data(), static_cast<std::size_t>(file.gcount())}) != nullptr;
}

Texts in_pieces(const Texts& texts, std::size_t most) {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
    Texts pieces;
    for (const auto& [keyword, text] : texts) {
        if (text.size() <= most) {
            pieces[keyword] = text;
            continue;
        }
        int number = 0;
        for (std::size_t at = 0; at < text.size();) {
            std::size_t count = most < text.size() - at ? most : text.size() - at;
            while (count > most - 4 && at + count < text.size() && continues(text[at + count])) --count;
            pieces[fmt::format("{}.{}", keyword, number++)] = text.substr(at, count);
            at += count;
        }
    }
    return pieces;
}

Texts put_together(Texts pieces) {
    Texts firsts;  // keywords of which there is a first piece
    for (const auto& [keyword, text] : pieces)
        if (keyword.starts_with(kOwnTexts) && keyword.ends_with(".0")) firsts[keyword.substr(0, keyword.size() - 2)];
    for (const auto& [keyword, none] : firsts) {
        if (pieces.contains(keyword)) continue;
        std::string whole;
        for (int number = 0;; ++number) {
            const auto piece = pieces.extract(fmt::format("{}.{}", keyword, number));
            if (piece.empty()) break;
            whole += piece.mapped();
        }
        pieces[keyword] = std::move(whole);
    }
    return pieces;
}

Result<Texts> read_texts(std::istream& file, const std::string& name) {
    const auto first = bytes_from(file, kMarkBytes);
    const PictureFormat* format = first ? format_of(*first) : nullptr;
    if (!first) return unreadable(name, texts_cut_off().message());
    if (format == nullptr) return unreadable(name, fmt::format("not a {} file", format_names()));
    file.seekg(0);
    Result<Texts> texts = format->texts(file);
    if (!texts) return unreadable(name, texts.error().message());
    return put_together(std::move(*texts));
}

Result<Texts> load_texts(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return bad_input(fmt::format("cannot read '{}': it cannot be opened", path.string()));
    return read_texts(file, path.string());
}

std::vector<std::string> history_cards(const Texts& texts) {
    std::vector<std::string> cards;
    for (const auto& [keyword, text] : texts) {
        cards.push_back(keyword);
        for (const std::string& line : split(text, '\n')) {
            char mark = '|';
            for (const std::string& piece : card_pieces(line)) {
                cards.push_back(piece.empty() ? std::string(1, mark) : fmt::format("{} {}", mark, piece));
                mark = '+';
            }
        }
    }
    return cards;
}

Texts texts_of_cards(const std::vector<std::string>& cards) {
    Texts texts;
    std::string* text = nullptr;
    std::size_t lines = 0;
    for (const std::string& card : cards) {
        if (card.starts_with(kOwnTexts) && card.find(' ') == std::string::npos)
            text = &(texts[card] = ""), lines = 0;
        else if (text != nullptr && card.starts_with('|'))
            *text += std::string(lines++ == 0 ? "" : "\n") + (card.size() > 2 ? card.substr(2) : "");
        else if (text != nullptr && card.starts_with("+ "))
            *text += card.substr(2);
        else
            text = nullptr;
    }
    for (auto& [keyword, whole] : texts) whole = without_escapes(whole);
    return texts;
}

}  // namespace nullscope
