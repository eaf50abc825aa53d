// First hits in the plane: against rationals, and by hand.
#include "plumb/query/ray/ray2.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "figure/basic/rational_polygon.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb {
namespace {

using shape_cases::Material, shape_cases::on_shapes;
constexpr Feature vertex(std::uint32_t i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge(std::uint32_t i) { return {FeatureKind::edge, i}; }
constexpr Feature face0{FeatureKind::face, 0};

using Pair = std::array<mpq_class, 2>;
Pair exact(const Point2& p) { return {mpq_class(p.x), mpq_class(p.y)}; }
Pair operator-(const Pair& a, const Pair& b) { return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1])}; }
mpq_class dot(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }
mpq_class cross(const Pair& a, const Pair& b) { return a[0] * b[1] - a[1] * b[0]; }

struct Shot {
  explicit Shot(const AnyRay2& r)
      : from(exact(r.origin)),
        way(r.kind == AnyRay::Kind::segment ? exact(r.end) - from : exact({r.direction.x, r.direction.y})),
        begins(r.kind != AnyRay::Kind::line),
        ends(r.kind == AnyRay::Kind::segment) {}

  [[nodiscard]] Pair at(const mpq_class& t) const {
    return {mpq_class(from[0] + t * way[0]), mpq_class(from[1] + t * way[1])};
  }
  /// The least of [first, last] that the ray has.
  [[nodiscard]] std::optional<mpq_class> least(mpq_class first, const mpq_class& last) const {
    if (begins && first < 0) first = 0;
    if (first > last || (ends && first > 1)) return {};
    return first;
  }

  Pair from, way;
  bool begins, ends;
};

struct NumberedEdge {
  Point2 a, b;
  std::uint32_t at_a, at_b, number;
};

bool holds(const NumberedEdge& e, const Pair& x) {
  const Pair a = exact(e.a), b = exact(e.b);
  return cross(b - a, x - a) == 0 && dot(x - a, x - b) <= 0;
}
std::optional<mpq_class> first_of(const Shot& ray, const NumberedEdge& e) {
  const Pair p = exact(e.a), along = exact(e.b) - p, to = p - ray.from;
  if (dot(ray.way, ray.way) == 0) return holds(e, ray.from) ? std::optional<mpq_class>(0) : std::nullopt;
  const mpq_class whole = cross(ray.way, along);
  if (whole != 0) {
    const mpq_class s = cross(to, ray.way) / whole, t = cross(to, along) / whole;
    return s < 0 || s > 1 ? std::nullopt : ray.least(t, t);
  }
  if (cross(to, ray.way) != 0) return {};
  const mpq_class square = dot(ray.way, ray.way), t = dot(to, ray.way) / square,
                  u = dot(exact(e.b) - ray.from, ray.way) / square;
  return ray.least(std::min(t, u), std::max(t, u));
}

void add_chain(std::vector<NumberedEdge>& edges, const std::vector<Point2>& chain) {
  const std::size_t first = edges.size();
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = (i + 1) % chain.size();
    edges.push_back({chain[i], chain[j], static_cast<std::uint32_t>(first + i), static_cast<std::uint32_t>(first + j),
                     static_cast<std::uint32_t>(first + i)});
  }
}
template <class Shape>
std::vector<std::vector<Point2>> chains_of(const Shape& s) {
  if constexpr (requires { s.outer; }) {
    std::vector<std::vector<Point2>> chains{s.outer.vertices};
    for (const auto& hole : s.holes) chains.push_back(hole.vertices);
    return chains;
  } else if constexpr (requires { s.vertices; }) {
    return {s.vertices};
  } else if constexpr (requires { s.d; }) {
    return {{s.a, s.b, s.c, s.d}};
  } else if constexpr (requires { s.c; }) {
    return {{s.a, s.b, s.c}};
  } else {
    return {};
  }
}
template <class Shape>
std::vector<NumberedEdge> edges_of(const Shape& s) {
  std::vector<NumberedEdge> edges;
  if constexpr (std::is_same_v<Shape, Segment2>) {
    edges = {{s.a, s.b, 0, 1, 0}};
  } else if constexpr (std::is_same_v<Shape, Aabb2>) {
    if (s.min.x > s.max.x || s.min.y > s.max.y) return edges;
    const Point2 p{s.max.x, s.min.y}, q{s.min.x, s.max.y};
    edges = {{s.min, p, 0, 1, 0}, {q, s.max, 2, 3, 1}, {s.min, q, 0, 2, 2}, {p, s.max, 1, 3, 3}};
  }
  for (const auto& chain : chains_of(s)) add_chain(edges, chain);
  return edges;
}
/// Beside all edges.
template <class Shape>
bool is_inside(const Shape& s, const Point2& p) {
  if constexpr (std::is_same_v<Shape, Aabb2>) {
    return s.min.x < p.x && p.x < s.max.x && s.min.y < p.y && p.y < s.max.y;
  } else {
    int turns = 0;
    for (const auto& chain : chains_of(s)) {
      const auto winding = plumb_test::winding(chain, p);
      if (!winding) return false;
      turns += *winding;
    }
    return turns % 2 != 0;
  }
}

