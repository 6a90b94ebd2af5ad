#include "image/area_filter.h"

#include <algorithm>
#include <cmath>

namespace nullscope {

std::vector<AreaFilter::Part> AreaFilter::parts_of(int from, int to) {
    std::vector<Part> parts(static_cast<std::size_t>(from));
    const double scale = static_cast<double>(to) / from;
    for (int i = 0; i < from; ++i) {
        const long long left = static_cast<long long>(i) * to,
                        right = left + to;  // of the old one, in parts of the new's 1/from
        const int first = static_cast<int>(left / from);
        const long long edge = static_cast<long long>(first + 1) * from;
        const double beyond = right > edge ? static_cast<double>(right - edge) / from : 0.0;
        parts[static_cast<std::size_t>(i)] = {first, static_cast<float>(scale - beyond), static_cast<float>(beyond)};
    }
    return parts;
}

AreaFilter::AreaFilter(int width, int height, int channels, int to_width, int to_height)
    : channels_(channels),
      columns_(parts_of(width, to_width)),
      rows_(parts_of(height, to_height)),
      line_(static_cast<std::size_t>(to_width + 1) * channels),
      sum_(line_.size()),
      next_(line_.size()),
      image_(to_width, to_height, channels) {}

void AreaFilter::add_row(const float* row) {
    std::fill(line_.begin(), line_.end(), 0.0f);
    const auto channels = static_cast<std::size_t>(channels_);
    for (const Part& column : columns_) {
        float* to = line_.data() + static_cast<std::size_t>(column.first) * channels;
        const float alpha = channels == 4 ? row[3] : 1.0f;
        for (std::size_t c = 0; c < 3; ++c) {
            to[c] += column.here * alpha * row[c];
            to[channels + c] += column.beyond * alpha * row[c];
        }
        if (channels == 4) to[3] += column.here * alpha, to[7] += column.beyond * alpha;
        row += channels;
    }
    const Part& part = rows_[row_++];
    for (std::size_t i = 0; i < line_.size(); ++i) {
        sum_[i] += part.here * line_[i];
        next_[i] += part.beyond * line_[i];
    }
    const bool last = row_ == rows_.size();
    if (!last && rows_[row_].first == part.first) return;
    float* to = image_.at(0, part.first);
    for (int x = 0; x < image_.width; ++x, to += channels) {
        const float* from = sum_.data() + static_cast<std::size_t>(x) * channels;
        const float alpha = channels == 4 ? from[3] : 1.0f;
        for (std::size_t c = 0; c < 3; ++c) to[c] = alpha > 0.0f ? from[c] / alpha : 0.0f;
        if (channels == 4) to[3] = std::min(alpha, 1.0f);
    }
    sum_.swap(next_);
    std::fill(next_.begin(), next_.end(), 0.0f);
}

FittedSize fitted_size(int width, int height, int max_side) {
    const int longer = std::max(width, height);
    if (longer <= max_side) return {width, height};
    const auto part = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(static_cast<double>(side) * max_side / longer)));
    };
    return {part(width), part(height)};
}

}  // namespace nullscope
