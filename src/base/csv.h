// CSV, and tables with another separator, line by line.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nullscope {

// The lines that say something: no blank ones, none that begin with #. They end with LF or CR LF; a byte order mark is skipped. The
// text must outlive it.
class CsvLines {
public:
    explicit CsvLines(std::string_view text);
    bool next();            // false: there is none
    int number = 0;         // in the file, from 1
    std::string_view line;  // as it stands there, without its end

private:
    std::string_view rest_;
};

// Its fields without blanks around them and without their quotes ("" in quotes stands for one); nothing if a quote is not closed or
// something follows it.
std::optional<std::vector<std::string>> csv_fields(std::string_view line, char separator = ',');

// A text as a field of a line, in quotes where it needs them.
std::string csv_field(const std::string& text);

}  // namespace nullscope
