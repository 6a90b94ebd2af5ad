#include "sky/star_catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "base/atomic_file.h"
#include "base/text.h"
#include "light/black_body.h"

namespace nullscope {
namespace {

using namespace std::string_view_literals;
constexpr std::string_view kMagic = "NSSTARS\0"sv;
constexpr std::size_t kHeaderBytes = 16, kStarBytes = 8;
constexpr std::uint64_t kVersion = 1;
constexpr std::size_t kMaxBytes = 64u << 20;  // a hostile file's limit: 8 million stars

constexpr double kAverageColour = 0.65;           // the Sun's, for stars without a measured B-V
constexpr double kBluest = -0.4, kReddest = 2.0;  // range in which Ballesteros' formula is meant

Star decode(std::uint64_t record) {
    const auto field = [&](int from, int bits) {
        return static_cast<double>(record >> from & ((std::uint64_t{1} << bits) - 1));
    };
    const double ra = field(0, 22) / (1 << 22) * 2.0 * std::numbers::pi;
    const double dec = (field(22, 21) / ((1 << 21) - 1) - 0.5) * std::numbers::pi;
    return {{std::cos(dec) * std::cos(ra), std::cos(dec) * std::sin(ra), std::sin(dec)},
            field(43, 11) * 0.01 - 2.0,
            static_cast<unsigned>(record >> 54)};
}

}  // namespace

Result<std::vector<Star>> load_stars(const std::filesystem::path& file) {
    const Result<std::string> read = read_text(file, kMaxBytes);
    if (!read) return failed(fmt::format("star catalogue: {}", read.error().message()));
    const std::string_view bytes = *read;
    const auto broken = [&] { return failed(fmt::format("star catalogue: '{}' is damaged", file.string())); };
    if (bytes.size() < kHeaderBytes || !bytes.starts_with(kMagic)) return broken();
    const std::uint64_t count = little_endian(bytes.substr(12, 4));
    if (little_endian(bytes.substr(8, 4)) != kVersion || bytes.size() != kHeaderBytes + count * kStarBytes)
        return broken();
    std::vector<Star> stars;
    stars.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i)
        stars.push_back(decode(little_endian(bytes.substr(kHeaderBytes + i * kStarBytes, kStarBytes))));
    return stars;
}

Result<std::vector<Star>> load_stars(StarCatalogue catalogue, const std::filesystem::path& assets) {
    if (catalogue == StarCatalogue::kHipparcos) return load_stars(assets / "sky" / "stars.bin");
    const std::filesystem::path file = assets / "sky" / "stars-tycho-2.bin";
    std::error_code error;
    if (!std::filesystem::exists(file, error))
        return bad_input(fmt::format("sky.catalogue: the stars of Tycho-2 are not there ({})", file.string()),
                         "\"hipparcos\", or scripts/fetch_stars.py first");
    return load_stars(file);
}

double b_minus_v(int code) { return code == kColourCodes - 1 ? kAverageColour : 0.01 * code - 0.5; }

double star_temperature(double colour_index) {
    const double bv = std::clamp(colour_index, kBluest, kReddest);
    return 4600.0 * (1.0 / (0.92 * bv + 1.7) + 1.0 / (0.92 * bv + 0.62));
}

Vec3 star_colour(double colour_index) {
    const Vec3 xyz = black_body_xyz(star_temperature(colour_index));
    return into_gamut(rec709_from_xyz(xyz / xyz.y));
}

}  // namespace nullscope
