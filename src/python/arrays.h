#pragma once

#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <inkedge/image.h>

#include "python/errors.h"

namespace inkedge::python {

inline py::array readOnly(py::array array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// An image as an array of its own memory: height x width, and x channels if there are several.
template <class Number>
py::array arrayOf(Image<Number> image) {
    std::vector<py::ssize_t> shape{image.size().height, image.size().width};
    if (image.channels() > 1) shape.push_back(image.channels());
    auto* const kept = new Image<Number>{std::move(image)};
    const py::capsule owner{kept, [](void* held) { delete static_cast<Image<Number>*>(held); }};
    return py::array_t<Number>{std::move(shape), kept->mutablePixels().data(), owner};
}

/// A matrix or a vector of GLM's, copied: rows x columns.
template <class Matrix>
py::array matrixOf(const Matrix& matrix) {
    constexpr auto size = static_cast<py::ssize_t>(Matrix::length());
    py::array_t<double> array{{size, size}};
    for (int row = 0; row < Matrix::length(); ++row)
        for (int column = 0; column < Matrix::length(); ++column) array.mutable_at(row, column) = matrix[column][row];
    return array;
}
template <class Vector>
py::array vectorOf(const Vector& vector) {
    py::array_t<double> array{static_cast<py::ssize_t>(Vector::length())};
    for (int i = 0; i < Vector::length(); ++i) array.mutable_at(i) = vector[i];
    return array;
}

}  // namespace inkedge::python
