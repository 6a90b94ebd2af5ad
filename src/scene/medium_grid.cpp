#include "scene/medium_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <span>

#include "base/file_cache.h"
#include "base/file_part.h"
#include "base/text.h"

namespace nullscope {
namespace {

constexpr std::size_t kLongestLine = 200, kBytes = sizeof(float) * MediumGrid::kNumbers;
constexpr std::size_t kLongestNote = 1100;
constexpr std::size_t kLargestFile = MediumGrid::kMostNodes * kBytes + 8 * kLongestLine + 2 * kLongestNote;
constexpr double kFarthest = 1e6;  // r_s

float number_at(const char* bytes) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(little_endian({bytes, sizeof(float)})));
}

// Of a node's numbers, in the order of the file.
struct NodeRange {
    const char* name;
    double least, most;
};
constexpr NodeRange kDensity{"density", 0, MediumGrid::kDensest},
    kTemperature{"temperature", 0, MediumGrid::kHottest_K},
    kField{"field", -MediumGrid::kStrongest_G, MediumGrid::kStrongest_G},
    kSpeed{"velocity", -MediumGrid::kFastest, MediumGrid::kFastest};
constexpr std::array<NodeRange, MediumGrid::kNumbers> kRanges = {kDensity, kTemperature, kField, kField,
                                                                 kField,   kSpeed,       kSpeed, kSpeed};

float logarithm(float value) {
    return static_cast<float>(std::log2(std::max(static_cast<double>(value), MediumGrid::kLeastDensity)));
}

// The numbers of a node; returns which of them is out of its range, or their count.
std::size_t read_node(const char* from, std::span<float> value) {
    for (std::size_t n = 0; n < value.size(); ++n) {
        value[n] = number_at(from + n * sizeof(float));
        // As floats: the limits are some of these.
        if (!(value[n] >= static_cast<float>(kRanges[n].least) && value[n] <= static_cast<float>(kRanges[n].most)))
            return n;
    }
    return value.size();
}

}  // namespace

class MediumGrid::Head {
public:
    Head(std::string_view bytes, std::string_view name) : rest_(bytes), name_(name) {}

    Error wrong(std::string what, std::string allowed) const {
        Error error = bad_input(std::move(what), std::move(allowed));
        error.file = name_, error.line = line_;
        return error;
    }
    // The words of the next line after its first one, which must be `key`.
    Result<std::vector<std::string>> words(std::string_view key, std::size_t count, const char* form) {
        ++line_;
        const std::size_t end = rest_.substr(0, kLongestLine).find('\n');
        if (end == std::string_view::npos) return wrong(fmt::format("the line \"{}\" is missing", key), form);
        std::vector<std::string> words;
        for (std::string& word : split(trim(rest_.substr(0, end)), ' '))
            if (!word.empty()) words.push_back(std::move(word));
        rest_.remove_prefix(end + 1);
        if (words.empty() || words.front() != key || words.size() != count + 1)
            return wrong(fmt::format("the line \"{}\" is expected here", key), form);
        words.erase(words.begin());
        return words;
    }
    // What follows `key` in the next line, if it is that line.
    Result<std::string> note(std::string_view key) {
        if (!rest_.starts_with(key) || rest_.substr(key.size(), 1) != " ") return std::string();
        ++line_;
        const std::size_t end = rest_.substr(0, kLongestNote).find('\n');
        if (end == std::string_view::npos)
            return wrong(fmt::format("the line \"{}\" is too long", key),
                         fmt::format("at most {} bytes", kLongestNote));
        std::string text = without_controls(trim(rest_.substr(key.size(), end - key.size())));
        rest_.remove_prefix(end + 1);
        return text;
    }
    Result<double> number(const std::string& word, const char* what, double least, double most) const {
        const auto value = parse_number(word);
        if (!value || !(*value >= least && *value <= most))
            return wrong(fmt::format("{} = {} is out of range", what, without_controls(word.substr(0, 40))),
                         fmt::format("[{}, {}]", least, most));
        return *value;
    }
    Result<int> count(const std::string& word, const char* what, int least, int most) const {
        TRY(value, number(word, what, least, most));
        if (*value != std::floor(*value))
            return wrong(fmt::format("{} = {} is not whole", what, word), fmt::format("[{}, {}]", least, most));
        return static_cast<int>(*value);
    }
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_, name_;
    int line_ = 0;
};

