#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace anisoquad {

/// How many scalars of which type one element of a vector holds, and so one row of the array made of it.
template <class Element>
struct RowOf {
    using Scalar = Element;
    static constexpr std::size_t width = 1;
};
template <>
struct RowOf<Eigen::Vector3d> {
    using Scalar = double;
    static constexpr std::size_t width = 3;
};
template <std::size_t Width>
struct RowOf<std::array<std::int32_t, Width>> {
    using Scalar = std::int32_t;
    static constexpr std::size_t width = Width;
};

/// Hands a vector over to numpy, without a copy: shape (n,) for scalars, (n, width) for rows.
template <class Element>
pybind11::array to_array(std::vector<Element>&& values) {
    using Row = RowOf<Element>;
    static_assert(sizeof(Element) == Row::width * sizeof(typename Row::Scalar));
    auto owned = std::make_unique<std::vector<Element>>(std::move(values));
    const auto* data = reinterpret_cast<const typename Row::Scalar*>(owned->data());
    std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(owned->size())};
    if constexpr (Row::width > 1) shape.push_back(static_cast<pybind11::ssize_t>(Row::width));
    pybind11::capsule owner(owned.get(), [](void* p) { delete static_cast<std::vector<Element>*>(p); });
    owned.release();
    return pybind11::array_t<typename Row::Scalar>(shape, data, owner);
}

/// The rows of an array of points. @throws std::invalid_argument unless its shape is (N, 3)
template <int Flags>
std::span<const Eigen::Vector3d> point_span(const pybind11::array_t<double, Flags>& points) {
    if (points.ndim() != 2 || points.shape(1) != 3) throw std::invalid_argument("points must have shape (N, 3)");
    return {reinterpret_cast<const Eigen::Vector3d*>(points.data()), static_cast<std::size_t>(points.shape(0))};
}

/// The rows of an array of triangles. @throws std::invalid_argument unless its shape is (M, 3)
template <int Flags>
std::span<const std::array<std::int32_t, 3>> triangle_span(const pybind11::array_t<std::int32_t, Flags>& triangles) {
    if (triangles.ndim() != 2 || triangles.shape(1) != 3) throw std::invalid_argument("triangles must have shape (M, 3)");
    return {reinterpret_cast<const std::array<std::int32_t, 3>*>(triangles.data()), static_cast<std::size_t>(triangles.shape(0))};
}

}  // namespace anisoquad
