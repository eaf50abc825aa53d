// Convex polyhedra: the figures of RTCD 3.8, the extruded pentagram, and random ones made and broken.
#include "plumb/figure/basic/polyhedron.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "degenerate/rational_signs.hpp"
#include "figure/basic/rational_polygon.hpp"
#include "figure/basic/shape_cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

using shape_cases::Material;
using shape_cases::on_shapes;
using Faces = std::vector<std::vector<std::uint32_t>>;

PolygonMesh mesh_of(std::vector<Point3> vertices, const Faces& faces) {
  PolygonMesh mesh{std::move(vertices), {}, {0}};
  for (const auto& f : faces) {
    mesh.corners.insert(mesh.corners.end(), f.begin(), f.end());
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

std::string refusal(const PolygonMesh& mesh) {
  return text_of<Error>([&] { convex_polyhedron(mesh); });
}

/// A chain of points as the floor (z = 0), and again as the roof (z = 1); walls, and the two caps given as faces of
/// corners of the chain, counterclockwise.  `inner` points lie in both caps, after the chain's.
PolygonMesh prism(const std::vector<Point2>& chain, const Faces& cap, const std::vector<Point2>& inner = {}) {
  std::vector<Point3> vertices;
  for (const double z : {0.0, 1.0}) {
    for (const Point2& p : chain) vertices.push_back({p.x, p.y, z});
    for (const Point2& p : inner) vertices.push_back({p.x, p.y, z});
  }
  const auto n = static_cast<std::uint32_t>(chain.size()), up = static_cast<std::uint32_t>(vertices.size() / 2);
  Faces faces;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    faces.push_back({i, j, j + up, i + up});
  }
  for (const auto& f : cap) {
    faces.emplace_back(f.rbegin(), f.rend());
    faces.emplace_back(f);
    for (auto& v : faces.back()) v += up;
  }
  return mesh_of(std::move(vertices), faces);
}

const std::vector<Point2> kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
// A star that turns to the left alone.
const std::vector<Point2> kPentagram{{0, 100}, {-59, -81}, {95, 31}, {-95, 31}, {59, -81}};

PolygonMesh cube() { return prism(kSquare, {{0, 1, 2, 3}}); }

PolygonMesh reversed(PolygonMesh mesh) {
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f)
    std::reverse(mesh.corners.begin() + mesh.first[f], mesh.corners.begin() + mesh.first[f + 1]);
  return mesh;
}

