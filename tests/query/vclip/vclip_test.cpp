// V-Clip against the exact search: the same distance from every start, the same points where there is but one pair.
#include "plumb/query/vclip/vclip.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/separation/corner_numbers.hpp"
#include "query/separation/proved_corners.hpp"
#include "query/vclip/nearest_features.hpp"
#include "query/vclip/pairs.hpp"

namespace plumb {
namespace {

using clip_cases::pair_of;
using testing::HasSubstr;
using testing::ThrowsMessage;

struct Seen {
  int pairs = 0, meet = 0, by_search = 0, several = 0, steps = 0;
};

bool has_one_pair(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  const auto p = query::CoreCorners::of(query::view_of(a)), q = query::CoreCorners::of(query::view_of(b));
  const auto proved = query::proved_nearest(*p, *q);
  return proved && proved->is_alone;
}

void expect_as_search(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b, const VClipOptions& options, Seen& seen,
                      const std::string& name) {
  VClipOptions exact = options;
  exact.squared_distance = true;
  const VClipResult r = vclip(a, b, exact);
  const Closest wanted = closest_points(a, b);
  const Rational square = squared_distance_exact(a, b);
  ++seen.pairs, seen.meet += r.meet ? 1 : 0, seen.by_search += r.by_search ? 1 : 0,
      seen.steps += static_cast<int>(r.steps);
  ASSERT_EQ(r.meet, square.sign() == Sign::zero) << name;
  ASSERT_EQ(r.meet, intersects(a, b)) << name;
  ASSERT_TRUE(r.squared_distance) << name;
  ASSERT_EQ(*r.squared_distance, square) << name;
  ASSERT_EQ(r.closest.distance, wanted.distance) << name;
  if (r.meet) {
    ASSERT_EQ(r.closest.on_a, r.closest.on_b) << name;
  } else if (!(r.closest == wanted)) {
    ++seen.several;
    ASSERT_FALSE(has_one_pair(a, b)) << name;
  }
}

void print(const Seen& s) {
  std::printf("%d walks, %d steps: %d meet, %d by search, %d of several pairs\n", s.pairs, s.steps, s.meet, s.by_search,
              s.several);
}

TEST(VClip, DistancesAreThoseOfTheSearch) {
  Seen seen;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 100 : 1200); ++i) {
    const auto [a, b, name] = pair_of(9, i);
    ASSERT_NO_FATAL_FAILURE(expect_as_search(a, b, {}, seen, name));
  }
  print(seen);
  EXPECT_GT(seen.meet * 4, seen.pairs);
  EXPECT_LT(seen.meet * 4, seen.pairs * 3);
  EXPECT_GT(seen.several * 200, seen.pairs);
  EXPECT_LT(seen.by_search * 50, seen.pairs);
}

TEST(VClip, OfAnyExponent) {
  Seen seen;
  shape_cases::on_shapes(91, battery::sanitized ? 40 : 300, [&](shape_cases::Material& m) {
    const auto a = pair_cases::figure<ConvexPolyhedron3>(m), b = pair_cases::figure<ConvexPolyhedron3>(m);
    expect_as_search(a, b, {}, seen, m.about());
  });
  print(seen);
  EXPECT_GT(seen.meet * 20, seen.pairs);
  EXPECT_LT(seen.meet * 20, seen.pairs * 19);
}

std::vector<MeshFeature> features_of(const ConvexPolyhedron3& p) {
  std::vector<MeshFeature> all;
  for (std::uint32_t c = 0; c < p.mesh.corners.size(); ++c)
    all.push_back({FeatureKind::vertex, c}), all.push_back({FeatureKind::edge, c});
  for (std::size_t f = 0; f + 1 < p.mesh.first.size(); ++f) all.push_back({FeatureKind::face, p.mesh.first[f]});
  return all;
}

