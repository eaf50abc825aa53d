// Are the contacts of a mesh in motion those of every vertex against every triangle and every edge against every edge?
#include "plumb/space/moving/motion_contacts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/query.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

using ::testing::HasSubstr;
using Contacts = std::vector<MotionContact>;
using Places = std::vector<Point3>;
using Corners = std::vector<Bvh::Corners>;

MovingMesh built(const Places& from, const Places& to, const Corners& triangles) {
  return build_moving_mesh(from, to, triangles, {.most_in_leaf = 2});
}

Contacts by_brute_force(const Places& from, const Places& to, const Corners& triangles, double separation) {
  std::set<std::uint32_t> corners;
  std::set<MovingMesh::Edge> edge_set;
  for (const auto& [a, b, c] : triangles) {
    corners.insert({a, b, c});
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
      if (p != q) edge_set.insert({std::min(p, q), std::max(p, q)});
    }
  }
  Contacts all;
  for (const std::uint32_t v : corners) {
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      if (v == a || v == b || v == c) continue;
      const Moving<Triangle3> triangle{{from[a], from[b], from[c]}, {to[a], to[b], to[c]}};
      const auto contact = first_contact(Moving<Point3>{from[v], to[v]}, triangle, {separation});
      if (contact) all.push_back({ContactPair::vertex_triangle, v, t, *contact});
    }
  }
  const std::vector<MovingMesh::Edge> edges(edge_set.begin(), edge_set.end());
  const auto edge = [&](std::size_t i) {
    const auto& [p, q] = edges[i];
    return Moving<Segment3>{{from[p], from[q]}, {to[p], to[q]}};
  };
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    for (std::uint32_t k = i + 1; k < edges.size(); ++k) {
      std::set<std::uint32_t> ends(edges[i].begin(), edges[i].end());
      ends.insert(edges[k].begin(), edges[k].end());
      if (ends.size() < 4) continue;
      const auto contact = first_contact(edge(i), edge(k), {separation});
      if (contact) all.push_back({ContactPair::edge_edge, i, k, *contact});
    }
  }
  return all;
}

Root exact_time(const MovingMesh& mesh, const MotionContact& c, double separation) {
  return c.pair == ContactPair::vertex_triangle
             ? *first_contact_time(mesh.vertex(c.a), mesh.triangle(c.b), {separation})
             : *first_contact_time(mesh.edge(c.a), mesh.edge(c.b), {separation});
}

/// Those of brute force by their exact times alone.
Contacts by_time(const MovingMesh& mesh, const Contacts& all, double separation) {
  std::vector<std::pair<Root, MotionContact>> exact;
  for (const MotionContact& c : all) exact.emplace_back(exact_time(mesh, c, separation), c);
  std::ranges::stable_sort(exact, [](const auto& x, const auto& y) { return x.first < y.first; });
  Contacts sorted;
  for (const auto& [time, c] : exact) sorted.push_back(c);
  return sorted;
}

std::size_t expect_contacts(const Places& from, const Places& to, const Corners& triangles, const std::string& about,
                            double separation = 0) {
  const MovingMesh mesh = built(from, to, triangles);
  const Contacts expected = by_brute_force(from, to, triangles, separation);
  const MotionContactOptions serial{.separation = separation, .execution = Execution::serial};
  EXPECT_EQ(contacts_in_motion(mesh, serial), expected) << about;
  const Contacts in_order = by_time(mesh, expected, separation);
  EXPECT_EQ(contacts_by_time(mesh, serial), in_order) << about;
  const auto first = first_contact(mesh, serial);
  EXPECT_EQ(first, in_order.empty() ? std::nullopt : std::optional(in_order[0])) << about;
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(contacts_in_motion(mesh, {.separation = separation}), expected) << about;
    EXPECT_EQ(first_contact(mesh, {.separation = separation}), first) << about;
  }
  return expected.size();
}

