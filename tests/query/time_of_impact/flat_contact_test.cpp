// Figures of the plane in straight motion: against times at which a corner comes to an edge, in rationals, and round
// ones by their distances just before and at the time.
#include <gtest/gtest.h>

#include <algorithm>

#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "figure/containment/exact_locations.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/time_of_impact/posed.hpp"

namespace plumb {
namespace {

using exact::Coordinates, exact::Rational;
using shape_cases::Material, shape_cases::on_shapes;

struct Corner {
  Coordinates at;
  std::uint32_t number;
};
struct Edge {
  Corner a, b;
  std::uint32_t number;
};
struct Drawing {
  std::vector<Corner> corners;
  std::vector<Edge> edges;
  bool solid = false;
};

Drawing drawing(const Point2& p) { return {{{exact::of(p), 0}}, {}}; }
void add(Drawing& d, const std::vector<Point2>& chain) {
  const auto start = static_cast<std::uint32_t>(d.corners.size()), n = static_cast<std::uint32_t>(chain.size());
  for (std::uint32_t i = 0; i < n; ++i) d.corners.push_back({exact::of(chain[i]), start + i});
  for (std::uint32_t i = 0; i < n; ++i)
    d.edges.push_back({d.corners[start + i], d.corners[start + (i + 1) % n], start + i});
  d.solid = true;
}
Drawing drawing(const Segment2& s) {
  const Corner a{exact::of(s.a), 0}, b{exact::of(s.b), 1};
  return {{a, b}, {{a, b, 0}}};
}
Drawing drawing(const Triangle2& t) {
  Drawing d;
  add(d, {t.a, t.b, t.c});
  return d;
}
Drawing drawing(const Polygon2& p) {
  Drawing d;
  add(d, p.vertices);
  return d;
}
Drawing drawing(const HoledPolygon2& p) {
  Drawing d;
  add(d, p.outer.vertices);
  for (const auto& hole : p.holes) add(d, hole.vertices);
  return d;
}
/// Corner bit k is the upper end of axis k.
Drawing of_corners(const std::vector<Coordinates>& c) {
  Drawing d;
  for (std::uint32_t i = 0; i < 4; ++i) d.corners.push_back({c[i], i});
  const auto& at = d.corners;
  d.edges = {{at[0], at[1], 0}, {at[2], at[3], 1}, {at[0], at[2], 2}, {at[1], at[3], 3}};
  d.solid = true;
  return d;
}
Drawing drawing(const Aabb2& b) {
  if (is_empty(b)) return {};
  return of_corners(
      {exact::of(b.min), exact::of(Point2{b.max.x, b.min.y}), exact::of(Point2{b.min.x, b.max.y}), exact::of(b.max)});
}
Drawing drawing(const Obb2& b) {
  std::vector<Coordinates> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Rational h = abs(Rational(b.half.x)), k = abs(Rational(b.half.y));
    corners.push_back(exact::combination(
        exact::combination(exact::of(b.center), (i & 1) != 0 ? h : Rational(-h), exact::of(b.axes[0])),
        (i & 2) != 0 ? k : Rational(-k), exact::of(b.axes[1])));
  }
  return of_corners(corners);
}

Rational area(const Coordinates& u, const Coordinates& v) { return u[0] * v[1] - u[1] * v[0]; }
bool on_edge(const Edge& e, const Coordinates& x) {
  const Coordinates p = exact::difference(x, e.a.at), q = exact::difference(x, e.b.at);
  return area(p, q) == 0 && exact::dot(p, q) <= 0;
}
bool inside(const Drawing& d, const Coordinates& x) {
  bool odd = false;
  for (const Edge& e : d.edges) {
    const Coordinates &a = e.a.at, &b = e.b.at;
    if ((a[1] > x[1]) == (b[1] > x[1])) continue;
    if (a[0] + (x[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]) > x[0]) odd = !odd;
  }
  return d.solid && odd;
}
bool cross(const Edge& e, const Edge& f) {
  const auto side = [](const Edge& g, const Coordinates& x) {
    return sgn(area(exact::difference(g.b.at, g.a.at), exact::difference(x, g.a.at)));
  };
  return side(e, f.a.at) * side(e, f.b.at) < 0 && side(f, e.a.at) * side(f, e.b.at) < 0;
}

using Found = std::tuple<int, FeatureKind, std::uint32_t, std::uint32_t, FeatureKind>;
void take(std::optional<std::pair<Rational, Found>>& best, const Rational& t, FeatureKind a, std::uint32_t i,
          FeatureKind b, std::uint32_t j) {
  if (t < 0 || t > 1) return;
  const std::pair<Rational, Found> one{t, {static_cast<int>(a) + static_cast<int>(b), a, i, j, b}};
  if (!best || one < *best) best = one;
}
/// When a point that moves by d comes to another.
std::optional<Rational> time_to(const Coordinates& p, const Coordinates& d, const Coordinates& q) {
  const Coordinates way = exact::difference(q, p);
  if (exact::square(d) == 0) return exact::square(way) == 0 ? std::optional<Rational>(0) : std::nullopt;
  if (area(way, d) != 0) return {};
  return Rational(exact::dot(way, d) / exact::square(d));
}

/// Of figures that do not overlap at the start.
std::optional<std::pair<Rational, Found>> meeting(const Drawing& a, const Drawing& b, const Coordinates& d) {
  std::optional<std::pair<Rational, Found>> best;
  const Coordinates back = exact::difference(exact::of(Vector2{0, 0}), d);
  for (const Corner& p : a.corners) {
    for (const Corner& q : b.corners) {
      if (const auto t = time_to(p.at, d, q.at))
        take(best, *t, FeatureKind::vertex, p.number, FeatureKind::vertex, q.number);
    }
  }
  const auto to_edges = [&](const Drawing& from, const Coordinates& by, const Drawing& to, bool first) {
    for (const Corner& p : from.corners) {
      for (const Edge& e : to.edges) {
        const Coordinates along = exact::difference(e.b.at, e.a.at);
        std::optional<Rational> t;
        if (const Rational speed = area(along, by); speed != 0) {
          t = Rational(area(along, exact::difference(e.a.at, p.at)) / speed);
        } else if (on_edge(e, p.at)) {
          t = 0;
        }
        if (!t || !on_edge(e, exact::combination(p.at, *t, by))) continue;
        if (first) {
          take(best, *t, FeatureKind::vertex, p.number, FeatureKind::edge, e.number);
        } else {
          take(best, *t, FeatureKind::edge, e.number, FeatureKind::vertex, p.number);
        }
      }
    }
  };
  to_edges(a, d, b, true), to_edges(b, back, a, false);
  return best;
}

template <class S>
inline constexpr bool has_chain = std::is_same_v<S, Polygon2> || std::is_same_v<S, HoledPolygon2>;

struct Tally {
  long missed = 0, started = 0, corners = 0, edges = 0;
};

template <class Shape>
Shape drawn_figure(Material& m) {
  if constexpr (std::is_same_v<Shape, Point2>) {
    return m.probe2();
  } else {
    return m.shape<Shape>();
  }
}

template <class A, class B>
void check(std::uint64_t start, std::uint64_t cases, Tally& tally) {
  on_shapes(start, cases, [&](Material& m) {
    const Translating<A> a{drawn_figure<A>(m), m.vector2()};
    const Translating<B> b{drawn_figure<B>(m), m.below(2) == 0 ? Vector2{0, 0} : m.vector2()};
    const std::string about = m.about(a.shape, a.by, b.by);
    const Drawing drawn = drawing(a.shape), other = drawing(b.shape);
    const auto contact = first_contact(a, b);
    const auto time = first_contact_time(a, b);
    ASSERT_EQ(intersects(a, b), contact.has_value()) << about;
    ASSERT_EQ(time.has_value(), contact.has_value()) << about;
    const auto other_way = first_contact(b, a);
    ASSERT_EQ(other_way.has_value(), contact.has_value()) << about;
    if (contact) {
      EXPECT_EQ(other_way->time, contact->time) << about;
    }
    bool overlap = false;
    for (const Corner& c : drawn.corners) overlap = overlap || inside(other, c.at);
    for (const Corner& c : other.corners) overlap = overlap || inside(drawn, c.at);
    for (const Edge& e : drawn.edges) {
      for (const Edge& f : other.edges) overlap = overlap || cross(e, f);
    }
    const auto expected = meeting(drawn, other, exact::difference(exact::of(a.by), exact::of(b.by)));
    if (overlap) {
      ASSERT_TRUE(contact) << about;
      EXPECT_EQ(contact->time, 0) << about;
      EXPECT_TRUE(*time == plumb::Rational(0)) << about;
      ++tally.started;
      return;
    }
    ASSERT_EQ(contact.has_value(), expected.has_value()) << about;
    if (!contact) {
      ++tally.missed;
      return;
    }
    const auto& [t, features] = *expected;
    EXPECT_TRUE(*time == plumb::Rational(BigRational{t})) << about;
    EXPECT_EQ(contact->time, plumb::Rational(BigRational{t}).rounded(Rounding::down)) << about;
    // Flat figures that overlap along a line, figures that coincide; of polygons what they themselves call so.
    const auto overlap_at_start = [&] {
      if constexpr (has_chain<A> || has_chain<B>) return relate(a.shape, b.shape) == Relation::overlapping;
      return contact->feature_a.kind == FeatureKind::interior;
    };
    if (t == 0 && overlap_at_start()) {
      EXPECT_EQ(contact->feature_a.kind, FeatureKind::interior) << about;
      ++tally.started;
      return;
    }
    const auto& [sum, kind_a, number_a, number_b, kind_b] = features;
    EXPECT_EQ(contact->feature_a, (Feature{kind_a, number_a})) << about;
    EXPECT_EQ(contact->feature_b, (Feature{kind_b, number_b})) << about;
    ++(sum == 0 ? tally.corners : tally.edges);
  });
}
void expect_all(const Tally& tally) {
  std::printf("%ld missed, %ld from the start, %ld at corners, %ld at edges\n", tally.missed, tally.started,
              tally.corners, tally.edges);
  for (const long n : {tally.missed, tally.started, tally.corners, tally.edges}) EXPECT_GT(n, 0);
}

TEST(FlatContact, OfConvexFiguresIsThatOfRationals) {
  Tally tally;
  check<Point2, Segment2>(941, 250, tally), check<Segment2, Segment2>(942, 250, tally);
  check<Triangle2, Aabb2>(943, 250, tally), check<Obb2, Triangle2>(944, 250, tally);
  check<Aabb2, Obb2>(945, 250, tally), check<Point2, Point2>(946, 100, tally);
  expect_all(tally);
}
TEST(FlatContact, OfPolygonsIsThatOfRationals) {
  Tally tally;
  check<Point2, Polygon2>(951, 200, tally), check<Polygon2, Polygon2>(952, 200, tally);
  check<Polygon2, Obb2>(953, 150, tally), check<HoledPolygon2, Segment2>(954, 100, tally);
  check<Triangle2, Polygon2>(955, 60, tally), check<Polygon2, Aabb2>(956, 60, tally);
  check<Obb2, HoledPolygon2>(957, 30, tally);
  expect_all(tally);
}

/// The square of the distance from a place to the edges of a figure, or its inside.
Rational gap(const Drawing& d, const Coordinates& x) {
  if (inside(d, x)) return 0;
  std::optional<Rational> least;
  for (const Corner& c : d.corners) {
    const Rational square = exact::square(exact::difference(c.at, x));
    if (!least || square < *least) least = square;
  }
  for (const Edge& e : d.edges) {
    const auto foot = exact::foot(e.a.at, exact::difference(e.b.at, e.a.at), x, Rational(0), Rational(1));
    if (foot.squared_distance < *least) least = foot.squared_distance;
  }
  return *least;
}

template <class B>
void check_circle(std::uint64_t start, std::uint64_t cases, Tally& tally) {
  on_shapes(start, cases, [&](Material& m) {
    const Translating<Circle2> a{m.shape<Circle2>(), m.vector2()};
    const B b = m.shape<B>();
    const std::string about = m.about(a.shape, a.by);
    const Drawing other = drawing(b);
    const auto contact = first_contact(a, b);
    const auto time = first_contact_time(a, b);
    ASSERT_EQ(time.has_value(), contact.has_value()) << about;
    ASSERT_EQ(intersects(a, b), contact.has_value()) << about;
    const Coordinates from = exact::of(a.shape.center), by = exact::of(a.by);
    const Rational square = exact::squared(a.shape.radius);
    const auto apart = [&](const Rational& t) { return gap(other, exact::combination(from, t, by)) > square; };
    Rational until = 1;
    if (!contact) {
      ++tally.missed;
    } else if (time->sign() == Sign::zero) {
      EXPECT_FALSE(apart(0)) << about;
      ++tally.started;
      return;
    } else {
      const auto [low, high] = time->interval(plumb::Rational(1, 1) / plumb::Rational(0x1p300));
      const Rational least = low.value().value, most = high.value().value;
      if (least == most) {
        EXPECT_FALSE(apart(least)) << about;
        ++tally.corners;
      } else {
        EXPECT_FALSE(apart(most)) << about;
        ++tally.edges;
      }
      until = least - Rational(1, mpz_class(1) << 400);
      EXPECT_EQ(contact->time, time->rounded(Rounding::down)) << about;
      EXPECT_EQ(contact->feature_a, (Feature{FeatureKind::edge, 0})) << about;
      EXPECT_NE(contact->feature_b.kind, FeatureKind::interior) << about;
    }
    for (int k = 0; k <= 8 && until >= 0; ++k) EXPECT_TRUE(apart(until * k / 8)) << about << " " << k;
  });
}
TEST(FlatContact, OfCirclesIsThatOfDistances) {
  Tally tally;
  check_circle<Polygon2>(961, 250, tally), check_circle<Obb2>(962, 250, tally), check_circle<Segment2>(963, 200, tally);
  expect_all(tally);
}

TEST(FlatContact, ByHand) {
  const Polygon2 notched{{{0, 0}, {6, 0}, {6, 6}, {3, 3}, {0, 6}}};
  EXPECT_EQ(*first_contact(Translating<Point2>{{3, 9}, {0, -12}}, notched),
            (Contact{0.5, {FeatureKind::vertex, 0}, {FeatureKind::vertex, 3}}));
  EXPECT_EQ(*first_contact(Translating<Circle2>{{{-3, 3}, 1}, {4, 0}}, notched),
            (Contact{0.5, {FeatureKind::edge, 0}, {FeatureKind::edge, 4}}));
  EXPECT_EQ(*first_contact(Point2{1, 1}, Translating<Polygon2>{notched, {1, 0}}),
            (Contact{0, {FeatureKind::interior, 0}, {FeatureKind::interior, 0}}));
  const HoledPolygon2 frame{{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}}, {{{{2, 2}, {6, 2}, {6, 6}, {2, 6}}}}};
  EXPECT_EQ(*first_contact(Translating<Circle2>{{{4, 4}, 1}, {2, 0}}, frame),
            (Contact{0.5, {FeatureKind::edge, 0}, {FeatureKind::edge, 5}}));  // from inside the hole
  EXPECT_FALSE(first_contact(Translating<Circle2>{{{4, 4}, 1}, {0x1.ffffffffffffp-1, 0}}, frame));
  const Translating<Capsule2> pill{{{0, 0}, {0, 2}, 1}, {9, 0}};  // slides along the box below it
  EXPECT_EQ(first_contact(pill, Aabb2{{4, -5}, {6, -1}})->time, 4.0 / 9);
  EXPECT_FALSE(first_contact(pill, Aabb2{{4, -5}, {6, -0x1.0000000000001p+0}}));
  EXPECT_EQ(*first_contact(Translating<Obb2>{{{0, 0}, {{{1, 1}, {-1, 1}}}, {1, 1}}, {4, 0}}, Aabb2{{4, -1}, {5, 1}}),
            (Contact{0.5, {FeatureKind::vertex, 1}, {FeatureKind::edge, 2}}));
}

