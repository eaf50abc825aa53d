// What arrays of doubles does Python hand over?  NumPy's arrays, and whatever NumPy makes one of.
//
// Laws: (1) no number is rounded: float16, float32 and integers widen, and what is no double is refused.  (2) An array of
//       float64 is looked at where it lies, whatever its strides; nothing is copied that need not be.  (3) What is refused
//       is named: function, argument, shape, type, and what was expected.
// Source: NumPy's array interface.
// Cost: none for float64; a copy otherwise.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <string>
#include <string_view>

#include "plumb/arith/point.hpp"

namespace plumb::python {

namespace py = pybind11;

/// Whose argument it is, for what is told of it.
struct Asked {
  std::string_view function, argument;
};

/// Throws TypeError where these are no numbers, and ValueError where they are no doubles.
py::array numbers_of(const py::handle& given, const Asked& asked);

/// "shape (5, 2) and dtype float64"
std::string told(const py::array& array);
/// "(5, 2)", "(5,)"
std::string told(std::span<const py::ssize_t> shape);
/// "orient3d: b has shape (5, 2) and dtype float64; ...", as ValueError.
[[noreturn]] void refuse(const Asked& asked, const py::array& given, const std::string& expected);

/// Rows of so many numbers one after the other, shape (n, columns), finite; other layouts are copied.
py::array_t<double> rows_of(const py::handle& given, const Asked& asked, py::ssize_t columns);
/// Rows of two or of three numbers.
py::array_t<double> rows_of_plane_or_space(const py::handle& given, const Asked& asked);
/// Where the shape is (columns,) as well, which is one row: `single` says so.
py::array_t<double> row_or_rows_of(const py::handle& given, const Asked& asked, py::ssize_t columns, bool& single);

/// The rows as points.
template <class Point>
std::span<const Point> points_of(const py::array_t<double>& rows) {
  return {reinterpret_cast<const Point*>(rows.data()),
          static_cast<std::size_t>(rows.size()) * sizeof(double) / sizeof(Point)};
}

/// An array of these items, shape (n,) or (n, columns); one copy.
template <class Number, class Item>
py::array_t<Number> array_of(std::span<const Item> items) {
  constexpr auto columns = static_cast<py::ssize_t>(sizeof(Item) / sizeof(Number));
  const auto n = static_cast<py::ssize_t>(items.size());
  py::array_t<Number> out(columns == 1 ? std::vector<py::ssize_t>{n} : std::vector<py::ssize_t>{n, columns});
  std::copy_n(reinterpret_cast<const Number*>(items.data()), n * columns, out.mutable_data());
  return out;
}

}  // namespace plumb::python
