// Ellipsoids against figures with straight edges as the balls that they are before their map, against balls and one another by
// where they are drawn, and by linear maps that change no answer.
#include "plumb/query/overlap/ellipsoid.hpp"

#include <gmock/gmock.h>

#include "query/body/pair_laws.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

double whole(Material& m, std::size_t most) {
  return static_cast<double>(m.below(2 * most + 1)) - static_cast<double>(most);
}

/// Of whole half axes that doubles hold, as a posed ball.
struct Drawn {
  Ellipsoid3 ellipsoid;
  Pose pose;
};
Drawn drawn(Material& m) {
  const auto vector = [&] { return Vector3{whole(m, 2), whole(m, 2), whole(m, 2)}; };
  Drawn d{{{whole(m, 4), whole(m, 4), whole(m, 4)}, {vector(), vector(), vector()}, {whole(m, 2), 1, 2}}, {}};
  const std::array<double, 3> half{d.ellipsoid.half.x, d.ellipsoid.half.y, d.ellipsoid.half.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& a = d.ellipsoid.axes[i];
    d.pose.columns[i] = {half[i] * a.x, half[i] * a.y, half[i] * a.z};
  }
  d.pose.translation = {d.ellipsoid.center.x, d.ellipsoid.center.y, d.ellipsoid.center.z};
  return d;
}

template <class Shape>
void expect_as_posed_ball(Answers& all, std::uint64_t start) {
  if constexpr (query::MeetsEllipsoid<Shape>) {
    constexpr bool is_costly = query::is_one_of(
        figure_kind<Shape>, {FigureKind::k_dop, FigureKind::halfspace_intersection, FigureKind::convex_polyhedron});
    shape_cases::on_shapes(start, is_costly || battery::sanitized ? 2 : 8, [&](Material& m) {
      const Drawn d = drawn(m);
      const Shape s = figure<Shape>(m);
      const std::string about = std::string(name_of(figure_kind<Shape>)) + m.about(d.ellipsoid, s);
      const auto asked = [](auto question) -> std::optional<Relation> {
        try {
          return question();
        } catch (const UnevenPose&) {
          return {};
        } catch (const InvalidShape&) {
          return {};
        }
      };
      const auto told = asked([&] { return relate(d.ellipsoid, s); });
      EXPECT_EQ(told, asked([&] { return relate(Posed{Sphere3{{0, 0, 0}, 1}, d.pose}, s); })) << about;
      EXPECT_EQ(told, asked([&] { return relate(s, d.ellipsoid); })) << about;
      if (!told) return;
      all.add(*told);
      EXPECT_EQ(intersects(s, d.ellipsoid), *told != Relation::disjoint) << about;
      if constexpr (figure_kind<Shape> == FigureKind::point) {
        if (determinant(d.pose) != 0) {
          EXPECT_EQ(static_cast<int>(locate(d.ellipsoid, s)), static_cast<int>(*told)) << about;
        }
      }
    });
  }
}

const int enough = battery::sanitized ? 2 : 20;

TEST(EllipsoidPairs, AsTheBallsThatTheyWere) {
  Answers all;
  const auto on_all = [&]<class... S>(Types<S...>) {
    std::uint64_t start = 5701;
    (expect_as_posed_ball<S>(all, start++), ...);
  };
  on_all(Space{});
  EXPECT_GT(all.of(Relation::overlapping), enough);
  EXPECT_GT(all.of(Relation::disjoint), enough);
}

