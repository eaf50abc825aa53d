// Pairs that need no sets of bounds: what doubles tell of those in general position, and few signs of most others, names
// what they have in common.  Where signs are zero that leave a choice, the general way has to tell.
#include "figure/basic/plane_of_points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/section/intersection.hpp"
#include "query/body/figure_input.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/quick2.hpp"
#include "query/section/corner_name.hpp"
#include "query/section/flat_outline.hpp"
#include "query/section/meet.hpp"

namespace plumb::query::meeting {
namespace {

bool strictly_same(Sign a, Sign b) { return a * b == Sign::positive; }
bool opposite(Sign a, Sign b) { return a * b == Sign::negative; }

template <class Common, class P>
Common at(const P& p) {
  Common common;
  common.kind = IntersectionKind::point;
  common.vertices.emplace_back(p);
  return common;
}

bool precedes(const Point2& p, const Point2& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }
bool precedes(const Point3& p, const Point3& q) {
  return p.x < q.x || (p.x == q.x && (p.y < q.y || (p.y == q.y && p.z < q.z)));
}
template <class P>
query::Ascending ascending(const std::array<P, 3>& p) {
  query::Ascending all{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) all[i][j] = precedes(p[i], p[j]);
  }
  return all;
}

/// What an outline encloses: crossing(i, i', j, j') names where the edges from corner i to i' and from j to j' cross.
template <class Common, class P, class Crossing>
Common polygon(const query::Outline& outline, const std::array<P, 3>& a, const std::array<P, 3>& b,
               const Crossing& crossing) {
  Common common;
  if (outline.count == 0) return common;
  common.kind = IntersectionKind::polygon;
  common.vertices.reserve(outline.count);
  const auto of = [](const std::array<P, 3>& t, int i) -> const P& { return t[static_cast<std::size_t>(i)]; };
  for (std::size_t k = 0; k < outline.count; ++k) {
    const auto& c = outline.corners[k];
    if (c.b == query::no_edge) {
      common.vertices.emplace_back(of(a, c.a));
    } else if (c.a == query::no_edge) {
      common.vertices.emplace_back(of(b, c.b));
    } else {
      common.vertices.emplace_back(crossing(of(a, c.a), of(a, c.a_to), of(b, c.b), of(b, c.b_to)));
    }
  }
  return common;
}

/// One component of the cross product of the normals of 0, 1, 2 and 3, 4, 5.
struct CrossOfNormals {
  static constexpr std::string_view name = "intersection";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    using predicates::difference;
    const auto n = predicates::cross(difference(p, 0, 1), difference(p, 0, 2));
    const auto m = predicates::cross(difference(p, 3, 4), difference(p, 3, 5));
    return n.y * m.z - n.z * m.y;
  }
};

/// Does the line of both planes ascend in the direction of this cross product?  Along x, where that is certain.
Sign ascent(const Triangle3& a, const Triangle3& b) {
  return static_cast<Sign>(
      magnitude_filter<CrossOfNormals>(coordinates_of<CrossOfNormals>(a.a, a.b, a.c, b.a, b.b, b.c)));
}

/// Of triangles that cross with corners on both sides of both planes, and whose edges cross one another nowhere.
Intersection3 crossing_segment(const Triangle3& a, const Triangle3& b) {
  // Above is the side of the normal, where orient3d is negative.
  const auto crossed = [](const Triangle3& plane, const Triangle3& t) {
    const auto above = [&](const Point3& p) { return query::orient3d(plane.a, plane.b, plane.c, p) == Sign::negative; };
    const std::array<bool, 3> up{above(t.a), above(t.b), above(t.c)};
    const std::size_t below = static_cast<std::size_t>(!up[0]) | static_cast<std::size_t>(!up[1]) << 1 |
                              static_cast<std::size_t>(!up[2]) << 2;
    const std::size_t alone = query::corner_alone[below];
    const std::array<Point3, 3> p{t.a, t.b, t.c};
    // The edges in the order in which the line n x m leaves and enters the triangle whose normal is n.
    const std::size_t first = (alone + (up[alone] ? 1 : 2)) % 3, second = (alone + (up[alone] ? 2 : 1)) % 3;
    return std::tuple(p[alone], p[first], p[second], up[alone]);
  };
  const auto [p, p_high, p_low, p_up] = crossed(b, a);
  const auto [q, q_low, q_high, q_up] = crossed(a, b);
  // Positive where an edge of a from p is crossed farther along n x m than one of b from q.
  const Sign way = p_up == q_up ? Sign::positive : Sign::negative;
  const LinePlanePoint3 high = way * query::orient3d(p, p_high, q, q_high) != Sign::positive
                                   ? LinePlanePoint3{p, p_high, b.a, b.b, b.c}
                                   : LinePlanePoint3{q, q_high, a.a, a.b, a.c};
  const LinePlanePoint3 low = way * query::orient3d(p, p_low, q, q_low) != Sign::negative
                                  ? LinePlanePoint3{p, p_low, b.a, b.b, b.c}
                                  : LinePlanePoint3{q, q_low, a.a, a.b, a.c};
  Sign rises = ascent(a, b);
  if (rises == Sign::zero) rises = compare_xyz(high, low);
  Intersection3 common;
  common.kind = IntersectionKind::segment;
  common.vertices.reserve(2);
  common.vertices.emplace_back(rises == Sign::positive ? low : high);
  common.vertices.emplace_back(rises == Sign::positive ? high : low);
  return common;
}