TEST(VClip, TheStartChangesNoDistance) {
  int starts = 0, by_search = 0, still = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 2 : 8); ++i) {
    const auto [a, b, name] = pair_of(92, i);
    if (a.mesh.corners.size() * b.mesh.corners.size() > 2500) continue;
    const double wanted = distance(a, b);
    for (const MeshFeature& of_a : features_of(a)) {
      for (const MeshFeature& of_b : features_of(b)) {
        const VClipResult r = vclip(a, b, {.start = MeshFeaturePair{of_a, of_b}});
        ASSERT_EQ(r.closest.distance, wanted) << name;
        ++starts, by_search += r.by_search ? 1 : 0;
        if (r.by_search || starts % 16 != 0) continue;
        const VClipResult again = vclip(a, b, {.start = r.at});
        ASSERT_EQ(again.closest.distance, wanted) << name;
        still += again.steps == 0 && again.at == r.at ? 1 : 0;
      }
    }
  }
  std::printf("%d starts, %d by search, %d of every 16th stay where they ended\n", starts, by_search, still);
  EXPECT_GT(starts, battery::sanitized ? 500 : 10'000);
  EXPECT_LT(by_search * 50, starts);
  EXPECT_GT(still * 16 * 10, starts * 9);
}

/// Mutants of an answer: features that are not nearest are refused by what proves those that are.
TEST(VClip, OtherFeaturesHaveNoProof) {
  using namespace query::vclipping;
  int proved = 0, refused = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 2 : 8); ++i) {
    const auto [a, b, name] = pair_of(97, i);
    const query::ClipView view_a{&a}, view_b{&b};
    const auto core_a = query::CoreCorners::of(query::view_of(a)), core_b = query::CoreCorners::of(query::view_of(b));
    const Solid solid_a(a, *core_a, false), solid_b(b, *core_b, false);
    CheckedSigns sign("test", view_a, view_b);
    const Rational wanted = squared_distance_exact(a, b);
    for (const MeshFeature& of_a : features_of(a)) {
      for (const MeshFeature& of_b : features_of(b)) {
        if (of_a.kind != FeatureKind::vertex && of_b.kind != FeatureKind::vertex &&
            (of_a.kind == FeatureKind::face || of_b.kind == FeatureKind::face))
          continue;  // a walk never ends there
        const MeshFeaturePair at{of_a, of_b};
        const auto corners = corners_of_features(solid_a, solid_b, at, sign);
        if (!corners || !prove_features(solid_a, solid_b, at, *corners).holds) {
          ++refused;
          continue;
        }
        ++proved;
        ASSERT_TRUE(Rational(BigRational{query::square_of(*core_a, *core_b, *corners)}) == wanted) << name;
      }
    }
  }
  std::printf("%d pairs of features proved, %d refused\n", proved, refused);
  EXPECT_GT(proved, 10);
  EXPECT_GT(refused, 20 * proved);
}

const Pose turned{{{{0.6, 0.8, 0}, {-0.8, 0.6, 0}, {0, 0, 1}}}, {1, 0.5, -2}},
    mirrored{{{{0, 1, 0}, {1, 0, 0}, {0, 0.25, 1}}}, {3, 0, 0}},
    flattened{{{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {2, 0, 1}};

TEST(VClip, PosesAreExact) {
  int meet = 0, asked = 0, by_search = 0;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 6 : 60); ++i) {
    const auto [a, b, name] = pair_of(93, i);
    for (const Pose& pose : {turned, mirrored, flattened}) {
      const Posed p{b, pose};
      const VClipResult r = vclip(a, p, {.start = {}, .squared_distance = true}), back = vclip(p, a);
      const Rational square = squared_distance_exact(a, p);
      ASSERT_EQ(*r.squared_distance, square) << name;
      ASSERT_EQ(r.meet, square.sign() == Sign::zero) << name;
      ASSERT_EQ(r.closest.distance, distance(a, p)) << name;
      ASSERT_EQ(back.closest.distance, r.closest.distance) << name;
      ++asked, meet += r.meet ? 1 : 0, by_search += r.by_search ? 1 : 0;
    }
  }
  std::printf("%d posed pairs, %d meet, %d by search\n", asked, meet, by_search);
  EXPECT_GT(meet * 10, asked);
  EXPECT_LT(meet * 10, asked * 9);
  EXPECT_LT(by_search * 5, asked * 2);  // all that is flattened, and little else
}

