#include "query/time_of_impact/lifted_motion.hpp"

#include <cmath>

#include "figure/basic/in_space.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/time_of_impact/moving_body.hpp"

namespace plumb::query {
namespace {

Polygon3 lifted_chain(const Polygon2& polygon) {
  Polygon3 lifted;
  for (const Point2& p : polygon.vertices) lifted.vertices.push_back(in_space(p));
  return lifted;
}

template <class Shape>
auto lifted_shape(const Shape& s) {
  if constexpr (std::is_same_v<Shape, Polygon2>) {
    return lifted_chain(s);
  } else if constexpr (std::is_same_v<Shape, HoledPolygon2>) {
    HoledPolygon3 lifted{lifted_chain(s.outer), {}};
    for (const Polygon2& hole : s.holes) lifted.holes.push_back(lifted_chain(hole));
    return lifted;
  } else if constexpr (std::is_same_v<Shape, Obb2>) {
    return Obb3{in_space(s.center),
                {in_space(s.axes[0]), in_space(s.axes[1]), {0, 0, 1}},
                {std::fabs(s.half.x), std::fabs(s.half.y), 0}};
  } else {
    return in_space(s);
  }
}

Pose lifted_pose(const Pose2& flat) {
  const auto& [u, v] = flat.columns;
  Pose pose{{{{u.x, u.y, 0}, {v.x, v.y, 0}, {0, 0, 1}}}, {flat.translation.x, flat.translation.y, 0}};
  Pose scaled = pose;
  scaled.columns[2].z = std::hypot(u.x, u.y);  // a guess
  return scale_of(&scaled) ? scaled : pose;
}
RigidPose lifted_pose(const RigidPose2& flat) { return {rotation_of(flat.turn), in_space(flat.translation)}; }
RigidChain lifted_pose(const RigidChain2& flat) {
  RigidChain chain;
  for (const RigidPose2& link : flat.links) chain.links.push_back(lifted_pose(link));
  return chain;
}

AnyPose lifted_pose(const AnyPoseView& flat) {
  return std::visit(
      []<class By>(const By& by) -> AnyPose {
        if constexpr (requires { lifted_pose(*by); }) {
          return lifted_pose(*by);
        } else {
          return AnyPose();
        }
      },
      flat.by);
}

}  // namespace

LiftedMotion::LiftedMotion(const PosedMotion& flat)
    : kind_(flat.figure.figure.kind),
      pose_(lifted_pose(flat.figure.pose)),
      by_(flat.by_in_plane == nullptr ? Vector3{0, 0, 0} : in_space(*flat.by_in_plane)) {
  with_figure(flat.figure.figure, [this]<class Shape>(const Shape& s) {
    if constexpr (MovesInPlane<Shape>) shape_ = lifted_shape(s);
  });
}

PosedMotion LiftedMotion::motion() const {
  PosedMotion in_space{{}, &by_};
  in_space.figure = std::visit([](const auto& s) { return PosedView{view_of(s)}; }, shape_);
  in_space.figure.pose = pose_;
  return in_space;
}

/// Edge 4 axis + y + 2 z, or + x + 2 z, of a box in space is edge 2 axis + y, or + x.
Feature LiftedMotion::in_plane(const Feature& f) const {
  if (f.kind == FeatureKind::interior) return f;
  if (kind_ == FigureKind::ball) return {FeatureKind::edge, 0};
  if (kind_ != FigureKind::aabb && kind_ != FigureKind::obb) return f;
  if (f.kind == FeatureKind::edge) return {f.kind, 2 * (f.index / 4) + (f.index & 1u)};
  return {f.kind, f.kind == FeatureKind::face ? 0 : f.index & 3u};
}

}  // namespace plumb::query
