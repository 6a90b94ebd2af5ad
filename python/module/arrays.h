// NumPy arrays that C++ has made.
#pragma once
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <initializer_list>
#include <vector>

#include "spacetime/spacetime.h"

namespace nullscope::python {

namespace nb = nanobind;

// Takes the values over, without a copy.
template <class T>
nb::ndarray<nb::numpy, T> array_of(std::vector<T> values, std::initializer_list<std::size_t> shape) {
    auto* owned = new std::vector<T>(std::move(values));
    const nb::capsule owner(owned, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
    return nb::ndarray<nb::numpy, T>(owned->data(), shape, owner);
}

inline nb::ndarray<nb::numpy, double> array_of(const Matrix4& matrix) {
    std::vector<double> values;
    for (const auto& row : matrix) values.insert(values.end(), row.begin(), row.end());
    return array_of(std::move(values), {4, 4});
}

}  // namespace nullscope::python