/// An edge that runs within a face's plane, and comes in at a side of it or begins there.
TEST(VClip, AnEdgeInAFaceHasACommonPoint) {
  const ConvexPolyhedron3 slab =
      clip_cases::solid_of({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {8, 8, 0}, {4, 4, -1}}, false, false);
  for (const double from : {-2.0, 2.0}) {
    const ConvexPolyhedron3 ridge =
        clip_cases::solid_of({{from, 3, 0}, {5, 4, 0}, {from, 2, 4}, {5, 6, 4}}, false, false);
    int asked = 0;
    for (const MeshFeature& of_a : features_of(slab)) {
      for (const MeshFeature& of_b : features_of(ridge)) {
        const VClipResult r = vclip(slab, ridge, {.start = MeshFeaturePair{of_a, of_b}});
        ASSERT_TRUE(r.meet);
        ASSERT_EQ(r.closest.on_a, r.closest.on_b);
        ASSERT_EQ(r.closest.on_a.z, 0);
        ASSERT_GE(r.closest.on_a.x, 0);
        ++asked;
      }
    }
    EXPECT_GT(asked, 100);
  }
}

/// RTCD figure 9.4: a vertex below a face, nearest to it of all its neighbors, and outside of another face.
TEST(VClip, ALocalMinimumIsLeft) {
  const ConvexPolyhedron3 slab = clip_cases::solid_of({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {8, 8, 0}, {4, 4, -1}}, false,
                                                      false),
                          spike = clip_cases::solid_of({{4, 4, -2}, {3, 3, -9}, {5, 3, -9}, {4, 6, -9}}, false, false);
  std::vector<MeshFeaturePair> history;
  MeshFeaturePair start;
  for (std::uint32_t c = 0; c < spike.mesh.corners.size(); ++c) {
    if (spike.mesh.vertices[spike.mesh.corners[c]] == Point3{4, 4, -2}) start.b = {FeatureKind::vertex, c};
  }
  for (std::size_t f = 0; f + 1 < slab.mesh.first.size(); ++f) {
    if (slab.mesh.first[f + 1] - slab.mesh.first[f] == 4) start.a = {FeatureKind::face, slab.mesh.first[f]};
  }
  const VClipResult r = vclip(slab, spike, {.start = start, .squared_distance = true, .history = &history});
  ASSERT_GE(history.size(), 2U);
  EXPECT_EQ(history[0], start);
  EXPECT_EQ(history[1].a.kind, FeatureKind::face);  // another one, that the vertex is above
  EXPECT_NE(history[1].a, start.a);
  EXPECT_FALSE(r.meet);
  EXPECT_FALSE(r.by_search);
  EXPECT_EQ(*r.squared_distance, Rational(1));
  EXPECT_EQ(r.closest.on_a, (Point3{4, 4, -1}));
}

TEST(VClip, WhatIsNoneIsNamed) {
  const clip_cases::Pair pair = pair_of(9, 0);
  const auto &a = pair.a, &b = pair.b;
  const ConvexPolyhedron3 none;
  const VClipOptions off{.start = MeshFeaturePair{{FeatureKind::edge, 9999}, {}}};
  EXPECT_THAT([&] { (void)vclip(a, none); }, ThrowsMessage<InvalidShape>(HasSubstr("b has no faces")));
  EXPECT_THAT([&] { (void)vclip(a, b, off); }, ThrowsMessage<InvalidShape>(HasSubstr("start.a is corner 9999")));
  ConvexPolyhedron3 broken = a;
  for (Point3& p : broken.mesh.vertices) p.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { (void)vclip(broken, b); }, ThrowsMessage<NonFinite>(HasSubstr("vertices[0].y")));
  Pose far = turned;
  far.translation.z = std::numeric_limits<double>::infinity();
  const Posed moved{b, far};
  EXPECT_THAT([&] { (void)vclip(a, moved); }, ThrowsMessage<NonFinite>(HasSubstr("pose.translation.z")));
}

}  // namespace
}  // namespace plumb
