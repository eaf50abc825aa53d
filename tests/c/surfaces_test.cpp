// What C is told of surfaces is what C++ is told, number for number: on soups of triangles of a small grid, where all is
// degenerate, and on segments and points of such a grid.
#include <gtest/gtest.h>

#include <cstring>

#include "certify/sanitized.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/plumb.h"
#include "plumb/surface.hpp"

namespace plumb {
namespace {

constexpr std::uint64_t seed = 131;

double grid(Entropy& e) { return static_cast<double>(e.below(4)); }

TriangleMesh soup(Entropy& e) {
  TriangleMesh mesh;
  const auto vertices = static_cast<std::uint32_t>(4 + e.below(9));
  const double height = e.below(2) == 1 ? 0 : 0.5;  // half of them lie in a plane
  for (std::uint32_t i = 0; i < vertices; ++i) {
    const double x = grid(e), y = grid(e), z = grid(e) * height;
    mesh.vertices.push_back({x, y, z});
  }
  const auto vertex = [&] { return static_cast<std::uint32_t>(e.below(vertices)); };
  for (std::uint64_t t = e.below(14); t > 0; --t) {
    const std::uint32_t a = vertex(), b = vertex(), c = vertex();
    mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

/// A handle of C, released at its end.
template <class Opaque, void (*destroy)(Opaque*)>
struct Held {
  Held() = default;
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  ~Held() { destroy(it); }
  Opaque* it = nullptr;
};
using HeldMesh = Held<plumb_mesh, plumb_mesh_destroy>;

/// Fails with what C says.
void ok(plumb_status status) { ASSERT_EQ(status, PLUMB_OK) << plumb_last_error(); }

void make(const TriangleMesh& mesh, HeldMesh& held) {
  ok(plumb_mesh_create(reinterpret_cast<const double*>(mesh.vertices.data()), mesh.vertices.size(),
                       reinterpret_cast<const std::uint32_t*>(mesh.triangles.data()), mesh.triangles.size(), &held.it));
}

template <class Row>
void expect_rows(const void* told, std::size_t count, const std::vector<Row>& expected) {
  ASSERT_EQ(count, expected.size());
  EXPECT_TRUE(count == 0 || std::memcmp(told, expected.data(), count * sizeof(Row)) == 0);
}

void expect_mesh(const plumb_mesh* told, const TriangleMesh& expected) {
  const double* vertices = nullptr;
  const std::uint32_t* triangles = nullptr;
  std::size_t count = 0;
  ok(plumb_mesh_vertices(told, &vertices, &count));
  expect_rows(vertices, count, expected.vertices);
  ok(plumb_mesh_triangles(told, &triangles, &count));
  expect_rows(triangles, count, expected.triangles);
}

std::string replay(std::uint64_t round) {
  return "Entropy(" + std::to_string(seed) + ", " + std::to_string(round) + ")";
}

struct Seen {
  std::size_t loops = 0, chains = 0, merged = 0, faces = 0, apart = 0, contours = 0, changes = 0;
};

void compare_topology(const TriangleMesh& mesh, const plumb_mesh* c, Seen& seen) {
  const MeshEdges edges = find_edges(mesh);
  for (const int over : {PLUMB_OVER_MANIFOLD_EDGES, PLUMB_OVER_EDGES, PLUMB_OVER_VERTICES}) {
    const Components expected = connected_components(mesh, edges, static_cast<JoinedOver>(over));
    std::vector<std::uint32_t> of(mesh.triangles.size());
    std::size_t count = 0;
    ok(plumb_mesh_components(c, over, of.data(), &count));
    EXPECT_EQ(of, expected.of);
    EXPECT_EQ(count, expected.count);
  }
  const std::vector<SurfaceKind> kinds = surface_kinds(mesh, edges);
  std::vector<plumb_surface_kind> told(kinds.size() + 1);
  std::size_t count = 0;
  ok(plumb_mesh_surface_kinds(c, told.data(), told.size(), &count));
  ASSERT_EQ(count, kinds.size());
  for (std::size_t k = 0; k < count; ++k) {
    const SurfaceKind as{told[k].vertices, told[k].edges, told[k].faces, told[k].loops, told[k].is_orientable != 0};
    EXPECT_EQ(as, kinds[k]);
    EXPECT_EQ(told[k].euler, kinds[k].euler());
    EXPECT_EQ(told[k].genus, kinds[k].genus());
  }
  Held<plumb_loops, plumb_loops_destroy> loops;
  const plumb_loop* each = nullptr;
  ok(plumb_mesh_boundary_loops(c, &loops.it));
  ok(plumb_loops_of(loops.it, &each, &count));
  const std::vector<BoundaryLoop> expected = boundary_loops(mesh, edges);
  ASSERT_EQ(count, expected.size());
  for (std::size_t k = 0; k < count; ++k) {
    expect_rows(each[k].vertices, each[k].count, expected[k].vertices);
    EXPECT_EQ(each[k].is_closed != 0, expected[k].closed);
    ++(expected[k].closed ? seen.loops : seen.chains);
  }
}

void compare_merging(const TriangleMesh& mesh, const plumb_mesh* c, Entropy& e, Seen& seen) {
  const WeldOptions options{static_cast<double>(e.below(5)) / 4, static_cast<WeldRule>(e.below(2)),
                            static_cast<TurnedOver>(e.below(2))};
  const plumb_weld_options wanted{sizeof(plumb_weld_options), options.tolerance, static_cast<int>(options.rule),
                                  options.turned_over == TurnedOver::kept};
  const Weld weld = find_weld(mesh, options);
  HeldMesh after;
  Held<plumb_weld, plumb_weld_destroy> held;
  plumb_weld_report report{};
  report.size = sizeof report;
  ok(plumb_mesh_weld(c, &wanted, &after.it, &held.it));
  ok(plumb_weld_of(held.it, &report));
  expect_mesh(after.it, welded(mesh, weld));
  expect_rows(report.into, report.vertex_count, weld.into);
  expect_rows(report.collapsed, report.collapsed_count, weld.collapsed);
  expect_rows(report.turned, report.turned_count, weld.turned);
  expect_rows(report.refused, report.refused_count, weld.refused);
  ASSERT_EQ(report.merged_count, weld.merged.size());
  for (std::size_t k = 0; k < weld.merged.size(); ++k) {
    const plumb_merged_vertex& m = report.merged[k];
    EXPECT_EQ((MergedVertex{m.vertex, m.into, m.distance}), weld.merged[k]);
  }
  seen.merged += weld.merged.size();

  const CoplanarOptions within{static_cast<double>(e.below(3)) / 8, static_cast<CollinearVertices>(e.below(2))};
  const CoplanarFaces faces = merge_coplanar(mesh, within);
  HeldMesh fewer;
  Held<plumb_coplanar, plumb_coplanar_destroy> merged;
  plumb_coplanar_report told{};
  told.size = sizeof told;
  ok(plumb_mesh_merge_coplanar(c, within.tolerance, within.collinear == CollinearVertices::dropped, &fewer.it,
                               &merged.it));
  ok(plumb_coplanar_of(merged.it, &told));
  expect_mesh(fewer.it, triangulated(mesh, faces));
  expect_rows(told.plane, told.face_count, faces.plane);
  expect_rows(told.apart, told.apart_count, faces.apart);
  expect_rows(told.first_ring, told.face_count + 1, faces.first_ring);
  expect_rows(told.first_triangle, told.face_count + 1, faces.first_triangle);
  expect_rows(told.first_corner, told.first_ring[told.face_count] + 1, faces.first_corner);
  expect_rows(told.corners, told.first_corner[told.first_ring[told.face_count]], faces.corners);
  expect_rows(told.triangles, told.first_triangle[told.face_count], faces.triangles);
  seen.faces += faces.size();
  seen.apart += faces.apart.size();
}

void compare_sections(const TriangleMesh& mesh, const plumb_mesh* c, Entropy& e, Seen& seen) {
  std::vector<AnyPlane3> planes;
  std::vector<plumb_figure> wanted(3);
  for (plumb_figure& f : wanted) {
    const Plane3 plane{{1, grid(e), grid(e)}, grid(e)};
    planes.emplace_back(plane);
    f.size = sizeof f;
    f.kind = PLUMB_PLANE;
    f.dimension = 3;
    f.as.plane3 = {{plane.normal.x, plane.normal.y, plane.normal.z}, plane.offset};
  }
  const bool below = e.below(2) == 1;
  Held<plumb_contours, plumb_contours_destroy> held;
  const plumb_contour* each = nullptr;
  std::size_t count = 0, at = 0;
  ok(plumb_mesh_sections(c, wanted.data(), wanted.size(), below, &held.it));
  ok(plumb_contours_of(held.it, &each, &count));
  const std::vector<Section> cuts = sections(mesh, planes, below ? OnPlane::below : OnPlane::above);
  for (std::size_t plane = 0; plane < cuts.size(); ++plane) {
    const std::size_t before = at;
    for (const Contour& expected : cuts[plane].contours) {
      ASSERT_LT(at, count);
      const plumb_contour& told = each[at++];
      std::vector<Point3> points;
      for (const SectionCorner& corner : expected.corners) points.push_back(corner.nearest);
      expect_rows(told.points, told.count, points);
      EXPECT_EQ(told.plane, plane);
      EXPECT_EQ(told.depth, expected.depth);
      EXPECT_EQ(told.is_closed != 0, expected.closed);
      EXPECT_EQ(told.turn, static_cast<int>(expected.turn));
      EXPECT_EQ(told.parent, expected.parent ? static_cast<std::int64_t>(before + *expected.parent) : -1);
    }
  }
  EXPECT_EQ(at, count);
  seen.contours += count;
}

void compare_repair(const TriangleMesh& mesh, const plumb_mesh* c, Entropy& e, Seen& seen) {
  std::vector<RepairStep> plan;
  std::vector<plumb_repair_step> wanted;
  for (int i = 0; i < 4; ++i) {
    const RepairStep step{static_cast<RepairKind>(e.below(repair_kinds)),
                          static_cast<double>(e.below(3)) / 4,
                          e.below(3),
                          static_cast<WeldRule>(e.below(2)),
                          static_cast<TurnedOver>(e.below(2)),
                          static_cast<CollinearVertices>(e.below(2))};
    plan.push_back(step);
    wanted.push_back({sizeof(plumb_repair_step), step.tolerance, step.size, static_cast<int>(step.kind),
                      static_cast<int>(step.rule), step.turned_over == TurnedOver::kept,
                      step.collinear == CollinearVertices::kept});
  }
  const Repaired done = repair(mesh, plan);
  struct Told {
    std::span<const RepairChange> expected;
    std::size_t at = 0;
  } told{done.changes};
  HeldMesh mended;
  plumb_faults faults{};
  faults.size = sizeof faults;
  ok(plumb_mesh_repair_by(
      c, wanted.data(), wanted.size(), nullptr, &mended.it, &faults,
      [](const plumb_repair_change* change, void* user) {
        Told& all = *static_cast<Told*>(user);
        EXPECT_LT(all.at, all.expected.size());
        if (all.at == all.expected.size()) return 0;
        const RepairChange& expected = all.expected[all.at++];
        EXPECT_EQ(change->what, text_of(expected.kind));
        EXPECT_EQ(change->step, static_cast<int>(expected.step));
        EXPECT_EQ(change->is_left != 0, is_left(expected.kind));
        EXPECT_EQ(change->how_many, expected.count);
        EXPECT_EQ(std::memcmp(change->place, &expected.place, sizeof expected.place), 0);
        EXPECT_EQ(change->distance, expected.distance);
        return 1;
      },
      &told));
  EXPECT_EQ(told.at, done.changes.size());
  expect_mesh(mended.it, done.mesh);
  EXPECT_EQ(faults.is_sound != 0, !done.faults.any());
  EXPECT_EQ(faults.open_edges, done.faults.open_edges);
  EXPECT_EQ(faults.overlapping_pairs, done.faults.met.overlapping);
  seen.changes += done.changes.size();
}

/// A fan that goes twice around its middle becomes no polygon.
TriangleMesh winding_stair() {
  TriangleMesh mesh{{{0, 0, 0}}, {}};
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::array<double, 4> turn{1, 0, -1, 0};
    mesh.vertices.push_back({turn[i % 4], turn[(i + 3) % 4], 0});
    mesh.triangles.push_back({0, i + 1, i == 7 ? 1 : i + 2});
  }
  return mesh;
}

TEST(CSurfaces, AnswerAsTheLibraryDoes) {
  Seen seen;
  Entropy fixed(seed, 1000);
  HeldMesh stair;
  make(winding_stair(), stair);
  compare_merging(winding_stair(), stair.it, fixed, seen);
  const std::uint64_t rounds = battery::sanitized ? 150 : 600;
  for (std::uint64_t round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(replay(round));
    Entropy e(seed, round);
    const TriangleMesh mesh = soup(e);
    HeldMesh c;
    make(mesh, c);
    compare_topology(mesh, c.it, seen);
    compare_merging(mesh, c.it, e, seen);
    compare_sections(mesh, c.it, e, seen);
    compare_repair(mesh, c.it, e, seen);
  }
  EXPECT_GT(seen.loops, rounds);
  EXPECT_GT(seen.chains, rounds / 8);
  EXPECT_GT(seen.merged, rounds);
  EXPECT_GT(seen.faces, rounds);
  EXPECT_GT(seen.apart, 0U);
  EXPECT_GT(seen.contours, rounds);
  EXPECT_GT(seen.changes, rounds);
}

TEST(CSurfaces, DivideThePlaneAsTheLibraryDoes) {
  std::size_t crossings = 0, centers = 0, wound = 0;
  const std::uint64_t rounds = battery::sanitized ? 100 : 400;
  for (std::uint64_t round = 0; round < rounds && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(replay(round));
    Entropy e(seed, round);
    std::vector<Point2> points(e.below(12));
    for (Point2& p : points) {
      p.x = grid(e) * 3;
      p.y = grid(e) + static_cast<double>(e.below(2)) / 4;
    }
    const PlanarTriangulation joined = delaunay(points);
    Held<plumb_triangles, plumb_triangles_destroy> held;
    const std::uint32_t* told = nullptr;
    std::size_t count = 0;
    ok(plumb_delaunay(reinterpret_cast<const double*>(points.data()), points.size(), nullptr, 0, &held.it));
    ok(plumb_triangles_of(held.it, &told, &count));
    expect_rows(told, count, joined.triangles);
    ok(plumb_triangles_neighbors(held.it, &told, &count));
    expect_rows(told, count, joined.neighbors);
    std::vector<Point2> places(count), expected;
    for (const ExactPoint2& p : voronoi_vertices(points, joined)) expected.push_back(approximate(p));
    ok(plumb_voronoi_vertices(held.it, reinterpret_cast<double*>(places.data())));
    expect_rows(places.data(), places.size(), expected);
    centers += count;

    std::vector<Segment2> segments;  // those that go around, and others
    for (std::size_t i = 0; i < points.size(); ++i) segments.push_back({points[i], points[(i + 1) % points.size()]});
    if (points.size() > 3 && e.below(2) == 1) segments.push_back({points[0], points[2]});
    const PlanarArrangement a = arrange_segments(segments);
    Held<plumb_arrangement, plumb_arrangement_destroy> arranged;
    plumb_arrangement_report report{};
    report.size = sizeof report;
    ok(plumb_arrange_segments(reinterpret_cast<const double*>(segments.data()), segments.size(), &arranged.it));
    ok(plumb_arrangement_of(arranged.it, &report));
    std::vector<Point2> vertices;
    for (const ExactPoint2& p : a.vertices) vertices.push_back(approximate(p));
    expect_rows(report.vertices, report.vertex_count, vertices);
    expect_rows(report.ends, report.segment_count, a.ends);
    expect_rows(report.edges, report.edge_count, a.edges);
    expect_rows(report.sides, report.edge_count, a.sides);
    expect_rows(report.weights, report.edge_count, a.weights);
    expect_rows(report.triangles, report.triangle_count, a.triangles);
    expect_rows(report.face_of, report.triangle_count, a.face_of);
    EXPECT_EQ(report.face_count, a.faces);
    EXPECT_EQ(report.windings == nullptr, a.windings.empty());
    if (report.windings != nullptr) {
      expect_rows(report.windings, report.face_count, a.windings);
      ++wound;
    }
    crossings += a.vertices.size() > points.size();
  }
  EXPECT_GT(crossings, rounds / 8);
  EXPECT_GT(centers, rounds);
  EXPECT_GT(wound, rounds / 4);
}

}  // namespace
}  // namespace plumb
