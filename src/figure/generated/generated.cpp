#include "plumb/figure/generated/generated.hpp"

#include <cstring>
#include <optional>
#include <string>

#include "plumb/figure/aabb/box_forms.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::figure::generated {

namespace {

std::vector<Point2> points2(std::span<const double> numbers) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.push_back({numbers[i], numbers[i + 1]});
  return points;
}

std::vector<Point3> points3(std::span<const double> numbers) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  }
  return points;
}

using degenerate::ShapeKind;

// A count stands before what it counts.
std::optional<std::size_t> count_at(std::span<const double> numbers, std::size_t at) {
  if (at >= numbers.size() || !(numbers[at] >= 0 && numbers[at] <= static_cast<double>(numbers.size()))) return {};
  const auto count = static_cast<std::size_t>(numbers[at]);
  return static_cast<double>(count) == numbers[at] ? std::optional(count) : std::nullopt;
}

/// Calls visit(numbers of the points) for each chain; whether the row is one of chains.
template <class Visit>
bool for_each_chain(std::span<const double> numbers, std::size_t dimension, const Visit& visit) {
  const auto chains = count_at(numbers, 0);
  std::size_t at = 1;
  for (std::size_t i = 0; chains && i < *chains; ++i) {
    const auto points = count_at(numbers, at);
    if (!points || numbers.size() - at - 1 < *points * dimension) return false;
    visit(numbers.subspan(at + 1, *points * dimension));
    at += 1 + *points * dimension;
  }
  return chains && *chains > 0 && at == numbers.size();
}

bool is_mesh(std::span<const double> numbers) {
  const auto vertices = count_at(numbers, 0);
  if (!vertices || numbers.size() < 1 + 3 * *vertices || numbers.size() % 3 != 1) return false;
  for (std::size_t i = 1 + 3 * *vertices; i < numbers.size(); ++i) {
    const auto corner = count_at(numbers, i);
    if (!corner || *corner >= *vertices) return false;
  }
  return true;
}

bool is_row_of(std::span<const double> numbers, ShapeKind kind, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  switch (kind) {
    case ShapeKind::holed_polygon:
      return for_each_chain(numbers, d, [](std::span<const double>) {});
    case ShapeKind::mesh:
      return is_mesh(numbers);
    case ShapeKind::halfspaces:
      return numbers.size() % (d + 1) == 0;
    case ShapeKind::polygon:
    case ShapeKind::points:
      return !numbers.empty() && numbers.size() % d == 0;
    default:
      return numbers.size() == degenerate::shape_size(kind, dimension);
  }
}

template <class Holed, class Points>
Holed holed(std::span<const double> numbers, std::size_t dimension, Points points) {
  Holed polygon;
  bool outer = true;
  for_each_chain(numbers, dimension, [&](std::span<const double> chain) {
    if (!outer) polygon.holes.emplace_back();
    (outer ? polygon.outer : polygon.holes.back()).vertices = points(chain);
    outer = false;
  });
  return polygon;
}

template <class Shape>
Shape halfspaces(std::span<const double> numbers, std::size_t dimension) {
  Shape shape;
  for (std::size_t i = 0; i < numbers.size(); i += dimension + 1) {
    std::memcpy(&shape.halfspaces.emplace_back(), &numbers[i], (dimension + 1) * sizeof(double));
  }
  return shape;
}

template <class Shape, class Directions>
Shape k_dop(std::span<const double> numbers, const Directions& directions) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(directions.size());
  return {directions, {numbers.begin(), middle}, {middle, numbers.end()}};
}

}  // namespace

void demand(std::span<const double> numbers, ShapeKind kind, int dimension) {
  if (is_row_of(numbers, kind, dimension)) return;
  std::string text = std::to_string(numbers.size()).append(" numbers are no ").append(degenerate::name_of(kind));
  text.append("; give ");
  const std::size_t size = degenerate::shape_size(kind, dimension);
  if (size != 0) {
    text.append(std::to_string(size));
  } else {
    text.append(degenerate::shape_kinds[static_cast<std::size_t>(kind)].layout);
  }
  throw InvalidShape(text);
}

template <>
AabbWidths3 made(std::span<const double> numbers) {
  return to_aabb_widths(shape_from<Aabb3>(numbers));
}
template <>
AabbCenter3 made(std::span<const double> numbers) {
  return to_aabb_center(shape_from<Aabb3>(numbers));
}
template <>
Polygon2 made(std::span<const double> numbers) {
  return {points2(numbers)};
}
template <>
Polygon3 made(std::span<const double> numbers) {
  return {points3(numbers)};
}
template <>
HoledPolygon2 made(std::span<const double> numbers) {
  return holed<HoledPolygon2>(numbers, 2, points2);
}
template <>
HoledPolygon3 made(std::span<const double> numbers) {
  return holed<HoledPolygon3>(numbers, 3, points3);
}
template <>
KDop2 made(std::span<const double> numbers) {
  return k_dop<KDop2>(numbers, k_dop_directions2(8));
}
template <>
KDop3 made(std::span<const double> numbers) {
  return k_dop<KDop3>(numbers, k_dop_directions(14));
}
template <>
HalfspaceIntersection2 made(std::span<const double> numbers) {
  return halfspaces<HalfspaceIntersection2>(numbers, 2);
}
template <>
HalfspaceIntersection3 made(std::span<const double> numbers) {
  return halfspaces<HalfspaceIntersection3>(numbers, 3);
}
template <>
ConvexPolyhedron3 made(std::span<const double> numbers) {
  const std::vector<Point3> points = points3(numbers);
  return convex_polyhedron(convex_hull(points), points);
}
template <>
TriangleMesh made(std::span<const double> numbers) {
  const auto end = 1 + 3 * static_cast<std::size_t>(numbers[0]);
  TriangleMesh mesh{points3(numbers.subspan(1, end - 1)), {}};
  for (std::size_t i = end; i < numbers.size(); i += 3) {
    TriangleMesh::Triangle& triangle = mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = static_cast<std::uint32_t>(numbers[i + k]);
  }
  return mesh;
}

}  // namespace plumb::figure::generated