AnyRay2 ray_of(Material& m) {
  const Point2 origin = m.probe2(), target = m.probe2();
  Vector2 d{target.x - origin.x, target.y - origin.y};
  if (!std::isfinite(d.x) || !std::isfinite(d.y) || m.below(6) == 0) d = m.vector2();
  if (m.below(6) == 0) d.x = 0;
  const std::size_t kind = m.below(3);
  if (kind == 0) return Ray2{origin, d};
  if (kind == 1) return Segment2{origin, m.below(10) == 0 ? origin : target};
  return Line2{origin, m.below(10) == 0 ? Vector2{0, 0} : d};
}
std::string text_of_ray(const AnyRay2& r) {
  std::string text = std::to_string(static_cast<int>(r.kind));
  for (const double x : {r.origin.x, r.origin.y, r.direction.x, r.direction.y, r.end.x, r.end.y})
    text.append(" ").append(hexadecimal(x));
  return text;
}

struct Tally {
  int missed = 0, vertices = 0, edges = 0, inside = 0;
};

template <class Shape>
void check_straight(std::uint64_t start, std::uint64_t cases) {
  Tally tally;
  on_shapes(start, cases, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const AnyRay2 ray = ray_of(m);
    const Shot shot(ray);
    const std::string about = m.about(shape).append(" ").append(text_of_ray(ray));
    const std::vector<NumberedEdge> edges = edges_of(shape);
    std::optional<mpq_class> t;
    for (const NumberedEdge& e : edges) {
      if (const auto at = first_of(shot, e); at && (!t || *at < *t)) t = at;
    }
    const bool begins = shot.begins || dot(shot.way, shot.way) == 0;
    const bool inside = !std::is_same_v<Shape, Segment2> && begins && is_inside(shape, ray.origin);
    if (inside) t = 0;
    const auto hit = first_hit(ray, shape);
    const auto parameter = first_hit_parameter(ray, shape);
    ASSERT_EQ(hit.has_value(), t.has_value()) << about;
    ASSERT_EQ(parameter.has_value(), t.has_value()) << about;
    ++(!t                                         ? tally.missed
       : inside                                   ? tally.inside
       : hit->feature.kind == FeatureKind::vertex ? tally.vertices
                                                  : tally.edges);
    if (!t) return;
    EXPECT_TRUE(parameter->base == Rational(BigRational{*t}) && parameter->square.sign() == Sign::zero) << about;
    EXPECT_EQ(hit->t, parameter->rounded()) << about;
    if (inside) {
      EXPECT_EQ(*hit, (Hit2{0, ray.origin, face0, {0, 0}})) << about;
      return;
    }
    const Pair x = shot.at(*t);
    EXPECT_EQ(hit->point.x, Rational(BigRational{x[0]}).rounded(Rounding::nearest)) << about;
    EXPECT_EQ(hit->point.y, Rational(BigRational{x[1]}).rounded(Rounding::nearest)) << about;
    Feature expected{FeatureKind::face, 0};
    for (const NumberedEdge& e : edges) {
      if (expected.kind == FeatureKind::face && holds(e, x)) expected = edge(e.number);
    }
    std::uint32_t corner = UINT32_MAX;
    for (const NumberedEdge& e : edges) {
      if (exact(e.a) == x) corner = std::min(corner, e.at_a);
      if (exact(e.b) == x) corner = std::min(corner, e.at_b);
    }
    if (corner != UINT32_MAX) expected = vertex(corner);
    EXPECT_EQ(hit->feature, expected) << about;
  });
  std::printf("missed %d, vertices %d, edges %d, inside %d\n", tally.missed, tally.vertices, tally.edges, tally.inside);
  const int least = static_cast<int>(cases / 20);
  EXPECT_GT(tally.missed, least);
  EXPECT_GT(tally.vertices, least);
  EXPECT_GT(tally.edges, least);
}
TEST(FirstHit2, OfSegmentsIsThatOfRationals) { check_straight<Segment2>(901, 1500); }
TEST(FirstHit2, OfTrianglesIsThatOfRationals) { check_straight<Triangle2>(902, 1500); }
TEST(FirstHit2, OfBoxesIsThatOfRationals) { check_straight<Aabb2>(903, 1500); }
TEST(FirstHit2, OfQuadrilateralsIsThatOfRationals) { check_straight<Quadrilateral2>(904, 1000); }
TEST(FirstHit2, OfPolygonsIsThatOfRationals) { check_straight<Polygon2>(905, 1000); }
TEST(FirstHit2, OfPolygonsWithHolesIsThatOfRationals) { check_straight<HoledPolygon2>(906, 500); }