/// Of triangles that have nothing else in common.
Intersection3 shared_corners(const Triangle3& t, const Triangle3& u) {
  Intersection3 common;
  for (const Point3& p : {t.a, t.b, t.c}) {
    const bool shared = p == u.a || p == u.b || p == u.c;
    if (shared && (common.vertices.empty() || p != std::get<Point3>(common.vertices[0].as())))
      common.vertices.emplace_back(p);
  }
  common.kind = common.vertices.size() == 1 ? IntersectionKind::point : IntersectionKind::segment;
  if (common.vertices.size() == 2 &&
      precedes(std::get<Point3>(common.vertices[1].as()), std::get<Point3>(common.vertices[0].as())))
    std::swap(common.vertices[0], common.vertices[1]);
  return common;
}

/// Of segments of one line, points among them.
Intersection2 on_one_line(const Segment2& s, const Segment2& t) {
  const auto least = [](const Point2& p, const Point2& q) { return precedes(q, p) ? q : p; };
  const auto most = [](const Point2& p, const Point2& q) { return precedes(q, p) ? p : q; };
  const Point2 from = most(least(s.a, s.b), least(t.a, t.b)), to = least(most(s.a, s.b), most(t.a, t.b));
  if (precedes(to, from)) return {};
  if (from == to) return at<Intersection2>(from);
  return {IntersectionKind::segment, {from, to}};
}

bool is_coplanar(const Triangle3& t, const Triangle3& u) {
  const auto on = [&](const Point3& p) { return query::orient3d(t.a, t.b, t.c, p) == Sign::zero; };
  return on(u.a) && on(u.b) && on(u.c);
}

std::optional<Intersection2> quick(const Segment2& s, const Segment2& t) {
  const auto told = query::by_doubles(s, t);
  if (!told) return {};
  return *told == Relation::disjoint ? Intersection2{} : at<Intersection2>(LineLinePoint2{s.a, s.b, t.a, t.b});
}

std::optional<Intersection2> quick(const Triangle2& t, const Triangle2& u) {
  if (query::by_doubles(t, u) == Relation::disjoint) return Intersection2{};
  const std::array a{t.a, t.b, t.c}, b{u.a, u.b, u.c};
  const auto outline = query::common_outline(t, u, ascending(a), ascending(b));
  if (!outline) return {};
  return polygon<Intersection2>(*outline, a, b, [](const Point2& p, const Point2& q, const Point2& v, const Point2& w) {
    return LineLinePoint2{p, q, v, w};
  });
}

std::optional<Intersection3> quick(const Segment3& s, const Triangle3& t) {
  const auto told = query::by_doubles(s, t);
  if (!told) return {};
  return *told == Relation::disjoint ? Intersection3{} : at<Intersection3>(LinePlanePoint3{s.a, s.b, t.a, t.b, t.c});
}

std::optional<Intersection3> quick(const Triangle3& t, const Triangle3& u) {
  const auto told = query::by_doubles(t, u);
  if (!told) return {};
  if (*told == Relation::disjoint) return Intersection3{};
  if (*told == Relation::touching) return shared_corners(t, u);
  for (const Point3& p : {t.a, t.b, t.c}) {
    if (p == u.a || p == u.b || p == u.c) return {};  // they cross from a corner on, or lie in one plane
  }
  return crossing_segment(t, u);
}

