// What the window's loop does, written to a file for tests and for people who look for hitches: a line for each turn
// that drew, one for each picture that is the first of its kind, one whenever the viewer comes to rest. Each line is
// a word and name=value pairs:
//
//   turn t=1.234 cpu_ms=3.1 here=0 programs=1 pictures=7 picture=whole size=1280x720 work=1 age_ms=41.3
//   first t=0.871 cpu=1.310 picture=coarse
//   rest t=2.100 key=284 measuring=0
//
// t: s since the process began. cpu_ms: processor time of the window's thread alone, so that it does not depend on
// what else the machine does. here: pictures that this thread drew itself until now. pictures: shown until now. age_ms: of a
// picture that is shown for the first time, since the input that it follows; 0: none is. cpu: s of the whole process.
// key: the last key that was pressed (GLFW's number), so that who has sent a key knows that all before it was
// answered. measuring: errors or the effects' times still are.
#pragma once
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "base/result.h"

namespace nullscope::viewer {

class LoopLog {
public:
    // Without it nothing is written. Errors: a file that cannot be written.
    Status open(const std::string& path);
    bool is_open() const { return file_.is_open(); }

    struct Turn {
        double cpu_ms = 0.0;
        int here = 0, programs = 0, pictures = 0;
        bool picture = false, coarse = false, working = false;
        int width = 0, height = 0;  // the picture's, px
        double age_ms = 0.0;
    };
    void turn(const Turn& turn);              // that drew
    void rest(int last_key, bool measuring);  // once after each turn, key or end of measuring

private:
    void line(const std::string& words);
    std::ofstream file_;
    bool coarse_seen_ = false, whole_seen_ = false;
    std::optional<std::pair<int, bool>> rested_;  // what rest() wrote last; nothing: a turn was drawn since
};

}  // namespace nullscope::viewer
