// Image<T>: rows from the top, channels interleaved.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace nullscope {

template <class T>
struct Image {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<T> data;  // width * height * channels

    Image() = default;
    Image(int w, int h, int c) : width(w), height(h), channels(c), data(static_cast<std::size_t>(w) * h * c, T{}) {}

    T* at(int x, int y) { return data.data() + (static_cast<std::size_t>(y) * width + x) * channels; }
    const T* at(int x, int y) const { return data.data() + (static_cast<std::size_t>(y) * width + x) * channels; }
    bool empty() const { return data.empty(); }
};

// Whether a file of that many bytes can hold that many samples (pixels times channels). A short file that announces
// more would only make a reader allocate: deflate, the densest compression there is, packs 1032 to 1, here 1-bit pixels.
inline bool plausible_size(long long samples, unsigned long long file_bytes) {
    constexpr unsigned long long kAlways = 1u << 26, kMostPerByte = 8 * 1032;  // 64 Mi samples: 256 MB of floats
    return static_cast<unsigned long long>(samples) <= kAlways ||
           static_cast<unsigned long long>(samples) / kMostPerByte <= file_bytes;
}

// Copies columns x rows px from (left, top) on to (to_left, to_top) of an image with as many channels, which has room for them.
template <class T>
void copy_part(const Image<T>& from, int left, int top, int columns, int rows, Image<T>& to, int to_left, int to_top) {
    for (int y = 0; y < rows; ++y)
        std::copy_n(from.at(left, top + y), columns * from.channels, to.at(to_left, to_top + y));
}

// Of one height and kind.
template <class T>
Image<T> side_by_side(const Image<T>& left, const Image<T>& right) {
    Image<T> both(left.width + right.width, left.height, left.channels);
    copy_part(left, 0, 0, left.width, left.height, both, 0, 0);
    copy_part(right, 0, 0, right.width, left.height, both, left.width, 0);
    return both;
}

}  // namespace nullscope
