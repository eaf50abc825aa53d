// Which numbers is a figure made of?  Up to three of them within few bounds, and where they lie in space.
//
// A triangle is the image of two numbers that are not negative and whose sum is at most one, a box that of three
// between zero and one: origin + the sum of numbers times columns.  The relative interior is the image of those that
// are strictly within.
// Laws: exact over numbers that are; a column may be zero, and columns may depend on one another.
// Source: Rockafellar, Convex Analysis, 1970, theorem 6.6.
// Cost: some 10 to 40 operations.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "figure/k_dop/halfspace_slack.hpp"
#include "query/body/axis_body.hpp"

namespace plumb::query {

/// (origin + the sum of numbers times columns) / weight.
template <class T>
struct Image {
  arith::Vec<T> origin{T(0.0), T(0.0), T(0.0)};
  T weight{1.0};
  std::array<arith::Vec<T>, 3> columns{origin, origin, origin};
  std::size_t count = 3;    // of the columns
  bool moves_only = false;  // columns are the axes
  bool has_weight = false;  // other than one
};

/// Bounds of the numbers that a figure is the image of.
enum class Range : unsigned char { all, from_zero, from_zero_to_one, in_sum_to_one, to_either_side };

struct ImageNumbers {
  std::size_t count;
  Range range;
};

/// normal . x <= limit, both small integers.
using OwnRow = std::array<int, 4>;

inline std::vector<OwnRow> rows_of(const ImageNumbers& numbers) {
  std::vector<OwnRow> rows;
  OwnRow sum{0, 0, 0, 1};
  for (std::size_t k = 0; k < numbers.count && numbers.range != Range::all; ++k) {
    OwnRow up{0, 0, 0, 1}, down{0, 0, 0, numbers.range == Range::to_either_side ? 1 : 0};
    up[k] = sum[k] = 1;
    down[k] = -1;
    rows.push_back(down);
    if (numbers.range == Range::from_zero_to_one || numbers.range == Range::to_either_side) rows.push_back(up);
  }
  if (numbers.range == Range::in_sum_to_one) rows.push_back(sum);
  return rows;
}

template <class Shape>
constexpr ImageNumbers numbers_of() {
  switch (figure_kind<Shape>) {
    case FigureKind::line:
      return {1, Range::all};
    case FigureKind::ray:
      return {1, Range::from_zero};
    case FigureKind::segment:
      return {1, Range::from_zero_to_one};
    case FigureKind::plane:
    case FigureKind::three_point_plane:
      return {2, Range::all};
    case FigureKind::triangle:
      return {2, Range::in_sum_to_one};
    case FigureKind::tetrahedron:
      return {3, Range::in_sum_to_one};
    case FigureKind::aabb:
      return {3, Range::from_zero_to_one};
    case FigureKind::rectangle:
      return {2, Range::to_either_side};
    case FigureKind::obb:
      return {std::is_same_v<Shape, Obb2> ? 2u : 3u, Range::to_either_side};
    default:
      return {0, Range::all};
  }
}

template <class T, class Shape>
Image<T> image_of(const Shape& s) {
  constexpr FigureKind kind = figure_kind<Shape>;
  const auto at = [](const auto& p) { return arith::vec<T>(in_space(p)); };
  Image<T> image;
  image.count = numbers_of<Shape>().count;
  if constexpr (kind == FigureKind::point) {
    image.origin = at(s);
  } else if constexpr (kind == FigureKind::line || kind == FigureKind::ray) {
    if constexpr (kind == FigureKind::line) {
      image.origin = at(s.point);
    } else {
      image.origin = at(s.origin);
    }
    image.columns[0] = at(s.direction);
  } else if constexpr (kind == FigureKind::plane) {
    const arith::Vec<T> n = at(s.normal), zero = image.origin;
    const arith::Vec<T> unit =
        s.normal.x != 0 ? arith::Vec<T>{zero.x, T(1.0), zero.x} : arith::Vec<T>{T(1.0), zero.x, zero.x};
    image.origin = n * T(s.offset);
    image.weight = arith::dot(n, n);
    image.has_weight = true;
    image.columns[0] = arith::cross(n, unit);
    image.columns[1] = arith::cross(n, image.columns[0]);
  } else if constexpr (requires { s.a, s.b; }) {
    image.origin = at(s.a);
    image.columns[0] = at(s.b) - image.origin;
    if constexpr (requires { s.c; }) image.columns[1] = at(s.c) - image.origin;
    if constexpr (requires { s.d; }) image.columns[2] = at(s.d) - image.origin;
  } else if constexpr (kind == FigureKind::aabb) {
    image.origin = at(s.min);
    const arith::Vec<T> width = at(s.max) - image.origin;
    image.columns[0].x = width.x, image.columns[1].y = width.y, image.columns[2].z = width.z;
  } else if constexpr (requires { s.axes, s.half; }) {
    image.origin = at(s.center);
    const auto half = coordinates(s.half);
    for (std::size_t k = 0; k < half.size(); ++k) image.columns[k] = at(s.axes[k]) * T(half[k]);
  }
  return image;
}

/// The axes, from a point given.
template <class T>
Image<T> moved_to(const Point3& origin) {
  Image<T> image;
  image.origin = arith::vec<T>(origin);
  image.columns[0].x = image.columns[1].y = image.columns[2].z = T(1.0);
  image.moves_only = true;
  return image;
}
template <class T>
figure::SlackRow<T> row_of(const OwnRow& row) {
  const auto number = [&](std::size_t k) { return T(static_cast<double>(row[k])); };
  return {{number(0), number(1), number(2)}, number(3)};
}
/// Do all numbers in the range leave the side?
inline bool leave(const figure::SlackRow<Running>& row, const ImageNumbers& numbers) {
  if (numbers.range == Range::all || (numbers.range == Range::from_zero && row.normal[0].lower() < 0)) return false;
  double least = 0;
  Running sum = Running(0.0) - row.limit;
  for (std::size_t k = 0; k < numbers.count; ++k) {
    const double low = std::min(0.0, row.normal[k].lower()), high = std::max(0.0, row.normal[k].upper());
    if (numbers.range == Range::from_zero_to_one) sum = sum + Running(low);
    if (numbers.range == Range::to_either_side) sum = sum - Running(std::max(high, -low));
    if (numbers.range == Range::in_sum_to_one) least = std::min(least, low);
  }
  return (sum + Running(least)).lower() > 0;
}
}  // namespace plumb::query