TEST(Figure3_19, ConvexAndConcave) {
  const SurfaceConvexity said = convexity(cube());
  EXPECT_TRUE(said.is_convex() && said.strictly);
  const ConvexPolyhedron3 solid = convex_polyhedron(cube());
  EXPECT_EQ(solid.across.size(), 24u);
  EXPECT_EQ(solid.across[0], 4u);  // below the first wall lies the floor
  for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(solid.neighbors_of(v).size(), 3u);
  EXPECT_EQ(std::vector(solid.neighbors_of(0).begin(), solid.neighbors_of(0).end()),
            (std::vector<std::uint32_t>{1, 3, 4}));
  // An L: all faces convex or triangulated, one ridge concave.
  const std::vector<Point2> ell{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const PolygonMesh concave = prism(ell, {{0, 1, 2, 3}, {0, 3, 4, 5}});
  EXPECT_EQ(convexity(concave).flaw, SurfaceFlaw::concave_ridge);
  EXPECT_EQ(refusal(concave),
            "convex_polyhedron: the ridge between face 2 and face 3, the edge from vertex 3 to vertex 9, is concave");
  EXPECT_EQ(refusal(prism(ell, {{0, 1, 2, 3, 4, 5}})),
            "convex_polyhedron: face 6 is not a convex polygon of distinct corners that has an area");
}

TEST(Figure3_19, AStraightEdgesVertexHasNeighborsOffItsLine) {
  // Vertex 8 halves an edge of the roof, in both faces there: its edges alone span no more than their line.
  PolygonMesh mesh = cube();
  std::vector<std::uint32_t> corners, first{0};
  mesh.vertices.push_back({1, 0, mesh.vertices[4].z});
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
    for (std::uint32_t c = mesh.first[f]; c < mesh.first[f + 1]; ++c) {
      const std::uint32_t a = mesh.corners[c], b = mesh.corners[c + 1 < mesh.first[f + 1] ? c + 1 : mesh.first[f]];
      corners.push_back(a);
      if ((a == 4 && b == 5) || (a == 5 && b == 4)) corners.push_back(8);
    }
    first.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  const ConvexPolyhedron3 solid = convex_polyhedron(PolygonMesh{mesh.vertices, corners, first});
  const auto neighbors = solid.neighbors_of(8);
  ASSERT_EQ(neighbors.size(), 4u);
  for (const double way : {1.0, -1.0}) {
    const auto is_before = [&](std::uint32_t v) {
      const Point3 &p = solid.mesh.vertices[v], &from = solid.mesh.vertices[8];
      return (p.y - from.y) + way * (p.z - from.z) > 0;
    };
    EXPECT_TRUE(std::ranges::any_of(neighbors, is_before)) << way;
  }
  for (std::size_t v : {0u, 4u, 5u}) EXPECT_EQ(solid.neighbors_of(v).size(), 3u);
}

TEST(Figure3_19, AFlatVertexHasANeighborOffItsPlane) {
  for (std::uint64_t start = 0; start < 4; ++start) {
    Entropy entropy(start, 3);
    const std::vector<Point3> points = cloud3(Cloud::lattice, 125, entropy);
    const Hull3 hull = convex_hull(points, {.triangulate = true, .all_boundary_points = true});
    const ConvexPolyhedron3 solid = convex_polyhedron(hull, points);
    // Along every axis, what has no neighbor farther is farthest of all.
    for (const Vector3& d : {Vector3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
      const auto along = [&](std::size_t v) {
        const Point3& p = solid.mesh.vertices[v];
        return p.x * d.x + p.y * d.y + p.z * d.z;
      };
      double most = along(0);
      for (std::size_t v = 0; v < solid.mesh.vertices.size(); ++v) most = std::max(most, along(v));
      for (std::size_t v = 0; v < solid.mesh.vertices.size(); ++v) {
        const auto neighbors = solid.neighbors_of(v);
        EXPECT_TRUE(std::ranges::is_sorted(neighbors));
        const bool is_top = std::ranges::none_of(neighbors, [&](std::uint32_t w) { return along(w) > along(v); });
        EXPECT_EQ(is_top, along(v) == most);
      }
    }
  }
}

TEST(Figure3_20, Simplices) {
  const std::vector<Point3> v{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Faces faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(convexity(mesh_of(v, faces)).strictly);
  const TriangleMesh triangles{v, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_TRUE(is_convex(triangles));
  EXPECT_EQ(convex_polyhedron(triangles).across, (std::vector<std::uint32_t>{3, 2, 1, 0, 2, 3, 0, 3, 1, 0, 1, 2}));
  const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, triangles.triangles};
  EXPECT_EQ(convexity(flat).flaw, SurfaceFlaw::no_volume);
  EXPECT_EQ(convexity(TriangleMesh{}).flaw, SurfaceFlaw::no_volume);
}

TEST(ExtrudedPentagram, IsRefusedHoweverItIsCapped) {
  // Caps as stars; as five triangles around the middle, which go around it twice; as fans from a corner.
  EXPECT_EQ(convexity(prism(kPentagram, {{0, 1, 2, 3, 4}})).flaw, SurfaceFlaw::face_not_convex);
  const Faces around{{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}};
  const PolygonMesh star = prism(kPentagram, around, {{0, 0}});
  const SurfaceConvexity said = convexity(star);
  EXPECT_EQ(said.flaw, SurfaceFlaw::seen_from_behind);
  EXPECT_EQ(refusal(star), "convex_polyhedron: vertex 0 lies above face 2; all must be on or below every face");
  // V - E + F is 2, every edge has two faces, every face is convex and no ridge is concave.
  EXPECT_EQ(star.vertices.size() + star.first.size() - 1, star.corners.size() / 2 + 2);
  EXPECT_FALSE(is_convex(prism(kPentagram, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}})));
  EXPECT_FALSE(is_convex(reversed(star)));
  // The same around a pentagon is convex, not strictly.
  const std::vector<Point2> pentagon{{0, 100}, {-95, 31}, {-59, -81}, {59, -81}, {95, 31}};
  const SurfaceConvexity whole = convexity(prism(pentagon, around, {{0, 0}}));
  EXPECT_TRUE(whole.is_convex());
  EXPECT_FALSE(whole.strictly);
  // Two pyramids on a star, where no two faces lie in a plane.
  std::vector<Point3> spindle;
  for (const Point2& p : kPentagram) spindle.push_back({p.x, p.y, 0});
  spindle.push_back({0, 0, 50});
  spindle.push_back({0, 0, -50});
  Faces sides;
  for (std::uint32_t i = 0; i < 5; ++i) {
    sides.push_back({i, (i + 1) % 5, 5});
    sides.push_back({(i + 1) % 5, i, 6});
  }
  EXPECT_EQ(convexity(mesh_of(spindle, sides)).flaw, SurfaceFlaw::seen_from_behind);
}

TEST(Flaws, AreToldByName) {
  using F = SurfaceFlaw;
  PolygonMesh mesh = cube();
  mesh.vertices.push_back({1, 1, 1});
  EXPECT_EQ(refusal(mesh), "convex_polyhedron: vertex 8 belongs to no face; leave it out");
  mesh = cube();
  mesh.vertices[0].z = -0x1p-1074;
  EXPECT_EQ(convexity(mesh).flaw, F::face_not_planar);
  EXPECT_EQ(refusal(mesh), "convex_polyhedron: face 4 is not planar: vertex 0 is off its plane; triangulate it");
  mesh = cube();
  mesh.corners.resize(20), mesh.first.pop_back();
  EXPECT_EQ(
      refusal(mesh),
      "convex_polyhedron: the edge from vertex 5 to vertex 4 of face 0 is not shared with just one other face that "
      "passes it the other way");
  mesh = cube();
  std::reverse(mesh.corners.begin(), mesh.corners.begin() + 4);
  EXPECT_EQ(convexity(mesh).flaw, F::open_edge);
  EXPECT_EQ(refusal(reversed(cube())), "convex_polyhedron: the faces are clockwise seen from outside; reverse them");
  // Two cubes: one in the other, and apart.
  for (const double move : {0.25, 5.0}) {
    PolygonMesh two = cube();
    const PolygonMesh other = cube();
    for (const Point3& v : other.vertices) two.vertices.push_back({v.x / 2 + move, v.y / 2 + move, v.z / 2 + move});
    for (const std::uint32_t c : other.corners) two.corners.push_back(c + 8);
    for (std::size_t f = 1; f < other.first.size(); ++f) two.first.push_back(24 + other.first[f]);
    EXPECT_EQ(convexity(two).flaw, F::several_pieces);
    EXPECT_EQ(refusal(two), "convex_polyhedron: face 0 and face 6 are not joined by faces across edges");
  }
  mesh = cube();
  mesh.corners[7] = 8;
  EXPECT_EQ(refusal(mesh), "convex_polyhedron: face 1 names vertex 8, but there are 8 vertices");
  EXPECT_THROW(static_cast<void>(convexity(mesh)), InvalidShape);
  mesh = cube();
  mesh.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(mesh), "convex_polyhedron: mesh.vertices[3].y is nan, not a real number; give a finite double");
  EXPECT_EQ(refusal({{{0, 0, 0}}, {0, 0}, {0, 2}}),
            "convex_polyhedron: face 0 has fewer than three corners; leave it out");
  EXPECT_EQ(refusal({{{0, 0, 0}}, {0, 0, 0}, {0, 2}}),
            "convex_polyhedron: mesh.first does not begin with 0 and end with the number of corners");
  EXPECT_EQ(refusal(PolygonMesh{}),
            "convex_polyhedron: all vertices lie in one plane; at least a tetrahedron is wanted");
  EXPECT_THROW(locate(ConvexPolyhedron3{}, {0, 0, 0}), InvalidShape);
}