/// Pieces that overlap along a polygon's edge from the start, while the polygon only touches: the lowest features count.
TEST(FlatContact, FlatFiguresAlongAnEdge) {
  const Polygon2 square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
  constexpr Vector2 away{-1, -9};
  const Contact corner_on_edge{0, {FeatureKind::vertex, 0}, {FeatureKind::edge, 0}};
  const Contact edge_at_corner{0, {FeatureKind::edge, 0}, {FeatureKind::vertex, 0}};
  const Translating<Obb2> flat_box{{{2, 0}, {{{1, 0}, {0, 1}}}, {1, 0}}, away};
  EXPECT_EQ(*first_contact(flat_box, square), corner_on_edge);
  EXPECT_EQ(*first_contact(square, flat_box), edge_at_corner);
  EXPECT_EQ(*first_contact(Translating<Aabb2>{{{-1, 0}, {5, 0}}, away}, square), edge_at_corner);
  EXPECT_EQ(*first_contact(Translating<Triangle2>{{{1, 0}, {3, 0}, {2, 0}}, away}, square), corner_on_edge);
  EXPECT_EQ(*first_contact(Translating<Capsule2>{{{1, 0}, {3, 0}, 0}, away}, square), corner_on_edge);
  EXPECT_EQ(*first_contact(Translating<Capsule2>{{{-1, 0}, {5, 0}, 0}, away}, square), edge_at_corner);
  EXPECT_EQ(*first_contact(Translating<Circle2>{{{2, 0}, 0}, away}, square),
            (Contact{0, {FeatureKind::edge, 0}, {FeatureKind::edge, 0}}));
  // A corner that is given twice, whose edge without length comes first.
  const Polygon2 repeated{{{4, 0}, {4, 4}, {0, 0}, {0, 0}}};
  const Contact at_corner{0, {FeatureKind::vertex, 0}, {FeatureKind::vertex, 2}};
  EXPECT_EQ(*first_contact(Translating<Point2>{{0, 0}, away}, repeated), at_corner);
  EXPECT_EQ(*first_contact(Translating<Triangle2>{{{0, 0}, {0, 0}, {0, 0}}, away}, repeated), at_corner);
}

TEST(FlatContact, BadInputIsNamed) {
  EXPECT_EQ(text_of<InvalidShape>([] {
              (void)first_contact(Translating<Circle2>{{{0, 0}, -1}, {1, 0}}, Point2{0, 0});
            }),
            "first_contact: circle.radius is negative; give zero or more");
  EXPECT_THROW((void)intersects(Translating<Polygon2>{{{{0, 0}, {1, 0}}}, {1, 0}}, Point2{0, 0}), InvalidShape);
  EXPECT_EQ(text_of<NonFinite>([] {
              (void)first_contact(Translating<Polygon2>{{{{0, 0}, {1, 0}, {0, 1}}}, {NAN, 0}}, Point2{0, 0});
            }).find("first_contact: a.by.x is nan"),
            0u);
}

}  // namespace
}  // namespace plumb