Status MediumGrid::read_head(Head& head) {
    TRY(version, head.words("nullscope-medium", 1, "nullscope-medium 1"));
    if (version->front() != "1") return head.wrong("another version of the format", "nullscope-medium 1");
    constexpr const char* kSystems = "coordinates kerr-schild, or coordinates boyer-lindquist";
    TRY(system, head.words("coordinates", 1, kSystems));
    kerr_schild_ = system->front() == "kerr-schild";
    if (!kerr_schild_ && system->front() != "boyer-lindquist") return head.wrong("other coordinates", kSystems);
    TRY(spin, head.words("spin", 1, "spin A"));
    TRY(a, head.number(spin->front(), "spin", -1, 1));
    spin_ = *a;

    TRY(rings, head.words("r", 3, "r FIRST LAST COUNT"));
    TRY(nearest, head.number((*rings)[0], "first r", 1e-3, kFarthest));
    TRY(farthest, head.number((*rings)[1], "last r", 1.001 * *nearest, kFarthest));
    TRY(ring_count, head.count((*rings)[2], "nodes of r", 2, kMostRings));
    rings_ = {std::log(*nearest), std::log(*farthest / *nearest) / (*ring_count - 1), *ring_count};
    TRY(polar, head.words("theta", 3, "theta FIRST LAST COUNT"));
    TRY(north, head.number((*polar)[0], "first theta", 0, 3.1));
    TRY(south, head.number((*polar)[1], "last theta", *north + 1e-3, std::numbers::pi + 1e-6));
    TRY(polar_count, head.count((*polar)[2], "nodes of theta", 2, kMostSide));
    polar_ = {*north, (*south - *north) / (*polar_count - 1), *polar_count};
    TRY(around, head.words("phi", 2, "phi FIRST COUNT"));
    TRY(first, head.number((*around)[0], "first phi", -2 * std::numbers::pi, 2 * std::numbers::pi));
    TRY(around_count, head.count((*around)[1], "nodes of phi", 1, kMostAround));
    around_ = {*first, 2 * std::numbers::pi / *around_count, *around_count};
    TRY(converter, head.note("converter"));
    TRY(source, head.note("source"));
    converter_ = *converter, source_ = *source;
    TRY(data, head.words("data", 0, "data"));
    if (nodes() > kMostNodes)
        return head.wrong(fmt::format("{} nodes", nodes()), fmt::format("at most {}", kMostNodes));
    return Done{};
}

Result<MediumGrid> MediumGrid::parse_head(std::string_view bytes, const std::string& name, std::size_t file_size) {
    Head head(bytes, name);
    MediumGrid grid;
    TRY(read, grid.read_head(head));
    const std::size_t before = bytes.size() - head.rest().size();
    if (Status whole = grid.check_size(head, file_size - std::min(before, file_size)); !whole) return whole.error();
    return grid;
}

Status MediumGrid::read_ring(std::size_t i, const char* from, const Head& head) {
    const auto r = static_cast<std::size_t>(rings_.count), t = static_cast<std::size_t>(polar_.count),
               p = static_cast<std::size_t>(around_.count);
    const auto fall_here = static_cast<float>(fall(std::exp(rings_.first + rings_.step * static_cast<double>(i))));
    for (std::size_t j = 0; j < t; ++j)
        for (std::size_t k = 0; k < p; ++k, from += kBytes) {
            std::array<float, kNumbers> value{};
            if (const std::size_t n = read_node(from, value); n < kNumbers)
                return head.wrong(fmt::format("{} of node ({}, {}, {}) is {}", kRanges[n].name, i, j, k, value[n]),
                                  fmt::format("[{}, {}]", kRanges[n].least, kRanges[n].most));
            const std::array<float, kNumbers> kept = {logarithm(value[0]),
                                                      value[5] * fall_here,
                                                      value[6],
                                                      value[7],
                                                      logarithm(value[1]),
                                                      value[2],
                                                      value[3],
                                                      value[4]};
            std::ranges::copy(kept, numbers_.begin() + static_cast<std::ptrdiff_t>(((k * t + j) * r + i) * kNumbers));
        }
    return Done{};
}

Status MediumGrid::check_size(const Head& head, std::size_t follow) const {
    if (follow == bytes()) return Done{};
    return head.wrong(fmt::format("{} bytes follow", follow), fmt::format("{} of {} nodes", bytes(), nodes()));
}

