// The laws of the signs about rays, planes, boxes, radicals and moving points, on any family, shrunk by RapidCheck.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "certify/space_cases.hpp"
#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/cross_products.hpp"
#include "plumb/certify/line_triangle.hpp"
#include "plumb/certify/moving_points.hpp"
#include "plumb/certify/radical.hpp"
#include "plumb/certify/ray_order.hpp"
#include "plumb/certify/separating_axis.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/degenerate/rapidcheck.hpp"

namespace plumb::space_cases {
namespace {

using Points = std::vector<Point3>;
using Plane = std::array<Point3, 3>;

// What refutes a property of `count` points of any family within 1500 cases, the same in every run: the shrunk points
// in hexadecimal.  Empty when nothing does.
template <class Property>
std::string refutation(std::size_t count, Property property) {
  const auto any_points = generator_of([count](Entropy& entropy) {
    const Family family = any_family(entropy);
    const Degeneracy degeneracy = degeneracies[entropy.below(degeneracies.size())];
    return entropy.below(4) == 0 ? grid_points(count, 2, entropy) : points3(family, degeneracy, count, entropy);
  });
  rc::detail::TestParams parameters;
  parameters.seed = 20'26;
  parameters.maxSuccess = static_cast<int>(1500 * more);
  const auto result = rc::detail::checkTestable([&] { property(*any_points); }, rc::detail::TestMetadata(), parameters);
  rc::detail::FailureResult failure;
  if (!result.match(failure)) return result.template is<rc::detail::SuccessResult>() ? "" : "too few cases";
  std::string told = failure.description + "\n";
  for (const auto& [type, value] : failure.counterExample) told += value + '\n';
  return told;
}

template <class Property>
void expect_law(std::size_t count, Property property) {
  EXPECT_EQ(refutation(count, property), "");
}

// Times 2^k, where that is exact for all; otherwise as they are.
Points scaled(Points points, int k) {
  Points to = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    to[i] = {std::ldexp(points[i].x, k), std::ldexp(points[i].y, k), std::ldexp(points[i].z, k)};
    if (Point3{std::ldexp(to[i].x, -k), std::ldexp(to[i].y, -k), std::ldexp(to[i].z, -k)} != points[i]) return points;
  }
  return to;
}

std::optional<Sign> opposite(std::optional<Sign> s) { return s ? std::optional(-*s) : s; }

TEST(SpaceLawsTest, EdgesOfATriangle) {
  expect_law(5, [](const Points& p) {
    const Vector3 d = vector(p[1]), back{-d.x, -d.y, -d.z};
    const EdgeSigns s = edge_signs(p[0], d, p[2], p[3], p[4]);
    RC_ASSERT(edge_signs(p[0], d, p[3], p[4], p[2]) == (EdgeSigns{s.bc, s.ca, s.ab}));
    RC_ASSERT(edge_signs(p[0], d, p[4], p[3], p[2]) == -(EdgeSigns{s.bc, s.ab, s.ca}));
    RC_ASSERT(edge_signs(p[0], back, p[2], p[3], p[4]) == -s);
    RC_ASSERT(edge_signs(p[1], p[0], p[2], p[3], p[4]) == -edge_signs(p[0], p[1], p[2], p[3], p[4]));
    const Points q = scaled(p, 7);
    RC_ASSERT(edge_signs(q[0], d, q[2], q[3], q[4]) == s);
    // Orthogonal to the normal when the three signs differ in nothing.
    if (s.ab == s.bc && s.bc == s.ca) {
      RC_ASSERT(orient_seen_from(d, p[2], p[3], p[4]) == -s.ab);
    }
  });
}

TEST(SpaceLawsTest, OrdersOfRayParametersAreTransitive) {
  expect_law(11, [](const Points& p) {
    const std::array<Plane, 3> plane{Plane{p[2], p[3], p[4]}, Plane{p[5], p[6], p[7]}, Plane{p[8], p[9], p[10]}};
    const auto order = [&](std::size_t i, std::size_t j) {
      return compare_segment_parameters(p[0], p[1], plane[i], plane[j]);
    };
    const auto ab = order(0, 1), bc = order(1, 2), ac = order(0, 2);
    RC_ASSERT(order(1, 0) == opposite(ab));
    RC_ASSERT(compare_segment_parameters(p[0], p[1], {p[4], p[2], p[3]}, {p[6], p[5], p[7]}) == ab);
    RC_ASSERT(order(0, 0).value_or(Sign::zero) == Sign::zero);
    if (!ab || !bc) return;
    RC_ASSERT(ac.has_value());
    if (*ab == *bc || *bc == Sign::zero) RC_ASSERT(*ac == *ab);
    if (*ab == Sign::zero) RC_ASSERT(*ac == *bc);
    // Between parameters and numbers likewise: the segment is met before 1 exactly when seen so from q.
    const auto at_end = compare_segment_parameter(p[0], p[1], plane[0], 1),
               from_end = compare_segment_parameter(p[1], p[0], plane[0], 0);
    RC_ASSERT(at_end == opposite(from_end));
  });
}

TEST(SpaceLawsTest, GapsOfBoxes) {
  expect_law(10, [](const Points& p) {
    const std::array w{vector(p[4]), vector(p[5]), vector(p[6]), vector(p[7])};
    const std::array half{p[8].x, p[8].y, p[8].z, p[9].x};
    const Vector3 u = vector(p[2]), v = vector(p[3]);
    const auto gap = axis_gap(p[0], p[1], u, v, w, half);
    RC_ASSERT(axis_gap(p[1], p[0], v, u, w, half) == gap);
    RC_ASSERT(axis_gap(p[0], p[1], {-u.x, -u.y, -u.z}, v, {w[3], w[1], w[2], w[0]},
                       {-half[3], half[1], -half[2], half[0]}) == gap);
    // A greater extent never widens the gap.
    auto greater = half;
    greater[2] = std::fabs(greater[2]) * 2;
    if (std::isfinite(greater[2]) && gap) {
      RC_ASSERT(axis_gap(p[0], p[1], u, v, w, greater).value() <= *gap);
    }
    RC_ASSERT(axis_gap(p[0], p[1], u, u, w, half) == std::nullopt);
  });
}

TEST(SpaceLawsTest, RadicalsGrowWithTheirTerms) {
  expect_law(2, [](const Points& p) {
    const double a = p[0].x, b = p[0].y, c = std::fabs(p[0].z), d = p[1].x, e = std::fabs(p[1].y);
    const Sign s = sign_of_radicals(a, b, c, d, e);
    RC_ASSERT(sign_of_radicals(-a, -b, c, -d, e) == -s);
    RC_ASSERT(sign_of_radicals(a, d, e, b, c) == s);
    const double more_a = moved_by_ulps(a, 1), more_e = moved_by_ulps(e, 1);
    if (std::isfinite(more_a)) RC_ASSERT(sign_of_radicals(more_a, b, c, d, e) >= s);
    if (std::isfinite(more_e)) {
      const Sign t = sign_of_radicals(a, b, c, d, more_e);
      RC_ASSERT((d > 0 ? t >= s : d < 0 ? t <= s : t == s));
    }
    RC_ASSERT(sign_of_radicals(a, b, c, 0, e) == sign_of_radical(a, b, c));
    // A perfect square gives what its root gives.
    const double root = static_cast<double>(static_cast<float>(p[1].z));
    if (std::fabs(root) > 0x1p-500 && std::fabs(root) < 0x1p500) {
      RC_ASSERT(sign_of_radical(a, b, root * root) ==
                sign_of([](auto x, auto y, auto r) { return x + y * r; }, a, b, std::fabs(root)));
    }
  });
}

TEST(SpaceLawsTest, MovingPoints) {
  expect_law(8, [](const Points& p) {
    const auto signs = [](const Points& q) {
      const std::span<const Point3> all(q);
      return coplanarity_signs(all.first<4>(), all.subspan<4, 4>());
    };
    const auto s = signs(p);
    RC_ASSERT(signs({p[1], p[2], p[0], p[3], p[5], p[6], p[4], p[7]}) == s);
    const auto swapped = signs({p[0], p[1], p[3], p[2], p[4], p[5], p[7], p[6]});
    for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(swapped[i] == -s[i]);
    const auto still = signs({p[0], p[1], p[2], p[3], p[0], p[1], p[2], p[3]});
    for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(still[i] == s[0]);
    RC_ASSERT(signs(scaled(p, -3)) == s);
  });
}

TEST(SpaceLawsTest, CoplanarOrientations) {
  expect_law(4, [](const Points& p) {
    const Sign s = coplanar_orientation(p[0], p[1], p[2]);
    RC_ASSERT(coplanar_orientation(p[1], p[2], p[0]) == s);
    RC_ASSERT(coplanar_orientation(p[0], p[2], p[1]) == -s);
    RC_ASSERT(coplanar_orientation(p[0], p[1], p[2], p[2]) == s * s);
    const Sign side = coplanar_orientation(p[0], p[1], p[2], p[3]);
    RC_ASSERT(coplanar_orientation(p[0], p[1], p[3], p[2]) == side);
    RC_ASSERT(coplanar_orientation(p[1], p[0], p[2], p[3]) == side);
    const Vector3 a = vector(p[0]), b = vector(p[1]), c = vector(p[2]), d = vector(p[3]);
    RC_ASSERT(dot_of_crosses(c, d, a, b) == dot_of_crosses(a, b, c, d));
    RC_ASSERT(dot_of_triple_cross(a, b, c, a) == dot_of_crosses(a, a, b, c));
  });
}

}  // namespace
}  // namespace plumb::space_cases
