// Closest points of any two figures: every answer has its certificate, and pairs that have formulas of their own agree.
#include "plumb/query/separation/separation.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/closest/oracle.hpp"
#include "query/closest/straight_oracle.hpp"
#include "query/convex/features.hpp"
#include "query/separation/certificate.hpp"
#include "query/separation/cores.hpp"

namespace plumb {
namespace {

using namespace certificate;
using pair_cases::Material;
using query::NearestPair, query::WhichPair;

struct Maker {
  FigureKind kind;
  std::function<certificate::AnyFigure(Material&)> figure, near_figure;
};

template <class... S>
std::vector<Maker> makers_of(pair_cases::Types<S...>) {
  std::vector<Maker> all;
  const auto add = [&all]<class Shape>(const Shape*) {
    if constexpr (query::closest_pairs.answers(FigureKind::point, figure_kind<Shape>, figure_dimension<Shape>)) {
      all.push_back({figure_kind<Shape>, [](Material& m) { return any(pair_cases::figure<Shape>(m)); },
                     [](Material& m) { return any(pair_cases::near_figure<Shape>(m)); }});
    }
  };
  (add(static_cast<const S*>(nullptr)), ...);
  return all;
}

std::string name_of_pair(const FigureView& a, const FigureView& b, const Material& m) {
  return std::string(name_of(a.kind)) + " and " + std::string(name_of(b.kind)) + m.about();
}

bool is_polygon_kind(FigureKind k) {
  return query::is_one_of(k, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon});
}

struct Seen {
  int apart = 0, meet = 0, several = 0;
};

/// The answer rounded from this pair of points, both exact.
void expect_rounded(const FigureView& a, const FigureView& b, const NearestPair& pair, const std::string& name) {
  const Closest c = query::closest_points_of(a, b);
  const double ra = query::radius_of(a), rb = query::radius_of(b),
               d = query::distance_of(a, b, query::Question::distance);
  const mpq_class radii = mpq_class(ra) + mpq_class(rb);
  EXPECT_EQ(c.distance, d) << name;
  if (pair.square <= radii * radii) {
    EXPECT_EQ(d, 0) << name;
    EXPECT_EQ(c.on_a, c.on_b) << name;
    if (radii != 0) return;
    const auto is_rounded = [](double x, const mpq_class& q) {
      return rationals::overflows(q) ? std::isinf(x) && (x > 0) == (q > 0) : rationals::is_nearest(x, q);
    };
    const bool rounded =
        is_rounded(c.on_a.x, pair.on_a[0]) && is_rounded(c.on_a.y, pair.on_a[1]) && is_rounded(c.on_a.z, pair.on_a[2]);
    EXPECT_TRUE(rounded) << name << " " << c.on_a.x << " " << c.on_a.y << " " << c.on_a.z;
    EXPECT_EQ(c.feature_a, query::feature_at(a, pair.on_a, false)) << name;
    EXPECT_EQ(c.feature_b, query::feature_at(b, pair.on_b, false)) << name;
    return;
  }
  EXPECT_TRUE(is_nearest_distance(d, pair.square, radii)) << name << " " << d;
  EXPECT_EQ(c.feature_a, query::feature_at(a, pair.on_a, false)) << name;
  EXPECT_EQ(c.feature_b, query::feature_at(b, pair.on_b, false)) << name;
  const std::array on_a{c.on_a.x, c.on_a.y, c.on_a.z}, on_b{c.on_b.x, c.on_b.y, c.on_b.z};
  for (std::size_t k = 0; k < 3; ++k) {
    const mpq_class way = pair.on_b[k] - pair.on_a[k];
    EXPECT_TRUE(is_nearest_moved(on_a[k], pair.on_a[k], way, ra, pair.square)) << name;
    EXPECT_TRUE(is_nearest_moved(on_b[k], pair.on_b[k], -way, rb, pair.square)) << name;
  }
}

void expect_certified(const std::vector<Maker>& makers, std::uint64_t start, std::uint64_t cases) {
  Seen seen;
  for (std::size_t i = 0; i < makers.size(); ++i) {
    for (std::size_t j = i; j < makers.size(); ++j) {
      if (is_polygon_kind(makers[i].kind) || is_polygon_kind(makers[j].kind)) continue;
      shape_cases::on_shapes(start++, cases, [&](Material& m) {
        const certificate::AnyFigure first = makers[i].figure(m), second = makers[j].near_figure(m);
        const FigureView &a = first.view, &b = second.view;
        const std::string name = name_of_pair(a, b, m);
        const FlatSet set_a = query::core_of(a), set_b = query::core_of(b);
        const auto pair = query::nearest_of_cores(a, b, WhichPair::first);
        ASSERT_EQ(pair.has_value(), !set_a.points.empty() && !set_b.points.empty()) << name;
        if (!pair) {
          EXPECT_THROW((void)query::closest_points_of(a, b), InvalidShape) << name;
          EXPECT_THROW((void)query::distance_of(a, b, query::Question::distance), InvalidShape) << name;
          return;
        }
        EXPECT_TRUE(are_nearest(set_a, set_b, pair->on_a, pair->on_b)) << name;
        EXPECT_EQ(sgn(pair->square) == 0, query::relate(set_a, set_b) != Relation::disjoint) << name;
        (sgn(pair->square) == 0 ? seen.meet : seen.apart) += 1;
        const auto any_pair = query::nearest_of_cores(a, b, WhichPair::any);
        EXPECT_EQ(any_pair->square, pair->square) << name;
        if (any_pair->on_a != pair->on_a) {
          ++seen.several;
          EXPECT_TRUE(are_nearest(set_a, set_b, any_pair->on_a, any_pair->on_b)) << name;
          EXPECT_TRUE(!pair->is_first || pair->on_a < any_pair->on_a) << name;
        }
        expect_rounded(a, b, *pair, name);
        EXPECT_EQ(query::closest_points_of(b, a), swapped(query::closest_points_of(a, b))) << name;
      });
    }
  }
  std::printf("%d apart, %d meet, %d of several pairs\n", seen.apart, seen.meet, seen.several);
  EXPECT_GT(seen.apart * 4, seen.meet);
  EXPECT_GT(seen.meet * 6, seen.apart);
  EXPECT_GT(seen.several * 40, seen.meet + seen.apart);
}

const std::uint64_t cases_of_pair = battery::sanitized ? 1 : 3;

TEST(Separation, EveryPairOfTheSpaceHasItsCertificate) {
  expect_certified(makers_of(pair_cases::Space{}), 18'000, cases_of_pair);
}
TEST(Separation, EveryPairOfThePlaneHasItsCertificate) {
  expect_certified(makers_of(pair_cases::Plane{}), 19'000, cases_of_pair);
}

TEST(Separation, AVertexThatHalvesAnEdgeEndsNoClimb) {
  // A cube whose vertex 0, where searches begin, halves an edge of its roof: its edges lead nowhere else.
  const std::vector<std::vector<std::uint32_t>> faces{{4, 3, 2, 1}, {5, 0, 6, 7, 8}, {1, 2, 6, 0, 5},
                                                      {2, 3, 7, 6}, {3, 4, 8, 7},    {4, 1, 5, 8}};
  PolygonMesh mesh{
      {{1, 0, 2}, {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}, {}, {0}};
  for (const auto& f : faces) {
    mesh.corners.insert(mesh.corners.end(), f.begin(), f.end());
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  const ConvexPolyhedron3 cube = convex_polyhedron(mesh);
  EXPECT_EQ(distance(cube, Segment3{{1, 0.125, 3}, {1, 0.25, 4}}), 1);
  const Closest c = closest_points(cube, Sphere3{{1, 0.125, 4}, 1});
  EXPECT_EQ(c.distance, 1);
  EXPECT_EQ(c.feature_a, (Feature{FeatureKind::face, 1}));
}

/// Every simplex of its vertices, of which there are at most four.
std::vector<straight_oracle::Part> simplices_of(const std::vector<Point3>& vertices) {
  std::vector<straight_oracle::Part> parts;
  for (unsigned mask = 1; mask < 1u << vertices.size(); ++mask) {
    straight_oracle::Part part{{FeatureKind::vertex, 0}, {}, {}};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if ((mask >> i & 1) == 0) continue;
      const auto at = rationals::exact(vertices[i]);
      if (part.base.empty()) {
        part.base = at;
      } else {
        part.ways.push_back(rationals::operator-(at, part.base));
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

TEST(Separation, SimplicesAreAsBruteForceSays) {
  int meet = 0;
  const auto expect = [&](const std::vector<Point3>& p, const std::vector<Point3>& q, const FigureView& a,
                          const FigureView& b, const std::string& name) {
    std::optional<straight_oracle::Pair> best;
    for (const auto& part : simplices_of(p)) {
      for (const auto& other : simplices_of(q)) {
        auto pair = straight_oracle::candidate(part, other);
        if (pair && (!best || straight_oracle::before(*pair, *best))) best = std::move(pair);
      }
    }
    meet += best->square == 0;
    const auto pair = query::nearest_of_cores(a, b, WhichPair::first);
    EXPECT_EQ(pair->square, best->square) << name;
    EXPECT_TRUE(std::ranges::equal(pair->on_a, best->on_a) && std::ranges::equal(pair->on_b, best->on_b)) << name;
    const Closest c = query::closest_points_of(a, b);
    EXPECT_TRUE(is_nearest_distance(c.distance, best->square, 0)) << name;
    EXPECT_TRUE(rationals::is_nearest(c.on_a.x, best->on_a[0]) && rationals::is_nearest(c.on_b.z, best->on_b[2]))
        << name;
  };
  shape_cases::on_shapes(20'001, battery::sanitized ? 4 : 30, [&](Material& m) {
    const auto t = pair_cases::figure<Tetrahedron3>(m), u = pair_cases::near_figure<Tetrahedron3>(m);
    const auto f = pair_cases::near_figure<Triangle3>(m);
    const auto s = pair_cases::near_figure<Segment3>(m);
    const std::vector<Point3> corners{t.a, t.b, t.c, t.d};
    expect(corners, {u.a, u.b, u.c, u.d}, query::view_of(t), query::view_of(u), m.about(t, u));
    expect({f.a, f.b, f.c}, corners, query::view_of(f), query::view_of(t), m.about(f, t));
    expect({s.a, s.b}, corners, query::view_of(s), query::view_of(t), m.about(s, t));
  });
  EXPECT_GT(meet, battery::sanitized ? 0 : 5);
}

std::vector<Point3> vertices_of(const Tetrahedron3& t) { return {t.a, t.b, t.c, t.d}; }
std::vector<Point3> vertices_of(const Triangle3& t) { return {t.a, t.b, t.c}; }
std::vector<Point3> vertices_of(const Polygon3& p) { return p.vertices; }
std::vector<Point3> vertices_of(const HoledPolygon3& p) {
  std::vector<Point3> all = p.outer.vertices;
  for (const Polygon3& hole : p.holes) all.insert(all.end(), hole.vertices.begin(), hole.vertices.end());
  return all;
}
std::vector<Segment3> edges_between(const std::vector<Point3>& all) {
  std::vector<Segment3> edges;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) edges.push_back({all[i], all[j]});
  }
  return edges;
}
std::vector<Segment3> edges_of(const Tetrahedron3& t) { return edges_between(vertices_of(t)); }
std::vector<Segment3> edges_of(const Triangle3& t) { return edges_between(vertices_of(t)); }
std::vector<Segment3> edges_of(const Polygon3& p) {
  std::vector<Segment3> edges;
  for (std::size_t i = 0; i < p.vertices.size(); ++i)
    edges.push_back({p.vertices[i], p.vertices[(i + 1) % p.vertices.size()]});
  return edges;
}
std::vector<Segment3> edges_of(const HoledPolygon3& p) {
  std::vector<Segment3> edges = edges_of(p.outer);
  for (const Polygon3& hole : p.holes) {
    for (const Segment3& e : edges_of(hole)) edges.push_back(e);
  }
  return edges;
}

/// Two that do not meet are nearest at a vertex of one or between two edges: by questions that have tests of their own.
template <class A, class B>
void expect_least_of_parts(std::uint64_t start, int& apart) {
  shape_cases::on_shapes(start, battery::sanitized ? 2 : 12, [&](Material& m) {
    const A a = pair_cases::figure<A>(m);
    const B b = pair_cases::near_figure<B>(m);
    const Rational square = squared_distance_exact(a, b);
    EXPECT_EQ(square.sign() == Sign::zero, intersects(a, b)) << m.about(a, b);
    const Closest c = closest_points(a, b);
    EXPECT_EQ(closest_points(b, a), swapped(c)) << m.about(a, b);
    EXPECT_EQ(c.distance, rounded_root(Rounding::nearest, square)) << m.about(a, b);
    if (square.sign() == Sign::zero) return;
    ++apart;
    std::optional<Rational> least;
    const auto see = [&](const Rational& x) {
      if (!least || x < *least) least = x;
    };
    for (const Point3& p : vertices_of(a)) see(squared_distance_exact(p, b));
    for (const Point3& p : vertices_of(b)) see(squared_distance_exact(p, a));
    for (const Segment3& e : edges_of(a)) {
      for (const Segment3& f : edges_of(b)) see(squared_distance_exact(e, f));
    }
    EXPECT_EQ(square, *least) << m.about(a, b);
  });
}
TEST(Separation, PolygonsAreAsNearAsTheirParts) {
  int apart = 0;
  expect_least_of_parts<Polygon3, Polygon3>(21'001, apart);
  expect_least_of_parts<Polygon3, HoledPolygon3>(21'002, apart);
  expect_least_of_parts<Triangle3, HoledPolygon3>(21'003, apart);
  expect_least_of_parts<Polygon3, Tetrahedron3>(21'004, apart);
  EXPECT_GT(apart, battery::sanitized ? 0 : 12);
}

TEST(Separation, PolygonsHoldWhatIsInside) {
  const Polygon3 frame{{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}};
  const HoledPolygon3 window{frame, {{{{3, 3, 0}, {6, 3, 0}, {6, 6, 0}, {3, 6, 0}}}}};
  const Aabb3 rod{{4, 4, -5}, {5, 5, 5}};
  EXPECT_EQ(distance(frame, rod), 0);
  EXPECT_EQ(closest_points(frame, rod),
            (Closest{{4, 4, 0}, {4, 4, 0}, 0, {FeatureKind::face, 0}, {FeatureKind::edge, 8}}));
  EXPECT_EQ(distance(window, rod), 1);
  EXPECT_EQ(distance(Sphere3{{4.5, 4.5, 2}, 0.5}, frame), 1.5);
  EXPECT_EQ(distance(HoledPolygon2{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, {{{{3, 3}, {6, 3}, {6, 6}, {3, 6}}}}},
                     Circle2{{4.5, 4.5}, 0.25}),
            1.25);
  EXPECT_EQ(closest_points(Polygon2{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}}, Aabb2{{2, 3}, {4, 5}}),
            (Closest2{{2, 3}, {2, 3}, 0, {FeatureKind::face, 0}, {FeatureKind::vertex, 0}}));
}

template <class Shape>
Shape scaled(Shape s, int by) {
  std::array<double, sizeof(Shape) / sizeof(double)> numbers;
  std::memcpy(numbers.data(), &s, sizeof(Shape));
  for (double& x : numbers) x = std::ldexp(x, by);
  std::memcpy(&s, numbers.data(), sizeof(Shape));
  return s;
}

TEST(Separation, ScalesHaveTheSameAnswer) {
  Material m(22'001, 0);
  const auto number = [&] { return static_cast<double>(m.below(1u << 20)) / 3; };
  const auto point = [&] {
    const double x = number(), y = number(), z = number();
    return Point3{x, y, z};
  };
  for (int i = 0; i < (battery::sanitized ? 10 : 100); ++i) {
    const Tetrahedron3 a{point(), point(), point(), point()};
    const Point3 p = point(), q = point();
    const Capsule3 b{p, q, number() / 64};
    const Closest near = closest_points(a, b, WhichPair::first);
    for (const int by : {-600, -480, 480, 960}) {  // places and distances are all normal numbers
      const Closest c = closest_points(scaled(a, by), scaled(b, by), WhichPair::first);
      EXPECT_EQ(c.distance, std::ldexp(near.distance, by)) << i << " " << by;
      EXPECT_EQ(c.on_a, scaled(near.on_a, by)) << i << " " << by;
      EXPECT_EQ(c.feature_a, near.feature_a) << i << " " << by;
      EXPECT_EQ(compare(exact_distance(scaled(a, by), scaled(b, by)), c.distance),
                compare(exact_distance(a, b), near.distance));
    }
  }
}

TEST(Separation, IsInfiniteBeyondAllDoubles) {
  constexpr double most = std::numeric_limits<double>::max(), infinite = std::numeric_limits<double>::infinity();
  const Aabb3 low{{-most, -most, -most}, {-most, -most, -most}}, high{{most, most, most}, {most, most, most}};
  const Closest c = closest_points(low, high);
  EXPECT_EQ(c.distance, infinite);
  EXPECT_EQ(c.on_a, low.min);
  EXPECT_EQ(c.on_b, high.max);
  EXPECT_EQ(compare_distance(low, high, most), Sign::positive);
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(distance(Aabb3{{0, 0, 0}, {1, 1, 1}}, Aabb3{{1 + 0x1p-52, 0, 0}, {2, 1, 1}}), 0x1p-52);
  EXPECT_EQ(
      distance(Aabb3{{-1, 0, 0}, {0, 1, 1}}, Obb3{{1, 0, 0}, {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 1, 1}}), 0);
  EXPECT_EQ(distance(Aabb3{{-1, 0, 0}, {-least, 1, 1}}, Sphere3{{1, 0, 0}, 1}), least);
}

TEST(Separation, ComparesExactly) {
  const Sphere3 ball{{0, 0, 0}, 1};
  const Aabb3 box{{3, 0, 0}, {4, 1, 1}};
  EXPECT_EQ(compare_distance(ball, box, 2.0), Sign::zero);
  EXPECT_EQ(compare_distance(ball, box, std::nextafter(2.0, 3.0)), Sign::negative);
  EXPECT_EQ(compare_distance(Sphere3{{0x1p-600, 0, 0}, 1}, box, 2.0), Sign::negative);
  EXPECT_EQ(compare_distance(ball, box, Segment3{{0, 0, 0}, {0, 0, 1}}, Aabb3{{2, 5, 5}, {3, 6, 6}}), Sign::negative);
  EXPECT_EQ(compare_distance(ball, Sphere3{{1, 1, 0}, 1}, 0.0), Sign::zero);
  EXPECT_EQ(text_of<InvalidShape>([&] {
              (void)distance(ball, Aabb3{{1, 0, 0}, {0, 1, 1}});
            }),
            "distance: aabb is empty, and nothing is nearest; give one that has a point");
}

}  // namespace
}  // namespace plumb
