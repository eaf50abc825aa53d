#include "space/ray/seen_ray.hpp"

#include <algorithm>
#include <cmath>

#include "arith/approximate.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/ray/numbers.hpp"

namespace plumb::space {
namespace {

using Balls = arith::Vec<Ball>;

template <class Numbers>
Balls balls(const Numbers& v) {
  return {Ball{v.x}, Ball{v.y}, Ball{v.z}};
}

Balls divided(const Balls& v, const Ball& by) { return {quotient(v.x, by), quotient(v.y, by), quotient(v.z, by)}; }

/// How far from the exact number its first double may be.
double off(const Ball& x) { return Interval::sum_up(std::abs(x.low), x.radius); }

/// Of whatever is of at most such a size, rounded once from what is off by so much.
Approximate at_most(double size, double off) { return {size, Interval::sum_up(size, off * 0x1p53), 1}; }

/// A corner anywhere between two places, from a place.
Approximate away(double low, double high, const Ball& from) {
  return at_most(std::max(std::abs(low - from.high), std::abs(high - from.high)), off(from));
}

query::RayDoubts doubts_of(const Aabb3& box, const Balls& from, const Balls& way) {
  using Numbers = arith::Vec<Approximate>;
  const auto along = [](const Ball& x) { return at_most(std::abs(x.high), off(x)); };
  const Numbers direction{along(way.x), along(way.y), along(way.z)};
  const Numbers corner{away(box.min.x, box.max.x, from.x), away(box.min.y, box.max.y, from.y),
                       away(box.min.z, box.max.z, from.z)};
  const Numbers twice = cross(corner, corner);
  const Approximate edge = dot(direction, twice), sum = (edge + edge) + edge, plane = dot(corner, twice);
  return {edge.reach(), sum.reach(), plane.reach(), (plane - sum).reach(), true};
}

/// Of columns over a weight.
std::array<Balls, 3> inverse_of(const query::WeightedPose<Ball>& by) {
  const auto part = [&](const Balls& v) { return by.has_weight ? divided(v, by.weight) : v; };
  const std::array columns{part(by.columns[0]), part(by.columns[1]), part(by.columns[2])};
  const auto& [a, b, c] = columns;
  const Balls bc = cross(b, c);
  const Ball determinant = dot(a, bc);
  return {divided(bc, determinant), divided(cross(c, a), determinant), divided(cross(a, b), determinant)};
}

}  // namespace

Sight::Sight(const MeshPose& pose, const BoxFrame& frame, const FloatBox3& all)
    : translation_{Ball{0}, Ball{0}, Ball{0}},
      frame_(frame),
      all_(all),
      box_{{0, 0, 0}, {0, 0, 0}},
      rows_{translation_, translation_, translation_} {
  const auto by = query::weighted_pose<Ball>(pose.any_view());
  translation_ = by.has_weight ? divided(by.translation, by.weight) : by.translation;
  rows_ = inverse_of(by);
  if (all.min[0] <= all.max[0]) box_ = frame.outside(all);
}

std::optional<SeenRay> Sight::operator()(const AnyRay& ray) const {
  if (query::has_no_direction(ray)) return {};
  const auto turned = [&](const Balls& v) { return Balls{dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)}; };
  const Balls origin = balls(ray.origin);
  const Balls from = turned(origin - translation_);
  const Balls way = turned(ray.kind == AnyRay::Kind::segment ? balls(ray.end) - origin : balls(ray.direction));
  const query::RayDoubts doubts = doubts_of(box_, from, way);
  if (!(doubts.edge + doubts.sum + doubts.plane + doubts.end < Ball::infinity)) return {};
  const RaySlabs slabs(ray.kind, {from.x, from.y, from.z}, {way.x, way.y, way.z}, frame_, all_);
  if (slabs.all_met()) return {};
  return SeenRay{slabs,
                 {{from.x.high, from.y.high, from.z.high},
                  {way.x.high, way.y.high, way.z.high},
                  query::begins(ray),
                  query::ends(ray)},
                 doubts};
}

}  // namespace plumb::space
