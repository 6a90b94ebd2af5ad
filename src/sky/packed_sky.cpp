// Its loops are to be vectorised: see its compiler options in src/CMakeLists.txt.
#include "sky/packed_sky.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "image/half_float.h"
#include "sky/wide_lanes.h"

namespace nullscope {
namespace {

constexpr int kShift11 = 17, kShift10 = 18;  // bits of a float's mantissa that are rounded off
constexpr float kMost11 = 65024.0f, kMost10 = 64512.0f;

// A band is so many rows that it holds one row of the level of 16 texels.
constexpr int kCoarsest = 16, kCoarsestBordered = bordered_size(kBorderOf) * kCoarsest / kBorderOf;
constexpr int kPaintedAtOnce = 32;  // rows: the floats of a face of 2048 then fit a core's cache
constexpr int kBandsAThread = 2;    // painted while as many are handed over: 6 MB a thread at 2048

NULLSCOPE_WITHIN_LANES void pack(float red, float green, float blue, std::uint32_t& to) {
    to = small_float<kShift11>(red, kMost11) | small_float<kShift11>(green, kMost11) << 11 |
         small_float<kShift10>(blue, kMost10) << 22;
}

NULLSCOPE_WITHIN_LANES void pack(float red, float green, float blue, std::uint64_t& to) {
    constexpr std::uint64_t kOne = 0x3c00;
    to = half_bits(red) | std::uint64_t{half_bits(green)} << 16 | std::uint64_t{half_bits(blue)} << 32 | kOne << 48;
}

using Planes = std::array<std::vector<float>, 3>;

template <class Texel>
NULLSCOPE_WITHIN_LANES void pack_all(const Planes& planes, std::size_t count, float scale, Texel* out) {
    const float *red = planes[0].data(), *green = planes[1].data(), *blue = planes[2].data();
    for (std::size_t i = 0; i < count; ++i) pack(scale * red[i], scale * green[i], scale * blue[i], out[i]);
}

// Planes of width x rows; `out` of bytes, aligned for any texel.
NULLSCOPE_WIDE_LANES void pack_planes(const Planes& planes, std::size_t count, const SkyPacking& packing,
                                      std::byte* out) {
    const auto scale = static_cast<float>(packing.scale);
    if (packing.format == SkyFormat::kHalfFloats)
        pack_all(planes, count, scale, reinterpret_cast<std::uint64_t*>(out));
    else
        pack_all(planes, count, scale, reinterpret_cast<std::uint32_t*>(out));
}

// The mean of every 2 x 2 numbers: width/2 a row.
void halve(const float* from, int width, int rows, float* to) {
    for (int y = 0; y + 1 < rows; y += 2) {
        const float *upper = from + static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                    *lower = upper + width;
        for (int x = 0; x < width / 2; ++x)
            *to++ = 0.25f * (upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1]);
    }
}

std::size_t area(int width, int rows) { return static_cast<std::size_t>(width) * static_cast<std::size_t>(rows); }

void resize(Planes& planes, std::size_t count) {
    for (std::vector<float>& plane : planes) plane.resize(count);
}

// Rows of a face at every level, one after the other, that belong to one band.
class Bands {
public:
    Bands(const SkyPainter& painter, const SkyPacking& packing)
        : painter_(painter),
          packing_(packing),
          rows_(painter.face_size() / kCoarsest),
          width_(painter.face_size() + 2 * painter.border()),
          of_face_(width_ / rows_) {
        for (int level = 0; rows_ >> level > 0; ++level) {
            starts_.push_back(bytes_);
            bytes_ += texel_bytes(packing.format) * area(width_ >> level, rows_ >> level);
        }
        bytes_ = (bytes_ + alignof(std::uint64_t) - 1) / alignof(std::uint64_t) * alignof(std::uint64_t);
    }
    int count() const { return 6 * of_face_; }
    int of_face() const { return of_face_; }
    std::size_t bytes() const { return bytes_; }

