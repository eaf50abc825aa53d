#include "query/overlap/polygon_apart.hpp"

#include <algorithm>
#include <vector>

#include "arith/running_error.hpp"
#include "query/body/boundary.hpp"

namespace plumb::query {
namespace {

using RunningVertices = std::vector<arith::Vec<Running>>;

/// Whose hull holds the figure; none for what goes on without end, or lies between halfspaces.
RunningVertices vertices_of(const FlatView& v) {
  RunningVertices all;
  with_shape(v, [&]<class Shape>(const Shape& s) {
    if constexpr (has_boundary<Shape>)
      for_each_corner<Running>(s, [&](const arith::Vec<Running>& p) { all.push_back(p); });
  });
  return all;
}

bool boxes_are_apart(const RunningVertices& a, const RunningVertices& b) {
  for (const auto part : {&arith::Vec<Running>::x, &arith::Vec<Running>::y, &arith::Vec<Running>::z}) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto range = [part](const RunningVertices& all) {
      std::array<double, 2> r{infinity, -infinity};
      for (const auto& v : all) r = {std::min(r[0], (v.*part).lower()), std::max(r[1], (v.*part).upper())};
      return r;
    };
    const auto p = range(a), q = range(b);
    if (p[1] < q[0] || q[1] < p[0]) return true;
  }
  return false;
}

bool is_beside_plane(const std::array<Point3, 3>& span, const RunningVertices& others) {
  const auto at = [&](std::size_t i) { return arith::vec<Running>(span[i]); };
  const auto normal = arith::cross(at(1) - at(0), at(2) - at(0));
  const auto side = [&](const arith::Vec<Running>& v) { return arith::dot(normal, v - at(0)).sign(); };
  const auto first = side(others[0]);
  if (!first.certain() || first.value() == Sign::zero) return false;
  return std::ranges::all_of(others, [&](const auto& v) {
    const auto s = side(v);
    return s.certain() && s.value() == first.value();
  });
}

/// Nothing is known of a vertex that is beyond all doubles.
bool are_finite(const RunningVertices& all) {
  double zero = 0;
  for (const auto& v : all) {
    for (const Running& x : {v.x, v.y, v.z}) zero += (x.upper() - x.upper()) + (x.lower() - x.lower());
  }
  return zero == 0;
}

}  // namespace

bool are_surely_apart(const FlatView& polygon, const SpanOfPolygon& span, const FlatView& other) {
  const RunningVertices others = vertices_of(other);
  if (others.empty() || !are_finite(others)) return false;
  return (span && polygon.dimension == 3 && is_beside_plane(*span, others)) ||
         boxes_are_apart(vertices_of(polygon), others);
}

}  // namespace plumb::query
