// Separating axes and vectors: against relate, and each axis against every vertex.
#include "plumb/query/vclip/separating_axis.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/vclip/separating_vector.hpp"
#include "query/separation/convex_body.hpp"
#include "query/vclip/pairs.hpp"

namespace plumb {
namespace {

using clip_cases::pair_of;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Of all of b less a, along the axis.
template <class A, class B>
mpq_class least_gap(const A& a, const B& b, const std::array<mpq_class, 3>& axis) {
  const auto along = [&](const auto& s, std::size_t i) {
    const auto p = query::CoreCorners::of(query::body_view(s))->template at<mpq_class>(i);
    return mpq_class(p.x * axis[0] + p.y * axis[1] + p.z * axis[2]);
  };
  const auto size = [](const auto& s) { return query::CoreCorners::of(query::body_view(s))->size(); };
  mpq_class most = along(a, 0), least = along(b, 0);
  for (std::size_t i = 0; i < size(a); ++i) most = std::max(most, along(a, i));
  for (std::size_t i = 0; i < size(b); ++i) least = std::min(least, along(b, i));
  return least - most;
}

struct Seen {
  int apart = 0, touch = 0, overlap = 0, by_edges = 0;
};

template <class A, class B>
void expect_axis(const A& a, const B& b, const std::string& name, Seen& seen) {
  const Relation wanted = relate(a, b);
  const auto axis = separating_axis(a, b);
  ASSERT_EQ(axis.has_value(), wanted != Relation::overlapping) << name;
  seen.overlap += axis ? 0 : 1;
  if (!axis) return;
  ASSERT_EQ(axis->relation, wanted) << name;
  std::array<mpq_class, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) exact[k] = axis->direction[k].value().value;
  ASSERT_EQ(sgn(least_gap(a, b, exact)), wanted == Relation::disjoint ? 1 : 0) << name;
  ASSERT_TRUE(sgn(exact[0]) != 0 || sgn(exact[1]) != 0 || sgn(exact[2]) != 0) << name;
  (wanted == Relation::disjoint ? seen.apart : seen.touch) += 1;
  seen.by_edges += axis->kind == AxisKind::edges ? 1 : 0;
}

const Pose turned{{{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}, {1, 0.5, -2}},
    mirrored{{{{0, 1, 0}, {1, 0, 0}, {0, 0.25, 1}}}, {3, 0, 0}},
    flattened{{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {2, 0, 1}};

TEST(SeparatingAxes, AreThereWhereSolidsDoNotOverlap) {
  Seen seen;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 50 : 700); ++i) {
    const auto [a, b, name] = pair_of(94, i);
    ASSERT_NO_FATAL_FAILURE(expect_axis(a, b, name, seen));
    if (i % 8 != 0) continue;
    ASSERT_NO_FATAL_FAILURE(expect_axis(a, Posed{b, turned}, name + ", turned", seen));
    ASSERT_NO_FATAL_FAILURE(expect_axis(Posed{a, mirrored}, b, name + ", mirrored", seen));
  }
  std::printf("%d apart, %d touch, %d overlap; %d by edges\n", seen.apart, seen.touch, seen.overlap, seen.by_edges);
  EXPECT_GT(seen.apart, seen.overlap / 4);
  EXPECT_GT(seen.touch * 20, seen.apart);
  if (battery::reaches_rare) {
    EXPECT_GT(seen.by_edges * 200, seen.apart);
  }
}

/// Two ridges that cross: no face's normal parts them.
TEST(SeparatingAxes, CrossingEdgesPart) {
  const ConvexPolyhedron3 below = clip_cases::solid_of({{-1, 0, 0}, {1, 0, 0}, {0, -2, -1}, {0, 2, -1}}, false, false);
  for (const double gap : {0.0, 0x1p-1074, 0x1p-53, 0.25}) {
    const ConvexPolyhedron3 above =
        clip_cases::solid_of({{0, -1, gap}, {0, 1, gap}, {-2, 0, 1 + gap}, {2, 0, 1 + gap}}, false, false);
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(expect_axis(below, above, "ridges", seen));
    const auto axis = separating_axis(below, above);
    ASSERT_TRUE(axis);
    EXPECT_EQ(axis->kind, AxisKind::edges) << gap;
    EXPECT_EQ(axis->direction[0].sign(), Sign::zero) << gap;
    EXPECT_EQ(axis->direction[2].sign(), Sign::positive) << gap;
  }
}

TEST(SeparatingAxes, WhatIsNoneIsNamed) {
  const clip_cases::Pair pair = pair_of(94, 0);
  const Posed flat{pair.b, flattened};
  const ConvexPolyhedron3 none;
  EXPECT_THAT([&] { (void)separating_axis(pair.a, flat); },
              ThrowsMessage<InvalidShape>(HasSubstr("b.pose is singular")));
  EXPECT_THAT([&] { (void)separating_axis(none, pair.b); }, ThrowsMessage<InvalidShape>(HasSubstr("a has no faces")));
}

struct Looks {
  int pairs = 0, steps = 0, by_search = 0, disjoint = 0, told = 0;
};

template <class A, class B>
void expect_vector(const A& a, const B& b, const SeparatingVectorOptions& options, const std::string& name,
                   Looks& looks) {
  const SeparatingVector v = separating_vector(a, b, options);
  ASSERT_EQ(v.disjoint, !intersects(a, b)) << name;
  ++looks.pairs, looks.steps += static_cast<int>(v.steps), looks.by_search += v.by_search ? 1 : 0,
      looks.disjoint += v.disjoint ? 1 : 0, looks.told += v.direction ? 1 : 0;
  if (!v.direction) return;
  ASSERT_TRUE(v.disjoint) << name;
  const Vector3& d = *v.direction;
  ASSERT_EQ(sgn(least_gap(a, b, {d.x, d.y, d.z})), 1) << name;
  const SeparatingVector again = separating_vector(a, b, {v.direction, v.vertices});
  ASSERT_EQ(again.steps, 1U) << name;
  ASSERT_TRUE(again.disjoint) << name;
}

TEST(SeparatingVectors, AreThereWhereSolidsAreDisjoint) {
  Looks looks;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 60 : 900); ++i) {
    const auto [a, b, name] = pair_of(95, i);
    ASSERT_NO_FATAL_FAILURE(expect_vector(a, b, {}, name, looks));
    const auto last = static_cast<std::uint32_t>(a.mesh.vertices.size() - 1);
    ASSERT_NO_FATAL_FAILURE(expect_vector(a, b, {Vector3{0, 0, -1}, {last, 0}}, name, looks));
    if (i % 8 != 0) continue;
    for (const Pose& pose : {turned, mirrored, flattened})
      ASSERT_NO_FATAL_FAILURE(expect_vector(a, Posed{b, pose}, {}, name + ", posed", looks));
  }
  std::printf("%d pairs, %d directions, %d by search; %d disjoint, %d of them told\n", looks.pairs, looks.steps,
              looks.by_search, looks.disjoint, looks.told);
  EXPECT_GT(looks.disjoint * 4, looks.pairs);
  EXPECT_LT(looks.disjoint * 4, looks.pairs * 3);
  EXPECT_GT(looks.told * 20, looks.disjoint * 19);
}

