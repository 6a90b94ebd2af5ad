// The report of a failed comparison: one HTML file that holds everything, pictures included.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "compare/ray_metrics.h"
#include "image/image.h"
#include "scene/ray.h"

namespace nullscope {

// What each witness says of one pixel (docs/architecture.md): reference A, shader core in double B64 and in float B32, GL C.
struct Witnesses {
    RayPixel reference, core64, core32, gl;
};
// Which step between two witnesses is the largest: "table" (A to B64), "float" (B64 to B32) or "driver" (B32 to C).
struct Verdict {
    double table_px = 0, float_px = 0, driver_px = 0;  // infinite where the ends differ
    const char* culprit() const;
};
// Steps in px by the exact answer's motion per pixel; exact.here is the reference's.
Verdict verdict_of(const Witnesses& witnesses, const ExactPixel& exact);

struct ReportPixel {
    int x = 0, y = 0;
    PixelErrors errors;
    Witnesses witnesses;
    Verdict verdict;
};
struct ReportPicture {
    std::string caption;
    Image<unsigned char> image;
};
struct FailureReport {
    std::string title;
    std::vector<std::string> reasons;  // what failed, one sentence each
    std::vector<ReportPicture> pictures;
    std::vector<ReportPixel> pixels;  // worst first
};

// Folders that are missing are made.
Status save_report(const std::filesystem::path& path, const FailureReport& report);

std::string base64(std::string_view bytes);
std::string html_text(std::string_view text);

// The pixels with the largest worst_px(), worst first.
struct PixelPlace {
    int x, y;
};
std::vector<PixelPlace> worst_pixels(const RayMeasures& measures, std::size_t most);

}  // namespace nullscope
