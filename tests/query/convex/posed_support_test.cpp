// How far do figures under poses reach?  As far as they do without the pose along what the transpose makes of the direction,
// and as their boxes say that are fitted another way.
#include "plumb/query/convex/posed_support.hpp"

#include <gtest/gtest.h>

#include "figure/basic/thrown.hpp"
#include "query/body/pair_types.hpp"
#include "query/body/posed_cases.hpp"
#include "query/body/rigid_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct Reached {
  double value = 0;
  bool is_beyond = false, is_invalid = false;
  friend bool operator==(const Reached&, const Reached&) = default;
};
template <class Ask>
Reached told(const Ask& ask) {
  try {
    const double value = ask();
    return std::isfinite(value) ? Reached{value} : Reached{0, true};
  } catch (const BeyondDoubles&) {
    return {0, true};
  } catch (const InvalidShape&) {
    return {0, false, true};
  }
}

struct SupportSeen {
  int cases = 0, valid = 0;
};

template <class Shape>
void hold_transpose(std::uint64_t start, SupportSeen& seen) {
  constexpr bool is_flat = figure_dimension<Shape> == 2;
  shape_cases::on_shapes(start, 40, [&](Material& m) {
    const Shape s = figure<Shape>(m);
    Pose pose = m.below(3) == 0 ? singular_pose(m) : whole_pose(m);
    pose.translation = {0, 0, 0};
    const auto n = [&] { return static_cast<double>(m.below(7)) - 3; };
    const Vector3 d{n(), n(), is_flat ? 0 : n()};
    const auto along = [](const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; };
    const auto& [u, v, w] = pose.columns;
    const Vector3 back{along(u, d), along(v, d), along(w, d)};
    for (const Rounding rounding : {Rounding::up, Rounding::down, Rounding::nearest}) {
      const auto [posed, plain] = [&] {
        if constexpr (is_flat) {
          const Posed<Shape, Pose2> turned{s, in_plane(pose)};
          return std::pair(told([&] {
                             return support_value(turned, Vector2{d.x, d.y}, rounding);
                           }),
                           told([&] {
                             return support_value(s, Vector2{back.x, back.y}, rounding);
                           }));
        } else {
          const Posed turned{s, pose};
          return std::pair(told([&] { return support_value(turned, d, rounding); }),
                           told([&] { return support_value(s, back, rounding); }));
        }
      }();
      EXPECT_EQ(posed, plain) << posed.value << " and " << plain.value
                              << m.about(s, pose.columns[0], pose.columns[1], pose.columns[2], d);
      ++seen.cases, seen.valid += !plain.is_invalid && !plain.is_beyond;
    }
  });
}

TEST(PosedSupport, IsThatAlongTheTransposedDirection) {
  SupportSeen seen;
  hold_transpose<Aabb3>(2801, seen), hold_transpose<Obb3>(2802, seen), hold_transpose<Sphere3>(2803, seen);
  hold_transpose<Capsule3>(2804, seen), hold_transpose<Lozenge3>(2805, seen), hold_transpose<Cylinder3>(2806, seen);
  hold_transpose<Cone3>(2807, seen), hold_transpose<SphericalCap3>(2808, seen), hold_transpose<KDop3>(2809, seen);
  hold_transpose<ConvexPolyhedron3>(2810, seen), hold_transpose<Aabb2>(2811, seen), hold_transpose<Obb2>(2812, seen);
  hold_transpose<Circle2>(2813, seen), hold_transpose<Capsule2>(2814, seen), hold_transpose<KDop2>(2815, seen);
  std::printf("%d cases, %d of them reach some double\n", seen.cases, seen.valid);
  EXPECT_GT(2 * seen.valid, seen.cases);
}

/// Of what figure/aabb/posed_aabb.hpp fits, translated as well.
template <class Shape>
void hold_box(std::uint64_t start, SupportSeen& seen) {
  shape_cases::on_shapes(start, 60, [&](Material& m) {
    const Shape s = figure<Shape>(m);
    const auto hold = [&](const auto& posed) {
      const auto boxed = [&](double Point3::*part, bool upper) {
        return told([&] {
          const Aabb3 box = fit_aabb(posed);
          return upper ? box.max.*part : -(box.min.*part);
        });
      };
      const auto reach = [&](const Vector3& d) { return told([&] { return support_value(posed, d); }); };
      const Reached up = boxed(&Point3::x, true), down = boxed(&Point3::y, false);
      ++seen.cases;
      if (up.is_beyond || up.is_invalid) return;  // of some bound: the box has none then
      ++seen.valid;
      EXPECT_EQ(reach({1, 0, 0}), up) << m.about(s);
      EXPECT_EQ(reach({0, -1, 0}), down) << m.about(s);
    };
    hold(Posed{s, regular_pose(m)});
    hold(Posed{s, singular_pose(m)});
    hold(Posed{s, rigid_pose(m)});
  });
}

TEST(PosedSupport, IsThatOfTheFittedBox) {
  SupportSeen seen;
  hold_box<Obb3>(2821, seen), hold_box<Sphere3>(2822, seen), hold_box<Capsule3>(2823, seen);
  hold_box<Lozenge3>(2824, seen), hold_box<ConvexPolyhedron3>(2825, seen);
  std::printf("%d cases, %d in doubles\n", seen.cases, seen.valid);
  EXPECT_GT(2 * seen.valid, seen.cases);
}

TEST(PosedSupport, ByHand) {
  const RigidPose quarter{{1, 0, 1, 0}, {10, 20, 30}};  // about y: z goes to x, x to -z
  const Cylinder3 can{{0, 0, 0}, {0, 0, 4}, 1};
  EXPECT_EQ(fit_aabb(Posed{can, quarter}), (Aabb3{{10, 19, 29}, {14, 21, 31}}));
  const Cone3 cone{{0, 0, 4}, {0, 0, 0}, 2};
  EXPECT_EQ(fit_aabb(Posed{cone, quarter}), (Aabb3{{10, 18, 28}, {14, 22, 32}}));
  const SphericalCap3 bowl{{{0, 0, 0}, 5}, {{0, 0, 1}, -3}};  // its circle has the radius 4
  EXPECT_EQ(fit_aabb(Posed{bowl, quarter}), (Aabb3{{5, 16, 26}, {7, 24, 34}}));
  const Pose flat{{{{1, 0, 0}, {0, 2, 0}, {0, 0, 0}}}, {0, 0, 7}};
  EXPECT_EQ(fit_aabb(Posed{bowl, flat}), (Aabb3{{-4, -8, 7}, {4, 8, 7}}));
  EXPECT_EQ(support_value(Posed{can, quarter}, {1, 1, 0}), 35);
  const KDop3 open{Directions3({{1, 0, 0}}), {0}, {1}}, none{Directions3({{1, 0, 0}}), {1}, {0}};
  EXPECT_EQ(text_of<InvalidShape>([&] {
              (void)fit_aabb(Posed{open, flat});
            }),
            "fit_aabb: k_dop is unbounded; give directions that span all of space");
  EXPECT_EQ(fit_aabb(Posed{none, flat}), (Aabb3{{1, 1, 1}, {-1, -1, -1}}));
}

}  // namespace
}  // namespace plumb::pair_cases
