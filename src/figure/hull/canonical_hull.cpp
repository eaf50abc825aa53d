#include "figure/hull/canonical_hull.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>

#include "plumb/arith/error.hpp"

namespace plumb::figure {
namespace {

Point3 without_negative_zero(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

bool precedes(const Point3& a, const Point3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

}  // namespace

CanonicalHull::CanonicalHull(std::string_view function, const Hull3& given, std::span<const Point3> points) {
  const std::size_t n = given.vertices.size();
  for (const std::uint32_t v : given.vertices) {
    if (v >= points.size())
      throw InvalidShape(std::string(function).append(": the hull names a point beyond the last one given"));
  }
  std::vector<std::uint32_t> order(n), rank(n);
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return precedes(points[given.vertices[a]], points[given.vertices[b]]);
  });
  vertices.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    rank[order[i]] = i;
    vertices.push_back(without_negative_zero(points[given.vertices[order[i]]]));
  }
  hull.dimension = given.dimension;
  hull.vertices.resize(n);
  std::iota(hull.vertices.begin(), hull.vertices.end(), 0U);

  const auto renumbered = [&](std::uint32_t v) {
    return rank[static_cast<std::size_t>(std::ranges::lower_bound(given.vertices, v) - given.vertices.begin())];
  };
  std::vector<std::vector<std::uint32_t>> faces(given.face_count());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::uint32_t v : given.face(f)) faces[f].push_back(renumbered(v));
    std::rotate(faces[f].begin(), std::ranges::min_element(faces[f]), faces[f].end());  // Clang 14 has no subranges
  }
  std::ranges::sort(faces);
  for (const auto& face : faces) {
    hull.corners.insert(hull.corners.end(), face.begin(), face.end());
    hull.first.push_back(static_cast<std::uint32_t>(hull.corners.size()));
  }
}

}  // namespace plumb::figure