TEST(Flaws, ATowerPassedTwiceIsFoundOutByItsVertices) {
  // Every vertex lies on or below every face, and every ridge is convex or flat: the faces around the middle of a cap
  // tell.
  std::vector<Point2> twice = kSquare;
  twice.insert(twice.end(), kSquare.begin(), kSquare.end());
  const Faces around{{0, 1, 8}, {1, 2, 8}, {2, 3, 8}, {3, 4, 8}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 0, 8}};
  const PolygonMesh tower = prism(twice, around, {{1, 1}});
  EXPECT_EQ(convexity(tower).flaw, SurfaceFlaw::winds_twice);
  EXPECT_EQ(refusal(tower), "convex_polyhedron: the faces around vertex 8 go around it more than once");
  EXPECT_EQ(convexity(reversed(tower)).flaw, SurfaceFlaw::inside_out);
}

/// A cube of lattice points, each face a grid of squares or triangles: many faces in a plane, straight edges.
PolygonMesh lattice_cube(std::uint32_t n, bool triangles) {
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  PolygonMesh mesh;
  const auto vertex = [&](std::array<std::uint32_t, 3> p) {
    const auto [at, fresh] = number.try_emplace(p, static_cast<std::uint32_t>(number.size()));
    if (fresh) mesh.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
    return at->second;
  };
  const auto add = [&](std::vector<std::uint32_t> face) {
    mesh.corners.insert(mesh.corners.end(), face.begin(), face.end());
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::uint32_t side : {0u, n}) {
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto at = [&](std::uint32_t u, std::uint32_t v) {
            std::array<std::uint32_t, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = i + u;
            p[(axis + 2) % 3] = j + v;
            return vertex(p);
          };
          std::vector<std::uint32_t> q{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
          if (side == 0) std::reverse(q.begin(), q.end());
          if (triangles) {
            add({q[0], q[1], q[2]});
            add({q[0], q[2], q[3]});
          } else {
            add(q);
          }
        }
      }
    }
  }
  return mesh;
}