TEST(FirstHit2, OfCirclesIsThatOfTheirEquation) {
  int hits = 0, tangents = 0, misses = 0;
  on_shapes(907, 1500, [&](Material& m) {
    const auto circle = m.shape<Circle2>();
    const AnyRay2 ray = ray_of(m);
    const Shot shot(ray);
    const Pair off = shot.from - exact(circle.center);
    const mpq_class r(circle.radius), square = dot(shot.way, shot.way), half = dot(off, shot.way),
                                      rest = dot(off, off) - r * r;  // square t^2 + 2 half t + rest <= 0
    std::optional<std::pair<mpq_class, mpq_class>> expected;         // base, and the square of what is less
    if (shot.begins && rest <= 0) {
      expected.emplace(0, 0);
    } else if (square == 0) {
      if (rest <= 0) expected.emplace(0, 0);
    } else if (const mpq_class root = (half * half - square * rest) / (square * square); root >= 0) {
      const mpq_class base = -half / square;
      const bool behind = shot.begins && base < 0;
      const bool beyond = shot.ends && base > 1 && (base - 1) * (base - 1) > root;
      if (!behind && !beyond) expected.emplace(base, root);
    }
    const std::string about = m.about(circle).append(" ").append(text_of_ray(ray));
    const auto parameter = first_hit_parameter(ray, circle);
    ASSERT_EQ(parameter.has_value(), expected.has_value()) << about;
    const auto hit = first_hit(ray, circle);
    ASSERT_EQ(hit.has_value(), expected.has_value()) << about;
    ++(expected ? expected->second == 0 ? tangents : hits : misses);
    if (!expected) return;
    const RayParameter wanted{Rational(BigRational{expected->first}), Rational(BigRational{expected->second})};
    EXPECT_TRUE(*parameter == wanted) << about;
    EXPECT_EQ(hit->t, wanted.rounded()) << about;
    EXPECT_EQ(hit->feature, (shot.begins && rest < 0) || (square == 0 && rest < 0) ? face0 : edge(0)) << about;
  });
  EXPECT_GT(hits, 100);
  EXPECT_GT(tangents, 50);
  EXPECT_GT(misses, 100);
}

mpq_class value(const Vector2& n, const Pair& x) { return dot(exact({n.x, n.y}), x); }

