// Visibilities of pictures.
#include "telescope/visibility.h"

#include <fmt/format.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>

#include "base/assets.h"
#include "module/arrays.h"
#include "module/call.h"
#include "module/module.h"

namespace nullscope::python {
namespace {

using Planes = nb::ndarray<const double, nb::ndim<3>, nb::c_contig, nb::device::cpu>;
using Waves = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// planes: (height, width, 1 or 4), first row north, first column east. Shape of what it gives: (points, 4).
auto visibilities(const Planes& planes, double pixel, const Waves& u, const Waves& v, const std::string& shape) {
    const auto* found = std::ranges::find(kPixelShapes, shape);
    if (found == kPixelShapes.end())
        throw Refused(bad_key("pixel", fmt::format("'{}' is none of them", shape), "point, square, triangle"));
    if ((planes.shape(2) != 1 && planes.shape(2) != 4) || u.shape(0) != v.shape(0))
        throw Refused(bad_input("planes, u, v: arrays of other shapes", "(height, width, 1 or 4), and as many u as v"));
    SkyPicture picture{Image<double>(static_cast<int>(planes.shape(1)), static_cast<int>(planes.shape(0)),
                                     static_cast<int>(planes.shape(2))),
                       pixel};
    std::copy_n(planes.data(), planes.size(), picture.flux.data.begin());
    std::vector<Baseline> baselines;
    for (std::size_t i = 0; i < u.shape(0); ++i) baselines.push_back({u.data()[i], v.data()[i]});
    std::vector<std::complex<double>> values;
    {
        const nb::gil_scoped_release released;
        const PictureVisibility light(picture, static_cast<PixelShape>(found - kPixelShapes.begin()));
        for (const Visibility& visibility : light.at(baselines))
            values.insert(values.end(), visibility.begin(), visibility.end());
    }
    return array_of(std::move(values), {baselines.size(), 4});
}

}  // namespace

void add_telescope(nb::module_& m) {
    m.def(
        "assets", [] { return assets_directory().string(); }, "The folder of the files that ship.");
    m.def("visibilities", visibilities, nb::arg("planes"), nb::arg("pixel"), nb::arg("u"), nb::arg("v"),
          nb::arg("shape"), "Of planes (height, width, 1 or 4) with pixels of this many rad: shape (points, 4).");
}

}  // namespace nullscope::python