    // coarsest: 3 x width numbers, the band's row of the coarsest level.
    void make(int band, std::byte* out, float* coarsest) {
        Scratch& scratch = scratch_.local();
        scratch.levels.resize(starts_.size());
        for (std::size_t level = 1; level < starts_.size(); ++level)
            resize(scratch.levels[level], area(width_ >> level, rows_ >> level));
        const int first = band % of_face_ * rows_ - painter_.border(), step = std::min(rows_, kPaintedAtOnce);
        const std::size_t texel = texel_bytes(packing_.format);
        for (int row = 0; row < rows_; row += step) {
            painter_.paint(band / of_face_, first + row, step, scratch.rows);
            pack_planes(scratch.rows.planes, area(width_, step), packing_, out + texel * area(width_, row));
            if (starts_.size() > 1)
                for (std::size_t c = 0; c < 3; ++c)
                    halve(scratch.rows.planes[c].data(), width_, step,
                          scratch.levels[1][c].data() + area(width_ / 2, row / 2));
        }
        for (std::size_t level = 1; level < starts_.size(); ++level) {
            const int width = width_ >> level, rows = rows_ >> level;
            const Planes& planes = scratch.levels[level];
            pack_planes(planes, area(width, rows), packing_, out + starts_[level]);
            for (std::size_t c = 0; level + 1 < starts_.size() && c < 3; ++c)
                halve(planes[c].data(), width, rows, scratch.levels[level + 1][c].data());
        }
        const Planes& last = starts_.size() > 1 ? scratch.levels.back() : scratch.rows.planes;
        for (const std::vector<float>& plane : last) coarsest = std::copy_n(plane.begin(), coarsest_width(), coarsest);
    }

    void hand_over(int band, const std::byte* texels, const std::function<void(const PackedRows&)>& take) const {
        for (std::size_t level = 0; level < starts_.size(); ++level) {
            const int rows = rows_ >> level;
            take({band / of_face_, static_cast<int>(level), band % of_face_ * rows, rows, width_ >> level,
                  texels + starts_[level]});
        }
    }
    int levels() const { return static_cast<int>(starts_.size()); }
    std::size_t coarsest_width() const { return static_cast<std::size_t>(width_ >> (levels() - 1)); }

private:
    struct Scratch {
        SkyRows rows;
        std::vector<Planes> levels;
    };
    const SkyPainter& painter_;
    const SkyPacking packing_;
    int rows_, width_, of_face_;
    std::vector<std::size_t> starts_;  // bytes
    std::size_t bytes_ = 0;
    tbb::enumerable_thread_specific<Scratch> scratch_;
};

// The mean of what lies under each of `count` x `count` equal parts of width x width numbers.
void shrink(const std::vector<float>& from, int width, int count, std::vector<float>& to) {
    const double step = static_cast<double>(width) / count;
    const auto share = [&](int part, int i) {  // of number i, in that part
        return std::max(0.0, std::min((part + 1) * step, i + 1.0) - std::max(part * step, i + 0.0)) / step;
    };
    std::fill_n(to.begin(), area(count, count), 0.0f);
    for (int y = 0; y < count * width; ++y)
        for (int x = 0; x < count * width; ++x)
            to[area(count, y / width) + static_cast<std::size_t>(x / width)] +=
                static_cast<float>(share(y / width, y % width) * share(x / width, x % width)) *
                from[area(width, y % width) + static_cast<std::size_t>(x % width)];
}

// The levels of less than a border, from the coarsest with one.
void hand_over_rest(int face, int level, Planes planes, const SkyPacking& packing,
                    const std::function<void(const PackedRows&)>& take) {
    Planes half;
    resize(half, planes[0].size());
    std::vector<std::uint64_t> texels(planes[0].size());
    auto* bytes = reinterpret_cast<std::byte*>(texels.data());
    for (int before = kCoarsestBordered, width = before / 2; width > 0; before = width, width /= 2) {
        for (std::size_t c = 0; c < 3; ++c) shrink(planes[c], before, width, half[c]);
        std::swap(planes, half);
        pack_planes(planes, area(width, width), packing, bytes);
        take({face, level++, 0, width, width, bytes});
    }
}

// Bands that are made together.
struct BandStore {
    BandStore(const Bands& bands, int most)
        : size(bands.bytes()),
          texels(size / sizeof(std::uint64_t) * static_cast<std::size_t>(most)),
          width(3 * bands.coarsest_width()),
          rows(width * static_cast<std::size_t>(most)) {}
    std::byte* of(int number) {
        return reinterpret_cast<std::byte*>(texels.data()) + size * static_cast<std::size_t>(number);
    }
    const std::byte* of(int number) const {
        return reinterpret_cast<const std::byte*>(texels.data()) + size * static_cast<std::size_t>(number);
    }
    float* coarsest(int number) { return rows.data() + width * static_cast<std::size_t>(number); }
    const float* coarsest(int number) const { return rows.data() + width * static_cast<std::size_t>(number); }

