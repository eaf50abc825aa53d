// Voronoi regions against the nearest point in rationals, found among all simplices of corners; figures 3.24, 3.25, 5.5
// and 5.6 by hand.
#include "plumb/figure/containment/voronoi_region.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>

#include "certify/sanitized.hpp"
#include "figure/basic/rationals.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "oracle/shapes.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/polyhedron.hpp"

namespace plumb {

std::ostream& operator<<(std::ostream& out, const Feature& f) {
  return out << std::array{"vertex", "edge", "face", "interior"}[static_cast<std::size_t>(f.kind)] << ' ' << f.index;
}

namespace {

using rationals::dot, rationals::exact, rationals::Vector;
using rationals::operator+, rationals::operator-, rationals::operator*;
using shape_cases::Material, shape_cases::on_shapes;
using testing::HasSubstr;

using Corners = std::vector<std::size_t>;

/// A solid or flat convex shape: its corners, and its vertices, edges and faces by their corners.
struct Pieces {
  std::vector<Vector> corners;
  std::array<std::map<std::uint32_t, Corners>, 3> features;
};

/// Calls visit for the nonempty sets of up to four of these, while it returns true.
template <class Visit>
void some_of(const Corners& all, Corners& chosen, std::size_t next, const Visit& visit) {
  if (!chosen.empty() && !visit(chosen)) return;
  if (chosen.size() == 4) return;
  for (std::size_t i = next; i < all.size(); ++i) {
    chosen.push_back(all[i]);
    some_of(all, chosen, i + 1, visit);
    chosen.pop_back();
  }
}

/// The point of the hull of these corners that is nearest to p.
Vector nearest_of(const Pieces& pieces, const Corners& all, const Vector& p) {
  std::optional<Vector> best;
  mpq_class distance;
  Corners chosen;
  some_of(all, chosen, 0, [&](const Corners& simplex) {
    std::vector<Vector> corners;
    for (const std::size_t i : simplex) corners.push_back(pieces.corners[i]);
    const auto weights = corners.size() == 1 ? Vector{1} : rationals::weights_of(corners, p).value_or(Vector{});
    if (weights.empty()) return false;  // dependent, and so is what contains them
    Vector q(p.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (weights[i] < 0) return true;
      q = q + weights[i] * corners[i];
    }
    const mpq_class d = dot(q - p, q - p);
    if (!best || d < distance) {
      best = q;
      distance = d;
    }
    return true;
  });
  return *best;
}

Feature told_by_rationals(const Pieces& pieces, const Vector& p) {
  Corners all(pieces.corners.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  const Vector q = nearest_of(pieces, all, p);
  for (std::size_t kind = 0; kind < 3; ++kind) {
    for (const auto& [index, corners] : pieces.features[kind]) {
      if (nearest_of(pieces, corners, q) == q) return {static_cast<FeatureKind>(kind), index};
    }
  }
  EXPECT_EQ(p, q);
  return {FeatureKind::interior, 0};
}

template <class Shape>
Pieces pieces(const Shape& s) requires requires {
  s.a;
}
{
  constexpr std::size_t corners = sizeof(Shape) / sizeof(s.a);
  Pieces r{{exact(s.a), exact(s.b)}, {}};
  if constexpr (corners > 2) r.corners.push_back(exact(s.c));
  if constexpr (corners > 3) r.corners.push_back(exact(s.d));
  for (std::uint32_t i = 0; i < corners; ++i) r.features[0][i] = {i};
  if constexpr (corners == 2) r.features[1] = {{0, {0, 1}}};
  if constexpr (corners == 3) {
    r.features[1] = {{0, {0, 1}}, {1, {1, 2}}, {2, {2, 0}}};
    r.features[2] = {{0, {0, 1, 2}}};
  }
  if constexpr (corners == 4) {
    r.features[1] = {{0, {0, 1}}, {1, {0, 2}}, {2, {0, 3}}, {3, {1, 2}}, {4, {1, 3}}, {5, {2, 3}}};
    r.features[2] = {{0, {1, 2, 3}}, {1, {0, 2, 3}}, {2, {0, 1, 3}}, {3, {0, 1, 2}}};
  }
  return r;
}

/// Those of a box by their numbers' definition.
void name_box_features(Pieces& r) {
  for (std::uint32_t v = 0; v < 8; ++v) {
    r.features[0][v] = {v};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
      r.features[1][4 * axis + (v >> low & 1) + 2 * (v >> high & 1)].push_back(v);
      r.features[2][2 * axis + (v >> axis & 1)].push_back(v);
    }
  }
}
Pieces pieces(const Obb3& box) {
  Pieces r;
  const auto half = coordinates(box.half);
  for (std::uint32_t v = 0; v < 8; ++v) {
    Vector corner = exact(box.center);
    for (std::uint32_t i = 0; i < 3; ++i)
      corner = corner + mpq_class((v >> i & 1) != 0 ? std::fabs(half[i]) : -std::fabs(half[i])) * exact(box.axes[i]);
    r.corners.push_back(corner);
  }
  name_box_features(r);
  return r;
}
Pieces pieces(const Aabb3& box) {
  Pieces r;
  for (std::uint32_t v = 0; v < 8; ++v) {
    r.corners.push_back({mpq_class((v & 1) != 0 ? box.max.x : box.min.x),
                         mpq_class((v & 2) != 0 ? box.max.y : box.min.y),
                         mpq_class((v & 4) != 0 ? box.max.z : box.min.z)});
  }
  name_box_features(r);
  return r;
}
Pieces pieces(const ConvexPolyhedron3& polyhedron) {
  const PolygonMesh& m = polyhedron.mesh;
  Pieces r;
  std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> edges;
  for (const Point3& p : m.vertices) r.corners.push_back(exact(p));
  for (std::uint32_t f = 0; f + 1 < m.first.size(); ++f) {
    for (std::uint32_t c = m.first[f]; c < m.first[f + 1]; ++c) {
      const std::uint32_t v = m.corners[c], w = m.corners[c + 1 == m.first[f + 1] ? m.first[f] : c + 1];
      r.features[0][v] = {v};
      r.features[2][f].push_back(v);
      if (edges.insert({{std::min(v, w), std::max(v, w)}, c}).second) r.features[1][c] = {v, w};
    }
  }
  return r;
}

struct Seen {
  std::array<int, 4> kind{};
};

template <class Shape, class Point>
Seen check_shapes(std::uint64_t start, std::uint64_t cases) {
  const int each = battery::sanitized ? 4 : 1;  // stands for so many
  Seen seen;
  on_shapes(start, cases / each, [&](Material& m) {
    const auto shape = m.shape<Shape>();
    const Point p = m.probe<Point>();
    if constexpr (std::is_same_v<Shape, Aabb3>) {
      if (shape.min.x > shape.max.x || shape.min.y > shape.max.y || shape.min.z > shape.max.z) {
        EXPECT_THROW(voronoi_region(shape, p), InvalidShape);
        return;
      }
    }
    const Feature told = voronoi_region(shape, p);
    if constexpr (std::is_same_v<Shape, Triangle3>) {
      EXPECT_TRUE(oracle::is_as_near(shape, told, p).value_or(true)) << m.about(shape, p);
    }
    seen.kind[static_cast<std::size_t>(told.kind)] += each;
    EXPECT_EQ(told, told_by_rationals(pieces(shape), exact(p))) << m.about(shape, p);
  });
  return seen;
}

TEST(VoronoiRegionTest, OfSegments) {
  for (const Seen& s : {check_shapes<Segment2, Point2>(31, 400), check_shapes<Segment3, Point3>(32, 400)}) {
    EXPECT_GT(s.kind[0], 100);
    EXPECT_GT(s.kind[1], 50);
  }
}
TEST(VoronoiRegionTest, OfTriangles) {
  for (const Seen& s : {check_shapes<Triangle2, Point2>(33, 800), check_shapes<Triangle3, Point3>(34, 800)}) {
    EXPECT_GT(s.kind[0], 200);
    EXPECT_GT(s.kind[1], 100);
    EXPECT_GT(s.kind[2], 20);
  }
}
TEST(VoronoiRegionTest, OfTetrahedra) {
  const Seen s = check_shapes<Tetrahedron3, Point3>(35, 800);
  EXPECT_GT(s.kind[0], 200);
  EXPECT_GT(s.kind[1], 100);
  EXPECT_GT(s.kind[2], 50);
  EXPECT_GT(s.kind[3], 2);
}
TEST(VoronoiRegionTest, OfAxisAlignedBoxes) {
  const Seen s = check_shapes<Aabb3, Point3>(36, 400);
  EXPECT_GT(s.kind[0], 30);
  EXPECT_GT(s.kind[1], 15);
  EXPECT_GT(s.kind[2], 8);
}
TEST(VoronoiRegionTest, OfOrientedBoxes) {
  const Seen s = check_shapes<Obb3, Point3>(37, 250);
  EXPECT_GT(s.kind[0], 20);
  EXPECT_GT(s.kind[1], 20);
  EXPECT_GT(s.kind[2], 5);
}

/// A cube whose front is two faces, whose top has a corner on an edge; a double pyramid over a hexagon.
PolygonMesh cube() {
  return {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 2}},
          {0, 3, 2, 1, 4, 8, 5, 6, 7, 0, 1, 8, 4, 1, 5, 8, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7},
          {0, 4, 9, 13, 16, 20, 24, 28}};
}
PolygonMesh pyramids() {
  PolygonMesh m;
  m.vertices = {{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}, {0, 0, 3}, {0, 0, -1}};
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    for (const std::uint32_t v : {i, j, 6u}) m.corners.push_back(v);
    m.first.push_back(static_cast<std::uint32_t>(m.corners.size()));
    for (const std::uint32_t v : {j, i, 7u}) m.corners.push_back(v);
    m.first.push_back(static_cast<std::uint32_t>(m.corners.size()));
  }
  return m;
}