TEST(Coplanar, FacesMayStandBesideOneAnother) {
  for (const bool triangles : {false, true}) {
    const PolygonMesh mesh = lattice_cube(8, triangles);
    const SurfaceConvexity said = convexity(mesh);
    EXPECT_TRUE(said.is_convex()) << describe(said);
    EXPECT_FALSE(said.strictly);
    const ConvexPolyhedron3 solid = convex_polyhedron(mesh);
    EXPECT_EQ(locate(solid, {4, 4, 4}), Location::inside);
    EXPECT_EQ(locate(solid, {8, 3.5, 8}), Location::boundary);
    EXPECT_EQ(locate(solid, {8, 3.5, std::nextafter(8.0, 9)}), Location::outside);
    EXPECT_EQ(volume(solid), 512);
    EXPECT_EQ(surface_area(solid), 384);
    // A lattice point pushed in or out by the least there is.
    for (const double to : {std::nextafter(8.0, 0), std::nextafter(8.0, 9)}) {
      PolygonMesh dented = mesh;
      const auto v = std::find(mesh.vertices.begin(), mesh.vertices.end(), Point3{4, 4, 8}) - mesh.vertices.begin();
      dented.vertices[static_cast<std::size_t>(v)].z = to;
      EXPECT_FALSE(is_convex(dented));
      EXPECT_EQ(convexity(dented).flaw, triangles ? SurfaceFlaw::concave_ridge : SurfaceFlaw::face_not_planar);
    }
  }
  // A face folded back over its neighbor, in their plane: the two halves of the roof overlap.
  const std::vector<Point2> six{{0, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}};
  EXPECT_TRUE(is_convex(prism(six, {{0, 1, 2, 3, 4}})));
  EXPECT_TRUE(is_convex(prism(six, {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}})));
  std::vector<Point2> folded = six;
  folded[3] = {3, 2};
  EXPECT_FALSE(is_convex(prism(folded, {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}})));
}

/// The hull of some points by brute force: every plane of three of them that leaves none above.
TriangleMesh brute_hull(const std::vector<Point3>& p) {
  TriangleMesh mesh{p, {}};
  const auto n = static_cast<std::uint32_t>(p.size());
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = 0; b < n; ++b) {
      for (std::uint32_t c = 0; c < n; ++c) {
        if (a == b || b == c || c == a || a > b || a > c || collinear(p[a], p[b], p[c])) continue;
        bool hull = true;
        for (std::uint32_t d = 0; d < n && hull; ++d)
          hull = d == a || d == b || d == c || orient3d(p[a], p[b], p[c], p[d]) == Sign::positive;
        if (hull) mesh.triangles.push_back({a, b, c});
      }
    }
  }
  return mesh;
}

/// Rationals: is p below, on or above the planes of all faces?
Location slow_location(const TriangleMesh& mesh, const Point3& p) {
  bool on = false;
  for (const auto& t : mesh.triangles) {
    plumb_test::Matrix m;
    for (const Point3& q : {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]], p})
      m.push_back({mpq_class(q.x), mpq_class(q.y), mpq_class(q.z), 1});
    const int sign = plumb_test::sign_of_determinant(m);
    if (sign < 0) return Location::outside;
    on = on || sign == 0;
  }
  return on ? Location::boundary : Location::inside;
}

