#include "annotate/marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "annotate/ink.h"
#include "annotate/lettering.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr int kLeastSide_px = 64;
constexpr double kLetters = 1.0 / 40.0, kLeastLetters_px = 11.0;  // an em, of the height
constexpr double kInk = 0.96, kLineInk = 0.85;
constexpr std::size_t kMostLines = 3;

enum class Align { kLeft, kMiddle, kRight };

// With an ellipsis where one line is too wide for itself.
std::string fitted(const Lettering& letters, std::string text, int most) {
    if (letters.width(text) <= most) return text;
    while (!text.empty() && letters.width(text + "…") > most) {
        do text.pop_back();
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80);
        if (!text.empty() && static_cast<unsigned char>(text.back()) >= 0xc0) text.pop_back();
    }
    return text + "…";
}

// Each word on the last line if it fits there and more lines are too many, else on the next.
void add_words(const Lettering& letters, const std::vector<std::string>& words, int most,
               std::vector<std::string>& lines) {
    for (const std::string& word : words) {
        const std::string longer = lines.empty() ? word : lines.back() + " " + word;
        if (!lines.empty() && (letters.width(longer) <= most || lines.size() == kMostLines))
            lines.back() = longer;
        else
            lines.push_back(word);
    }
}

// Broken behind commas; at other blanks only where a part is too wide for a line.
std::vector<std::string> lines_of(const Lettering& letters, const std::string& text, int most) {
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t comma = std::min(text.find(", ", from), text.size());
        const std::string part = text.substr(from, comma + 1 - from);
        add_words(letters, letters.width(part) <= most ? std::vector{part} : split(part, ' '), most, lines);
        from = comma + 2;
    }
    for (std::string& line : lines) line = fitted(letters, line, most);
    return lines;
}

// x: the side or the middle, by `align`; y: the top.
Mark text_mark(const Lettering& letters, const std::vector<std::string>& lines, int x, int y, Align align, double em) {
    int width = 1;
    for (const std::string& line : lines) width = std::max(width, letters.width(line));
    const auto room = [&](int inner) {
        return align == Align::kLeft ? 0 : align == Align::kRight ? width - inner : (width - inner) / 2;
    };
    Sheet ink(width, letters.height() * static_cast<int>(lines.size()));
    int top = 0;
    for (const std::string& line : lines) {
        const Image<unsigned char> drawn = letters.line(line);
        const int left = std::max(room(drawn.width), 0);
        for (int row = 0; row < drawn.height; ++row)
            for (int column = 0; column < std::min(drawn.width, width - left); ++column)
                ink.at(left + column, top + row) = static_cast<float>(*drawn.at(column, row)) / 255.0f;
        top += letters.height();
    }
    const int left = align == Align::kLeft ? x : align == Align::kRight ? x - width : x - width / 2;
    return outlined(ink, left, y, em, kInk);
}

// The last column is covered in part: the bar is as long as it should be.
Mark bar_mark(double length_px, int x, int y, int thick, double em) {
    Sheet ink(std::max(static_cast<int>(std::ceil(length_px)), 1), thick);
    for (int row = 0; row < thick; ++row)
        for (int column = 0; column < ink.width; ++column)
            ink.at(column, row) = static_cast<float>(std::clamp(length_px - column, 0.0, 1.0));
    return outlined(ink, x, y, em, kInk);
}

// Beyond both ends of the picture, so that its outline does not end there.
Mark divider_mark(int width, int height, double em) {
    const int thick = std::max(1, static_cast<int>(std::lround(height / 600.0))), beyond = static_cast<int>(em);
    Sheet ink(thick, height + 2 * beyond);
    std::fill(ink.data.begin(), ink.data.end(), 1.0f);
    return outlined(ink, width / 2 - thick / 2, -beyond, 0.6 * em, kLineInk);
}

}  // namespace

Marks make_marks(const Annotations& annotations, int width, int height, int top, int bottom) {
    Marks made;
    if (annotations.empty() || std::min(width, height) < kLeastSide_px) return made;
    const double em = std::max(kLetters * height, kLeastLetters_px);
    if (annotations.divided) made.marks.push_back(divider_mark(width, height, em));
    if (annotations.left.empty() && annotations.right.empty() && !annotations.bar) return made;
    const Result<Lettering> letters = Lettering::open(em);
    if (!letters) {
        made.note = "pictures have no labels: " + letters.error().message();
        return made;
    }
    const int gap = static_cast<int>(std::lround(0.6 * em)), margin = static_cast<int>(std::lround(em));
    const int middle = width / 2, room = middle - gap - margin;
    for (const auto& [words, x, align] : {std::tuple(annotations.left, middle - gap, Align::kRight),
                                          std::tuple(annotations.right, middle + gap, Align::kLeft)})
        if (!words.empty())
            made.marks.push_back(text_mark(*letters, lines_of(*letters, words, room), x, top + gap, align, em));
    if (annotations.bar) {
        const double length = annotations.bar->length_px;
        const int thick = std::max(2, static_cast<int>(std::lround(0.12 * em))),
                  words = letters->width(annotations.bar->words);
        const int centre = width - margin - static_cast<int>(std::lround(0.5 * std::max(length, 1.0 * words)));
        const int y = height - bottom - margin - thick;
        made.marks.push_back(bar_mark(length, centre - static_cast<int>(std::lround(0.5 * length)), y, thick, em));
        made.marks.push_back(text_mark(*letters, {annotations.bar->words}, centre, y - letters->height() - thick / 2,
                                       Align::kMiddle, em));
    }
    return made;
}

namespace {

template <class T>
void lay(const std::vector<Mark>& marks, Image<T>& picture) {
    constexpr int kCode = std::numeric_limits<T>::max() / 255;  // of the picture, for one of the mark
    for (const Mark& mark : marks)
        for (int row = std::max(0, -mark.y); row < std::min(mark.rgba.height, picture.height - mark.y); ++row)
            for (int column = std::max(0, -mark.x); column < std::min(mark.rgba.width, picture.width - mark.x);
                 ++column) {
                const unsigned char* from = mark.rgba.at(column, row);
                T* to = picture.at(mark.x + column, mark.y + row);
                for (int c = 0; c < 3; ++c)
                    to[c] = static_cast<T>((kCode * from[c] * from[3] + to[c] * (255 - from[3]) + 127) / 255);
            }
}

}  // namespace

void lay_over(const std::vector<Mark>& marks, Image<unsigned char>& picture) { lay(marks, picture); }
void lay_over(const std::vector<Mark>& marks, Image<unsigned short>& picture) { lay(marks, picture); }

}  // namespace nullscope