/// What is left of the ray by each slab: the way of an oriented box's corner or of a k-DOP's interval along directions.
struct Slabs {
  std::vector<std::array<mpq_class, 4>> all;  // of n: n . from, n . way, least, most
  [[nodiscard]] bool holds(const mpq_class& t) const {
    for (const auto& [at, speed, least, most] : all) {
      const mpq_class x = at + t * speed;
      if (x < least || x > most) return false;
    }
    return true;
  }
  /// The first of all candidates that is held.
  [[nodiscard]] std::optional<mpq_class> first(const Shot& shot) const {
    std::vector<mpq_class> times;
    const bool still = dot(shot.way, shot.way) == 0;
    if (shot.begins || still) times.emplace_back(0);
    for (const auto& [at, speed, least, most] : all) {
      if (speed != 0) times.push_back((least - at) / speed), times.push_back((most - at) / speed);
    }
    std::sort(times.begin(), times.end());
    for (const mpq_class& t : times) {
      if ((!shot.begins || t >= 0) && (!shot.ends || t <= 1) && holds(t)) return t;
    }
    return {};
  }
};

TEST(FirstHit2, OfOrientedBoxesIsThatOfRationals) {
  Tally tally;
  on_shapes(909, 1500, [&](Material& m) {
    const auto box = m.shape<Obb2>();
    const AnyRay2 ray = ray_of(m);
    const Shot shot(ray);
    const std::string about = m.about(box).append(" ").append(text_of_ray(ray));
    // Corners as differences of the halves; the hull of four points is a polygon to rationals, whatever the axes.
    const Pair c = exact(box.center), u = exact({box.axes[0].x, box.axes[0].y}),
               v = exact({box.axes[1].x, box.axes[1].y});
    const mpq_class h = abs(mpq_class(box.half.x)), k = abs(mpq_class(box.half.y)), turn = cross(u, v) * h * k;
    const auto hit = first_hit(ray, box);
    if (turn == 0) {  // a segment, at least where all four corners are on one line: told by intersection alone
      const bool meet = ray.kind == AnyRay::Kind::segment ? intersects(Segment2{ray.origin, ray.end}, box)
                        : ray.kind == AnyRay::Kind::ray   ? intersects(Ray2{ray.origin, ray.direction}, box)
                                                          : intersects(Line2{ray.origin, ray.direction}, box);
      EXPECT_EQ(hit.has_value(), meet) << about;
      return;
    }
    Slabs slabs;
    const auto slab = [&](const Pair& along, const mpq_class& reach) {
      const Pair n{mpq_class(-along[1]), along[0]};
      slabs.all.push_back({dot(n, shot.from - c), dot(n, shot.way), mpq_class(-abs(reach)), abs(reach)});
    };
    slab(u, dot({mpq_class(-u[1]), u[0]}, v) * k), slab(v, dot({mpq_class(-v[1]), v[0]}, u) * h);
    const auto t = slabs.first(shot);
    ASSERT_EQ(hit.has_value(), t.has_value()) << about;
    if (!t) {
      ++tally.missed;
      return;
    }
    EXPECT_TRUE(first_hit_parameter(ray, box)->base == Rational(BigRational{*t})) << about;
    EXPECT_EQ(hit->t, Rational(BigRational{*t}).rounded(Rounding::nearest)) << about;
    // Weights of the axes tell the feature.
    const Pair x = shot.at(*t) - c;
    const mpq_class s = cross(x, v) / cross(u, v), r = cross(u, x) / cross(u, v);
    const bool at_u = abs(s) == h, at_v = abs(r) == k;
    Feature expected = face0;
    if (at_u && at_v) {
      expected = vertex((s > 0 ? 1u : 0u) + (r > 0 ? 2u : 0u));
      ++tally.vertices;
    } else if (at_v || at_u) {
      expected = edge(at_v ? (r > 0 ? 1u : 0u) : 2 + (s > 0 ? 1u : 0u));
      ++tally.edges;
    } else {
      ++tally.inside;
    }
    EXPECT_EQ(hit->feature, expected) << about;
    // Perpendicular to its edge, against the ray.
    if (expected == face0) {
      EXPECT_EQ(hit->normal, (Vector2{0, 0})) << about;
      return;
    }
    Pair along = at_v ? u : v;
    mpq_class half = at_v ? h : k;
    if (at_u && at_v && cross(shot.way, u) == 0) along = v, half = k;
    mpq_class across = cross(shot.way, along);
    mpq_class way = across > 0 ? -2 * half : across < 0 ? 2 * half : mpq_class(0);
    EXPECT_EQ(hit->normal.x, Rational(BigRational{mpq_class(way * along[1])}).rounded(Rounding::nearest)) << about;
    EXPECT_EQ(hit->normal.y, Rational(BigRational{mpq_class(-way * along[0])}).rounded(Rounding::nearest)) << about;
  });
  for (const int n : {tally.missed, tally.vertices, tally.edges, tally.inside}) EXPECT_GT(n, 0);
}

