// Penetration of every pair of bodies, against all planes of their difference by brute force.
#include "plumb/query/penetration/penetration.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "certify/sanitized.hpp"
#include "query/penetration/told_checks.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb {
namespace {

using namespace penetration_oracle;
using pair_cases::Material;

/// What the cases were, so that it shows that there are enough of each.
struct Seen {
  int none = 0, touching = 0, deep = 0, several = 0, apart_cores = 0, features = 0;
};

std::string features_of(const Penetration& p) {
  const auto text = [](const Feature& f) {
    return " " + std::to_string(static_cast<int>(f.kind)) + "." + std::to_string(f.index);
  };
  return text(p.feature_a) + text(p.feature_b);
}

/// Everything that the header promises, of one pair.
template <class A, class B>
void expect_penetration(const A& a, const B& b, const std::string& about, Seen& seen) {
  const Round p = round_of(a), q = round_of(b);
  const auto wanted = expected(p, q);
  const auto told = penetration(a, b), turned = penetration(b, a);
  const auto exact = exact_penetration(a, b);
  ASSERT_EQ(told.has_value(), wanted.has_value()) << about;
  ASSERT_EQ(exact.has_value(), wanted.has_value()) << about;
  ASSERT_EQ(turned.has_value(), wanted.has_value()) << about;
  if (!wanted) {
    ++seen.none;
    return;
  }
  EXPECT_EQ(told_checks::fault(*wanted, p, q, *told, *exact), "") << about;
  EXPECT_EQ(told_checks::fault_of_features(*wanted, p, q, query::body_view(a), query::body_view(b), told->feature_a,
                                           told->feature_b, seen.features),
            "")
      << about << features_of(*told);
  EXPECT_EQ(told_checks::fault_of_move(*exact, p, q), "") << about;
  EXPECT_EQ(turned->depth, told->depth) << about;
  EXPECT_EQ(turned->is_unique, told->is_unique) << about;
  if (told->is_unique) {
    EXPECT_EQ(*turned, told_checks::reversed(*told)) << about;
  }
  seen.several += told->is_unique ? 0 : 1;
  seen.apart_cores += exact->cores_are_apart ? 1 : 0;
  (told->depth == 0 ? seen.touching : seen.deep) += 1;
}

const std::uint64_t few = battery::sanitized ? 1 : 16;

template <class A, class B>
void expect_pairs(std::uint64_t start, std::uint64_t cases, Seen& seen) {
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const A a = pair_cases::figure<A>(m);
    const B b = pair_cases::near_figure<B>(m);
    try {
      static_cast<void>(query::bodies_of("", query::body_view(a), query::body_view(b)));
    } catch (const Error&) {
      return;  // an empty box, a polygon that is not convex: convex_body_test.cpp
    }
    expect_penetration(a, b, m.about(), seen);
  });
}

template <class A, class... B>
void expect_with_all(std::uint64_t start, Seen& seen) {
  (expect_pairs<A, B>(start + static_cast<std::uint64_t>(figure_kind<B>), few, seen), ...);
}

void expect_most(const Seen& seen, int each) {
  std::printf("none %d, touching %d, deep %d; several ways %d, cores apart %d, features by a point %d\n", seen.none,
              seen.touching, seen.deep, seen.several, seen.apart_cores, seen.features);
  EXPECT_GE(std::min({seen.none, seen.touching, seen.deep, seen.several, seen.features}),
            battery::sanitized ? 0 : each);
}

TEST(Penetration, OfFlatBodies) {
  Seen seen;
  expect_with_all<Point3, Point3, Segment3, Triangle3, Rectangle3, Quadrilateral3, Polygon3>(100, seen);
  expect_with_all<Segment3, Segment3, Triangle3, Rectangle3, Quadrilateral3, Polygon3>(200, seen);
  expect_with_all<Triangle3, Triangle3, Rectangle3, Quadrilateral3, Polygon3>(300, seen);
  expect_with_all<Polygon3, Rectangle3, Quadrilateral3, Polygon3>(400, seen);
  expect_most(seen, 5);
}

TEST(Penetration, OfFlatBodiesInSolids) {
  Seen seen;
  expect_with_all<Tetrahedron3, Point3, Segment3, Triangle3, Rectangle3, Quadrilateral3, Polygon3>(500, seen);
  expect_with_all<Aabb3, Point3, Segment3, Triangle3>(600, seen);
  expect_with_all<Obb3, Point3, Segment3, Triangle3>(700, seen);
  expect_with_all<ConvexPolyhedron3, Point3, Segment3, Triangle3, Quadrilateral3>(800, seen);
  expect_most(seen, 5);
}

TEST(Penetration, OfSolids) {
  Seen seen;
  expect_with_all<Tetrahedron3, Tetrahedron3, ConvexPolyhedron3>(900, seen);
  expect_pairs<Tetrahedron3, Aabb3>(910, few / 2 + 1, seen);
  expect_pairs<Tetrahedron3, Obb3>(911, few / 2 + 1, seen);
  expect_pairs<ConvexPolyhedron3, ConvexPolyhedron3>(912, few / 2 + 1, seen);
  expect_pairs<Aabb3, Obb3>(913, 1, seen);
  expect_pairs<Aabb3, Aabb3>(914, 2, seen);
  expect_most(seen, 1);
}

TEST(Penetration, OfRoundBodies) {
  Seen seen;
  expect_with_all<Sphere3, Sphere3, Point3, Segment3, Triangle3, Tetrahedron3, Aabb3, Capsule3, Lozenge3>(1000, seen);
  expect_with_all<Capsule3, Capsule3, Point3, Segment3, Triangle3, Tetrahedron3, Lozenge3, Polygon3>(1100, seen);
  expect_with_all<Lozenge3, Lozenge3, Segment3, Triangle3, Quadrilateral3>(1200, seen);
  expect_most(seen, 5);
  EXPECT_GE(seen.apart_cores, battery::sanitized ? 0 : 10);
}

}  // namespace
}  // namespace plumb
