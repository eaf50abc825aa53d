// First hits of polygons in space: against rationals, and by hand.
//
// A line is in a polygon at a time that is that of its plane, or of an edge; of all of these the first that the polygon
// holds is the answer, where holding is told by a winding number in rationals.
#include <gtest/gtest.h>

#include <algorithm>

#include "figure/basic/thrown.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/ray/cases.hpp"
#include "query/ray/oracle.hpp"

namespace plumb {
namespace {

using namespace ray_cases;
namespace oracle = ray_oracle;
using oracle::Coordinates, oracle::Path, oracle::Rational;

using Chains = std::vector<std::vector<Coordinates>>;
Chains chains_of(const Polygon3& p) {
  Chains all(1);
  for (const Point3& v : p.vertices) all[0].push_back(exact::of(v));
  return all;
}
Chains chains_of(const HoledPolygon3& p) {
  Chains all = chains_of(p.outer);
  for (const Polygon3& hole : p.holes) all.push_back(chains_of(hole)[0]);
  return all;
}

bool on_edge(const Coordinates& a, const Coordinates& b, const Coordinates& x) {
  return exact::square(oracle::cross(exact::difference(b, a), exact::difference(x, a))) == 0 &&
         exact::dot(exact::difference(a, x), exact::difference(b, x)) <= 0;
}

struct Outline {
  /// The normal is that of the first corner, the first beside it, and the first that is not on their line.
  explicit Outline(Chains c) : chains(std::move(c)) {
    const Coordinates& a = chains[0][0];
    std::optional<Coordinates> along;
    each_edge([&](const Coordinates& corner, const Coordinates&, std::uint32_t) {
      const Coordinates way = exact::difference(corner, a);
      if (!along && exact::square(way) != 0) along = way;
      if (!along || normal) return;
      if (const Coordinates n = oracle::cross(*along, way); exact::square(n) != 0) normal = n;
    });
  }
  template <class F>
  void each_edge(F f) const {
    std::uint32_t first = 0;
    for (const auto& chain : chains) {
      const auto n = static_cast<std::uint32_t>(chain.size());
      for (std::uint32_t i = 0; i < n; ++i) f(chain[i], chain[(i + 1) % n], first + i);
      first += n;
    }
  }
  /// Of the lowest dimension, then number; nothing for a point that is not held.
  [[nodiscard]] std::optional<Feature> holder(const Coordinates& x) const {
    std::optional<Feature> found;
    const auto take = [&](FeatureKind kind, std::uint32_t i) {
      if (!found || std::pair(kind, i) < std::pair(found->kind, found->index)) found = Feature{kind, i};
    };
    each_edge([&](const Coordinates& a, const Coordinates& b, std::uint32_t i) {
      if (a == x) take(FeatureKind::vertex, i);
      if (on_edge(a, b, x)) take(FeatureKind::edge, i);
    });
    if (found) return found;
    if (!normal || exact::dot(*normal, exact::difference(x, chains[0][0])) != 0) return {};
    // Edges that a ray of the plane passes: along one axis, where the normal's largest part is left out.
    std::size_t left_out = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (abs((*normal)[k]) > abs((*normal)[left_out])) left_out = k;
    }
    const std::size_t u = (left_out + 1) % 3, v = (left_out + 2) % 3;
    bool odd = false;
    each_edge([&](const Coordinates& a, const Coordinates& b, std::uint32_t) {
      if ((a[v] > x[v]) == (b[v] > x[v])) return;
      if (a[u] + (x[v] - a[v]) * (b[u] - a[u]) / (b[v] - a[v]) > x[u]) odd = !odd;
    });
    if (odd) found = Feature{FeatureKind::face, 0};
    return found;
  }