TEST(EllipsoidPairs, BallsUnderTheirOwnPoses) {
  Answers all;
  shape_cases::on_shapes(5801, battery::sanitized ? 40 : 250, [&](Material& m) {
    const Sphere3 a{{whole(m, 3), whole(m, 3), whole(m, 3)}, 1 + static_cast<double>(m.below(3))},
        b{{whole(m, 3), whole(m, 3), whole(m, 3)}, 1 + static_cast<double>(m.below(3))};
    const Relation plain = relate(a, b);
    all.add(plain);
    const Pose both = regular_pose(m);
    EXPECT_EQ(relate(Posed{a, both}, Posed{b, both}), plain) << m.about(a, b);
    // Along z both are as they were; across they are stretched as they like: those with centers on the axis z.
    const double gap = whole(m, 2) / 2, r = 1 + static_cast<double>(m.below(2)),
                 s = 1 + static_cast<double>(m.below(2));
    const Ellipsoid3 below{
        {0, 0, 0}, {{{r, 0, 0}, {0, r, 0}, {0, 0, r}}}, {3, 0.5 + static_cast<double>(m.below(4)), 1}},
        above{{0, 0, r + s + gap}, {{{1, 1, 0}, {1, -2, 0}, {0, 0, 1}}}, {0.25, 7, s}};
    const Relation expected = gap > 0 ? Relation::disjoint : gap == 0 ? Relation::touching : Relation::overlapping;
    EXPECT_EQ(relate(below, above), expected) << m.about(below, above);
    EXPECT_EQ(relate(above, below), expected) << m.about(below, above);
    all.add(expected);
    // A common map changes nothing.
    const Pose map = whole_pose(m);
    if (determinant(map) == 0) return;
    const auto moved = [&](const Ellipsoid3& e) {
      const auto times = [&](const Vector3& v) {
        const auto& [x, y, z] = map.columns;
        return Vector3{x.x * v.x + y.x * v.y + z.x * v.z, x.y * v.x + y.y * v.y + z.y * v.z,
                       x.z * v.x + y.z * v.y + z.z * v.z};
      };
      const Vector3 c = times({e.center.x, e.center.y, e.center.z});
      return Ellipsoid3{{c.x + map.translation.x, c.y + map.translation.y, c.z + map.translation.z},
                        {times(e.axes[0]), times(e.axes[1]), times(e.axes[2])},
                        e.half};
    };
    EXPECT_EQ(relate(moved(below), moved(above)), expected) << m.about(below, above);
  });
  EXPECT_GT(all.of(Relation::touching), enough);
  EXPECT_GT(all.of(Relation::overlapping), enough);
  EXPECT_GT(all.of(Relation::disjoint), enough);
}

TEST(EllipsoidPairs, HitsByAnUlpAreToldApart) {
  const std::array<Vector3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Ellipsoid3 flat{{0, 0, 0}, axes, {4, 4, 0.1}};
  const auto above = [&](double z) { return Ellipsoid3{{0, 0, z}, axes, {1, 5, 1}}; };
  EXPECT_EQ(relate(flat, above(1.1)), Relation::disjoint);  // 0.1 is a little more, and 1.1 more than that
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {4, 4, 0.125}}, above(1.125)), Relation::touching);
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {4, 4, 0.125}}, above(std::nextafter(1.125, 2))), Relation::disjoint);
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {4, 4, 0.125}}, above(std::nextafter(1.125, 1))), Relation::overlapping);
  EXPECT_EQ(relate(flat, flat), Relation::overlapping);
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {4, 4, 4}}, Ellipsoid3{{0, 0, 1}, axes, {1, 2, 1}}),
            Relation::overlapping);  // one inside the other
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {2, 3, 1}}, Sphere3{{4, 0, 0}, 2}), Relation::touching);
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {2, 3, 0}}, Segment3{{0, 0, -1}, {0, 0, 1}}), Relation::overlapping);
  EXPECT_EQ(relate(Posed{Circle2{{0, 0}, 1}, Pose2{{{{2, 0}, {0, 1}}}, {0, 0}}}, Circle2{{4, 0}, 2}),
            Relation::touching);
  EXPECT_EQ(relate(Posed{Circle2{{0, 0}, 1}, Pose2{{{{2, 0}, {0, 1}}}, {0, 0}}}, Circle2{{0, 3.5}, 2}),
            Relation::disjoint);
  EXPECT_EQ(relate(Ellipsoid3{{0, 0, 0}, axes, {0x1p-500, 0x1p-500, 0x1p300}}, Sphere3{{0, 0, 0x1p301}, 0x1p300}),
            Relation::touching);
  EXPECT_THAT(
      [&] {
        (void)relate(flat, Capsule3{{0, 0, 0}, {1, 0, 0}, 1});
      },
      ThrowsMessage<UnevenPose>(HasSubstr("relate: ellipsoid and capsule: neither")));
  EXPECT_THAT(
      [&] {
        (void)relate(Ellipsoid3{{0, 0, 0}, axes, {1, NAN, 1}}, Point3{0, 0, 0});
      },
      ThrowsMessage<NonFinite>(HasSubstr("relate: ellipsoid.half.y is nan")));
}

}  // namespace
}  // namespace plumb::pair_cases
