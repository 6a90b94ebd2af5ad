#include "compare/remembered_trace.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace nullscope {
namespace {

using Place = std::array<double, 2>;

class Rays {
public:
    explicit Rays(ExactTrace trace) : trace_(std::move(trace)) {}
    void put(const Place& place, const RayPixel& ray) { known_.emplace(place, ray); }
    std::vector<RayPixel> at(const std::vector<Place>& positions) {
        std::vector<Place> others;
        std::ranges::copy_if(positions, std::back_inserter(others),
                             [&](const Place& place) { return !known_.contains(place); });
        const std::vector<RayPixel> traced = others.empty() ? std::vector<RayPixel>() : trace_(others);
        for (std::size_t i = 0; i < others.size(); ++i) known_.emplace(others[i], traced[i]);
        std::vector<RayPixel> pixels;
        pixels.reserve(positions.size());
        for (const Place& place : positions) pixels.push_back(known_.at(place));
        return pixels;
    }

private:
    ExactTrace trace_;
    std::map<Place, RayPixel> known_;
};

// What errors are formed of (compare/ray_errors.cpp), as a difference to the pixel's own ray: a float of it says a motion to 1e-7. One that
// ends elsewhere is looked up.
struct Moved {
    enum class Kept : unsigned char { kNot, kHere, kLookedUp };
    std::array<float, 8> by{};
    Kept kept = Kept::kNot;
};
std::array<double*, 8> numbers_of(RayPixel& p) {
    return {&p.sky.x, &p.sky.y, &p.sky.z, &p.g, &p.angle, &p.u, &p.v, &p.w};
}

class FrameRays {
public:
    FrameRays(ExactTrace trace, int width, int height)
        : trace_(trace), others_(std::move(trace)), width_(width), height_(height) {
        const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        middles_.resize(count), is_known_.resize(count), right_.resize(count), below_.resize(count);
    }

    std::vector<RayPixel> at(const std::vector<Place>& positions) {
        trace_what_is_new(positions);
        std::vector<RayPixel> pixels(positions.size());
        std::vector<Place> others;
        std::vector<std::size_t> rows;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            if (const auto found = kept(positions[i])) {
                pixels[i] = *found;
                continue;
            }
            others.push_back(positions[i]);
            rows.push_back(i);
        }
        if (others.empty()) return pixels;
        const std::vector<RayPixel> traced = others_.at(others);
        for (std::size_t k = 0; k < rows.size(); ++k) pixels[rows[k]] = traced[k];
        return pixels;
    }

private:
    struct Ask {
        std::size_t pixel;
        std::vector<Moved>* moved;  // nullptr: through the middle
    };
    // Nothing: a ray that is not kept by pixel.
    std::optional<Ask> ask(const Place& place) {
        const double x = std::floor(place[0]), y = std::floor(place[1]);
        if (!(x >= 0 && x < width_ && y >= 0 && y < height_)) return std::nullopt;
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
        const bool in_column = place[0] == x + 0.5, in_row = place[1] == y + 0.5;
        if (in_column && in_row) return Ask{pixel, nullptr};
        if (in_row && place[0] == x + 0.5 + kDisplaced_px) return Ask{pixel, &right_};
        if (in_column && place[1] == y + 0.5 + kDisplaced_px) return Ask{pixel, &below_};
        return std::nullopt;
    }

    bool is_new(const Ask& asked) const {
        if (asked.moved == nullptr) return !is_known_[asked.pixel];
        return is_known_[asked.pixel] && (*asked.moved)[asked.pixel].kept == Moved::Kept::kNot;
    }

    void trace_what_is_new(const std::vector<Place>& positions) {
        std::vector<Place> fresh;
        std::vector<Ask> asks;
        for (const Place& place : positions) {
            const auto asked = ask(place);
            if (!asked || !is_new(*asked)) continue;
            fresh.push_back(place);
            asks.push_back(*asked);
        }
        if (fresh.empty()) return;
        std::vector<RayPixel> traced = trace_(fresh);
        for (std::size_t i = 0; i < fresh.size(); ++i) {
            RayPixel& middle = middles_[asks[i].pixel];
            if (asks[i].moved == nullptr) {
                middle = traced[i], is_known_[asks[i].pixel] = true;
                continue;
            }
            Moved& moved = (*asks[i].moved)[asks[i].pixel];
            if (same_end(middle, traced[i])) {
                moved.kept = Moved::Kept::kHere;
                const auto from = numbers_of(middle), to = numbers_of(traced[i]);
                for (std::size_t k = 0; k < from.size(); ++k) moved.by[k] = static_cast<float>(*to[k] - *from[k]);
            } else {
                moved.kept = Moved::Kept::kLookedUp;
                others_.put(fresh[i], traced[i]);
            }
        }
    }

    std::optional<RayPixel> kept(const Place& place) {
        const auto asked = ask(place);
        if (!asked || !is_known_[asked->pixel]) return std::nullopt;
        RayPixel pixel = middles_[asked->pixel];
        if (asked->moved == nullptr) return pixel;
        const Moved& moved = (*asked->moved)[asked->pixel];
        if (moved.kept != Moved::Kept::kHere) return std::nullopt;
        const auto numbers = numbers_of(pixel);
        for (std::size_t k = 0; k < numbers.size(); ++k) *numbers[k] += static_cast<double>(moved.by[k]);
        return pixel;
    }

    ExactTrace trace_;
    Rays others_;
    int width_, height_;
    std::vector<RayPixel> middles_;
    std::vector<bool> is_known_;
    std::vector<Moved> right_, below_;
};

}  // namespace

ExactTrace remembered(ExactTrace trace) {
    return [rays = std::make_shared<Rays>(std::move(trace))](const std::vector<Place>& positions) {
        return rays->at(positions);
    };
}

ExactTrace remembered(ExactTrace trace, int width, int height) {
    return [rays = std::make_shared<FrameRays>(std::move(trace), width, height)](const std::vector<Place>& positions) {
        return rays->at(positions);
    };
}

}  // namespace nullscope