  Chains chains;
  std::optional<Coordinates> normal;
};

/// Near to the corners, the middles of two, and centers of three.
Point3 probe(Material& m, const std::vector<Point3>& corners) {
  const auto any = [&] { return corners[m.below(corners.size())]; };
  const Point3 a = any(), b = any(), c = any();
  switch (m.below(5)) {
    case 0:
      return a;
    case 1:
      return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
    case 2:
      return {a.x / 2 + b.x / 4 + c.x / 4, a.y / 2 + b.y / 4 + c.y / 4, a.z / 2 + b.z / 4 + c.z / 4};
    default:
      return m.point3();
  }
}
AnyRay ray_at(Material& m, const std::vector<Point3>& corners) {
  const Point3 origin = probe(m, corners), target = probe(m, corners);
  if (m.below(3) == 0) return Segment3{origin, m.below(8) == 0 ? origin : target};
  Vector3 d = toward(origin, target);
  if (m.below(6) == 0) d = {0, 0, d.z};
  if (m.below(2) == 0) return Line3{origin, d};
  return Ray3{origin, d};
}
std::vector<Point3> corners_of(const Polygon3& p) { return p.vertices; }
std::vector<Point3> corners_of(const HoledPolygon3& p) {
  std::vector<Point3> all = p.outer.vertices;
  for (const Polygon3& hole : p.holes) all.insert(all.end(), hole.vertices.begin(), hole.vertices.end());
  return all;
}

template <class Polygon>
void check(std::uint64_t start, std::uint64_t cases, Tally& tally) {
  on_shapes(start, cases, [&](Material& m) {
    const auto polygon = pair_cases::figure<Polygon>(m);
    for (int k = 0; k < 3; ++k) {
      const AnyRay ray = ray_at(m, corners_of(polygon));
      const std::string about = m.about() + " " + text_of(ray);
      const Path path(ray);
      const Outline outline(chains_of(polygon));
      std::vector<Rational> times;
      if (path.begins || path.is_point()) times.emplace_back(0);
      if (!path.is_point()) {
        if (outline.normal && exact::dot(*outline.normal, path.direction) != 0) {
          times.push_back(exact::dot(*outline.normal, exact::difference(outline.chains[0][0], path.origin)) /
                          exact::dot(*outline.normal, path.direction));
        }
        outline.each_edge([&](const Coordinates& a, const Coordinates& b, std::uint32_t) {
          const Coordinates x = oracle::cross(path.direction, exact::difference(b, a));
          if (exact::square(x) != 0)
            times.push_back(exact::dot(oracle::cross(exact::difference(a, path.origin), exact::difference(b, a)), x) /
                            exact::square(x));
          times.push_back(exact::dot(exact::difference(a, path.origin), path.direction) /
                          exact::square(path.direction));
        });
      }
      std::sort(times.begin(), times.end());
      std::optional<Rational> t;
      for (const Rational& x : times) {
        if (!t && path.has(x) && outline.holder(path.at(x))) t = x;
      }
      const auto hit = first_hit(ray, polygon);
      tally.count(hit);
      const auto parameter = first_hit_parameter(ray, polygon);
      ASSERT_EQ(hit.has_value(), t.has_value()) << about;
      ASSERT_EQ(parameter.has_value(), t.has_value()) << about;
      ASSERT_EQ(hits(ray, polygon), t.has_value()) << about;
      if (!t) continue;
      EXPECT_EQ(parameter->base.value().value, *t) << about;
      EXPECT_TRUE(oracle::is_nearest(hit->t, *t)) << about;
      EXPECT_TRUE(oracle::is_nearest(hit->point, path.at(*t))) << about;
      EXPECT_EQ(hit->feature, *outline.holder(path.at(*t))) << about;
      EXPECT_TRUE(oracle::is_nearest(hit->normal, outline.normal.value_or(exact::of(Vector3{0, 0, 0})))) << about;
    }
  });
}

TEST(FirstHitPolygon, IsTheFirstOfAllCandidates) {
  Tally tally;
  check<Polygon3>(721, 700, tally);
  std::printf("%ld misses, %ld vertices, %ld edges, %ld faces\n", tally.misses, tally.vertices, tally.edges,
              tally.faces);
  for (const long n : {tally.misses, tally.vertices, tally.edges, tally.faces}) EXPECT_GT(n, 0);
}

TEST(FirstHitPolygon, WithHolesIsTheFirstOfAllCandidates) {
  Tally tally;
  check<HoledPolygon3>(722, 300, tally);
  std::printf("%ld misses, %ld vertices, %ld edges, %ld faces\n", tally.misses, tally.vertices, tally.edges,
              tally.faces);
  for (const long n : {tally.misses, tally.vertices, tally.edges}) EXPECT_GT(n, 0);
}

TEST(FirstHitPolygon, ByHand) {
  const Polygon3 notched{{{0, 0, 1}, {6, 0, 1}, {6, 6, 1}, {3, 3, 1}, {0, 6, 1}}};
  EXPECT_EQ(*first_hit(Ray3{{3, 1, 4}, {0, 0, -2}}, notched),
            (Hit{1.5, {3, 1, 1}, {FeatureKind::face, 0}, {0, 0, 36}}));
  EXPECT_FALSE(first_hit(Ray3{{3, 4, 4}, {0, 0, -2}}, notched));  // in the notch
  EXPECT_EQ(first_hit(Ray3{{3, 3, 4}, {0, 0, -2}}, notched)->feature, (Feature{FeatureKind::vertex, 3}));
  EXPECT_EQ(first_hit(Ray3{{3, 4, 1}, {1, 0, 0}}, notched)->feature, (Feature{FeatureKind::edge, 2}));  // in its plane
  EXPECT_EQ(first_hit(Ray3{{3, 1, 1}, {1, 0, 0}}, notched)->t, 0);
  const HoledPolygon3 frame{{{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}},
                            {{{{2, 2, 0}, {6, 2, 0}, {6, 6, 0}, {2, 6, 0}}}}};
  EXPECT_FALSE(first_hit(Ray3{{4, 4, 4}, {0, 0, -1}}, frame));
  EXPECT_EQ(first_hit(Ray3{{4, 4, 0}, {1, 0, 0}}, frame)->feature, (Feature{FeatureKind::edge, 5}));
  EXPECT_EQ(first_hit(Ray3{{6, 6, 4}, {0, 0, -1}}, frame)->feature, (Feature{FeatureKind::vertex, 6}));
  // Collinear corners, and a chain that goes there and back.
  const Polygon3 spike{{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  EXPECT_EQ(first_hit(Segment3{{6, 0, 3}, {6, 0, -3}}, spike)->feature, (Feature{FeatureKind::edge, 1}));
  EXPECT_FALSE(first_hit(Segment3{{6, 1, 3}, {6, 1, -3}}, spike));
}

TEST(FirstHitPolygon, BadInputIsNamed) {
  const Ray3 ray{{0, 0, 0}, {1, 0, 0}};
  EXPECT_THROW((void)first_hit(ray, Polygon3{{{0, 0, 0}, {1, 0, 0}}}), InvalidShape);
  EXPECT_EQ(text_of<InvalidShape>([&] {
              (void)first_hit(ray, Polygon3{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}}});
            }).find("first_hit: the polygon is not planar"),
            0u);
  EXPECT_EQ(text_of<NonFinite>([&] {
              (void)first_hit(ray, Polygon3{{{0, 0, 0}, {1, 0, 0}, {1, NAN, 0}}});
            }).find("first_hit: polygon.vertices[2].y is nan"),
            0u);
}

}  // namespace
}  // namespace plumb
