// Closest points of posed figures: as the plain question tells them where poses stay or images are doubles, features that
// move with the figure, and what singular poses flatten.
#include "plumb/query/separation/posed.hpp"

#include <gmock/gmock.h>

#include "query/body/pair_laws.hpp"
#include "query/body/pair_questions.hpp"
#include "query/body/posed_cases.hpp"
#include "query/convex/features.hpp"
#include "query/separation/cores.hpp"

namespace plumb::pair_cases {
namespace {

struct PosedNearSeen {
  int cases = 0, apart = 0, mapped = 0, round = 0;
};

query::PosedView under(const query::FigureView& v, const Pose& in_space, const Pose2& flat) {
  return v.dimension == 3 ? query::PosedView{v, &in_space} : query::PosedView{v, &flat};
}

constexpr bool ends_everywhere(FigureKind k) {
  return !query::is_one_of(k, {FigureKind::line, FigureKind::ray, FigureKind::plane, FigureKind::three_point_plane,
                               FigureKind::halfspace, FigureKind::halfspace_intersection, FigureKind::k_dop});
}

void expect_closest(const PairRow& pair, PosedNearSeen& seen, std::uint64_t start) {
  if (pair.forth.closest_points == nullptr) return;
  // Others tell the pair by laws of their own where there are several.
  const bool by_one_law = pair.is_separated;
  const auto plain_answer = [&pair](const AnyFigure& a, const AnyFigure& b) {
    return pair.forth.closest_points(a.shape(), b.shape());
  };
  shape_cases::on_shapes(start, battery::sanitized ? 1 : 2, [&](Material& m) {
    const auto [a, b] = pair_of(pair, m);
    const std::string name = pair.name() + about(m, a, b);
    const Pose2 stays{{{{1, 0}, {0, 1}}}, {0, 0}};
    const query::PosedView posed = under(a.view(), identity_pose, stays), other{b.view()};
    Closest plain{};
    try {
      plain = plain_answer(a, b);
    } catch (const InvalidShape&) {
      EXPECT_THROW(query::posed_closest_points(posed, other), InvalidShape) << name;
      return;
    }
    ++seen.cases, seen.apart += plain.distance > 0;
    const Closest told = query::posed_closest_points(posed, other);
    EXPECT_EQ(told.distance, plain.distance) << name;
    EXPECT_EQ(query::posed_closest_points(other, posed), swapped(told)) << name;
    if (by_one_law) {
      EXPECT_EQ(told, plain) << name;
    }
    const MapKind kind = map_kind(a.row().kind, b.row().kind, m);
    Map map(m, pair.dimension(), kind, m.below(2) == 0);
    const Pose pose = pose_of(map);
    const Pose2 flat = in_plane(pose);
    const AnyFigure c = mapped(a, map), d = mapped(b, map);
    if (!map.exact()) return;
    ++seen.mapped, seen.round += has_core(a.row().kind) || has_core(b.row().kind) ? 1 : 0;
    const query::PosedView both_a = under(a.view(), pose, flat), both_b = under(b.view(), pose, flat);
    const Closest moved = query::posed_closest_points(both_a, both_b);
    const Closest images = plain_answer(c, d);
    EXPECT_EQ(moved.distance, images.distance) << name;
    const Closest half_posed = query::posed_closest_points(both_a, {d.view()});
    EXPECT_EQ(half_posed.distance, images.distance) << name;
    // Of what goes on there need not be a first pair, and features of an image that is drawn anew have other numbers.
    if (by_one_law && (ends_everywhere(a.row().kind) || ends_everywhere(b.row().kind))) {
      EXPECT_EQ(half_posed.on_a, images.on_a) << name;
      EXPECT_EQ(half_posed.on_b, images.on_b) << name;
      EXPECT_EQ(moved.on_a, images.on_a) << name;
      EXPECT_EQ(moved.on_b, images.on_b) << name;
    }
  });
}

template <class All>
void expect_all_closest(std::uint64_t start) {
  PosedNearSeen seen;
  for (const PairRow& pair : pairs_of(All{})) expect_closest(pair, seen, start++);
  std::printf("%d cases, %d apart, %d mapped, %d of them round\n", seen.cases, seen.apart, seen.mapped, seen.round);
  EXPECT_GT(seen.apart * 4, seen.cases);
  EXPECT_GT(seen.mapped * 3, seen.cases);
  EXPECT_GT(seen.round * 9, seen.mapped);
}

TEST(PosedClosest, AllPairsOfThePlane) { expect_all_closest<Plane>(4601); }
TEST(PosedClosest, AllPairsOfSpace) { expect_all_closest<Space>(4801); }

/// Of a point of the figure, whatever the pose.
template <class Shape>
void expect_features_move(std::uint64_t start) {
  shape_cases::on_shapes(start, battery::sanitized ? 2 : 12, [&](Material& m) {
    const Shape s = figure<Shape>(m);
    const query::FigureView view = query::view_of(s);
    const Point3 p = m.probe3();
    const auto near = query::nearest_of_cores({query::view_of(p)}, {view}, query::WhichPair::first);
    if (!near) return;
    const Pose pose = regular_pose(m);
    const query::ExactMap map = query::exact_map(&pose);
    EXPECT_EQ(query::feature_at(view, image(map, near->on_b), false, &map), query::feature_at(view, near->on_b, false))
        << m.about(s, p);
    // What the singular pose that keeps all of it does changes nothing, either: by images, not by the inverse.
    const Feature as_it_stands = query::feature_at(view, near->on_b, false);
    query::ExactMap flat = query::exact_identity();
    flat.columns[2] = {0, 0, 0};
    const Feature seen = query::feature_at(view, image(flat, near->on_b), false, &flat);
    EXPECT_LE(std::pair(seen.kind, seen.index), std::pair(as_it_stands.kind, as_it_stands.index)) << m.about(s, p);
  });
}

TEST(PosedClosest, FeaturesGoWithTheFigure) {
  expect_features_move<Triangle3>(4901);
  expect_features_move<Tetrahedron3>(4902);
  expect_features_move<Aabb3>(4903);
  expect_features_move<Obb3>(4904);
  expect_features_move<Rectangle3>(4905);
  expect_features_move<KDop3>(4906);
  expect_features_move<HalfspaceIntersection3>(4907);
  expect_features_move<Halfspace3>(4908);
  expect_features_move<ConvexPolyhedron3>(4909);
  expect_features_move<HoledPolygon3>(4910);
  expect_features_move<Lozenge3>(4911);
  expect_features_move<ThreePointPlane3>(4912);
  expect_features_move<Ray3>(4913);
}

TEST(PosedClosest, OfWhatIsFlattened) {
  const Pose flat{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, {0, 0, 1}}, nothing{{}, {1, 2, 3}};
  const Aabb3 box{{0, 0, 0}, {1, 1, 9}};
  // Beside the middle of an upright edge, which is now a corner; above the middle of the floor, which the lid is as well.
  EXPECT_EQ(closest_points(Posed{box, flat}, Point3{4, 0, 5}),
            (Closest{{1, 0, 1}, {4, 0, 5}, 5, {FeatureKind::vertex, 1}, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(closest_points(Posed{box, flat}, Point3{0.5, 0.5, 5}),
            (Closest{{0.5, 0.5, 1}, {0.5, 0.5, 5}, 4, {FeatureKind::face, 4}, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(closest_points(Posed{box, nothing}, Point3{1, 2, 5}),
            (Closest{{1, 2, 3}, {1, 2, 5}, 2, {FeatureKind::vertex, 0}, {FeatureKind::vertex, 0}}));
  const HalfspaceIntersection3 region{{{{0, 0, 1}, 9}, {{1, 0, 0}, 1}, {{0, 0, -1}, 0}}};
  EXPECT_EQ(closest_points(Posed{region, flat}, Point3{4, 0, 5}).feature_a, (Feature{FeatureKind::face, 0}));
  EXPECT_EQ(closest_points(Posed{region, flat}, Point3{4, 0, 5}).on_a, (Point3{1, 0, 1}));
  const Polygon3 upright{{{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {1, 0, 1}, {0, 0, 2}}};
  EXPECT_EQ(closest_points(Posed{upright, flat}, Point3{1, 3, 1}),
            (Closest{{1, 0, 1}, {1, 3, 1}, 3, {FeatureKind::vertex, 3}, {FeatureKind::vertex, 0}}));
  const Pose2 to_line{{{{1, 0}, {0, 0}}}, {0, 0}};
  EXPECT_EQ(closest_points(Posed{Triangle2{{0, 0}, {4, 1}, {2, 5}}, to_line}, Posed{Segment2{{1, 3}, {1, 7}}, to_line},
                           WhichPair::first),
            (Closest2{{1, 0}, {1, 0}, 0, {FeatureKind::edge, 0}, {FeatureKind::vertex, 0}}));
}

TEST(PosedClosest, RoundOnesKeepTheirNumbers) {
  const Pose five{{{{3, 4, 0}, {-4, 3, 0}, {0, 0, 5}}}, {1, 0, 0}},
      third{{{{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}, {0, 0, 0}}, sheared{{{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};
  const Capsule3 capsule{{0, 0, 0}, {0, 0, 2}, 1};
  EXPECT_EQ(closest_points(Posed{capsule, five}, Point3{9, 0, 5}),
            (Closest{{6, 0, 5}, {9, 0, 5}, 3, {FeatureKind::face, 0}, {FeatureKind::vertex, 0}}));
  EXPECT_EQ(closest_points(Posed{capsule, five}, Point3{1, 0, 18}).feature_a, (Feature{FeatureKind::face, 2}));
  EXPECT_EQ(closest_points(Posed{Sphere3{{1, 0, 0}, 0.1}, third}, Posed{Sphere3{{-1, 0, 0}, 0.1}, third}).distance,
            rounded_root(Rounding::nearest, Rational(36.0)) - 2 * (3 * 0.1));
  EXPECT_THAT(
      [&] {
        (void)closest_points(Point3{9, 0, 0}, Posed{capsule, sheared});
      },
      testing::ThrowsMessage<UnevenPose>(testing::HasSubstr("closest_points: capsule: its pose makes")));
  EXPECT_THAT(
      [&] {
        (void)closest_points(Posed{Aabb3{{1, 0, 0}, {0, 1, 1}}, sheared}, capsule);
      },
      testing::ThrowsMessage<InvalidShape>(testing::HasSubstr("closest_points: aabb is empty")));
}

}  // namespace
}  // namespace plumb::pair_cases
