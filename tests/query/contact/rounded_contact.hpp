// Is a manifold the exact contact, each number rounded once?
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "plumb/query/contact/contact.hpp"
#include "query/convex/nearest_pair.hpp"
#include "query/penetration/told_checks.hpp"

namespace plumb {

inline void expect_rounded(const ContactManifold& m, const ExactContact& e, const std::string& about) {
  using told_checks::big, told_checks::gmp, told_checks::is_nearest_to, query::dot, query::Exact3;
  const auto exact = [](const RationalPoint3& p) { return Exact3{gmp(p.x), gmp(p.y), gmp(p.z)}; };
  const Exact3 n = gmp(e.direction);
  const mpf_class length = sqrt(big(dot(n, n)));
  const mpq_class r_a = gmp(e.radius_a), r_b = gmp(e.radius_b);
  EXPECT_EQ(m.relation, e.relation) << about;
  EXPECT_TRUE(is_nearest_to(m.distance, big(gmp(e.along)) * length - big(r_a + r_b))) << about;
  const auto expect_point = [&](const Point3& p, const RationalPoint3& core, const mpq_class& radius) {
    const Exact3 x = exact(core);
    const std::array told{p.x, p.y, p.z};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(is_nearest_to(told[k], big(x[k]) + big(radius) * big(n[k]) / length)) << about << " coordinate " << k;
    }
  };
  const std::array normal{m.normal.x, m.normal.y, m.normal.z};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(is_nearest_to(normal[k], big(n[k]) / length)) << about;
  ASSERT_EQ(m.corners.size(), e.corners.size()) << about;
  for (std::size_t i = 0; i < e.corners.size(); ++i) {
    const ExactContactCorner& k = e.corners[i];
    EXPECT_EQ(m.corners[i].id, k.id) << about;
    if (i > 0) {
      EXPECT_LT(e.corners[i - 1].id, k.id) << about;
    }
    EXPECT_TRUE(is_nearest_to(m.corners[i].distance, big(gmp(k.along)) * length - big(r_a + r_b))) << about;
    expect_point(m.corners[i].on_a, k.on_a, r_a), expect_point(m.corners[i].on_b, k.on_b, -r_b);
  }
}

}  // namespace plumb