/// The image under an integer matrix, all faces turned where it mirrors.
PolygonMesh moved(PolygonMesh m, const std::array<std::array<double, 3>, 3>& by, double determinant) {
  for (Point3& p : m.vertices) {
    const auto row = [&](std::size_t i) { return by[i][0] * p.x + by[i][1] * p.y + by[i][2] * p.z; };
    p = {row(0), row(1), row(2)};
  }
  for (std::size_t f = 0; determinant < 0 && f + 1 < m.first.size(); ++f)
    std::reverse(m.corners.begin() + m.first[f], m.corners.begin() + m.first[f + 1]);
  return m;
}

TEST(VoronoiRegionTest, OfPolyhedra) {
  Seen seen;
  for (std::uint64_t index = 0; index < 120; ++index) {
    SCOPED_TRACE(testing::Message() << "start 38 index " << index);
    Entropy entropy(38, index);
    std::array<std::array<double, 3>, 3> by{};
    for (auto& row : by) {
      for (double& x : row) x = static_cast<double>(entropy.within(3));
    }
    const double determinant = by[0][0] * (by[1][1] * by[2][2] - by[1][2] * by[2][1]) -
                               by[0][1] * (by[1][0] * by[2][2] - by[1][2] * by[2][0]) +
                               by[0][2] * (by[1][0] * by[2][1] - by[1][1] * by[2][0]);
    if (determinant == 0) continue;
    const ConvexPolyhedron3 polyhedron =
        convex_polyhedron(moved(index % 2 == 0 ? cube() : pyramids(), by, determinant));
    const Pieces exactly = pieces(polyhedron);
    const std::int64_t reach = index % 3 == 0 ? 5 : 24;
    for (int probe = 0; probe < 3; ++probe) {
      const auto half = [&] { return static_cast<double>(entropy.within(reach)) / 2; };
      const double x = half(), y = half(), z = half();
      const Point3 p{x, y, z};
      const Feature told = voronoi_region(polyhedron, p);
      ++seen.kind[static_cast<std::size_t>(told.kind)];
      EXPECT_EQ(told, told_by_rationals(exactly, exact(p))) << x << ' ' << y << ' ' << z;
      for (std::size_t kind = 0; kind < 3; ++kind) {  // from everywhere
        for (const auto& [number, corners] : exactly.features[kind])
          EXPECT_EQ(voronoi_region(polyhedron, p, Feature{static_cast<FeatureKind>(kind), number}), told);
      }
    }
  }
  EXPECT_GT(seen.kind[0], 20);
  EXPECT_GT(seen.kind[1], 20);
  EXPECT_GT(seen.kind[2], 20);
  EXPECT_GT(seen.kind[3], 10);
}