TEST(MotionContacts, AreThoseOfAllPairs) {
  std::size_t contacts = 0, moved = 0;
  shape_cases::on_shapes(991, battery::fitting(60), [&](shape_cases::Material& m) {
    const TriangleMesh mesh = meshes::soup(m, 6 + m.below(8), 2 + m.below(6));
    Places to = mesh.vertices;
    const bool still = m.below(8) == 0;
    for (Point3& p : to) p = still || m.below(3) == 0 ? p : m.point3();
    contacts += expect_contacts(mesh.vertices, to, mesh.triangles, m.about());
    moved += still ? 0 : 1;
  });
  EXPECT_TRUE(!battery::reaches_rare || contacts > 300) << contacts;
  EXPECT_TRUE(!battery::reaches_rare || moved > 30) << moved;
}

/// A sheet of 2 n^2 triangles in z = 0.
TriangleMesh sheet(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) mesh.vertices.push_back({1.0 * k, 1.0 * i, 0});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

/// Two sheets, the second above the first.
TriangleMesh two_sheets(std::uint32_t n, const Vector3& by) {
  TriangleMesh mesh = sheet(n);
  const auto vertices = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Point3& p : sheet(n).vertices) mesh.vertices.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
  for (const auto& [a, b, c] : sheet(n).triangles) mesh.triangles.push_back({a + vertices, b + vertices, c + vertices});
  return mesh;
}

TEST(MotionContacts, OfAMeshAtRestThatMeetsNothingAreNone) {
  const TriangleMesh flat = sheet(4), ring = meshes::ring(6);
  EXPECT_EQ(expect_contacts(flat.vertices, flat.vertices, flat.triangles, "sheet"), 0u);
  EXPECT_EQ(expect_contacts(ring.vertices, ring.vertices, ring.triangles, "ring"), 0u);
  Places moved = ring.vertices;
  for (Point3& p : moved) p = {p.x + 2, p.y, p.z};
  EXPECT_EQ(contacts_in_motion(built(ring.vertices, moved, ring.triangles)), Contacts{});
}

TEST(MotionContacts, OfSheetsThatLandTouchAndPass) {
  const TriangleMesh mesh = two_sheets(2, {0.25, 0.125, 1});
  const auto to = [&](double z, double lift) {
    Places places = mesh.vertices;
    for (std::size_t i = 9; i < 18; ++i) places[i].z = z;
    places[9].z += lift;
    return places;
  };
  EXPECT_EQ(expect_contacts(mesh.vertices, to(0x1p-1074, 0), mesh.triangles, "above"), 0u);
  EXPECT_GT(expect_contacts(mesh.vertices, to(0x1p-3, 0), mesh.triangles, "near", 0.125), 20u);
  const std::size_t touching = expect_contacts(mesh.vertices, to(0, 0x1p-60), mesh.triangles, "touching");
  const std::size_t landed = expect_contacts(mesh.vertices, to(0, 0), mesh.triangles, "landed");
  EXPECT_GT(landed, touching);
  EXPECT_GT(touching, 10u);
  EXPECT_GT(expect_contacts(mesh.vertices, to(-1, 0), mesh.triangles, "through"), 20u);
  const auto first = first_contact(built(mesh.vertices, to(-3, -1), mesh.triangles));
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->pair, ContactPair::vertex_triangle);  // the corner that is fastest
  EXPECT_EQ(first->a, 9u);
  EXPECT_EQ(first->contact.time, std::nextafter(0.2, 0.0));  // a fifth, rounded down
}

TEST(MotionContacts, OfASurfaceThatIsShaken) {
  const TriangleMesh ring = meshes::ring(5);
  Entropy entropy(992, 0);
  Places to = ring.vertices;
  const auto step = [&](double most) { return most * static_cast<double>(entropy.within(1 << 20)) / (1 << 20); };
  for (const double most : {0.01, 0.5}) {
    for (Point3& p : to) p = {p.x + step(most), p.y + step(most), p.z + step(most)};
    const std::size_t n = expect_contacts(ring.vertices, to, ring.triangles, "shaken");
    EXPECT_EQ(n > 20, most > 0.1) << n;
  }
}

