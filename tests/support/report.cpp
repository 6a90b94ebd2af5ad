#include "support/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <system_error>

#include "base/atomic_file.h"
#include "image/image_file.h"

namespace nullscope {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{0}</title><style>
body {{ font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 1200px; padding: 0 1rem; color: #222; background: #fff }}
figure {{ display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top }} img {{ max-width: 100%; image-rendering: pixelated }}
table {{ border-collapse: collapse; font: 12px/1.4 ui-monospace, monospace }} td, th {{ padding: 2px 8px; text-align: right; white-space: nowrap }}
tr.first td {{ border-top: 1px solid #999 }} .bad {{ color: #b00020; font-weight: 600 }} div.wide {{ overflow-x: auto }}
@media (prefers-color-scheme: dark) {{ body {{ color: #ddd; background: #181818 }} .bad {{ color: #ff8a80 }} }}
</style></head><body><h1>{0}</h1>
)";

const char* fate_name(Fate fate) {
    switch (fate) {
        case Fate::kEscaped: return "escaped";
        case Fate::kCaptured: return "captured";
        case Fate::kOtherSide: return "other side";
        case Fate::kNoSky: return "no sky";
        case Fate::kHit: return "hit";
    }
    return "unknown";
}

// The difference of two witnesses in px: as if the exact answer were off by as much. Where the exact ray ends elsewhere than
// theirs, its motion says nothing: a pixel counts as what it spans without lensing.
double step_px(const RayPixel& from, const RayPixel& to, ExactPixel exact) {
    if (!same_end(from, to)) return std::numeric_limits<double>::infinity();
    if (!same_end(from, exact.here)) {
        exact.here = from;
        exact.right_px = exact.down_px = 0;
    }
    RayPixel moved = exact.here;
    moved.sky = moved.sky + (to.sky - from.sky);
    moved.u += to.u - from.u;
    moved.v += to.v - from.v;
    moved.angle += to.angle - from.angle;
    if (from.g > 0) moved.g *= to.g / from.g;
    return pixel_errors(moved, exact).worst_px();
}

// PNG bytes by way of a file beside the report: base writes files only.
Result<std::string> png_bytes(const std::filesystem::path& beside, const Image<unsigned char>& image) {
    std::filesystem::path file = beside;
    file += ".png";
    if (Status saved = save_png(file, image); !saved) return saved.error();
    auto bytes = read_text(file, std::numeric_limits<int>::max());
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return bytes;
}

std::string witness_row(std::string_view name, const RayPixel& p, std::string_view front, std::string_view back) {
    return fmt::format(
        "<tr{}>{}<td>{}</td><td>{}</td><td>{:.8f} {:.8f} {:.8f}</td><td>{:.8g}</td><td>{:.8g}</td><td>{}</td>"
        "<td>{:.6f} {:.6f}</td>{}</tr>\n",
        front.empty() ? "" : " class=\"first\"", front, name, fate_name(p.fate), p.sky.x, p.sky.y, p.sky.z, p.g,
        p.angle, p.hit, p.u, p.v, back);
}

std::string pixel_rows(const ReportPixel& p) {
    const std::string front = fmt::format("<td rowspan=\"4\">{}, {}</td><td rowspan=\"4\" class=\"bad\">{:.4g}</td>",
                                          p.x, p.y, p.errors.worst_px());
    const std::string back = fmt::format(
        "<td rowspan=\"4\">{:.3g}</td><td rowspan=\"4\">{:.3g}</td><td rowspan=\"4\">{:.3g}</td>"
        "<td rowspan=\"4\" class=\"bad\">{}</td>",
        p.verdict.table_px, p.verdict.float_px, p.verdict.driver_px, p.verdict.culprit());
    return witness_row("reference", p.witnesses.reference, front, back) +
           witness_row("core64", p.witnesses.core64, "", "") + witness_row("core32", p.witnesses.core32, "", "") +
           witness_row("GL", p.witnesses.gl, "", "");
}

std::string pixel_table(const std::vector<ReportPixel>& pixels) {
    std::string html =
        "<h2>The worst pixels</h2><p>Column, row from the top left corner, and the largest error in px. Steps between "
        "witnesses: reference to core64 is the table's error, core64 to core32 that of single precision, core32 to GL "
        "the driver's.</p>\n<div class=\"wide\"><table><tr><th>pixel</th><th>error px</th><th>witness</th><th>fate</th>"
        "<th>sky</th><th>g</th><th>angle</th><th>hit</th><th>u, v</th><th>table px</th><th>float px</th>"
        "<th>driver px</th><th>largest</th></tr>\n";
    for (const ReportPixel& pixel : pixels) html += pixel_rows(pixel);
    return html + "</table></div>\n";
}

}  // namespace

const char* Verdict::culprit() const {
    if (driver_px >= table_px && driver_px >= float_px) return driver_px > 0 ? "driver" : "none";
    return float_px > table_px ? "float" : "table";
}

Verdict verdict_of(const Witnesses& w, const ExactPixel& exact) {
    return {step_px(w.reference, w.core64, exact), step_px(w.core64, w.core32, exact), step_px(w.core32, w.gl, exact)};
}

Status save_report(const std::filesystem::path& path, const FailureReport& report) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    std::string html = fmt::format(kHead, html_text(report.title));
    html += "<ul>\n";
    for (const std::string& reason : report.reasons)
        html += fmt::format("<li class=\"bad\">{}</li>\n", html_text(reason));
    html += "</ul>\n";
    for (const ReportPicture& picture : report.pictures) {
        TRY(bytes, png_bytes(path, picture.image));
        const std::string caption = html_text(picture.caption);
        html += fmt::format(
            "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
            caption, base64(*bytes));
    }
    if (!report.pixels.empty()) html += pixel_table(report.pixels);
    return write_text_atomically(path, html + "</body></html>\n");
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

std::string html_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            default: out += c;
        }
    }
    return out;
}

std::vector<PixelPlace> worst_pixels(const RayMeasures& measures, std::size_t most) {
    std::vector<std::size_t> order(measures.pixels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t count = std::min(most, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t a, std::size_t b) {
                          const float ea = measures.pixels[a].worst_px(), eb = measures.pixels[b].worst_px();
                          return ea != eb ? ea > eb : a < b;
                      });
    std::vector<PixelPlace> places;
    const auto width = static_cast<std::size_t>(measures.width);
    for (std::size_t i = 0; i < count; ++i)
        places.push_back({static_cast<int>(order[i] % width), static_cast<int>(order[i] / width) * measures.row_step});
    return places;
}

}  // namespace nullscope