// A thin slab: the walk comes to the upper face while p is below the lower one.
// Above a vertex of a straight edge, of which all edges lead away from p, and the face toward it.
TEST(VoronoiRegionTest, StraightCornersDoNotHoldTheWalk) {
  const ConvexPolyhedron3 polyhedron = convex_polyhedron(cube());
  for (const Point3& p : {Point3{1, 1, 3}, Point3{1, 0.5, 2}, Point3{1, 3, 9}, Point3{1, -1, 3}, Point3{1, 0, 1}}) {
    const Feature expected = told_by_rationals(pieces(polyhedron), exact(p));
    for (std::uint32_t c = 0; c < polyhedron.mesh.corners.size(); ++c)
      EXPECT_EQ(voronoi_region(polyhedron, p, Feature{FeatureKind::edge, c}), expected) << c;
    EXPECT_EQ(voronoi_region(polyhedron, p, Feature{FeatureKind::vertex, 8}), expected);
  }
}

TEST(VoronoiRegionTest, ThinPolyhedraDoNotHoldTheWalk) {
  PolygonMesh m = cube();
  for (Point3& p : m.vertices) p.z *= 0x1p-60;
  const ConvexPolyhedron3 slab = convex_polyhedron(m);
  EXPECT_EQ(voronoi_region(slab, {1, 1, -1}, Feature{FeatureKind::face, 1}), (Feature{FeatureKind::face, 0}));
  EXPECT_EQ(voronoi_region(slab, {1, 1, 1}, Feature{FeatureKind::face, 0}), (Feature{FeatureKind::face, 1}));
  EXPECT_EQ(voronoi_region(slab, {1, 1, 0x1p-60}), (Feature{FeatureKind::interior, 0}));
}