TEST(MotionContacts, OfDegenerateTriangles) {
  // A triangle, a segment that falls through it, and a point that falls onto its edge.
  const Places from{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1}, {2, 1, 2}, {2, 0, 1}};
  const Places to{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {2, 1, 1}, {2, 0, 0}};
  const Corners triangles{{0, 1, 2}, {3, 4, 3}, {5, 5, 5}};
  EXPECT_EQ(expect_contacts(from, to, triangles, "degenerate"), 2u);
  const Contacts all = contacts_by_time(built(from, to, triangles));
  EXPECT_EQ(all[0].a, 3u);
  EXPECT_EQ(all[0].contact.time, 0.5);
  EXPECT_EQ(all[1].a, 5u);
  EXPECT_EQ(all[1].contact.time, 1);
  EXPECT_EQ(all[1].contact.feature_b, (Feature{FeatureKind::edge, 0}));
}

TEST(MovingMesh, AdvancesFromFrameToFrame) {
  const TriangleMesh mesh = two_sheets(3, {0.25, 0.125, 1});
  const auto frame = [&](int n) {
    Places places = mesh.vertices;
    for (std::size_t i = 16; i < 32; ++i) places[i].z -= 0.4 * n + 0.01 * static_cast<double>(i % 5);
    return places;
  };
  MovingMesh moving = built(mesh.vertices, frame(0), mesh.triangles);
  for (int n = 1; n < 5; ++n) {
    next_frame(moving, frame(n));
    const Contacts expected = by_brute_force(frame(n - 1), frame(n), mesh.triangles, 0);
    EXPECT_EQ(contacts_in_motion(moving), expected) << n;
    EXPECT_EQ(expected.empty(), n != 3) << n;
  }
  const double far = 0x1p70;  // another frame for the boxes
  Places away = frame(4);
  for (std::size_t i = 16; i < 32; ++i) away[i].z = -far;
  next_frame(moving, away);
  EXPECT_EQ(contacts_in_motion(moving), by_brute_force(frame(4), away, mesh.triangles, 0));
}

TEST(MovingMesh, HasEveryEdgeAndCornerOnce) {
  const Places places(7, Point3{0, 0, 0});
  const MovingMesh mesh = built(places, places, {{5, 1, 2}, {2, 1, 3}, {3, 3, 3}, {1, 1, 6}});
  EXPECT_EQ(mesh.edges, (std::vector<MovingMesh::Edge>{{1, 2}, {1, 3}, {1, 5}, {1, 6}, {2, 3}, {2, 5}}));
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{1, 2, 3, 5, 6}));
}

TEST(MotionContacts, OfNothingAreNone) {
  const MovingMesh none = built({{0, 0, 0}}, {{1, 0, 0}}, {});
  EXPECT_EQ(contacts_in_motion(none), Contacts{});
  EXPECT_EQ(contacts_by_time(none), Contacts{});
  EXPECT_EQ(first_contact(none), std::nullopt);
}

TEST(MotionContacts, NameWhatIsWrongAndStop) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Places three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)built(three, three, {{0, 1, 2}, {0, 3, 1}});
              }),
              HasSubstr("build_moving_mesh: triangles[1][1] is 3, but there are 3 vertices"));
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)built(three, {{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, {});
              }),
              HasSubstr("build_moving_mesh: to[1].y is nan"));
  EXPECT_THAT(text_of<UnequalLengths>([&] { (void)built(three, {}, {}); }),
              HasSubstr("from has length 3, to has length 0"));
  MovingMesh mesh = built(three, three, {{0, 1, 2}});
  EXPECT_THAT(text_of<UnequalLengths>([&] { next_frame(mesh, Places(2)); }),
              HasSubstr("next_frame: from has length 3"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)first_contact(mesh, {.separation = nan}); }),
              HasSubstr("first_contact: options.separation is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)contacts_in_motion(mesh, {.separation = -1}); }),
              HasSubstr("contacts_in_motion: options.separation is negative"));
  const TriangleMesh sheets = two_sheets(6, {0, 0, 1});
  Places landed = sheets.vertices;
  for (Point3& p : landed) p.z = 0;
  const MovingMesh large = built(sheets.vertices, landed, sheets.triangles);
  const auto stopped = [&] { (void)contacts_in_motion(large, {.progress = [](double) { return false; }}); };
  EXPECT_THAT(text_of<Cancelled>(stopped), HasSubstr("contacts_in_motion: cancelled"));
}

}  // namespace
}  // namespace plumb