TEST(RandomHulls, AreConvexUntilTheyAreBroken) {
  std::map<Location, int> seen;
  std::map<SurfaceFlaw, int> flaws;
  int hulls = 0, still = 0, no_more = 0;
  on_shapes(51, 1000, [&](Material& m) {
    std::vector<Point3> points;
    for (std::size_t n = 4 + m.below(6); n-- > 0;) points.push_back(m.point3());
    TriangleMesh hull = brute_hull(points);
    std::vector<bool> used(points.size());
    for (const auto& t : hull.triangles) {
      for (const auto v : t) used[v] = true;
    }
    const SurfaceConvexity said = convexity(hull);
    // General position on the hull: every vertex used, Euler's formula for triangles.
    const bool whole =
        std::find(used.begin(), used.end(), false) == used.end() && hull.triangles.size() == 2 * points.size() - 4;
    EXPECT_EQ(said.is_convex(), whole) << m.about() << describe(said);
    ++flaws[said.flaw];
    if (!whole) return;
    EXPECT_TRUE(said.strictly);
    ++hulls;
    const ConvexPolyhedron3 solid = convex_polyhedron(hull);
    for (std::size_t c = 0; c < solid.across.size(); ++c) {
      const TriangleMesh::Triangle &f = hull.triangles[c / 3], &g = hull.triangles[solid.across[c]];
      const std::uint32_t a = f[c % 3], b = f[(c + 1) % 3];
      const auto at = static_cast<std::size_t>(std::find(g.begin(), g.end(), b) - g.begin());
      ASSERT_LT(at, 3u);
      EXPECT_EQ(g[(at + 1) % 3], a);
    }
    EXPECT_GT(signed_volume(hull), -1e-300);
    for (int k = 0; k < 4; ++k) {
      const Point3 p = m.probe3();
      const Location said_of_p = locate(solid, p);
      EXPECT_EQ(said_of_p, slow_location(hull, p)) << m.about(p);
      EXPECT_EQ(contains(solid, p), said_of_p != Location::outside);
      ++seen[said_of_p];
    }
    // Move a vertex: the triangles are still those of the hull, or they are not convex.
    TriangleMesh moved = hull;
    moved.vertices[m.below(points.size())] = m.probe3();
    const auto sorted = [](const TriangleMesh& mesh) {
      std::vector<TriangleMesh::Triangle> all = mesh.triangles;
      for (TriangleMesh::Triangle& t : all) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      std::sort(all.begin(), all.end());
      return all;
    };
    const SurfaceConvexity now = convexity(moved);
    ++(now.is_convex() ? still : no_more);
    if (now.strictly || !now.is_convex()) {
      EXPECT_EQ(now.is_convex(), sorted(brute_hull(moved.vertices)) == sorted(hull)) << m.about() << describe(now);
    }
    ++flaws[now.flaw];
    // Flip an edge: the two triangles beside it become a concave ridge.
    TriangleMesh flipped = hull;
    const TriangleMesh::Triangle f = hull.triangles[0];
    const std::uint32_t beyond = solid.across[0];
    const TriangleMesh::Triangle g = hull.triangles[beyond];
    std::uint32_t apex = g[0];
    for (const std::uint32_t v : g) apex = v == f[0] || v == f[1] ? apex : v;
    flipped.triangles[0] = {f[2], f[0], apex};
    flipped.triangles[beyond] = {apex, f[1], f[2]};
    EXPECT_FALSE(is_convex(flipped)) << m.about();
    ++flaws[convexity(flipped).flaw];
    std::reverse(flipped.triangles[0].begin(), flipped.triangles[0].end());
    EXPECT_EQ(convexity(flipped).flaw, SurfaceFlaw::open_edge) << m.about();
  });
  EXPECT_GE(hulls, 100);
  EXPECT_GE(still, 20);
  EXPECT_GE(no_more, 20);
  EXPECT_GE(flaws[SurfaceFlaw::seen_from_behind] + flaws[SurfaceFlaw::inside_out], 1);
  EXPECT_GE(flaws[SurfaceFlaw::concave_ridge], 50);
  EXPECT_GE(seen[Location::inside], 20);
  EXPECT_GE(seen[Location::boundary], 100);
  EXPECT_GE(seen[Location::outside], 100);
}

