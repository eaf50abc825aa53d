// Are the hits of flat shapes those of real arithmetic: whether, where, on which feature, with which normal?
#include <gtest/gtest.h>

#include "plumb/arith/big.hpp"
#include "query/ray/cases.hpp"
#include "query/ray/oracle.hpp"

namespace plumb {
namespace {

using namespace ray_cases;
namespace oracle = ray_oracle;
using oracle::Coordinates, oracle::Corners, oracle::Path;

/// Up to its sign, of the face numbered so, in the order of its corners that the header tells.
Coordinates face_normal(const Corners& c, std::size_t p, std::size_t q, std::size_t r) {
  return oracle::cross(exact::difference(c[q], c[p]), exact::difference(c[r], c[p]));
}

template <class Shape>
void check_numbers(const std::string& about, const AnyRay& ray, const Shape& shape, const Hit& hit,
                   const oracle::Rational& t) {
  const Path path(ray);
  EXPECT_TRUE(oracle::is_nearest(hit.t, t)) << about << " t " << hit.t;
  EXPECT_TRUE(oracle::is_nearest(hit.point, path.at(t))) << about;
  const auto parameter = first_hit_parameter(ray, shape);
  ASSERT_TRUE(parameter) << about;
  EXPECT_EQ(parameter->base.value().value, t) << about;
  EXPECT_EQ(parameter->square.sign(), Sign::zero) << about;
}

/// Shapes that are hulls of their corners.
template <class Shape>
void check_hull(Material& m, Tally& tally) {
  const auto shape = m.shape<Shape>();
  const AnyRay ray = ray_of(m);
  const std::string about = m.about(shape) + " " + text_of(ray);
  const auto hit = first_hit(ray, shape);
  tally.count(hit);
  const Corners corners = oracle::corners_of(shape);
  const Path path(ray);
  const auto t = corners.empty() ? std::nullopt : oracle::first(path, corners);
  ASSERT_EQ(hit.has_value(), t.has_value()) << about;
  if (!hit) return;
  check_numbers(about, ray, shape, *hit, *t);
  const Feature feature = oracle::holder(corners, oracle::parts(shape), path.at(*t));
  EXPECT_EQ(hit->feature.kind, feature.kind) << about;
  EXPECT_EQ(hit->feature.index, feature.index) << about;
  if (feature.kind == FeatureKind::interior) {
    EXPECT_EQ(hit->normal, (Vector3{0, 0, 0})) << about;
  } else if constexpr (std::is_same_v<Shape, Triangle3>) {
    EXPECT_TRUE(oracle::is_nearest(hit->normal, face_normal(corners, 0, 1, 2))) << about;
  } else if constexpr (std::is_same_v<Shape, Aabb3>) {
    // Outward: no corner is farther along it than the point.
    const Coordinates n = exact::of(hit->normal);
    EXPECT_EQ(exact::square(n), 1) << about;
    for (const Coordinates& c : corners) EXPECT_LE(exact::dot(n, c), exact::dot(n, path.at(*t))) << about;
  }
}

template <class Shape>
Tally check_hulls(std::uint64_t start, std::uint64_t cases) {
  Tally tally;
  on_shapes(start, cases, [&](Material& m) { check_hull<Shape>(m, tally); });
  std::printf("start %llu: %ld misses, %ld vertices, %ld edges, %ld faces, %ld inside\n",
              static_cast<unsigned long long>(start), tally.misses, tally.vertices, tally.edges, tally.faces,
              tally.interiors);
  for (const long n : {tally.misses, tally.vertices, tally.edges, tally.faces})
    EXPECT_GT(n, static_cast<long>(cases) / 50);
  return tally;
}

TEST(FirstHit, OfTrianglesIsThatOfRationals) { check_hulls<Triangle3>(501, 3000); }
TEST(FirstHit, OfRectanglesIsThatOfRationals) { check_hulls<Rectangle3>(502, 1500); }
TEST(FirstHit, OfTetrahedraIsThatOfRationals) { EXPECT_GT(check_hulls<Tetrahedron3>(503, 1500).interiors, 30); }
TEST(FirstHit, OfAlignedBoxesIsThatOfRationals) { EXPECT_GT(check_hulls<Aabb3>(504, 500).interiors, 5); }
TEST(FirstHit, OfOrientedBoxesIsThatOfRationals) { EXPECT_GT(check_hulls<Obb3>(505, 300).interiors, 5); }

}  // namespace
}  // namespace plumb
