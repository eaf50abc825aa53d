#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/minkowski/minkowski.hpp"

namespace plumb {
namespace {

/// orient2d(a + b, c + d, p).
struct SumsOrient2d {
  static constexpr std::string_view name = "locate";
  static constexpr std::array arguments{2, 2, 2, 2, 2};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto x = (p[4] + p[6]) - (p[0] + p[2]), y = (p[5] + p[7]) - (p[1] + p[3]);
    return predicates::det2(x, y, (p[8] - p[0]) - p[2], (p[9] - p[1]) - p[3]);
  }
};

/// Positive above the plane of the sums a + b, c + d, e + f, from where they are seen counterclockwise.
struct SumsAbove {
  static constexpr std::string_view name = "locate";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 21>& p) const {
    const auto along = [&p](std::size_t to, std::size_t axis) {
      return (p[to + axis] + p[to + 3 + axis]) - (p[axis] + p[3 + axis]);
    };
    const auto off = [&p](std::size_t axis) { return (p[18 + axis] - p[axis]) - p[3 + axis]; };
    return predicates::det3(along(6, 0), along(6, 1), along(6, 2),     //
                            along(12, 0), along(12, 1), along(12, 2),  //
                            off(0), off(1), off(2));
  }
};

/// a + b - x.
Sign beyond(double a, double b, double x) {
  return sign_of([](auto p, auto q, auto r) { return p + q - r; }, a, b, x);
}

Sign turn(const SumVertex2& s, const SumVertex2& t, const Point2& p) {
  return sign_of(SumsOrient2d{}, s.a, s.b, t.a, t.b, p);
}

Location at_most(bool member) { return member ? Location::boundary : Location::outside; }

bool equal(const SumVertex2& s, const Point2& p) {
  return beyond(s.a.x, s.b.x, p.x) == Sign::zero && beyond(s.a.y, s.b.y, p.y) == Sign::zero;
}

bool between(const SumVertex2& s, const SumVertex2& t, const Point2& p) {
  return beyond(s.a.x, s.b.x, p.x) * beyond(t.a.x, t.b.x, p.x) != Sign::positive &&
         beyond(s.a.y, s.b.y, p.y) * beyond(t.a.y, t.b.y, p.y) != Sign::positive;
}

Location located(std::span<const SumVertex2> chain, const Point2& p) {
  if (chain.empty()) return Location::outside;
  if (chain.size() == 1) return at_most(equal(chain[0], p));
  if (chain.size() == 2) {
    return at_most(turn(chain[0], chain[1], p) == Sign::zero && between(chain[0], chain[1], p));
  }
  Location where = Location::inside;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Sign s = turn(chain[i], chain[(i + 1) % chain.size()], p);
    if (s == Sign::negative) return Location::outside;
    if (s == Sign::zero) where = Location::boundary;
  }
  return where;
}

using Axis = double Point3::*;
constexpr std::array<std::array<Axis, 2>, 3> planes{
    {{&Point3::x, &Point3::y}, {&Point3::y, &Point3::z}, {&Point3::z, &Point3::x}}};

Point2 dropped(const Point3& p, const std::array<Axis, 2>& plane) { return {p.*plane[0], p.*plane[1]}; }

std::vector<SumVertex2> dropped(const MinkowskiSum3& sum, const std::array<Axis, 2>& plane) {
  std::vector<SumVertex2> chain;
  const auto add = [&](const SumVertex3& v) {
    chain.push_back({dropped(v.a, plane), dropped(v.b, plane), v.index_a, v.index_b});
  };
  if (sum.dimension == 2) {
    for (const std::uint32_t i : sum.corners) add(sum.vertices[i]);
  } else {
    for (const SumVertex3& v : sum.vertices) add(v);
  }
  return chain;
}

/// Do the first three corners turn, in this plane?  Then all do, for a chain that is strictly convex in its own.
bool has_area(std::span<const SumVertex2> chain) {
  const SumVertex2 &r = chain[0], &s = chain[1], &t = chain[2];
  return sign_of(
             [](auto ax, auto ay, auto bx, auto by, auto cx, auto cy, auto dx, auto dy, auto ex, auto ey, auto fx,
                auto fy) {
               return ((cx + dx) - (ax + bx)) * ((ey + fy) - (ay + by)) -
                      ((cy + dy) - (ay + by)) * ((ex + fx) - (ax + bx));
             },
             r.a, r.b, s.a, s.b, t.a, t.b) != Sign::zero;
}

Sign above(const MinkowskiSum3& sum, std::span<const std::uint32_t> face, const Point3& p) {
  const SumVertex3 &r = sum.vertices[face[0]], &s = sum.vertices[face[1]], &t = sum.vertices[face[2]];
  return sign_of(SumsAbove{}, r.a, r.b, s.a, s.b, t.a, t.b, p);
}

Location located_in_polygon(const MinkowskiSum3& sum, const Point3& p) {
  if (above(sum, sum.face(0), p) != Sign::zero) return Location::outside;
  for (const auto& plane : planes) {
    const std::vector<SumVertex2> chain = dropped(sum, plane);
    if (has_area(chain)) return at_most(located(chain, dropped(p, plane)) != Location::outside);
  }
  return Location::outside;
}

}  // namespace

Location locate(const MinkowskiSum2& sum, const Point2& p) {
  require_finite_parts("locate", {"p"}, p);
  return located(sum.vertices, p);
}

Location locate(const MinkowskiSum3& sum, const Point3& p) {
  require_finite_parts("locate", {"p"}, p);
  if (sum.dimension == 2) return located_in_polygon(sum, p);
  if (sum.dimension < 2) {  // a point or segment contains what it contains in each of the three planes
    const bool member = std::ranges::all_of(planes, [&](const auto& plane) {
      return located(dropped(sum, plane), dropped(p, plane)) != Location::outside;
    });
    return at_most(member);
  }
  Location where = Location::inside;
  for (std::size_t f = 0; f < sum.face_count(); ++f) {
    const Sign s = above(sum, sum.face(f), p);
    if (s == Sign::positive) return Location::outside;
    if (s == Sign::zero) where = Location::boundary;
  }
  return where;
}

bool contains(const MinkowskiSum2& sum, const Point2& p) { return locate(sum, p) != Location::outside; }
bool contains(const MinkowskiSum3& sum, const Point3& p) { return locate(sum, p) != Location::outside; }
bool contains_origin(const MinkowskiSum2& sum) { return contains(sum, {0, 0}); }
bool contains_origin(const MinkowskiSum3& sum) { return contains(sum, {0, 0, 0}); }

std::vector<Point2> rounded_vertices(const MinkowskiSum2& sum) {
  const auto coordinate = [](double a, double b) {
    return figure::within_doubles(a + b + 0.0, "rounded_vertices", "a coordinate");
  };
  std::vector<Point2> points;
  for (const SumVertex2& v : sum.vertices) points.push_back({coordinate(v.a.x, v.b.x), coordinate(v.a.y, v.b.y)});
  return points;
}

std::vector<Point3> rounded_vertices(const MinkowskiSum3& sum) {
  const auto coordinate = [](double a, double b) {
    return figure::within_doubles(a + b + 0.0, "rounded_vertices", "a coordinate");
  };
  std::vector<Point3> points;
  for (const SumVertex3& v : sum.vertices) {
    points.push_back({coordinate(v.a.x, v.b.x), coordinate(v.a.y, v.b.y), coordinate(v.a.z, v.b.z)});
  }
  return points;
}

}  // namespace plumb