std::optional<Intersection2> by_signs(const Segment2& s, const Segment2& t) {
  const Sign a = query::orient2d(s.a, s.b, t.a), b = query::orient2d(s.a, s.b, t.b);
  if (strictly_same(a, b)) return Intersection2{};
  const Sign c = query::orient2d(t.a, t.b, s.a), d = query::orient2d(t.a, t.b, s.b);
  if (strictly_same(c, d)) return Intersection2{};
  if (opposite(a, b) && opposite(c, d)) return at<Intersection2>(LineLinePoint2{s.a, s.b, t.a, t.b});
  if (a == Sign::zero && b == Sign::zero && c == Sign::zero && d == Sign::zero) return on_one_line(s, t);
  // The lines cross in one point, where one segment ends.
  return at<Intersection2>(a == Sign::zero ? t.a : b == Sign::zero ? t.b : c == Sign::zero ? s.a : s.b);
}

std::optional<Intersection2> by_signs(const Triangle2& t, const Triangle2& u) {
  if (plumb::relate(t, u) == Relation::disjoint) return Intersection2{};
  return {};
}

std::optional<Intersection3> by_signs(const Segment3& s, const Triangle3& t) {
  if (plumb::relate(s, t) == Relation::disjoint) return Intersection3{};
  const Sign a = query::orient3d(t.a, t.b, t.c, s.a), b = query::orient3d(t.a, t.b, t.c, s.b);
  if (opposite(a, b)) return at<Intersection3>(LinePlanePoint3{s.a, s.b, t.a, t.b, t.c});
  if (a == b) return {};  // in the plane
  return at<Intersection3>(a == Sign::zero ? s.a : s.b);
}

std::optional<Intersection3> by_signs(const Triangle3& t, const Triangle3& u) {
  const Relation relation = plumb::relate(t, u);
  if (relation == Relation::disjoint) return Intersection3{};
  if (relation != Relation::overlapping || !is_coplanar(t, u) || collinear(t.a, t.b, t.c)) return {};
  const Look look = look_at_plane(t.a, t.b, t.c);
  const auto seen = [&](const Triangle3& v) {
    return Triangle2{projected(look, v.a), projected(look, v.b), projected(look, v.c)};
  };
  const std::array a{t.a, t.b, t.c}, b{u.a, u.b, u.c};
  const auto outline = query::common_outline(seen(t), seen(u), ascending(a), ascending(b));
  if (!outline) return {};
  const std::size_t axis = look == Look::along_z ? 2 : look == Look::along_x ? 0 : 1;
  return polygon<Intersection3>(*outline, a, b,
                                [&](const Point3& p, const Point3& q, const Point3& v, const Point3& w) {
                                  return LinePlanePoint3{p, q, v, w, moved<3>(v, axis)};
                                });
}

std::optional<Intersection3> by_signs(const Triangle3& t, const Aabb3& b) {
  const auto outside = [](double x, double y, double z, double min, double max) {
    return (x < min && y < min && z < min) || (x > max && y > max && z > max);
  };
  if (outside(t.a.x, t.b.x, t.c.x, b.min.x, b.max.x) || outside(t.a.y, t.b.y, t.c.y, b.min.y, b.max.y) ||
      outside(t.a.z, t.b.z, t.c.z, b.min.z, b.max.z))
    return Intersection3{};
  if (plumb::relate(t, b) == Relation::disjoint) return Intersection3{};
  return {};
}

/// By doubles, whatever they are; then by exact signs, of real numbers.
template <class Common, class A, class B>
Common intersection_of(const A& a, const B& b) {
  if constexpr (requires { quick(a, b); }) {
    if (auto told = quick(a, b)) return std::move(*told);
  }
  query::require_figures("intersection", a, b);
  if (auto told = by_signs(a, b)) return std::move(*told);
  return meet(convex_set(a), convex_set(b));
}

}  // namespace
}  // namespace plumb::query::meeting

namespace plumb {

using query::meeting::intersection_of;

Intersection2 intersection(const Segment2& a, const Segment2& b) { return intersection_of<Intersection2>(a, b); }
Intersection2 intersection(const Triangle2& a, const Triangle2& b) { return intersection_of<Intersection2>(a, b); }
Intersection3 intersection(const Segment3& a, const Triangle3& b) { return intersection_of<Intersection3>(a, b); }
Intersection3 intersection(const Triangle3& a, const Triangle3& b) { return intersection_of<Intersection3>(a, b); }
Intersection3 intersection(const Triangle3& a, const Aabb3& b) { return intersection_of<Intersection3>(a, b); }

}  // namespace plumb
