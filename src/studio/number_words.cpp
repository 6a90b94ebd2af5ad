#include "studio/number_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nullscope::viewer {
namespace {

constexpr double kRadiusOfSun_km = 2.95325008;  // r_s of one solar mass, 2 G M/c^2
constexpr double kLight_km_s = 299792.458;
constexpr double kMinute = 60.0, kHour = 3600.0;  // s

std::string with_decimal_sign(std::string words, const NumberStyle& style) {
    if (style.decimal_comma) std::ranges::replace(words, '.', ',');
    return words;
}

std::string with_unit(const std::string& number, const char* unit) { return number + ' ' + unit; }

}  // namespace

NumberStyle style_in(const Scene& scene, const Spacetime& spacetime, NumberStyle wish) {
    if (const auto mass = scene.object.mass()) wish.mass_suns = *mass;
    if (spacetime.by_proper_length()) wish.unit = LengthUnit::kOwn;
    return wish;
}

LengthScale length_scale(const NumberStyle& style) {
    switch (style.unit) {
        case LengthUnit::kSchwarzschildRadius: return {1.0, "r_s"};
        case LengthUnit::kMass: return {2.0, "M"};
        case LengthUnit::kKilometre: return {kRadiusOfSun_km * style.mass_suns, "km"};
        case LengthUnit::kOwn: break;
    }
    return {1.0, ""};
}

std::string count_words(long long number) {
    std::string text = fmt::format("{}", number);
    for (std::size_t at = text.size(); at > 3; at -= 3)
        text.insert(text.begin() + static_cast<std::ptrdiff_t>(at) - 3, ' ');
    return text;
}

std::string number_words(double value, const NumberStyle& style, int digits) {
    return std::isfinite(value) ? with_decimal_sign(fmt::format("{:.{}g}", value, digits), style) : "none";
}

std::string fixed_words(double value, const NumberStyle& style, int decimals) {
    return std::isfinite(value) ? with_decimal_sign(fmt::format("{:.{}f}", value, decimals), style) : "none";
}

std::string length_words(double length, const NumberStyle& style, int digits) {
    if (!std::isfinite(length)) return "none";
    const LengthScale scale = length_scale(style);
    const std::string number = number_words(scale.one * length, style, digits);
    return *scale.name != '\0' ? with_unit(number, scale.name) : number;
}

std::string time_words(double time, const NumberStyle& style, int digits) {
    if (!std::isfinite(time)) return "none";
    const auto number = [&](double units) { return with_decimal_sign(fmt::format("{:#.{}g}", units, digits), style); };
    switch (style.unit) {
        case LengthUnit::kSchwarzschildRadius: return with_unit(number(time), "r_s/c");
        case LengthUnit::kMass: return with_unit(number(2.0 * time), "M/c");
        case LengthUnit::kOwn: return number(time);
        case LengthUnit::kKilometre: break;
    }
    const double s = time * kRadiusOfSun_km * style.mass_suns / kLight_km_s, size = std::fabs(s);
    if (size < kMinute) return with_unit(number(s), "s");
    return size < kHour ? with_unit(number(s / kMinute), "min") : with_unit(number(s / kHour), "h");
}

}  // namespace nullscope::viewer