TEST(FirstHit2, OfKDopsIsThatOfTheirIntervals) {
  Tally tally;
  on_shapes(910, 1000, [&](Material& m) {
    std::vector<Vector2> directions;
    for (std::size_t n = 1 + m.below(4); directions.size() < n;) {
      const Vector2 d = m.direction2();
      if (d != Vector2{0, 0}) directions.push_back(d);
    }
    KDop2 k_dop{Directions2(directions), {}, {}};
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double a = m.number(), b = m.number();
      k_dop.min.push_back(m.below(12) == 0 ? std::max(a, b) : std::min(a, b)), k_dop.max.push_back(std::max(a, b));
    }
    const AnyRay2 ray = ray_of(m);
    const Shot shot(ray);
    const std::string about = m.about().append(" ").append(text_of_ray(ray));
    Slabs slabs;
    for (std::size_t i = 0; i < directions.size(); ++i)
      slabs.all.push_back({value(directions[i], shot.from), value(directions[i], shot.way), mpq_class(k_dop.min[i]),
                           mpq_class(k_dop.max[i])});
    auto t = slabs.first(shot);
    if (!t && slabs.holds(0)) t = 0;  // along all slabs
    const auto hit = first_hit(ray, k_dop);
    ASSERT_EQ(hit.has_value(), t.has_value()) << about;
    ++(t ? tally.edges : tally.missed);
    if (!t) return;
    EXPECT_TRUE(first_hit_parameter(ray, k_dop)->base == Rational(BigRational{*t})) << about;
    EXPECT_EQ(hit->t, Rational(BigRational{*t}).rounded(Rounding::nearest)) << about;
    Feature expected = face0;
    for (std::size_t i = 0; i < slabs.all.size() && expected == face0; ++i) {
      const auto& [at, speed, least, most] = slabs.all[i];
      const mpq_class x = at + *t * speed;
      if (x == least || x == most) expected = edge(static_cast<std::uint32_t>(2 * i + (x == least ? 0 : 1)));
    }
    EXPECT_EQ(hit->feature, expected) << about;
  });
  EXPECT_GT(tally.missed, 2);
  EXPECT_GT(tally.edges, 2);
}

TEST(FirstHit2, OfCapsulesWhereTheyMeet) {
  int met = 0, apart = 0;
  on_shapes(908, 800, [&](Material& m) {
    const auto capsule = m.shape<Capsule2>();
    const AnyRay2 ray = ray_of(m);
    const bool meet = ray.kind == AnyRay::Kind::segment ? intersects(Segment2{ray.origin, ray.end}, capsule)
                      : ray.kind == AnyRay::Kind::ray   ? intersects(Ray2{ray.origin, ray.direction}, capsule)
                                                        : intersects(Line2{ray.origin, ray.direction}, capsule);
    ++(meet ? met : apart);
    EXPECT_EQ(first_hit(ray, capsule).has_value(), meet) << m.about(capsule) << " " << text_of_ray(ray);
  });
  EXPECT_GT(met, 100);
  EXPECT_GT(apart, 25);
}

