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

// Of one height and kind.
template <class T>
Image<T> side_by_side(const Image<T>& left, const Image<T>& right) {
    Image<T> both(left.width + right.width, left.height, left.channels);
    for (int y = 0; y < left.height; ++y) {
        std::copy_n(left.at(0, y), left.width * left.channels, both.at(0, y));
        std::copy_n(right.at(0, y), right.width * right.channels, both.at(left.width, y));
    }
    return both;
}

}  // namespace nullscope
