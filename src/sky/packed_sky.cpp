// Its loops are to be vectorised: see its compiler options in src/CMakeLists.txt.
#include "sky/packed_sky.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

namespace nullscope {
namespace {

constexpr std::int32_t kRebias = 112 << 23;  // between a float's exponent and a small float's
constexpr int kShift11 = 17, kShift10 = 18;
constexpr float kMost11 = 65024.0f, kMost10 = 64512.0f;

// A band is so many rows that it holds one row of the level of 16 texels.
constexpr int kCoarsest = 16;
constexpr int kPaintedAtOnce = 32;  // rows: the floats of a face of 2048 then fit a core's cache
constexpr int kBandsAThread = 2;    // painted while as many are handed over: 6 MB a thread at 2048

constexpr std::int32_t kLeast = kRebias + (1 << 23);  // bits of 2^-14, from which on a small float has an exponent

// kShift: bits of a float's mantissa that are cut off. Below 2^-14 steps stay what they are there.
template <int kShift>
inline std::uint32_t small_float(float value, float most) {
    constexpr float kSteps = static_cast<float>(1 << (14 + 23 - kShift));  // in 1
    const float positive = value > 0.0f ? value : 0.0f;                    // NaN too
    const float within = positive < most ? positive : most;
    const auto bits = std::bit_cast<std::int32_t>(within);
    const auto fine = static_cast<std::int32_t>((bits < kLeast ? within : 0.0f) * kSteps);
    return static_cast<std::uint32_t>(bits >= kLeast ? (bits - kRebias) >> kShift : fine);
}

template <int kShift>
inline float large_float(std::uint32_t packed) {
    constexpr float kStep = 1.0f / static_cast<float>(1 << (14 + 23 - kShift));
    const auto bits = static_cast<std::int32_t>(packed << kShift);
    return bits >= 1 << 23 ? std::bit_cast<float>(bits + kRebias)
                           : static_cast<float>(static_cast<std::int32_t>(packed)) * kStep;
}

inline std::uint32_t pack(float red, float green, float blue) {
    return small_float<kShift11>(red, kMost11) | small_float<kShift11>(green, kMost11) << 11 |
           small_float<kShift10>(blue, kMost10) << 22;
}

void pack_rows(const SkyRows& rows, std::uint32_t* out) {
    const float *red = rows.planes[0].data(), *green = rows.planes[1].data(), *blue = rows.planes[2].data();
    for (std::size_t i = 0, count = rows.texels(); i < count; ++i) out[i] = pack(red[i], green[i], blue[i]);
}

// Rows of a face at every level, one after the other, that belong to one band.
class Bands {
public:
    explicit Bands(const SkyPainter& painter)
        : painter_(painter),
          rows_(painter.face_size() / kCoarsest),
          width_(painter.face_size() + 2 * painter.border()),
          of_face_(width_ / rows_) {
        for (int level = 0; rows_ >> level > 0; ++level) {
            starts_.push_back(texels_);
            texels_ += static_cast<std::size_t>(width_ >> level) * static_cast<std::size_t>(rows_ >> level);
        }
    }
    int count() const { return 6 * of_face_; }
    int of_face() const { return of_face_; }
    std::size_t texels() const { return texels_; }

    void make(int band, std::uint32_t* out) {
        SkyRows& scratch = scratch_.local();
        const int first = band % of_face_ * rows_ - painter_.border(), step = std::min(rows_, kPaintedAtOnce);
        for (int row = 0; row < rows_; row += step) {
            painter_.paint(band / of_face_, first + row, step, scratch);
            pack_rows(scratch, out + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_));
        }
        for (std::size_t level = 1; level < starts_.size(); ++level)
            halve_packed(out + starts_[level - 1], width_ >> (level - 1), rows_ >> (level - 1), out + starts_[level]);
    }

