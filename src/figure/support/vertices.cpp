#include <algorithm>
#include <optional>
#include <unordered_set>

#include "figure/support/input.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

/// Which of two vertices lies farther, under the name of the question.
struct Farther2 : predicates::OrderAlongDirection2d {
  static constexpr std::string_view name = "support_point";
  static constexpr std::array<std::string_view, 3> argument_names{"vertex", "other vertex", "direction"};
};
struct Farther3 : predicates::OrderAlongDirection3d {
  static constexpr std::string_view name = "support_point";
  static constexpr std::array<std::string_view, 3> argument_names{"vertex", "other vertex", "direction"};
};

template <class Support, class Order, class Point, class Vector>
Support of_points(std::string_view part, std::span<const Point> points, const Vector& direction) {
  require_finite_parts("support_point", {"direction"}, direction);
  figure::require_finite_points("support_point", part, points);
  Support best{points[0], 0, true};
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    const Sign s = sign_of(Order{}, points[i], best.point, direction);
    if (s == Sign::positive) best = {points[i], i, true};
    if (s == Sign::zero && !(points[i] == best.point)) best.unique = false;
  }
  return best;
}

Support2 of(std::string_view part, std::span<const Point2> points, const Vector2& direction) {
  return of_points<Support2, Farther2>(part, points, direction);
}
Support3 of(std::string_view part, std::span<const Point3> points, const Vector3& direction) {
  return of_points<Support3, Farther3>(part, points, direction);
}

template <class Point>
void require_some(std::span<const Point> points) {
  if (points.empty()) throw InvalidShape("support_point: no points; give at least one");
}

template <class Polygon>
const Polygon& required(const Polygon& polygon) {
  if (polygon.vertices.size() < 3)
    throw InvalidShape("support_point: polygon has fewer than three vertices; give at least three");
  return polygon;
}

/// The vertices that can be reached from `start` over neighbors that lie as far along the direction, up to one that
/// has a neighbor which lies farther: that neighbor comes second.
struct Plateau {
  std::vector<std::uint32_t> ties;
  std::optional<std::uint32_t> higher;
};

Plateau plateau(const ConvexPolyhedron3& polyhedron, const Vector3& direction, std::uint32_t start) {
  const std::vector<Point3>& vertices = polyhedron.mesh.vertices;
  Plateau found{{start}, {}};
  std::unordered_set<std::uint32_t> seen;
  for (std::size_t next = 0; next < found.ties.size(); ++next) {
    for (const std::uint32_t v : polyhedron.neighbors_of(found.ties[next])) {
      const Sign s = sign_of(Farther3{}, vertices[v], vertices[start], direction);
      if (s == Sign::positive) {
        found.higher = v;
        return found;
      }
      if (s == Sign::zero && v != start && seen.insert(v).second) found.ties.push_back(v);
    }
  }
  return found;
}

}  // namespace

Support2 support_point(std::span<const Point2> points, const Vector2& direction) {
  require_some(points);
  return of("points", points, direction);
}
Support2 support_point(const Segment2& s, const Vector2& direction) {
  return of("segment", std::array{s.a, s.b}, direction);
}
Support2 support_point(const Triangle2& t, const Vector2& direction) {
  return of("triangle", std::array{t.a, t.b, t.c}, direction);
}
Support2 support_point(const Quadrilateral2& q, const Vector2& direction) {
  return of("quadrilateral", std::array{q.a, q.b, q.c, q.d}, direction);
}
Support2 support_point(const Polygon2& polygon, const Vector2& direction) {
  return of("polygon.vertices", required(polygon).vertices, direction);
}

Support3 support_point(std::span<const Point3> points, const Vector3& direction) {
  require_some(points);
  return of("points", points, direction);
}
Support3 support_point(const Segment3& s, const Vector3& direction) {
  return of("segment", std::array{s.a, s.b}, direction);
}
Support3 support_point(const Triangle3& t, const Vector3& direction) {
  return of("triangle", std::array{t.a, t.b, t.c}, direction);
}
Support3 support_point(const Quadrilateral3& q, const Vector3& direction) {
  return of("quadrilateral", std::array{q.a, q.b, q.c, q.d}, direction);
}
Support3 support_point(const Polygon3& polygon, const Vector3& direction) {
  return of("polygon.vertices", required(polygon).vertices, direction);
}
Support3 support_point(const Tetrahedron3& t, const Vector3& direction) {
  return of("tetrahedron", std::array{t.a, t.b, t.c, t.d}, direction);
}

Support3 support_point(const ConvexPolyhedron3& polyhedron, const Vector3& direction, std::uint32_t start) {
  const std::vector<Point3>& vertices = polyhedron.mesh.vertices;
  if (start >= vertices.size()) {
    throw InvalidShape(std::string("support_point: start is ")
                           .append(std::to_string(start))
                           .append("; the polyhedron has ")
                           .append(std::to_string(vertices.size()))
                           .append(" vertices"));
  }
  require_finite_parts("support_point", {"direction"}, direction);
  std::uint32_t at = start;
  while (true) {  // ends, for each vertex that it goes to is farther, exactly, than the one before
    // The farthest of the neighbors, where one lies farther; else over what ties.
    const std::uint32_t from = at;
    for (const std::uint32_t v : polyhedron.neighbors_of(from)) {
      if (sign_of(Farther3{}, vertices[v], vertices[at], direction) == Sign::positive) at = v;
    }
    if (at != from) continue;
    const Plateau level = plateau(polyhedron, direction, at);
    if (level.higher) {
      at = *level.higher;
      continue;
    }
    const std::uint32_t least = *std::ranges::min_element(level.ties);
    const auto equal = [&](std::uint32_t v) { return vertices[v] == vertices[least]; };
    return {vertices[least], least, std::ranges::all_of(level.ties, equal)};
  }
}

}  // namespace plumb
