// Files that a number in their names tells apart: flow-00001.grid, flow-00002.grid, ...
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace nullscope {

inline constexpr std::string_view kNumberPlaces = "%05d, %d or #####";  // for messages
inline constexpr int kMostNumberDigits = 9;

// Is there a place for a number? (One # alone may be part of any name.)
bool names_numbers(const std::string& text);

class NumberedFiles {
public:
    // pattern: a path whose file name holds one of %d, %5d, %05d (up to kMostNumberDigits) or #####. folder: of a pattern without one.
    // Nothing: no such place, or more than one.
    static std::optional<NumberedFiles> parse(const std::string& pattern, const std::string& folder = {});
    NumberedFiles(std::string before, std::string after, int digits)
        : before_(std::move(before)), after_(std::move(after)), digits_(digits) {}

    std::string of(int number) const;  // with zeros in front, as many digits as there are places
    std::vector<int> on_disk() const;  // the numbers of the files that are there, ascending
    const std::string& before() const { return before_; }
    const std::string& after() const { return after_; }

private:
    std::string before_, after_;
    int digits_;
};

}  // namespace nullscope