// Figure 3.24: seven regions of a triangle; and their boundaries, which belong to the lower dimension.
TEST(VoronoiRegionTest, SevenRegionsOfATriangle) {
  const Triangle2 t{{0, 0}, {6, 0}, {2, 4}};
  using enum FeatureKind;
  const std::vector<std::pair<Point2, Feature>> known{
      {{2, 1}, {face, 0}},     {{3, -2}, {edge, 0}},   {{6, 3}, {edge, 1}},    {{-1, 3}, {edge, 2}},
      {{-2, -1}, {vertex, 0}}, {{9, -1}, {vertex, 1}}, {{2, 7}, {vertex, 2}},   // each inside its region
      {{0, -3}, {vertex, 0}},  {{6, -3}, {vertex, 1}}, {{4, 6}, {vertex, 2}},   // on the line between two
      {{3, 0}, {edge, 0}},     {{0, 0}, {vertex, 0}},  {{-4, 2}, {vertex, 0}},  // on the triangle; on the other line
  };
  for (const auto& [p, feature] : known) {
    EXPECT_EQ(voronoi_region(t, p), feature) << p.x << ' ' << p.y;
    const auto lift = [](const Point2& q) { return Point3{q.y, q.x, 1}; };
    EXPECT_EQ(voronoi_region(Triangle3{lift(t.a), lift(t.b), lift(t.c)}, Point3{p.y, p.x, 77}), feature);
  }
}

// Figure 5.6: the angle at a is obtuse; p lies beyond the line ab, within the ends of neither, and yet nearest to ca.
TEST(VoronoiRegionTest, BesideAnObtuseCorner) {
  const Triangle2 t{{0, 0}, {4, 0}, {-8, 1}};
  EXPECT_EQ(voronoi_region(t, {-3, -2}), (Feature{FeatureKind::edge, 2}));
  EXPECT_EQ(voronoi_region(t, {-0.25, -2}), (Feature{FeatureKind::vertex, 0}));  // on the line between both regions
  EXPECT_EQ(voronoi_region(t, {-0.25 - 0x1p-54, -2}), (Feature{FeatureKind::edge, 2}));
  EXPECT_EQ(voronoi_region(t, {0, -2}), (Feature{FeatureKind::vertex, 0}));
  EXPECT_EQ(voronoi_region(t, {0x1p-1074, -2}), (Feature{FeatureKind::edge, 0}));
}