    std::size_t size;
    std::vector<std::uint64_t> texels;
    std::size_t width;
    std::vector<float> rows;
};

}  // namespace

std::uint32_t packed_light(float red, float green, float blue) {
    std::uint32_t texel = 0;
    pack(red, green, blue, texel);
    return texel;
}

std::uint64_t half_light(float red, float green, float blue) {
    std::uint64_t texel = 0;
    pack(red, green, blue, texel);
    return texel;
}

double packing_scale(SkyFormat format, double largest) {
    if (format == SkyFormat::kSmallFloats || !(largest > 0.0)) return 1.0;
    return std::exp2(std::floor(std::log2(kMostHalf / largest)));
}

struct SkyPacker::Work {
    Work(const SkyPainter& painter, const SkyPacking& how) : packing(how), bands(painter, how) { make(0, halves[0]); }

    void make(int from, BandStore& half) {
        tbb::parallel_for(from, std::min(from + at_once, bands.count()),
                          [&](int band) { bands.make(band, half.of(band % at_once), half.coarsest(band % at_once)); });
    }
    void hand_over(const BandStore& half, const TakeRows& take) {
        for (int band = first; band < std::min(first + at_once, bands.count()); ++band) {
            bands.hand_over(band, half.of(band % at_once), take);
            if (band % bands.of_face() == 0) coarsest = {};
            const float* row = half.coarsest(band % at_once);
            for (std::vector<float>& plane : coarsest)
                plane.insert(plane.end(), row, row + kCoarsestBordered), row += kCoarsestBordered;
            if (coarsest[0].size() == kCoarsestBordered * kCoarsestBordered)
                hand_over_rest(band / bands.of_face(), bands.levels(), coarsest, packing, take);
        }
    }

    SkyPacking packing;
    Bands bands;
    int at_once = kBandsAThread * tbb::this_task_arena::max_concurrency(), first = 0;  // bands
    std::array<BandStore, 2> halves{BandStore(bands, std::min(at_once, bands.count())),
                                    BandStore(bands, std::min(at_once, bands.count()))};
    Planes coarsest{};
};

SkyPacker::SkyPacker(const SkyPainter& painter, const SkyPacking& packing)
    : work_(std::make_unique<Work>(painter, packing)) {}
SkyPacker::~SkyPacker() = default;

bool SkyPacker::next(const TakeRows& take) {
    Work& work = *work_;
    tbb::task_group coming;
    coming.run([&work] { work.make(work.first + work.at_once, work.halves[1]); });
    work.hand_over(work.halves[0], take);
    coming.wait();
    std::swap(work.halves[0], work.halves[1]);
    work.first += work.at_once;
    return work.first < work.bands.count();
}

void pack_sky(const SkyPainter& painter, const SkyPacking& packing, const TakeRows& take) {
    SkyPacker packer(painter, packing);
    while (packer.next(take)) {
    }
}

}  // namespace nullscope