TEST(ManyFaces, APrismOverThousandsOfCocircularPoints) {
  std::vector<Point2> circle;
  std::vector<std::uint32_t> all;
  for (std::uint32_t k = 0; k < 5000; ++k) {
    circle.push_back({std::cos(k * 0x1.921fb54442d18p+2 / 5000), std::sin(k * 0x1.921fb54442d18p+2 / 5000)});
    all.push_back(k);
  }
  EXPECT_TRUE(convexity(prism(circle, {all})).strictly);
  std::swap(circle[7], circle[8]);
  EXPECT_FALSE(is_convex(prism(circle, {all})));
  // Every second one, twice around, about the middle.
  std::vector<Point2> star;
  Faces around;
  for (std::uint32_t k = 0; k < 4999; ++k) {
    star.push_back({std::cos(k * 0x1.921fb54442d18p+3 / 4999), std::sin(k * 0x1.921fb54442d18p+3 / 4999)});
    around.push_back({k, (k + 1) % 4999, 4999});
  }
  EXPECT_FALSE(is_convex(prism(star, around, {{0, 0}})));
}

// What was filled in by hand is held against the mesh, and the first thing that differs is named.
TEST(CheckPolyhedron, NamesWhatIsWrong) {
  const ConvexPolyhedron3 good = convex_polyhedron(cube());
  EXPECT_NO_THROW(check_polyhedron(good));
  const auto refused = [&](const auto& change) -> std::string {
    ConvexPolyhedron3 p = good;
    change(p);
    return text_of<InvalidShape>([&] { check_polyhedron(p, "asked"); });
  };
  const std::string by = "; make it by convex_polyhedron";
  EXPECT_EQ(refused([](auto& p) {
              p.mesh.vertices[6] = {1, 1, 2};
            }),
            "asked: face 1 is not planar: vertex 5 is off its plane; triangulate it");
  EXPECT_EQ(refused([](auto& p) { p.mesh.corners[5] = 99; }),
            "asked: face 1 names vertex 99, but there are 8 vertices");
  EXPECT_EQ(refused([](auto& p) { p.across.pop_back(); }), "asked: polyhedron.across has 23 faces for 24 corners" + by);
  EXPECT_EQ(refused([](auto& p) { p.across[2] = 77; }),
            "asked: polyhedron.across[2] is face 77, but beyond the edge that leaves vertex 5 there is face 5" + by);
  EXPECT_NE(refused([](auto& p) { p.first_neighbor.clear(); }).find("first_neighbor does not divide"),
            std::string::npos);
  EXPECT_NE(refused([](auto& p) { p.first_neighbor[3] = 90; }).find("first_neighbor does not divide"),
            std::string::npos);
  EXPECT_EQ(refused([](auto& p) { p.neighbors[0] = 8; }),
            "asked: vertex 0 has the neighbor 8, but there are 8 vertices" + by);
  // 0 has 1, 3 and 4.
  EXPECT_EQ(refused([](auto& p) { p.neighbors[0] = 6; }),
            "asked: vertex 0 has the neighbor 6, but not the other way round: vertex 6 has not the neighbor 0" + by);
  EXPECT_EQ(refused([](auto& p) { p.neighbors[0] = 3; }),
            "asked: vertex 0 lacks the neighbor 1, which it has in the mesh" + by);
  EXPECT_EQ(refused([](auto& p) { std::swap(p.neighbors[0], p.neighbors[1]); }),
            "asked: the neighbors of vertex 0 are not each named once, in ascending order" + by);
  const auto other_edge = [](auto& p) { p.neighbors[1] = 6, p.neighbors[p.first_neighbor[6] + 1] = 0; };
  EXPECT_EQ(refused(other_edge), "asked: vertex 0 has the neighbor 6, which it has not in the mesh" + by);
  const PolygonMesh dent = prism({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}, {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}});
  EXPECT_NE(
      refused([&](auto& p) { p.mesh = dent; }).find("asked: the ridge between face 2 and face 3, the edge from vertex"),
      std::string::npos);
}

TEST(CheckPolyhedron, TakesWhatIsMade) {
  on_shapes(611, 100, [](Material& m) {
    std::vector<Point3> points;
    for (int i = 0; i < 8; ++i) points.push_back(m.point3());
    const Hull3 hull = convex_hull(points);
    if (hull.dimension != 3) return;
    EXPECT_NO_THROW(check_polyhedron(convex_polyhedron(hull, points))) << m.about();
  });
}

}  // namespace
}  // namespace plumb
