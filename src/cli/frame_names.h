// The names of a sequence's files: a file name with one place for the frame's number.
#pragma once
#include <string>

#include "base/result.h"

namespace nullscope::cli {

class FrameNames {
public:
    // pattern: holds one of %d, %5d, %05d (up to 9 digits) or #####. Errors: no such place, or more than one.
    static Result<FrameNames> parse(const std::string& pattern);
    static FrameNames in_folder(const std::string& folder);  // folder/00000.png ...
    std::string of(int frame) const;                         // with zeros in front, as many digits as there are places
    const std::string& pattern() const { return pattern_; }
    std::string stamp_file() const;  // NAME.png.stamp for NAME%05d.png

private:
    std::string pattern_, before_, after_;
    int digits_ = 1;
};

}  // namespace nullscope::cli
