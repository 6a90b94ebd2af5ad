// How large the pictures of a view in motion are: as large as their rate allows.
#pragma once

namespace nullscope::viewer {

inline constexpr double kMotion_ms = 40.0;  // what a picture in motion may take: 25 a second
inline constexpr double kMotionInMatter_ms =
    50.0;  // with matter: 20 a second, for a picture of a quarter of the pixels costs more than a third
// Of a picture as large as the window, drawn by itself: it is shown as it is, which takes next to nothing, where the driver of a processor
// takes 7 ns a pixel to stretch a smaller one.
inline constexpr double kWholeInMotion_ms = 34.0;

class MotionSize {
public:
    struct Costs {
        double last_ms = 0.0;   // of the last picture, drawn while the window was drawn, too; 0: not known
        double alone_ms = 0.0;  // of one as large as the window, drawn by itself; 0: not known
        bool matter =
            false;  // light of matter is interpolated: what it takes goes by the picture's sides, not by its pixels
    };
    // How many times smaller than the window's the sides of the next picture are, 1 to 8; the last one's were as this has said.
    double next(const Costs& costs);

private:
    double proportional(const Costs& costs, double most_ms) const;
    double beside_window(const Costs& costs);

    double times_ = 1.0;     // of the last picture
    double wait_ms_ = -1.0;  // of each picture, whatever its size, for the window; of the last few. -1: not known
    double most_ms_ = 0.0;   // of a picture as large as the window with that wait, likewise
    double alone_ms_ = 0.0;  // that it is of
    bool whole_fails_ = false;
};

}  // namespace nullscope::viewer
