// Warp meshes: which place of the projection's own picture each place of the screen shows. Rays go through the mesh, so nothing is resampled.
// Their files: scene/warp_file.h.
//
// A node has x, y: on the screen in half its heights from its middle, right and up, so that y goes from -1 to 1 and x from -aspect to
// aspect; parts of a mesh may lie beside the screen. u, v: in the projection's picture, from 0 at its left and lower side to 1.
// i: factor on the light (CameraSpec::warp_intensity); no cell is drawn that has a node of negative i.
//
// A cell has four nodes. Its middle is their mean in x, y, u, v and i, and each of the four triangles about the middle is linear: no
// diagonal is preferred, and along its sides a cell is as wide as its neighbour. Where cells overlap the last is seen.
//
// The projection's own picture is the one that the camera has without a mesh, as wide and high; of a fisheye the square about its
// circle, and of an equirectangular picture twice as wide as it is high. Places beyond it (u or v not in [0, 1]) are not drawn.
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"
#include "scene/warp_file.h"

namespace nullscope {

// Cells by place: the plane's bins, and of each the cells that may reach into it.
struct CellBins {
    double left = 0, bottom = 0, right = 0, top = 0;  // of all bins
    int columns = 1, rows = 1;
    std::vector<int> first;  // columns * rows + 1 places in `cells`, row by row from the lower left
    std::vector<int> cells;  // in growing order within a bin
    std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
};

// What is at a place of the screen.
struct WarpPlace {
    double u = 0, v = 0, light = 0;
    std::array<double, 4> slopes{};  // du/dx, du/dy, dv/dx, dv/dy
};

class WarpMesh {
public:
    // name: of the file, for messages. Errors: what is no mesh, with its line, and meshes of which too many cells overlap at one point.
    static Result<WarpMesh> parse(std::string_view text, const std::string& name, const WarpScreen& screen = {});
    // Of a picture of that many pixels, both even: u, v of each pixel's middle, row by row from the top, also beyond the projection's own picture.
    // Its pixels are points: their share is 0. Between their middles it says nothing.
    static WarpMesh of_pixels(const std::vector<std::array<double, 2>>& places, int width, int height);
    bool of_points() const { return of_points_; }
    bool of_screen() const { return of_screen_; }  // it is another one for another screen

    std::optional<WarpPlace> at(double x, double y) const;                    // nothing beside the mesh
    std::optional<std::array<double, 2>> place_of(double u, double v) const;  // x, y; of several the last cell's
    double least_area() const { return least_area_; }                         // du dv over dx dy, of all triangles

    const std::vector<WarpNode>& nodes() const { return nodes_; }
    const std::vector<std::array<int, 4>>& cells() const {
        return cells_;
    }                                                                  // that are drawn: numbers of nodes, going round
    const CellBins& bins() const { return bins_; }                     // by x, y
    const CellBins& picture_bins() const { return bins_of_picture_; }  // by u, v

private:
    Status find_bins();
    void find_least_area();
    std::vector<WarpNode> nodes_;
    std::vector<std::array<int, 4>> cells_;
    CellBins bins_, bins_of_picture_;
    int columns_ = 0, rows_ = 0;
    double least_area_ = 1e30;
    bool of_screen_ = false, of_points_ = false;
};

// Half the width and half the height of the projection's own picture, in half heights of the screen.
std::array<double, 2> input_half(const CameraSpec& camera);

// The mesh of a file, read once, and again when the file has changed. Thread-safe.
Result<std::shared_ptr<const WarpMesh>> load_warp_mesh(const std::filesystem::path& file,
                                                       const WarpScreen& screen = {});
Result<std::shared_ptr<const WarpMesh>> load_warp_mesh(const CameraSpec& camera);

// Of a camera with a mesh: what a place of its picture shows, px from the upper left corner. at: where the projection's own picture has
// that, px of a pixel's height from its middle, right and up. Nothing: the picture is dark there, or the mesh cannot be read.
struct WarpedPlace {
    std::array<double, 2> at{};
    double light = 1.0;
    double share = 1.0;  // of the width of a pixel there, the root of areas
};
std::optional<WarpedPlace> warped_place(const CameraSpec& camera, double x, double y);
// Where that is seen; at: as above.
std::optional<std::array<double, 2>> unwarped_place(const CameraSpec& camera, std::array<double, 2> at);
// The least share of the picture, but no less than kNarrowestShare; 1 without a mesh.
inline constexpr double kNarrowestShare = 0.1;
double smallest_warp_share(const CameraSpec& camera);
inline constexpr double kDisplayPower = 2.2;  // of a display's light over its values, WarpIntensity::kDisplay
// Factor on light: 1 without a mesh, 0 where the picture is dark.
double warp_light(const CameraSpec& camera, double x, double y);

}  // namespace nullscope