Result<MediumGrid> MediumGrid::parse(std::string_view bytes, const std::string& name) {
    Head head(bytes, name);
    MediumGrid grid;
    TRY(read, grid.read_head(head));
    const std::string_view rest = head.rest();
    if (Status whole = grid.check_size(head, rest.size()); !whole) return whole.error();
    grid.numbers_.resize(grid.nodes() * kNumbers);
    const std::size_t ring = grid.bytes() / static_cast<std::size_t>(grid.rings_.count);
    for (std::size_t i = 0; i * ring < rest.size(); ++i)
        if (Status good = grid.read_ring(i, rest.data() + i * ring, head); !good) return good.error();
    return grid;
}

Result<MediumGrid> MediumGrid::read(const std::filesystem::path& file) {
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(file, none);
    if (none) return failed(fmt::format("cannot read {}: {}", file.string(), none.message()));
    const std::string name = file.string(), first = file_part(file, kMostHead, FileEnd::kFirst);
    Head head(first, name);
    MediumGrid grid;
    TRY(heading, grid.read_head(head));
    const std::size_t before = first.size() - head.rest().size();
    if (Status whole = grid.check_size(head, static_cast<std::size_t>(size) - std::min<std::size_t>(before, size));
        !whole)
        return whole.error();
    grid.numbers_.resize(grid.nodes() * kNumbers);
    std::string ring(grid.bytes() / static_cast<std::size_t>(grid.rings_.count), '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(before));
    for (std::size_t i = 0; i < static_cast<std::size_t>(grid.rings_.count); ++i) {
        if (!stream.read(ring.data(), static_cast<std::streamsize>(ring.size())))
            return failed(fmt::format("cannot read {}", name));
        if (Status good = grid.read_ring(i, ring.data(), head); !good) return good.error();
    }
    return grid;
}

double MediumGrid::horizon() const { return 0.5 + 0.5 * std::sqrt((1 - spin_) * (1 + spin_)); }

double MediumGrid::fall(double r) const { return std::sqrt(std::max(1 - horizon() / r, kLeastFall)); }

double MediumGrid::nearest() const { return std::exp(rings_.first); }

double MediumGrid::farthest() const { return std::exp(rings_.first + rings_.step * (rings_.count - 1)); }

std::size_t MediumGrid::nodes() const {
    return static_cast<std::size_t>(rings_.count) * static_cast<std::size_t>(polar_.count) *
           static_cast<std::size_t>(around_.count);
}

MediumGrid MediumGrid::without_numbers() const {
    MediumGrid grid;
    grid.kerr_schild_ = kerr_schild_, grid.spin_ = spin_, grid.converter_ = converter_, grid.source_ = source_;
    grid.rings_ = rings_, grid.polar_ = polar_, grid.around_ = around_;
    return grid;
}

MediumGrid MediumGrid::between(const MediumGrid& a, const MediumGrid& b, double part) {
    MediumGrid grid = a.without_numbers();
    grid.numbers_.resize(a.numbers_.size());
    std::ranges::transform(a.numbers_, b.numbers_, grid.numbers_.begin(), [part](float x, float y) {
        return static_cast<float>(static_cast<double>(x) + part * (static_cast<double>(y) - static_cast<double>(x)));
    });
    return grid;
}

const char* MediumGrid::other_nodes(const MediumGrid& than) const {
    constexpr double kSame = 1e-9;
    const auto same = [](const Axis& a, const Axis& b) {
        return a.count == b.count && std::abs(a.first - b.first) <= kSame &&
               std::abs(a.step - b.step) * a.count <= kSame;
    };
    if (kerr_schild_ != than.kerr_schild_) return "coordinates";
    if (std::abs(spin_ - than.spin_) > kSame) return "spin";
    if (!same(rings_, than.rings_)) return "nodes of r";
    if (!same(polar_, than.polar_)) return "nodes of theta";
    return same(around_, than.around_) ? nullptr : "nodes of phi";
}

const float* MediumGrid::node(int ring, int polar, int around) const {
    const auto at =
        (static_cast<std::size_t>(around) * static_cast<std::size_t>(polar_.count) + static_cast<std::size_t>(polar)) *
            static_cast<std::size_t>(rings_.count) +
        static_cast<std::size_t>(ring);
    return numbers_.data() + at * kNumbers;
}

Result<std::shared_ptr<const MediumGrid>> load_medium_grid(const std::filesystem::path& file) {
    static FileCache<MediumGrid> loaded(2, kLargestFile);
    return loaded.get(file, MediumGrid::parse);
}

}  // namespace nullscope
