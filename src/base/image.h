// Image<T>: rows from the top, channels interleaved.
#pragma once
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
    Image(int w, int h, int c)
        : width(w), height(h), channels(c), data(static_cast<std::size_t>(w) * h * c, T{}) {}

    T* at(int x, int y) { return data.data() + (static_cast<std::size_t>(y) * width + x) * channels; }
    const T* at(int x, int y) const { return data.data() + (static_cast<std::size_t>(y) * width + x) * channels; }
    bool empty() const { return data.empty(); }
};

}  // namespace nullscope
