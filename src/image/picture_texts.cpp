#include "image/picture_texts.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.h"
#include "image/image_formats.h"

namespace nullscope {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPngMark = "\x89PNG\r\n\x1a\n", kJpegMark = "\xff\xd8\xff", kExrMark = "\x76\x2f\x31\x01",
                           kFitsMark = "SIMPLE  =";

Error cut_off() { return bad_input("it is cut off within what it says of itself"); }
Error too_long() { return bad_input(fmt::format("it says more than {} bytes of itself", kMostTextBytes)); }

// Exactly so many bytes; nothing where the file ends before.
std::optional<std::string> bytes_of(std::istream& file, std::size_t count) {
    std::string bytes(count, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(count));
    if (static_cast<std::size_t>(file.gcount()) != count) return std::nullopt;
    return bytes;
}

std::size_t big_endian(std::string_view bytes) {
    std::size_t value = 0;
    for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

// What is not looked at is skipped; a file that ends in its pixels has said all before, or nothing.
Result<Texts> png_texts_of(std::istream& file) {
    std::string chunks;
    for (auto head = bytes_of(file, 8); head; head = bytes_of(file, 8)) {
        constexpr std::size_t kCheckSum = 4;
        const std::size_t length = big_endian(head->substr(0, 4));
        const std::string kind = head->substr(4);
        if (kind == "IEND") break;
        if (kind != "tEXt" && kind != "zTXt" && kind != "iTXt") {
            file.seekg(static_cast<std::streamoff>(length + kCheckSum), std::ios::cur);
            continue;
        }
        if (chunks.size() + length > kMostTextBytes) return too_long();
        const auto body = bytes_of(file, length + kCheckSum);
        if (!body) return cut_off();
        chunks += *head + *body;
    }
    return png_chunk_texts(chunks);
}

Result<Texts> jpeg_texts_of(std::istream& file) {
    constexpr std::size_t kScan = 0xda, kEnd = 0xd9, kComment = 0xfe;
    Texts texts;
    std::size_t size = 0;
    for (auto mark = bytes_of(file, 2); mark; mark = bytes_of(file, 2)) {
        if ((*mark)[0] != '\xff') return bad_input("its markers are damaged");
        if ((*mark)[1] == '\xff') {  // fill bytes
            file.seekg(-1, std::ios::cur);
            continue;
        }
        const std::size_t kind = big_endian(mark->substr(1));
        if (kind == kScan || kind == kEnd) return texts;
        const auto length = bytes_of(file, 2);
        if (!length || big_endian(*length) < 2) return cut_off();
        const std::size_t left = big_endian(*length) - 2;
        if (kind != kComment) {
            file.seekg(static_cast<std::streamoff>(left), std::ios::cur);
            continue;
        }
        if ((size += left) > kMostTextBytes) return too_long();
        const auto comment = bytes_of(file, left);
        if (!comment) return cut_off();
        const std::size_t line = comment->find('\n');
        if (comment->starts_with(kOwnTexts) && line != std::string::npos)
            texts[comment->substr(0, line)] = comment->substr(line + 1);
    }
    return cut_off();
}

Result<Texts> exr_texts_of(std::istream& file) {
    std::string header(kMostTextBytes, '\0');
    file.read(header.data(), static_cast<std::streamsize>(header.size()));
    header.resize(static_cast<std::size_t>(file.gcount()));
    return exr_header_texts(header);
}

constexpr std::size_t kCardBytes = 80, kCardWords = 72;  // characters, and those of a HISTORY card's text

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

Result<Texts> fits_texts_of(std::istream& file) {
    Texts texts;
    std::string* text = nullptr;
    std::size_t size = 0, lines = 0;
    for (auto card = bytes_of(file, kCardBytes); card; card = bytes_of(file, kCardBytes)) {
        if (card->starts_with("END     ")) return texts;
        if ((size += kCardBytes) > kMostTextBytes) return too_long();
        if (!card->starts_with("HISTORY ")) continue;
        std::string words = card->substr(kCardBytes - kCardWords);
        words.erase(words.find_last_not_of(' ') + 1);
        if (words.starts_with(kOwnTexts) && words.find(' ') == std::string::npos)
            text = &(texts[words] = ""), lines = 0;
        else if (text != nullptr && words.starts_with('|'))
            *text += std::string(lines++ == 0 ? "" : "\n") + (words.size() > 2 ? words.substr(2) : "");
        else if (text != nullptr && words.starts_with("+ "))
            *text += words.substr(2);
        else
            text = nullptr;
    }
    return cut_off();
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

bool is_picture(std::string_view bytes) {
    return bytes.starts_with(kPngMark) || bytes.starts_with(kJpegMark) || bytes.starts_with(kExrMark) ||
           bytes.starts_with(kFitsMark);
}

bool is_picture_file(const fs::path& path) {
    std::array<char, 16> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    return is_picture({bytes.data(), static_cast<std::size_t>(file.gcount())});
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
    const auto first = bytes_of(file, kFitsMark.size());
    const auto found = [&]() -> Result<Texts> {
        if (!first) return cut_off();
        const auto from = [&](std::size_t at) -> std::istream& {
            file.seekg(static_cast<std::streamoff>(at));
            return file;
        };
        if (first->starts_with(kPngMark)) return png_texts_of(from(kPngMark.size()));
        if (first->starts_with(kJpegMark)) return jpeg_texts_of(from(2));
        if (first->starts_with(kExrMark)) return exr_texts_of(from(0));
        if (first->starts_with(kFitsMark)) return fits_texts_of(from(0));
        return bad_input("not a PNG, JPEG, EXR or FITS file");
    };
    Result<Texts> texts = found();
    if (!texts) return unreadable(name, texts.error().message());
    Texts whole = put_together(std::move(*texts));
    if (first->starts_with(kFitsMark))
        for (auto& [keyword, text] : whole) text = without_escapes(text);
    return whole;
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

}  // namespace nullscope
