// What the viewer says over the picture for a while.
#pragma once
#include <algorithm>
#include <limits>
#include <string>

namespace nullscope::viewer {

class Message {
public:
    static constexpr double kTime_s = 6.0;
    // now: s of a steady clock, here and below.
    void say(const std::string& text, double now) { text_ = text, until_ = now + kTime_s; }
    const std::string& text() const { return text_; }  // "": nothing is said
    // True once, when it is over.
    bool ends(double now) {
        if (text_.empty() || now <= until_) return false;
        return text_.clear(), true;
    }
    // Until it ends; infinite: nothing is said.
    double left(double now) const {
        constexpr double kLeast = 0.01;
        return text_.empty() ? std::numeric_limits<double>::infinity() : std::max(until_ - now, kLeast);
    }

private:
    std::string text_;
    double until_ = 0.0;
};

}  // namespace nullscope::viewer