TEST(FirstHit2, ByHand) {
  const Aabb2 box{{0, 0}, {4, 2}};
  EXPECT_EQ(*first_hit(Ray2{{-1, 1}, {2, 0}}, box), (Hit2{0.5, {0, 1}, edge(2), {-2, 0}}));
  EXPECT_EQ(*first_hit(Ray2{{1, 5}, {0, -1}}, box), (Hit2{3, {1, 2}, edge(1), {0, 4}}));
  EXPECT_EQ(*first_hit(Ray2{{-1, 2}, {1, 0}}, box), (Hit2{1, {0, 2}, vertex(2), {-2, 0}}));  // along an edge
  EXPECT_EQ(*first_hit(Ray2{{1, 1}, {1, 0}}, box), (Hit2{0, {1, 1}, face0, {0, 0}}));
  EXPECT_FALSE(first_hit(Ray2{{5, 1}, {1, 0}}, box));
  EXPECT_EQ(first_hit(Line2{{5, 1}, {1, 0}}, box)->t, -5);
  EXPECT_EQ(first_hit(Line2{{1, 1}, {0, 0}}, box), (Hit2{0, {1, 1}, face0, {0, 0}}));  // a point
  EXPECT_TRUE(first_hit_parameter(Line2{{1, 1}, {0, 0}}, box));
  const Obb2 turned{{0, 0}, {{{3, 4}, {-4, 3}}}, {1, 1}};  // corners (1, -7), (7, 1), (-1, 7), (-7, -1)
  EXPECT_EQ(*first_hit(Ray2{{10, 4}, {-1, 0}}, turned), (Hit2{7, {3, 4}, edge(3), {6, 8}}));
  EXPECT_EQ(first_hit(Ray2{{-10, -1}, {1, 0}}, turned)->feature, vertex(2));
  EXPECT_EQ(*first_hit(Ray2{{1, 1}, {1, 0}}, turned), (Hit2{0, {1, 1}, face0, {0, 0}}));
  EXPECT_EQ(*first_hit(Ray2{{9, 1}, {-2, 0}}, KDop2{Directions2(std::vector<Vector2>{{1, 1}, {1, 0}}), {0, 0}, {4, 9}}),
            (Hit2{3, {3, 1}, edge(1), {1, 1}}));
  const Polygon2 notched{{{0, 0}, {6, 0}, {6, 6}, {3, 3}, {0, 6}}};
  EXPECT_EQ(*first_hit(Ray2{{3, 9}, {0, -1}}, notched), (Hit2{6, {3, 3}, vertex(3), {-3, 3}}));
  const Capsule2 pill{{0, 0}, {9, 0}, 2};
  EXPECT_EQ(*first_hit(Ray2{{3, 5}, {0, -1}}, pill), (Hit2{3, {3, 2}, edge(0), {0, 2}}));
  EXPECT_EQ(*first_hit(Ray2{{15, 0}, {-1, 0}}, pill), (Hit2{4, {11, 0}, edge(2), {2, 0}}));
}

TEST(FirstHit2, BadInputIsNamed) {
  const double nan = std::nan("");
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)first_hit(Ray2{{0, nan}, {1, 0}}, Circle2{{0, 0}, 1});
            }).find("first_hit: ray.origin.y is nan"),
            0u);
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)first_hit(Ray2{{0, 0}, {1, 0}}, Circle2{{0, 0}, nan});
            }).find("first_hit: circle.radius is nan"),
            0u);
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)first_hit(Segment2{{0, 0}, {1, 0}}, Segment2{{0, nan}, {1, 0}});
            }).find("first_hit: b.a.y is nan"),
            0u);
  EXPECT_EQ(text_of<InvalidShape>([&] {
              (void)first_hit(Ray2{{0, 0}, {1, 0}}, Capsule2{{0, 0}, {1, 0}, -1});
            }).find("first_hit: capsule.radius is negative"),
            0u);
  EXPECT_THROW((void)first_hit(Ray2{{0, 0}, {1, 0}}, Polygon2{{{0, 0}, {1, 0}}}), InvalidShape);
}

}  // namespace
}  // namespace plumb
