#include "base/csv.h"

#include <algorithm>

#include "base/text.h"

namespace nullscope {

CsvLines::CsvLines(std::string_view text) : rest_(text) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

bool CsvLines::next() {
    while (!rest_.empty()) {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        ++number;
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != std::string_view::npos && line[first] != '#') return true;
    }
    return false;
}

std::optional<std::vector<std::string>> csv_fields(std::string_view line, char separator) {
    const std::string_view blanks = separator == '\t' ? " " : " \t";
    std::vector<std::string> fields;
    std::size_t at = 0;
    while (true) {
        std::string field;
        const std::size_t first = std::min(line.find_first_not_of(blanks, at), line.size());
        if (first < line.size() && line[first] == '"') {
            at = first + 1;
            while (true) {
                const std::size_t quote = line.find('"', at);
                if (quote == std::string_view::npos) return std::nullopt;
                field += line.substr(at, quote - at);
                at = quote + 1;
                if (at >= line.size() || line[at] != '"') break;
                field += '"';  // "" stands for one
                ++at;
            }
            at = std::min(line.find_first_not_of(blanks, at), line.size());
            if (at < line.size() && line[at] != separator) return std::nullopt;
        } else {
            const std::size_t comma = std::min(line.find(separator, at), line.size());
            field = trim(line.substr(at, comma - at));
            at = comma;
        }
        fields.push_back(std::move(field));
        if (at == line.size()) return fields;
        ++at;
    }
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace nullscope
