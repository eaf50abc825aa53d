// Distances of posed figures: as the plain question tells them where poses stay or images are doubles, and the same under
// a common pose that permutes and mirrors.
#include "plumb/query/overlap/posed_distance.hpp"

#include "plumb/query/separation/separation.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct DistanceSeen {
  int cases = 0, apart = 0, mapped = 0;
};

query::PosedView posed_by(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space, nullptr} : query::PosedView{v, nullptr, &flat};
}
double asked(const query::PosedView& a, const query::PosedView& b) {
  return query::posed_distance(a, b, query::Question::distance);
}

template <class A, class B>
void expect_distances(DistanceSeen& seen, std::uint64_t start) {
  using By = std::conditional_t<figure_dimension<A> == 2, Pose2, Pose>;
  if constexpr (query::PosedMeasured<Posed<A, By>, B>) {
    shape_cases::on_shapes(start, battery::sanitized ? 1 : 4, [&](Material& m) {
      const auto pair = pair_of<A, B>(m);
      const A& a = pair.first;
      const B& b = pair.second;
      double plain = 0;
      const Pose2 stays{{{{1, 0}, {0, 1}}}, {0, 0}};
      const query::PosedView posed = posed_by(query::view_of(a), identity_pose, stays), other{query::view_of(b)};
      try {
        plain = distance(a, b);
      } catch (const InvalidShape&) {
        EXPECT_THROW(asked(posed, other), InvalidShape) << pair_name<A, B>() << m.about(a, b);
        return;
      }
      ++seen.cases, seen.apart += plain > 0;
      EXPECT_EQ(asked(posed, other), plain) << pair_name<A, B>() << m.about(a, b);
      EXPECT_EQ(asked(other, posed), plain) << pair_name<A, B>() << m.about(a, b);
      EXPECT_EQ(
          compare(query::posed_exact_distance(posed, other, query::Question::exact_distance), exact_distance(a, b)),
          Sign::zero)
          << pair_name<A, B>() << m.about(a, b);
      Map map(m, figure_dimension<A>, map_kind<A, B>(m), m.below(2) == 0);
      const Pose pose = pose_of(map);
      const Pose2 flat = in_plane(pose);
      const A c = mapped(a, map);
      const B d = mapped(b, map);
      if (!map.exact()) return;
      ++seen.mapped;
      const double of_images = distance(c, d);
      EXPECT_EQ(asked(posed_by(query::view_of(a), pose, flat), {query::view_of(d)}), of_images)
          << pair_name<A, B>() << m.about(a, b);
      EXPECT_EQ(asked(posed_by(query::view_of(a), pose, flat), posed_by(query::view_of(b), pose, flat)), of_images)
          << pair_name<A, B>() << m.about(a, b);
    });
  }
}

template <class All>
void expect_all_distances(std::uint64_t start) {
  DistanceSeen seen;
  on_pairs(All{}, [&]<class A, class B>(const A*, const B*) { expect_distances<A, B>(seen, start++); });
  std::printf("%d cases, %d apart, %d mapped\n", seen.cases, seen.apart, seen.mapped);
  EXPECT_GT(seen.apart * 4, seen.cases);
  EXPECT_GT(seen.mapped * 3, seen.cases);
}

TEST(PosedDistance, AllPairsOfThePlane) { expect_all_distances<Plane>(4101); }
TEST(PosedDistance, AllPairsOfSpace) { expect_all_distances<Space>(4301); }

TEST(PosedDistance, ClosestPointsOfTrianglesAsWithoutPoses) {
  shape_cases::on_shapes(4501, battery::sanitized ? 30 : 150, [&](Material& m) {
    const Triangle3 t = m.shape<Triangle3>(), u = near_figure<Triangle3>(m);
    const Point3 p = m.probe3();
    EXPECT_EQ(closest_points(Posed{t, identity_pose}, Posed{u, identity_pose}), closest_points(t, u)) << m.about(t, u);
    EXPECT_EQ(closest_points(p, Posed{t, identity_pose}), closest_points(p, t)) << m.about(t, p);
    EXPECT_EQ(closest_points(Posed{t, identity_pose}, p), closest_points(t, p)) << m.about(t, p);
    Map map(m, 3, MapKind::turned, true);
    const Pose pose = pose_of(map);
    const Triangle3 v = mapped(t, map), w = mapped(u, map);
    if (map.exact()) {
      EXPECT_EQ(closest_points(Posed{t, pose}, Posed{u, pose}), closest_points(v, w)) << m.about(t, u);
    }
  });
}

TEST(PosedDistance, IsMeasuredInTheSpaceOfThePoses) {
  const Pose turned{{{{0.96, 0.28, 0}, {-0.28, 0.96, 0}, {0, 0, 1}}}, {0.1, 0.2, 0.3}};  // not quite a rotation
  const Triangle3 t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(distance(Posed{Point3{1, 1, 2}, turned}, Posed{t, turned}), 2);
  EXPECT_EQ(distance(Posed{Point3{1, 1, 0}, turned}, Posed{t, turned}), 0);
  const Pose flat{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1}};
  EXPECT_EQ(distance(Posed{Aabb3{{0, 0, 0}, {1, 1, 9}}, flat}, Point3{0, 0, 4}), 3);
  EXPECT_EQ(compare_distance(Posed{Point3{1, 1, 2}, turned}, Posed{t, turned}, 2.0), Sign::zero);
  const Pose sheared{{{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {0, 0, 0}}, five{{{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}, {}};
  EXPECT_THROW(distance(Point3{9, 0, 0}, Posed{Sphere3{{0, 0, 0}, 1}, sheared}), UnevenPose);
  EXPECT_EQ(distance(Point3{9, 0, 0}, Posed{Sphere3{{0, 0, 0}, 1}, five}), 4);
}

}  // namespace
}  // namespace plumb::pair_cases