// Figure 3.25: an edge, a vertex and a face of a cube, by the numbers the header gives them.
TEST(VoronoiRegionTest, ThreeKindsOfRegionsOfACube) {
  const Aabb3 box{{-1, -1, -1}, {1, 1, 1}};
  const Obb3 same{{0, 0, 0}, {{{2, 0, 0}, {0, -1, 0}, {0, 0, 1}}}, {0.5, -1, 1}};
  using enum FeatureKind;
  EXPECT_EQ(voronoi_region(box, {0, 3, 4}), (Feature{edge, 4 * 0 + 1 + 2}));
  EXPECT_EQ(voronoi_region(box, {-3, 0, 4}), (Feature{edge, 4 * 1 + 0 + 2}));
  EXPECT_EQ(voronoi_region(box, {5, -1, 0}), (Feature{edge, 4 * 2 + 1 + 0}));
  EXPECT_EQ(voronoi_region(box, {5, -5, 5}), (Feature{vertex, 1 + 0 + 4}));
  EXPECT_EQ(voronoi_region(box, {0, -5, 0}), (Feature{face, 2}));
  EXPECT_EQ(voronoi_region(box, {0, 0, 1}), (Feature{face, 5}));
  EXPECT_EQ(voronoi_region(box, {0, 0, 0.5}), (Feature{interior, 0}));
  EXPECT_EQ(voronoi_region(same, {0, 3, 4}), (Feature{edge, 2}));  // its second axis points down
  EXPECT_EQ(voronoi_region(same, {5, -5, 5}), (Feature{vertex, 7}));
  EXPECT_EQ(voronoi_region(same, {0, 0, 0.5}), (Feature{interior, 0}));
  EXPECT_EQ(voronoi_region(Aabb3{{0, 0, 0}, {1, 1, 0}}, {0.5, 0.5, 9}), (Feature{face, 4}));  // flat: the lower one
}

TEST(VoronoiRegionTest, CollapsedTriangles) {
  using enum FeatureKind;
  const Triangle3 segment{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};  // c on ab
  EXPECT_EQ(voronoi_region(segment, {2, 5, 5}), (Feature{edge, 0}));
  EXPECT_EQ(voronoi_region(segment, {1, 5, 5}), (Feature{vertex, 2}));
  EXPECT_EQ(voronoi_region(segment, {9, 5, 5}), (Feature{vertex, 1}));
  EXPECT_EQ(voronoi_region(Triangle3{}, {1, 2, 3}), (Feature{vertex, 0}));
}

/// Of a cube whose faces are cut into triangles at their middles: those are corners within flat parts of it.
TEST(VoronoiRegionTest, WhatIsBelowAFlatPartIsNotInItsRegion) {
  std::vector<Point3> points;
  for (const double x : {0, 1, 2}) {
    for (const double y : {0, 1, 2}) {
      for (const double z : {0, 1, 2}) points.push_back({x, y, z});
    }
  }
  points.erase(points.begin() + 13);  // the middle of all
  const Hull3 hull = convex_hull(points, {.triangulate = true, .all_boundary_points = true});
  const ConvexPolyhedron3 solid = convex_polyhedron(hull, points);
  int inside = 0;
  for (const double x : {-1.0, 0.5, 1.0, 2.0, 3.0}) {
    for (const double y : {-1.0, 0.0, 1.0, 1.5}) {
      for (const double z : {-0.5, 0.25, 1.0, 2.5}) {
        const Point3 p{x, y, z};
        const Feature wanted = voronoi_region(solid, p);
        EXPECT_EQ(wanted.kind == FeatureKind::interior, locate(solid, p) == Location::inside) << x << y << z;
        inside += wanted.kind == FeatureKind::interior ? 1 : 0;
        for (std::uint32_t c = 0; c < solid.mesh.corners.size(); ++c) {
          EXPECT_EQ(voronoi_region(solid, p, Feature{FeatureKind::edge, c}), wanted);
          EXPECT_EQ(voronoi_region(solid, p, Feature{FeatureKind::vertex, solid.mesh.corners[c]}), wanted);
        }
      }
    }
  }
  EXPECT_EQ(inside, 8);
}

TEST(VoronoiRegionTest, BadInputIsNamed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Obb3 box{{0, 0, 0}, {{{1, 0, 0}, {0, inf, 0}, {0, 0, 1}}}, {1, 1, 1}};
  EXPECT_THAT(text_of<NonFinite>([&] { voronoi_region(box, Point3{}); }),
              HasSubstr("voronoi_region: obb.axes[1].y is inf"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                voronoi_region(Segment2{{0, nan}, {}}, Point2{});
              }),
              HasSubstr("segment.a.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                voronoi_region(Aabb3{{1, 0, 0}, {0, 1, 1}}, Point3{});
              }),
              HasSubstr("the box is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] { voronoi_region(ConvexPolyhedron3{}, Point3{}); }), HasSubstr("no faces"));
  const ConvexPolyhedron3 polyhedron = convex_polyhedron(cube());
  EXPECT_THAT(text_of<NonFinite>([&] { voronoi_region(polyhedron, Point3{0, -inf, 0}); }), HasSubstr("p.y is -inf"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                voronoi_region(polyhedron, {}, Feature{FeatureKind::edge, 28});
              }),
              HasSubstr("has no edge 28 to start from"));
}

}  // namespace
}  // namespace plumb