TEST(SeparatingVectors, OfAnyExponent) {
  Looks looks;
  shape_cases::on_shapes(96, battery::sanitized ? 30 : 200, [&](shape_cases::Material& m) {
    const auto a = pair_cases::figure<ConvexPolyhedron3>(m), b = pair_cases::figure<ConvexPolyhedron3>(m);
    expect_vector(a, b, {}, m.about(), looks);
  });
  EXPECT_GT(looks.disjoint, 0);
}

TEST(SeparatingVectors, WhatIsNoneIsNamed) {
  const clip_cases::Pair pair = pair_of(94, 0);
  const SeparatingVectorOptions off{{}, {0, 9999}}, nowhere{Vector3{0, std::numeric_limits<double>::infinity(), 0}, {}};
  EXPECT_THAT([&] { (void)separating_vector(pair.a, pair.b, off); },
              ThrowsMessage<InvalidShape>(HasSubstr("has vertex 9999 of b")));
  EXPECT_THAT([&] { (void)separating_vector(pair.a, pair.b, nowhere); },
              ThrowsMessage<NonFinite>(HasSubstr("options.direction.y")));
  ConvexPolyhedron3 broken = pair.a;
  for (Point3& p : broken.mesh.vertices) p.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { (void)separating_vector(broken, pair.b); }, ThrowsMessage<NonFinite>(HasSubstr("vertices[0].z")));
}

}  // namespace
}  // namespace plumb
