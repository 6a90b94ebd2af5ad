#include "sky/panorama.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/large_image.h"
#include "sky/cube.h"
#include "sky/equirectangular.h"

namespace nullscope {
namespace {

constexpr double kPi = std::numbers::pi;
// A bilinear sample covers two pixels, so samples this far apart leave no gap between them.
constexpr double kPixelsPerSample = 1.5;

// Columns are periodic or clamped, rows clamped.
Vec3 bilinear(const Image<float>& image, double x, double y, bool periodic) {
    const double left = x + 0.5, above = y + 0.5;  // >= 0, so that a cast is floor
    const int fx = static_cast<int>(left) - 1, fy = static_cast<int>(above) - 1;
    const double tx = x - 0.5 - fx, ty = y - 0.5 - fy;
    const auto column = [&](int i) {
        if (periodic) return i < 0 ? i + image.width : i >= image.width ? i - image.width : i;
        return std::clamp(i, 0, image.width - 1);
    };
    const auto row = [&](int i) { return std::clamp(i, 0, image.height - 1); };
    const int x0 = column(fx), x1 = column(fx + 1);
    const int y0 = row(fy), y1 = row(fy + 1);
    const float *a = image.at(x0, y0), *b = image.at(x1, y0), *c = image.at(x0, y1), *d = image.at(x1, y1);
    const double wa = (1 - tx) * (1 - ty), wb = tx * (1 - ty), wc = (1 - tx) * ty, wd = tx * ty;
    return {wa * a[0] + wb * b[0] + wc * c[0] + wd * d[0], wa * a[1] + wb * b[1] + wc * c[1] + wd * d[1],
            wa * a[2] + wb * b[2] + wc * c[2] + wd * d[2]};
}

int samples_per_texel(double pixels_per_radian, int face_size) {
    return std::max(1, static_cast<int>(std::ceil(pixels_per_radian * 2.0 / face_size / kPixelsPerSample)));
}

// Images are read no larger than this: 4 columns a texel along the faces' equator, where 3.14 lie in the middle of a face and one at
// its edge is 2 times as fine; never less than 8192, so that only the largest are touched.
Result<Image<float>> load_for(int face_size, const ImageSource& source, std::vector<std::string>& notes) {
    const std::filesystem::path& path = source.file;
    constexpr int kLeastSide = 8192, kColumnsPerTexel = 4;
    const int side = std::max(kLeastSide, kColumnsPerTexel * face_size);
    TRY(fitted, load_fitted_image(path, {.max_side = side, .alpha = Alpha::kOnBlack, .layer = source.layer}));
    notes.insert(notes.end(), fitted->notes.begin(), fitted->notes.end());
    if (fitted->reduced())
        notes.push_back(reduction_words(path, *fitted, fmt::format("the sky's faces are of {} px", face_size)));
    return std::move(fitted->image);
}

// Seen from inside and upright, with the band's middle (azimuth 0) in front: the north cap joins above the band with
// azimuth 0 at its lower edge, the south cap below it with azimuth 0 at its upper edge; azimuth pi/2 is to the left in
// all three.
Vec3 sample_cap(const Image<float>& image, double side, double phi, double fraction) {
    const double radius = 0.5 * std::min(image.width, image.height);
    const double r = std::min(fraction * radius, radius - 0.5);  // the corners outside of the circle are not sky
    const double x = 0.5 * image.width - r * std::sin(phi);
    const double y = 0.5 * image.height + side * r * std::cos(phi);
    return bilinear(image, x, y, false);
}

// Pixels per radian: of a band to this latitude, of a cap from it.
double density_of(const ImageSize& size, double limit) {
    return std::max(size.width / (2.0 * kPi), size.height / (2.0 * limit));
}
double cap_density(const ImageSize& size, double limit) {
    return 0.5 * std::min(size.width, size.height) / (0.5 * kPi - limit);
}

}  // namespace

Result<double> panorama_density(const SkySpec& spec) {
    const bool caps = spec.mapping != SkyMapping::kEquirectangular;
    const double limit = caps ? spec.band_latitude : 0.5 * kPi;
    TRY(size, image_size(spec.image, spec.image_layer));
    double density = density_of(*size, limit);
    if (caps)
        for (const std::filesystem::path* file : {&spec.north_cap, &spec.south_cap}) {
            TRY(cap, image_size(*file, spec.image_layer));
            density = std::max(density, cap_density(*cap, limit));
        }
    return density;
}

Result<Panorama> Panorama::load(const SkySpec& spec, const Mat3& world_from_sky, int face_size) {
    Panorama made;
    made.mapping_ = spec.mapping;
    made.band_latitude_ = spec.band_latitude;
    made.sky_from_world_ = transposed(world_from_sky);
    const bool caps = spec.mapping != SkyMapping::kEquirectangular;
    const double limit = caps ? spec.band_latitude : 0.5 * kPi;
    if (caps && !(limit > 0.0 && limit < 0.5 * kPi))
        return bad_input(fmt::format("sky: band latitude {} is outside (0, pi/2)", limit));
    TRY(image, load_for(face_size, {spec.image, spec.image_layer}, made.notes_));
    made.image_ = std::move(*image);
    double density = density_of({made.image_.width, made.image_.height}, limit);
    if (caps)
        for (const auto& [file, cap] :
             {std::pair{&spec.north_cap, &made.north_}, std::pair{&spec.south_cap, &made.south_}}) {
            TRY(loaded, load_for(face_size, {*file, spec.image_layer}, made.notes_));
            *cap = std::move(*loaded);
            density = std::max(density, cap_density({cap->width, cap->height}, limit));
        }
    made.samples_ = samples_per_texel(density, face_size);
    made.brightness_ = spec.brightness;
    for (const Image<float>* part : {&made.image_, &made.north_, &made.south_})
        for (const float light : part->data) made.largest_ = std::max(made.largest_, spec.brightness * light);
    return made;
}

Vec3 Panorama::sample_band_and_caps(Vec3 d) const {
    const double phi = azimuth_of(d), beta = latitude_of(d), limit = band_latitude_, cap_angle = 0.5 * kPi - limit;
    if (beta > limit) return sample_cap(north_, 1.0, phi, (0.5 * kPi - beta) / cap_angle);
    if (beta < -limit) return sample_cap(south_, -1.0, phi, (0.5 * kPi + beta) / cap_angle);
    const double y = 0.5 * (1.0 - beta / limit) * image_.height;
    return bilinear(image_, (0.5 - phi / (2.0 * kPi)) * image_.width, y, true);
}

Vec3 Panorama::sample(Vec3 d) const {
    if (mapping_ != SkyMapping::kEquirectangular) return sample_band_and_caps(d);
    const PanoramaPosition p = equirectangular_position(image_.width, image_.height, d);
    return bilinear(image_, p.x, p.y, true);
}

void Panorama::paint(SkyRows& rows) const {
    const int n = samples_;
    const double step = 1.0 / (static_cast<double>(rows.size) * n), weight = brightness_ / (static_cast<double>(n) * n);
    for (int y = rows.first; y < rows.first + rows.count; ++y) {
        float *red = rows.row(0, y), *green = rows.row(1, y), *blue = rows.row(2, y);
        for (int x = -rows.border; x < rows.size + rows.border; ++x) {
            Vec3 sum{};
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    sum = sum + sample(sky_from_world_ *
                                       cube_direction(rows.face, (x * n + i + 0.5) * step, (y * n + j + 0.5) * step));
            *red++ = static_cast<float>(weight * sum.x);
            *green++ = static_cast<float>(weight * sum.y);
            *blue++ = static_cast<float>(weight * sum.z);
        }
    }
}

}  // namespace nullscope
