// Rays at posed figures: t as the plain question tells it where poses stay or images are doubles, and the same under a
// common pose.
#include "plumb/query/ray/posed.hpp"

#include "query/body/pair_laws.hpp"
#include "query/body/posed_cases.hpp"

namespace plumb::pair_cases {
namespace {

struct ShotSeen {
  int cases = 0, hit = 0, mapped = 0;
};
using Parameter = std::optional<RayParameter>;

query::PosedView posed_by(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space} : query::PosedView{v, &flat};
}
Parameter asked(const query::PosedView& a, const query::PosedView& b) {
  return query::posed_first_hit_parameter("first_hit_parameter", a, b);
}
bool same(const Parameter& a, const Parameter& b) { return a.has_value() == b.has_value() && (!a || (*a <=> *b) == 0); }

using OneHit = std::optional<Hit>;
OneHit in_space(const OneHit& h) { return h; }
OneHit in_space(const std::optional<Hit2>& h) {
  if (!h) return {};
  return Hit{h->t, {h->point.x, h->point.y, 0}, h->feature, {h->normal.x, h->normal.y, 0}};
}
/// Which laws of whole hits fail, a bit each.
int broken_hits(const query::FigureView& a, const query::FigureView& b, const Pose& pose, const OneHit& plain) {
  const Pose2 flat = in_plane(pose), stays{{{{1, 0}, {0, 1}}}, {0, 0}};
  const OneHit still = query::posed_first_hit({a}, posed_by(b, identity_pose, stays)),
               moved = query::posed_first_hit(posed_by(a, pose, flat), posed_by(b, pose, flat));
  const bool moves_alike =
      plain.has_value() == moved.has_value() && (!plain || (plain->t == moved->t && plain->feature == moved->feature));
  return (still == plain ? 0 : 1) | (moves_alike ? 0 : 2);
}

/// Whose normals are cross products of their edges.
constexpr bool has_corners(FigureKind k) {
  return query::is_one_of(
      k, {FigureKind::segment, FigureKind::three_point_plane, FigureKind::triangle, FigureKind::quadrilateral,
          FigureKind::polygon, FigureKind::holed_polygon, FigureKind::tetrahedron});
}
bool is_that_of_image(const OneHit& hit, const OneHit& image, bool with_normal) {
  if (!hit || !image) return !hit && !image;
  return hit->t == image->t && hit->point == image->point && hit->feature.kind == image->feature.kind &&
         (!with_normal || hit->normal == image->normal);
}

/// Which laws fail, a bit each.
int broken(const query::FigureView& a, const query::FigureView& b, const Pose& pose, const Parameter& plain) {
  const Pose2 flat = in_plane(pose), stays{{{{1, 0}, {0, 1}}}, {0, 0}};
  const bool stays_same = same(asked({a}, posed_by(b, identity_pose, stays)), plain);
  const bool moves_alike = same(asked(posed_by(a, pose, flat), posed_by(b, pose, flat)), plain);
  return (stays_same ? 0 : 1) | (moves_alike ? 0 : 2);
}

template <class A, class B>
void expect_shots(ShotSeen& seen, std::uint64_t start) {
  using By = std::conditional_t<figure_dimension<A> == 2, Pose2, Pose>;
  if constexpr (query::PosedShot<Posed<A, By>, B>) {
    shape_cases::on_shapes(start, battery::sanitized ? 3 : 12, [&](Material& m) {
      const auto pair = pair_of<A, B>(m);
      const A& a = pair.first;
      const B& b = pair.second;
      const Parameter plain = first_hit_parameter(a, b);
      ++seen.cases, seen.hit += plain.has_value();
      EXPECT_EQ(broken(query::view_of(a), query::view_of(b), regular_pose(m), plain), 0)
          << pair_name<A, B>() << m.about(a, b);
      const OneHit plain_hit = in_space(first_hit(a, b));
      EXPECT_EQ(broken_hits(query::view_of(a), query::view_of(b), regular_pose(m), plain_hit), 0)
          << pair_name<A, B>() << m.about(a, b);
      Map map(m, figure_dimension<A>, map_kind<A, B>(m), m.below(2) == 0);
      const Pose pose = pose_of(map);
      const B d = mapped(b, map);
      const A c = mapped(a, map);
      if (!map.exact()) return;
      ++seen.mapped;
      const Pose2 flat = in_plane(pose);
      EXPECT_TRUE(same(asked({query::view_of(c)}, posed_by(query::view_of(b), pose, flat)), first_hit_parameter(c, d)))
          << pair_name<A, B>() << m.about(a, b);
      const OneHit hit = query::posed_first_hit({query::view_of(c)}, posed_by(query::view_of(b), pose, flat));
      EXPECT_TRUE(is_that_of_image(hit, in_space(first_hit(c, d)), has_corners(figure_kind<B>)))
          << pair_name<A, B>() << m.about(a, b);
    });
  }
}

template <class All>
void expect_all_shots(std::uint64_t start) {
  ShotSeen seen;
  on_pairs(All{}, [&]<class A, class B>(const A*, const B*) { expect_shots<A, B>(seen, start++); });
  std::printf("%d cases, %d hit, %d mapped\n", seen.cases, seen.hit, seen.mapped);
  EXPECT_GT(seen.hit * 5, seen.cases);
  EXPECT_GT(seen.mapped * 3, seen.cases);
}

TEST(PosedRay, AllFiguresOfThePlane) { expect_all_shots<Plane>(5101); }
TEST(PosedRay, AllFiguresOfSpace) { expect_all_shots<Space>(5301); }

TEST(PosedRay, FirstHitsOfTrianglesAsWithoutPoses) {
  int hit = 0, all = 0;
  shape_cases::on_shapes(5501, battery::sanitized ? 50 : 300, [&](Material& m) {
    const Triangle3 t = m.shape<Triangle3>();
    const Ray3 ray = near_figure<Ray3>(m);
    const auto plain = first_hit(ray, t);
    ++all, hit += plain.has_value();
    EXPECT_EQ(first_hit(ray, Posed{t, identity_pose}), plain) << m.about(t, ray);
    Map map(m, 3, MapKind::turned, true);
    const Pose pose = pose_of(map);
    const Triangle3 image = mapped(t, map);
    const Ray3 moved = mapped(ray, map);
    if (!map.exact()) return;
    EXPECT_EQ(first_hit(moved, Posed{t, pose}), first_hit(moved, image)) << m.about(t, ray);
  });
  EXPECT_GT(hit * 10, all);
  EXPECT_THROW(first_hit(Ray3{}, Posed{Triangle3{}, Pose{{}, {0, 0, std::numeric_limits<double>::infinity()}}}),
               NonFinite);
}

/// A ray that is posed as well, even by the identity, is asked in rationals.
template <class Box, class Ray, class By>
bool is_as_in_rationals(const Box& box, const Ray& ray, const By& pose) {
  const query::PosedView given{query::view_of(ray)}, in_rationals{query::view_of(ray), &identity_pose},
      posed{query::view_of(box), &pose};
  return query::posed_first_hit(given, posed) == query::posed_first_hit(in_rationals, posed) &&
         same(asked(given, posed), asked(in_rationals, posed));
}

TEST(PosedRay, BoxesByTheirHalfspacesAsInRationals) {
  int hit = 0, all = 0;
  shape_cases::on_shapes(5551, battery::sanitized ? 20 : 150, [&](Material& m) {
    const auto expect_same = [&]<class Box>(const Box& box, const auto& ray) {
      const Pose pose = regular_pose(m);
      const RigidPose turn{{1.0 + static_cast<double>(m.below(3)), 0.5, static_cast<double>(m.below(2)), 0x1p-20},
                           {1, -2, static_cast<double>(m.below(3))}};
      ++all, hit += hits(ray, Posed{box, pose});
      EXPECT_TRUE(is_as_in_rationals(box, ray, pose)) << m.about(box, ray);
      EXPECT_TRUE(is_as_in_rationals(box, ray, turn)) << m.about(box, ray);
    };
    const auto box = m.shape<Aabb3>();
    expect_same(box, near_figure<Ray3>(m));
    const auto turned = m.shape<Obb3>();
    expect_same(turned, near_figure<Segment3>(m));
    expect_same(turned, near_figure<Line3>(m));
  });
  EXPECT_GT(hit * 20, all);
}

TEST(PosedRay, WhatPosesMakeIsHit) {
  const Pose flat{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1}}, long_z{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 3}}}, {}};
  const Ray3 up{{0.5, 0.5, 0}, {0, 0, 2}};
  EXPECT_EQ(first_hit_parameter(up, Posed{Aabb3{{0, 0, 0}, {1, 1, 9}}, flat})->rounded(), 0.5);
  EXPECT_FALSE(hits(Ray3{{1.5, 0.5, 0}, {0, 0, 2}}, Posed{Aabb3{{0, 0, 0}, {1, 1, 9}}, flat}));
  EXPECT_EQ(first_hit_parameter(Line3{{0, 0, 0}, {0, 0, 1}}, Posed{Sphere3{{0, 0, 0}, 1}, long_z})->rounded(), -3);
  EXPECT_THROW(hits(up, Posed{Sphere3{{0, 0, 0}, 1}, flat}), UnevenPose);
  EXPECT_THROW(first_hit(up, Posed{Sphere3{{0, 0, 0}, 1}, flat}), UnevenPose);
  EXPECT_EQ(first_hit(up, Posed{Aabb3{{0, 0, 0}, {1, 1, 9}}, flat}),
            (Hit{0.5, {0.5, 0.5, 1}, {FeatureKind::face, 4}, {0, 0, 1}}));
  // An ellipsoid's normal is that of its tangent plane.
  EXPECT_EQ(first_hit(Ray3{{0, 0, -9}, {0, 0, 2}}, Posed{Sphere3{{0, 0, 0}, 1}, long_z}),
            (Hit{3, {0, 0, -3}, {FeatureKind::face, 0}, {0, 0, -1}}));
  const Pose mirrors{{{{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}};
  EXPECT_EQ(first_hit(Line3{{0, 0.5, 0.5}, {1, 0, 0}}, Posed{Aabb3{{0, 0, 0}, {1, 1, 1}}, mirrors}),
            (Hit{-2, {-2, 0.5, 0.5}, {FeatureKind::face, 1}, {-1, 0, 0}}));
  const Pose2 turned{{{{0, 2}, {-2, 0}}}, {1, 0}};
  EXPECT_EQ(first_hit(Ray2{{-5, 1}, {1, 0}}, Posed{Capsule2{{0, 0}, {2, 0}, 1}, turned}),
            (Hit2{4, {-1, 1}, {FeatureKind::edge, 0}, {-2, 0}}));
}

// Of a can and a cone that are sheared along x by their height, and of a lozenge: as their images by hand.
TEST(PosedRay, RoundSidesAndFlatEndsThatPosesShear) {
  const Pose sheared{{{{1, 0, 0}, {0, 1, 0}, {1, 0, 1}}}, {0, 0, 0}};
  const Posed can{Cylinder3{{0, 0, 0}, {0, 0, 4}, 2}, sheared};
  // At height 2 the side is moved by 2; its normal has x = -2 as before, and is at right angles to (1, 0, 1).
  EXPECT_EQ(first_hit(Ray3{{-9, 0, 2}, {1, 0, 0}}, can), (Hit{9, {0, 0, 2}, {FeatureKind::face, 0}, {-2, 0, 2}}));
  EXPECT_EQ(first_hit(Ray3{{5, 0, 9}, {0, 0, -1}}, can), (Hit{5, {5, 0, 4}, {FeatureKind::face, 2}, {0, 0, 4}}));
  EXPECT_EQ(first_hit(Ray3{{6, 0, 9}, {0, 0, -1}}, can), (Hit{5, {6, 0, 4}, {FeatureKind::edge, 1}, {0, 0, 4}}));
  EXPECT_FALSE(hits(Ray3{{0x1.8000000000001p+2, 0, 9}, {0, 0, -1}}, can));
  EXPECT_EQ(first_hit(Ray3{{1, 0, 1}, {0, 0, -1}}, can), (Hit{0, {1, 0, 1}, {FeatureKind::interior, 0}, {0, 0, 0}}));
  const Posed cone{Cone3{{0, 0, 4}, {0, 0, 0}, 4}, sheared};
  EXPECT_EQ(first_hit(Ray3{{4, 0, 9}, {0, 0, -1}}, cone), (Hit{5, {4, 0, 4}, {FeatureKind::vertex, 0}, {0, 0, 0}}));
  // Before the pose it is (-2, 0, 2) that is met, where the normal is (-2, 0, 2).
  EXPECT_EQ(first_hit(Ray3{{-9, 0, 2}, {1, 0, 0}}, cone), (Hit{9, {0, 0, 2}, {FeatureKind::face, 0}, {-2, 0, 4}}));
  EXPECT_EQ(first_hit_parameter(Posed{Ray3{{0, 1, 9}, {0, 0, -1}}, sheared}, cone)->rounded(), 6);
  const Posed lozenge{Lozenge3{{0, 0, 0}, {{{4, 0, 0}, {0, 4, 0}}}, 1}, sheared};
  EXPECT_EQ(first_hit(Ray3{{2, 1, 5}, {0, 0, -1}}, lozenge), (Hit{4, {2, 1, 1}, {FeatureKind::face, 0}, {0, 0, 16}}));
  EXPECT_EQ(first_hit(Ray3{{-9, 2, 0}, {1, 0, 0}}, lozenge), (Hit{8, {-1, 2, 0}, {FeatureKind::face, 4}, {-1, 0, 1}}));
}

// A round figure that is flattened is refused; without a radius it is the segment or the plate that it becomes,
// and under the matrix zero a point.
TEST(PosedRay, WhatSingularMatricesMakeOfRoundFigures) {
  const Pose flat{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1}}, point{{}, {2, 0, 0}};
  const Ray3 up{{0.5, 0, 0}, {0, 0, 2}}, along{{0, 0, 0}, {1, 0, 0}};
  const Vector3 none{0, 0, 0};
  EXPECT_THROW(hits(up, Posed{Cylinder3{{0, 0, 0}, {0, 0, 1}, 1}, flat}), UnevenPose);
  EXPECT_THROW(first_hit(up, Posed{Cone3{{0, 0, 0}, {0, 0, 1}, 1}, flat}), UnevenPose);
  EXPECT_THROW(first_hit(up, Posed{Lozenge3{{0, 0, 0}, {}, 1}, flat}), UnevenPose);
  const Point3 at{0.5, 0, 1};
  EXPECT_EQ(first_hit(up, Posed{Cylinder3{{0, 0, 0}, {1, 0, 5}, 0}, flat}),
            (Hit{0.5, at, {FeatureKind::face, 0}, none}));
  EXPECT_EQ(first_hit(up, Posed{Cylinder3{{0, 0, 0}, {0.5, 0, 5}, 0}, flat}),
            (Hit{0.5, at, {FeatureKind::edge, 1}, none}));
  EXPECT_EQ(first_hit(up, Posed{Cone3{{0.5, 0, 9}, {1, 0, 5}, 0}, flat}),
            (Hit{0.5, at, {FeatureKind::vertex, 0}, none}));
  EXPECT_EQ(first_hit(up, Posed{Lozenge3{{0, 0, 7}, {{{1, 0, 0}, {0, 1, 0}}}, 0}, flat}),
            (Hit{0.5, at, {FeatureKind::face, 0}, none}));
  // The closed zone of a plate holds its edges and corners, a capsule's side and a single point's flat face all of it.
  const Ray3 down{{1, 0, 5}, {0, 0, -1}};
  for (const Vector3& second : {Vector3{0, 2, 0}, Vector3{1, 0, 0}, Vector3{0, 0, 3}}) {
    for (const double first : {2.0, 1.0}) {
      const Lozenge3 lozenge{{0, 0, 0}, {{{first, 0, 0}, second}}, 0};
      EXPECT_EQ(first_hit(down, lozenge)->feature, (Feature{FeatureKind::face, 0}));
      EXPECT_EQ(first_hit(down, Posed{lozenge, flat}), (Hit{4, {1, 0, 1}, {FeatureKind::face, 0}, none}));
    }
  }
  EXPECT_EQ(first_hit(along, Posed{Lozenge3{{0, 0, 0}, {{{2, 0, 0}, {0, 2, 0}}}, 1}, point}),
            (Hit{2, {2, 0, 0}, {FeatureKind::face, 0}, none}));
  EXPECT_EQ(first_hit(along, Posed{Cone3{{0, 0, 0}, {0, 0, 1}, 3}, point}),
            (Hit{2, {2, 0, 0}, {FeatureKind::vertex, 0}, none}));
  EXPECT_EQ(first_hit(along, Posed{Cylinder3{{0, 0, 0}, {0, 0, 1}, 3}, point})->feature,
            (Feature{FeatureKind::edge, 0}));
}

}  // namespace
}  // namespace plumb::pair_cases
