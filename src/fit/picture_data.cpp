#include "fit/picture_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/text.h"
#include "fit/sigma_words.h"
#include "image/fits_input.h"
#include "image/image_file.h"
#include "image/luminance.h"

namespace nullscope::fit {
namespace {

bool is_fits(const std::string& file) {
    constexpr std::string_view kBegins = "SIMPLE  =";
    std::string head(kBegins.size(), '\0');
    std::ifstream(file, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
    return head == kBegins;
}

Error of_file(const std::string& file, const std::string& what, const std::string& allowed) {
    Error error = bad_input(what, allowed);
    error.file = without_controls(file);
    return error;
}

// Plane I of a FITS file, else luminance.
Result<Image<double>> load_light(const std::string& file) {
    Image<double> light;
    if (is_fits(file)) {
        TRY(fits, load_fits(file));
        const Image<double>& planes = fits->planes;
        light = Image<double>(planes.width, planes.height, 1);
        for (std::size_t i = 0; i < light.data.size(); ++i)
            light.data[i] = planes.data[i * static_cast<std::size_t>(planes.channels)];
    } else {
        TRY(image, load_image(file, static_cast<long long>(kMostData)));
        light = Image<double>(image->width, image->height, 1);
        for (std::size_t i = 0; i < light.data.size(); ++i)
            light.data[i] = luminance_of(&image->data[i * static_cast<std::size_t>(image->channels)]);
    }
    if (light.data.size() > kMostData)
        return of_file(file, fmt::format("{} x {} pixels", light.width, light.height),
                       fmt::format("at most {}", kMostData));
    return light;
}

Result<Image<double>> load_like(const std::string& file, const Image<double>& data) {
    TRY(light, load_light(file));
    if (light->width != data.width || light->height != data.height)
        return of_file(file, fmt::format("{} x {} pixels", light->width, light->height),
                       fmt::format("{} x {}, as the data", data.width, data.height));
    return light;
}

Result<Image<double>> load_sigma(const std::string& words, const Image<double>& data) {
    if (words.empty())
        return bad_input("a picture without its error", "--sigma NUMBER, NUMBER% of the brightest pixel, or a picture");
    double largest = 0;
    for (const double value : data.data)
        if (std::isfinite(value)) largest = std::max(largest, value);
    const auto number = sigma_of_words(words, largest);
    if (!number) return load_like(words, data);
    Image<double> sigma(data.width, data.height, 1);
    std::ranges::fill(sigma.data, *number);
    return sigma;
}

Status check_pixels(const PictureData& picture, const std::vector<bool>& counts, const PictureSources& sources) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!counts[i]) continue;
        const int x = static_cast<int>(i) % picture.light.width, y = static_cast<int>(i) / picture.light.width;
        if (!std::isfinite(picture.light.data[i]))
            return of_file(sources.data, fmt::format("pixel {}, {} is no finite number", x, y),
                           "numbers, or a --mask without this pixel");
        if (!(picture.sigma.data[i] > 0) || !std::isfinite(picture.sigma.data[i]))
            return bad_input(fmt::format("--sigma {}: {} at pixel {}, {}", without_controls(sources.sigma),
                                         picture.sigma.data[i], x, y),
                             "above 0, or a --mask without this pixel");
    }
    return Done{};
}

}  // namespace

std::size_t PictureData::count() const {
    return static_cast<std::size_t>(std::ranges::count_if(sigma.data, [](double s) { return s > 0; }));
}

Observed PictureData::observed(const std::string& name) const {
    Observed observed;
    for (std::size_t i = 0; i < light.data.size(); ++i)
        if (sigma.data[i] > 0) observed.value.push_back(light.data[i]), observed.sigma.push_back(sigma.data[i]);
    observed.what = fmt::format("{} of {}", counted(std::ssize(observed.value), "pixel"), name);
    return observed;
}

Result<PictureData> load_picture_data(const PictureSources& sources) {
    TRY(light, load_light(sources.data));
    TRY(sigma, load_sigma(sources.sigma, *light));
    std::vector<bool> counts(light->data.size(), true);
    if (!sources.mask.empty()) {
        TRY(mask, load_like(sources.mask, *light));
        for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = mask->data[i] > 0.5;
    }
    PictureData picture{std::move(*light), std::move(*sigma), is_fits(sources.data)};
    if (Status good = check_pixels(picture, counts, sources); !good) return good.error();
    for (std::size_t i = 0; i < counts.size(); ++i)
        if (!counts[i]) picture.sigma.data[i] = 0;
    if (picture.count() == 0) return of_file(sources.mask, "no pixel counts", "pixels above one half");
    return picture;
}

std::optional<PictureData> coarser(const PictureData& picture, int factor) {
    if (picture.light.width % factor != 0 || picture.light.height % factor != 0) return {};
    PictureData mean;
    mean.of_sky = picture.of_sky;
    mean.light = mean.sigma = Image<double>(picture.light.width / factor, picture.light.height / factor, 1);
    const double pixels = factor * factor;
    for (int y = 0; y < mean.light.height; ++y)
        for (int x = 0; x < mean.light.width; ++x) {
            double light = 0, variance = 0;
            bool counts = true;
            for (int row = 0; row < factor; ++row)
                for (int column = 0; column < factor; ++column) {
                    const int from_x = x * factor + column, from_y = y * factor + row;
                    const double sigma = *picture.sigma.at(from_x, from_y);
                    counts = counts && sigma > 0;
                    light += *picture.light.at(from_x, from_y), variance += sigma * sigma;
                }
            if (counts) *mean.light.at(x, y) = light / pixels, *mean.sigma.at(x, y) = std::sqrt(variance) / pixels;
        }
    if (2 * pixels * static_cast<double>(mean.count()) < static_cast<double>(picture.count())) return {};
    return mean;
}

}  // namespace nullscope::fit
