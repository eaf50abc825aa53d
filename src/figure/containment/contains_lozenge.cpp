// Lozenges: how far is a point from a parallelogram whose far corners need not be doubles?  The nearest point is in the
// interior, where the point projects into the parallelogram, or else on one of the four edges; the distance is the
// least of those to the edges and, where it projects, to the plane.  With parallel edges the parallelogram is the union
// of its edges, which go around from the corner to the opposite one and back.
#include "figure/containment/contains_input.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb {
namespace figure::containment {
namespace {

using predicates::argument, predicates::cross, predicates::difference, predicates::dot;

/// From the corner moved by two vectors, arguments 2 and 3, to p.
template <class T, std::size_t N>
[[gnu::always_inline]] constexpr auto way(const std::array<T, N>& x) {
  return difference(x, 0, 1) - (argument(x, 2) + argument(x, 3));
}

/// (corner, p, move, move, d): is p ahead along d?
struct Ahead {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& x) const {
    return dot(way(x), argument(x, 4));
  }
};

/// (corner, p, move, move, radius): from a point.
struct BeyondBall {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 13>& x) const {
    const auto w = way(x);
    return dot(w, w) - x[12] * x[12];
  }
};

/// (corner, p, move, move, d, radius): from a line of direction d.
struct BeyondRod {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 16>& x) const {
    const auto d = argument(x, 4);
    const auto across = cross(way(x), d);
    return dot(across, across) - dot(d, d) * (x[15] * x[15]);
  }
};

/// (corner, p, u, v, radius): from the plane.
struct BeyondPlate {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 13>& x) const {
    const auto normal = cross(argument(x, 2), argument(x, 3));
    const auto along = dot(difference(x, 0, 1), normal);
    return along * along - dot(normal, normal) * (x[12] * x[12]);
  }
};

/// (corner, p, move, move, u, v): the share of u in the way to p, seen along the normal of u and v.
struct Share {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& x) const {
    const auto u = argument(x, 4), v = argument(x, 5);
    return dot(cross(way(x), v), cross(u, v));
  }
};

constexpr Vector3 zero_edge{0, 0, 0};
constexpr Sign nearer(Sign s, Sign t) { return s < t ? s : t; }

/// The distance of p from the edge that starts at corner + move in direction d, against the radius.
Sign beyond_edge(const Point3& corner, const Vector3& move, const Vector3& d, double radius, const Point3& p) {
  if (sign_of(Ahead{}, corner, p, move, zero_edge, d) != Sign::positive)
    return sign_of(BeyondBall{}, corner, p, move, zero_edge, radius);
  if (sign_of(Ahead{}, corner, p, move, d, d) != Sign::negative)
    return sign_of(BeyondBall{}, corner, p, move, d, radius);
  return sign_of(BeyondRod{}, corner, p, move, zero_edge, d, radius);
}

bool projects(const Point3& corner, const Vector3& u, const Vector3& v, const Point3& p) {
  const auto between = [&](const Vector3& a, const Vector3& b) {
    return sign_of(Share{}, corner, p, zero_edge, zero_edge, a, b) == Sign::positive &&
           sign_of(Share{}, corner, p, a, zero_edge, a, b) == Sign::negative;
  };
  return between(u, v) && between(v, u);
}

}  // namespace
}  // namespace figure::containment

using namespace figure::containment;

Location locate(const Lozenge3& lozenge, const Point3& p) {
  const auto& [corner, edges, radius] = lozenge;
  const auto& [u, v] = edges;
  figure::require_sound("contains", lozenge, part::place("p", p));
  if (projects(corner, u, v, p)) return location(sign_of(BeyondPlate{}, corner, p, u, v, radius));
  Sign least = Sign::positive;
  for (const auto& [move, d] : {std::pair{zero_edge, u}, {zero_edge, v}, {u, v}, {v, u}}) {
    least = nearer(least, beyond_edge(corner, move, d, radius, p));
    if (least == Sign::negative) break;
  }
  return location(least);
}

}  // namespace plumb
