// Distances of posed figures: as the plain question tells them where poses stay or images are doubles, and the same under
// a common pose that permutes and mirrors.
#include "plumb/query/overlap/posed_distance.hpp"

#include "plumb/query/separation/separation.hpp"
#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct DistanceSeen {
  int cases = 0, apart = 0, mapped = 0;
};

query::PosedView posed_by(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space} : query::PosedView{v, &flat};
}
double asked(const query::PosedView& a, const query::PosedView& b) {
  return query::posed_distance(a, b, query::Question::distance);
}

void expect_distances(const PairRow& pair, DistanceSeen& seen, std::uint64_t start) {
  if (pair.forth.distance == nullptr) return;
  shape_cases::on_shapes(start, battery::sanitized ? 1 : 4, [&](Material& m) {
    const auto [a, b] = pair_of(pair, m);
    const std::string name = pair.name() + about(m, a, b);
    double plain = 0;
    const Pose2 stays{{{{1, 0}, {0, 1}}}, {0, 0}};
    const query::PosedView posed = posed_by(a.view(), identity_pose, stays), other{b.view()};
    try {
      plain = pair.forth.distance(a.shape(), b.shape());
    } catch (const InvalidShape&) {
      EXPECT_THROW(asked(posed, other), InvalidShape) << name;
      return;
    }
    ++seen.cases, seen.apart += plain > 0;
    EXPECT_EQ(asked(posed, other), plain) << name;
    EXPECT_EQ(asked(other, posed), plain) << name;
    EXPECT_EQ(compare(query::posed_exact_distance(posed, other, query::Question::exact_distance),
                      pair.forth.exact_distance(a.shape(), b.shape())),
              Sign::zero)
        << name;
    const MapKind kind = map_kind(a.row().kind, b.row().kind, m);
    Map map(m, pair.dimension(), kind, m.below(2) == 0);
    const Pose pose = pose_of(map);
    const Pose2 flat = in_plane(pose);
    const AnyFigure c = mapped(a, map), d = mapped(b, map);
    if (!map.exact()) return;
    ++seen.mapped;
    const double of_images = pair.forth.distance(c.shape(), d.shape());
    EXPECT_EQ(asked(posed_by(a.view(), pose, flat), {d.view()}), of_images) << name;
    EXPECT_EQ(asked(posed_by(a.view(), pose, flat), posed_by(b.view(), pose, flat)), of_images) << name;
  });
}

template <class All>
void expect_all_distances(std::uint64_t start) {
  DistanceSeen seen;
  for (const PairRow& pair : pairs_of(All{})) expect_distances(pair, seen, start++);
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
