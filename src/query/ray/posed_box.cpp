#include "query/ray/posed_box.hpp"

#include <cmath>
#include <span>
#include <variant>

#include "query/body/weighted_pose.hpp"
#include "query/ray/answers.hpp"
#include "query/ray/box_feature.hpp"

namespace plumb::query {
namespace {

/// All center + s0 axes[0] + s1 axes[1] + s2 axes[2] with s between low and high.
struct BoxSpan {
  Point3 center;
  std::array<Vector3, 3> axes;
  std::array<double, 3> low, high;
};
BoxSpan span_of(const Aabb3& b) {
  return {{0, 0, 0},
          {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}},
          {b.min.x, b.min.y, b.min.z},
          {b.max.x, b.max.y, b.max.z}};
}
BoxSpan span_of(const Obb3& b) {
  const std::array<double, 3> high{std::fabs(b.half.x), std::fabs(b.half.y), std::fabs(b.half.z)};
  return {b.center, b.axes, {-high[0], -high[1], -high[2]}, high};
}

struct PosedSpan {
  BoxSpan box;
  AnyPoseView pose;
};

/// The image of a span, times the weight of its pose, and the halfspaces that bound it.
template <class T>
class SpanImage {
 public:
  SpanImage(const PosedSpan& s, Sign turn)
      : box_(s.box),
        by_(weighted_pose<T>(s.pose)),
        center_(by_.image(vector_of<T>(s.box.center))),
        axes_{axis(0), axis(1), axis(2)},
        out_{outward(0, turn), outward(1, turn), outward(2, turn)} {}

  [[nodiscard]] T volume() const { return dot(axes_[0], out_[0]); }

  static std::size_t size() { return 6; }
  template <class Same>
  [[nodiscard]] Linear<Same> linear(const ShotLine<Same>& line, std::uint32_t i, RaySigns&) const {
    const std::uint32_t k = i / 2;
    const Vec3<T> from = beside(vector_of<T>(line.ray.origin)) - center_;
    const T above = dot(from, out_[k]), slope = weighted(dot(line.direction, out_[k]));
    if (i % 2 == 1) return {above - T(box_.high[k]) * volume(), slope};
    return {T(box_.low[k]) * volume() - above, T(0.0) - slope};
  }
  static Feature feature(std::span<const std::uint32_t> tight) { return box_feature(tight); }

  [[nodiscard]] NormalForm<T> normal_of(std::uint32_t face) const {
    const T zero(0.0);
    const Vec3<T>& out = out_[face / 2];
    const Vec3<T> n = face % 2 == 1 ? out : Vec3<T>{zero - out.x, zero - out.y, zero - out.z};
    if (!by_.has_weight) return still_normal(n);
    return {n, {zero, zero, zero}, by_.weight * by_.weight, true};
  }

 private:
  [[nodiscard]] Vec3<T> axis(std::size_t i) const { return by_.turned(vector_of<T>(box_.axes[i])); }
  [[nodiscard]] Vec3<T> outward(std::size_t i, Sign turn) const {
    const Vec3<T>&u = axes_[(i + 1) % 3], &v = axes_[(i + 2) % 3];
    return turn == Sign::negative ? cross(v, u) : cross(u, v);
  }
  [[nodiscard]] T weighted(const T& x) const { return by_.has_weight ? x * by_.weight : x; }
  [[nodiscard]] Vec3<T> beside(const Vec3<T>& p) const { return by_.has_weight ? times(p, by_.weight) : p; }

  const BoxSpan& box_;
  WeightedPose<T> by_;
  Vec3<T> center_;
  std::array<Vec3<T>, 3> axes_, out_;
};

struct PosedBoxModel {
  const PosedSpan& span;
  Sign turn;  // of the axes of the image

  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const {
    return clip<T>(line, SpanImage<T>(span, turn), ask);
  }
  template <class T>
  Time<T> time(const ShotLine<T>& line, const When& when, RaySigns& ask) const {
    const Linear<T> c = SpanImage<T>(span, turn).linear(line, when.index, ask);
    return {T(0.0) - c.constant, c.slope};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>&, const Decided& decided, RaySigns&) const {
    return SpanImage<T>(span, turn).normal_of(decided.normal);
  }
};

template <class Shape>
const Shape& shape_of(const FigureView& v) {
  return *static_cast<const Shape*>(v.shape);
}
/// Makes a ray of a line, a ray or a segment.
AnyRay given_ray(const FigureView& v) {
  if (v.kind == FigureKind::segment) return shape_of<Segment3>(v);
  if (v.kind == FigureKind::line) return shape_of<Line3>(v);
  return shape_of<Ray3>(v);
}

template <class Answer>
std::optional<std::optional<Answer>> first_of_box(const PosedView& ray, const PosedView& figure) {
  const FigureKind kind = figure.figure.kind;
  const bool is_box = figure.figure.dimension == 3 && (kind == FigureKind::aabb || kind == FigureKind::obb);
  if (!is_box || !std::holds_alternative<std::monostate>(ray.pose.by)) return {};
  const PosedSpan span{
      kind == FigureKind::aabb ? span_of(shape_of<Aabb3>(figure.figure)) : span_of(shape_of<Obb3>(figure.figure)),
      figure.pose};
  const Sign turn =
      certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) { return ask(SpanImage<T>(span, Sign::positive).volume()); });
  if (turn == Sign::zero) return {};
  return answer_of_model<Answer>(given_ray(ray.figure), PosedBoxModel{span, turn});
}

}  // namespace

std::optional<std::optional<Hit>> first_hit_of_box(const PosedView& ray, const PosedView& figure) {
  return first_of_box<Hit>(ray, figure);
}
std::optional<std::optional<RayParameter>> first_parameter_of_box(const PosedView& ray, const PosedView& figure) {
  return first_of_box<RayParameter>(ray, figure);
}

}  // namespace plumb::query
