// A picture is drawn in bands of rows, each finished before the next: a driver does one thing at a time, and the
// window must get its turn. Pure arithmetic: what the bands are, from what those before took.
#pragma once

namespace nullscope::viewer {

inline constexpr double kBand_ms = 20.0;  // what the window may have to wait for
inline constexpr int kFirstRows = 8;      // of a picture of unknown cost
// Bands begin and end at multiples of this many rows: software drivers shade blocks of 4 x 4 pixels, whole ones even where a band ends within
// them, so that a single row costs as much as four.
inline constexpr int kBlockRows = 4;
static_assert(kFirstRows % kBlockRows == 0);
// How much longer a band may take where dear rows begin, as they did in the picture before. With 1 a single time that
// the machine lengthened would cut the next picture into single rows.
inline constexpr double kLongestBand = 4.0;

class BandCutter {
public:
    // row_ms: of the dearest row of a picture like this one; 0: not known.
    BandCutter(int height, double row_ms);

    bool done() const { return first_ >= height_; }
    int first() const { return first_; }
    int last() const { return last_; }  // one after the band's last row

    // Goes on to the next band. compiled: the driver has compiled a program meanwhile, so that the time says nothing
    // about rows.
    void took(double ms, bool compiled);

    double row_ms() const { return dearest_ms_; }  // of the dearest row so far; 0: not known
    // What the band that compiled took beyond what its rows take, judged by the band after it.
    double compile_ms() const { return compile_ms_; }

private:
    int height_, first_ = 0, last_;
    double expected_ms_;  // at least, of a row that is yet to come
    double dearest_ms_ = 0.0, compile_ms_ = 0.0;
    int compiled_rows_ = 0;  // of a band that compiled, until a band after it tells what they took
};

}  // namespace nullscope::viewer
