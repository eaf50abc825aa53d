// Where does a point lie to a figure under a pose?  Where what the pose makes the point of lies to the figure.
#include <gtest/gtest.h>

#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "query/body/pair_types.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct LocateSeen {
  std::array<int, 3> count{};
};

/// A quarter about z, twice as large.
Point3 turned(const Point3& p) { return {-2 * p.y, 2 * p.x, 2 * p.z}; }
Point2 turned(const Point2& p) { return {-2 * p.y, 2 * p.x}; }
constexpr Pose quarter{{{{0, 2, 0}, {-2, 0, 0}, {0, 0, 2}}}, {0, 0, 0}};
constexpr Pose2 quarter2{{{{0, 2}, {-2, 0}}}, {0, 0}};
constexpr Pose flatten{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 3}};

template <class Shape>
void hold(LocateSeen& seen, std::uint64_t start) {
  constexpr bool is_flat = figure_dimension<Shape> == 2;
  using Point = std::conditional_t<is_flat, Point2, Point3>;
  if constexpr (LocatesPoints<Shape, Point>) {
    shape_cases::on_shapes(start, 20, [&](Material& m) {
      const Shape s = figure<Shape>(m);
      const Point p = near_figure<Point>(m);
      const Point image = turned(p);
      const Location plain = locate(s, p);
      const auto doubled = [](double x) { return std::isfinite(2 * x); };
      if (!doubled(p.x) || !doubled(p.y)) return;
      if constexpr (is_flat) {
        EXPECT_EQ(locate(Posed{s, quarter2}, image), plain) << m.about(s, p);
        EXPECT_EQ(locate(Posed{s, RigidPose2{}}, p), plain) << m.about(s, p);
      } else {
        if (!doubled(p.z)) return;
        EXPECT_EQ(locate(Posed{s, quarter}, image), plain) << m.about(s, p);
        EXPECT_EQ(locate(Posed{s, RigidPose{}}, p), plain) << m.about(s, p);
        if constexpr (query::is_one_of(figure_kind<Shape>,
                                       {FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb})) {
          if (plain != Location::outside) {
            EXPECT_EQ(locate(Posed{s, flatten}, Point3{p.x, p.y, 3}), Location::boundary) << m.about(s, p);
          }
        }
      }
      ++seen.count[static_cast<std::size_t>(plain == Location::inside ? 0 : plain == Location::boundary ? 1 : 2)];
    });
  }
}
template <class... Shapes>
void hold_all(Types<Shapes...>, LocateSeen& seen, std::uint64_t start) {
  (hold<Shapes>(seen, start++), ...);
}

TEST(PosedLocate, IsThatBeforeThePose) {
  LocateSeen seen;
  hold_all(Plane{}, seen, 2831);
  hold_all(Space{}, seen, 2861);
  std::printf("%d inside, %d on the boundary, %d outside\n", seen.count[0], seen.count[1], seen.count[2]);
  for (const int n : seen.count) EXPECT_GE(n, 60);
}

}  // namespace
}  // namespace plumb::pair_cases