    void hand_over(int band, const std::uint32_t* texels, const std::function<void(const PackedRows&)>& take) const {
        for (std::size_t level = 0; level < starts_.size(); ++level) {
            const int rows = rows_ >> level;
            take({band / of_face_, static_cast<int>(level), band % of_face_ * rows, rows, width_ >> level,
                  texels + starts_[level]});
        }
    }
    int levels() const { return static_cast<int>(starts_.size()); }
    const std::uint32_t* coarsest(const std::uint32_t* texels) const { return texels + starts_.back(); }

private:
    const SkyPainter& painter_;
    int rows_, width_, of_face_;
    std::vector<std::size_t> starts_;
    std::size_t texels_ = 0;
    tbb::enumerable_thread_specific<SkyRows> scratch_;
};

// The levels of less than kCoarsest texels, from that one.
void hand_over_rest(int face, int level, std::vector<std::uint32_t> texels,
                    const std::function<void(const PackedRows&)>& take) {
    std::vector<std::uint32_t> half(texels.size());
    for (int width = kCoarsest / 2; width > 0; width /= 2) {
        halve_packed(texels.data(), 2 * width, 2 * width, half.data());
        std::swap(texels, half);
        take({face, level++, 0, width, width, texels.data()});
    }
}

}  // namespace

std::uint32_t packed_light(float red, float green, float blue) { return pack(red, green, blue); }

void halve_packed(const std::uint32_t* from, int width, int rows, std::uint32_t* to) {
    constexpr std::uint32_t kMask11 = (1u << 11) - 1;
    for (int y = 0; y + 1 < rows; y += 2) {
        const std::uint32_t *upper = from + static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                            *lower = upper + width;
        for (int x = 0; x < width / 2; ++x) {
            const std::uint32_t a = upper[2 * x], b = upper[2 * x + 1], c = lower[2 * x], d = lower[2 * x + 1];
            const float red = large_float<kShift11>(a & kMask11) + large_float<kShift11>(b & kMask11) +
                              large_float<kShift11>(c & kMask11) + large_float<kShift11>(d & kMask11);
            const float green = large_float<kShift11>(a >> 11 & kMask11) + large_float<kShift11>(b >> 11 & kMask11) +
                                large_float<kShift11>(c >> 11 & kMask11) + large_float<kShift11>(d >> 11 & kMask11);
            const float blue = large_float<kShift10>(a >> 22) + large_float<kShift10>(b >> 22) +
                               large_float<kShift10>(c >> 22) + large_float<kShift10>(d >> 22);
            *to++ = pack(0.25f * red, 0.25f * green, 0.25f * blue);
        }
    }
}

void pack_sky(const SkyPainter& painter, const std::function<void(const PackedRows&)>& take) {
    Bands bands(painter);
    const int at_once = kBandsAThread * tbb::this_task_arena::max_concurrency();
    std::array<std::vector<std::uint32_t>, 2> halves;
    for (auto& half : halves) half.resize(bands.texels() * static_cast<std::size_t>(std::min(at_once, bands.count())));
    const auto place = [&](std::vector<std::uint32_t>& half, int band) {
        return half.data() + bands.texels() * static_cast<std::size_t>(band % at_once);
    };
    const auto make = [&](int first, std::vector<std::uint32_t>& half) {
        tbb::parallel_for(first, std::min(first + at_once, bands.count()),
                          [&](int band) { bands.make(band, place(half, band)); });
    };
    std::vector<std::uint32_t> coarsest;
    make(0, halves[0]);
    for (int first = 0; first < bands.count(); first += at_once, std::swap(halves[0], halves[1])) {
        tbb::task_group next;
        next.run([&] { make(first + at_once, halves[1]); });
        for (int band = first; band < std::min(first + at_once, bands.count()); ++band) {
            bands.hand_over(band, place(halves[0], band), take);
            if (painter.border() > 0) continue;
            if (band % bands.of_face() == 0) coarsest.clear();
            const std::uint32_t* row = bands.coarsest(place(halves[0], band));
            coarsest.insert(coarsest.end(), row, row + kCoarsest);
            if (coarsest.size() == kCoarsest * kCoarsest)
                hand_over_rest(band / bands.of_face(), bands.levels(), coarsest, take);
        }
        next.wait();
    }
}

}  // namespace nullscope
