#include "plumb/space/ray/open_winding.hpp"

#include <algorithm>
#include <tuple>

#include "arith/arc_tangent.hpp"
#include "plumb/space/ray/inside.hpp"
#include "query/ray/crossings.hpp"

namespace plumb {
namespace {

auto place_of(const Point3& p) { return std::tie(p.x, p.y, p.z); }

struct SeenVertex {
  Interval x, y, z, length;

  SeenVertex(const Point3& v, const Point3& p)
      : x(Interval(v.x) - Interval(p.x)),
        y(Interval(v.y) - Interval(p.y)),
        z(Interval(v.z) - Interval(p.z)),
        length(root(x * x + y * y + z * z)) {}
};

/// Straight ahead of the point along x, so that the strip from it, against x, leads through the point.
bool is_ahead(const Point3& v, const Point3& p) { return v.y == p.y && v.z == p.z && v.x > p.x; }

Interval size_of(Interval x) {
  if (x.lower >= 0) return x;
  if (x.upper <= 0) return {-x.upper, -x.lower};
  return {0, std::max(-x.lower, x.upper)};
}

/// Half of the solid angle of the triangle from the edge to the infinite against x, without its sign.
Interval half_angle_of_strip(const BorderEdge& edge, const Point3& p, Interval pi) {
  const SeenVertex a(edge.from, p), b(edge.to, p);
  // The point is moved in y by far more than in z, and sees such a vertex against y: the strip is all between two
  // meridians.
  if (is_ahead(edge.from, p)) return angle_of_vectors(Interval(0) - b.y, size_of(b.z), pi);
  if (is_ahead(edge.to, p)) return angle_of_vectors(Interval(0) - a.y, size_of(a.z), pi);
  const Interval volume = a.y * b.z - a.z * b.y;
  const Interval whole = a.length * b.length + a.x * b.x + a.y * b.y + a.z * b.z - a.x * b.length - b.x * a.length;
  return angle_of_vectors(whole, size_of(volume), pi);
}

}  // namespace

std::vector<BorderEdge> border_of(const Bvh& mesh, std::vector<BorderEdge> rows) {
  rows.clear();
  std::vector<bool> seen;
  std::vector<BorderEdge> edges;
  for (std::size_t slot = 0; slot < mesh.slots(); ++slot) {
    const std::size_t number = mesh.number(slot);
    if (number >= seen.size()) seen.resize(number + 1);
    if (seen[number]) continue;  // a triangle may be in several slots
    seen[number] = true;
    const auto& [a, b, c] = mesh.triangle(slot);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (place_of(from) < place_of(to)) edges.push_back({from, to, 1});
      if (place_of(to) < place_of(from)) edges.push_back({to, from, -1});
    }
  }
  const auto ends_of = [](const BorderEdge& e) { return std::tuple_cat(place_of(e.from), place_of(e.to)); };
  std::ranges::sort(edges, [&](const BorderEdge& a, const BorderEdge& b) { return ends_of(a) < ends_of(b); });
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    BorderEdge sum = edges[i];
    for (j = i + 1; j < edges.size() && ends_of(edges[j]) == ends_of(sum); ++j) sum.times += edges[j].times;
    if (sum.times < 0) sum = {sum.to, sum.from, -sum.times};
    if (sum.times != 0) rows.push_back(sum);
  }
  return rows;
}

std::optional<WindingInterval> generalized_winding_number(const Bvh& mesh, std::span<const BorderEdge> border,
                                                          const Point3& p) {
  const auto crossed = winding_number(mesh, p);
  if (!crossed) return {};
  Interval number(static_cast<double>(*crossed));
  if (border.empty()) return WindingInterval{number.lower, number.upper};
  const Interval pi = pi_between();
  Interval angles(0);
  for (const BorderEdge& edge : border) {
    const Sign way = query::moved_side(edge.from, edge.to, p);
    if (way == Sign::zero) continue;  // the edge is seen as one point, and its strip as nothing
    const Interval angle = half_angle_of_strip(edge, p, pi) * Interval(edge.times);
    angles = way == Sign::positive ? angles - angle : angles + angle;
  }
  number = number + quotient(angles, Interval(2) * pi);
  return WindingInterval{number.lower, number.upper};
}

}  // namespace plumb
