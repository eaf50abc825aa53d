#include "query/time_of_impact/moving_axes.hpp"

#include "arith/big_rounding.hpp"
#include "arith/exact_number.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/time_of_impact/vector_length.hpp"

namespace plumb::query {
namespace {

using Kind = TimeAxis::Kind;

class Axes {
 public:
  Axes(const MovingBody<Running>& a, const MovingBody<Running>& b, const Vec3<Running>& velocity)
      : a_(a), b_(b), velocity_(velocity), reach_((a.reach + b.reach).upper()) {}

  /// Narrows the window; is there any left?  `length` is no less than that of the axis.
  bool meet(const Vec3<Running>& axis, double length, const TimeAxis& which) {
    return meet(ends(a_, axis), ends(b_, axis), dot(velocity_, axis), length, which);
  }
  /// A plane has an extent along its normal alone.
  void meet_plane() {
    const bool plane_is_a = a_.vertices.empty();
    const auto& face = (plane_is_a ? a_ : b_).faces[0];
    const FeatureEnds at{face.offset.lower(), face.offset.upper()}, other = ends(plane_is_a ? b_ : a_, face.normal);
    meet(plane_is_a ? at : other, plane_is_a ? other : at, dot(velocity_, face.normal), length_above(face.normal),
         {Kind::ways});
  }

  [[nodiscard]] const TimeWindow& window() const { return window_; }

 private:
  struct FeatureEnds {
    double low, high;
  };
  static FeatureEnds ends(const MovingBody<Running>& body, const Vec3<Running>& axis) {
    Running low(Interval::infinity), high(-Interval::infinity);
    double error = 0;
    bool known = true;
    for (const auto& v : body.vertices) {
      const Running at = dot(v, axis);
      low.value = std::min(low.value, at.value), high.value = std::max(high.value, at.value);
      error = std::max(error, at.error), known &= at.error < Interval::infinity;
    }
    if (!known) return {-Interval::infinity, Interval::infinity};
    low.error = high.error = error;
    return {low.lower(), high.upper()};
  }
  bool meet(const FeatureEnds& of_a, const FeatureEnds& of_b, const Running& speed, double length,
            const TimeAxis& which) {
    const double reach = Interval::product_up(reach_, length);
    const Slabs slab({speed, Running(0.0), Running(0.0)}, Running(reach));
    const auto [from, to] = slab.times({{of_a.low, 0, 0}, {of_a.high, 0, 0}}, {{of_b.low, 0, 0}, {of_b.high, 0, 0}});
    if (from > window_.from) window_.from = from, window_.axis = which;
    window_.to = std::min(window_.to, to);
    return !window_.empty();
  }

  const MovingBody<Running>&a_, &b_;
  const Vec3<Running>& velocity_;
  double reach_;
  TimeWindow window_;
};

template <class T>
Vec3<T> along(const MovingBody<T>& body, const typename MovingBody<T>::Edge& e) {
  return body.vertices[e.ends[1]] - body.vertices[e.ends[0]];
}

void narrow(Axes& axes, const MovingBody<Running>& a, const MovingBody<Running>& b) {
  if (a.vertices.empty() || b.vertices.empty()) {
    axes.meet_plane();
    return;
  }
  const Running one(1.0), zero(0.0);
  const std::array<Vec3<Running>, 3> coordinates{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}};
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (!axes.meet(coordinates[k], 1, {Kind::coordinate, k})) return;
  }
  for (const auto* body : {&a, &b}) {
    const Kind kind = body == &a ? Kind::face_of_a : Kind::face_of_b;
    for (std::uint32_t i = 0; i < body->faces.size(); ++i) {
      const Vec3<Running>& normal = body->faces[i].normal;
      if (!axes.meet(normal, length_above(normal), {kind, i, i})) return;
    }
  }
  constexpr std::size_t few = 12;  // edges: of more the faces tell enough
  if (a.edges.size() > few || b.edges.size() > few) return;
  for (std::uint32_t i = 0; i < a.edges.size(); ++i) {
    for (std::uint32_t k = 0; k < b.edges.size(); ++k) {
      const Vec3<Running> axis = cross(along(a, a.edges[i]), along(b, b.edges[k]));
      if (!axes.meet(axis, length_above(axis), {Kind::edges, i, k})) return;
    }
  }
  // Of what is round: the ways from vertex to vertex.
  constexpr std::size_t few_ways = 16;
  if (!(a.swept || b.swept) || a.vertices.size() * b.vertices.size() > few_ways) return;
  for (const auto& v : a.vertices) {
    for (const auto& w : b.vertices) {
      if (!axes.meet(w - v, length_above(w - v), {Kind::ways})) return;
    }
  }
}

/// The axis itself.
Vec3<BigDyadic> exact_axis(const MovingBody<BigDyadic>& a, const MovingBody<BigDyadic>& b, const TimeAxis& axis) {
  if (axis.kind == Kind::face_of_a) return a.faces[axis.a].normal;
  if (axis.kind == Kind::face_of_b) return b.faces[axis.b].normal;
  if (axis.kind == Kind::edges) return cross(along(a, a.edges[axis.a]), along(b, b.edges[axis.b]));
  const auto part = [&](std::uint32_t k) { return BigDyadic(axis.a == k ? 1.0 : 0.0); };
  return {part(0), part(1), part(2)};
}

/// How far the body reaches along an axis: most, or least.
BigDyadic end_along(const MovingBody<BigDyadic>& body, const Vec3<BigDyadic>& axis, Sign way) {
  BigDyadic end = dot(body.vertices[0], axis);
  for (std::size_t i = 1; i < body.vertices.size(); ++i) {
    BigDyadic at = dot(body.vertices[i], axis);
    if ((at - end).sign() == way) end = std::move(at);
  }
  return end;
}

}  // namespace

TimeWindow time_window(const MovingBody<Running>& a, const MovingBody<Running>& b, const Vec3<Running>& velocity) {
  Axes axes(a, b, velocity);
  narrow(axes, a, b);
  return axes.window();
}

Rational AxisEntry::time() const { return exact_number(way) / exact_number(speed); }
double AxisEntry::rounded(Rounding rounding) const { return rounded_quotient(rounding, way, speed); }

std::optional<AxisEntry> exact_entry(const MovingBody<BigDyadic>& a, const MovingBody<BigDyadic>& b,
                                     const Vec3<BigDyadic>& velocity, const TimeAxis& axis) {
  const BigDyadic zero(0.0), one(1.0);
  if (axis.kind == Kind::start) return AxisEntry{zero, one};
  if (axis.kind == Kind::ways) return {};
  const Vec3<BigDyadic> n = exact_axis(a, b, axis);
  BigDyadic speed = dot(velocity, n);
  if (speed.sign() == Sign::zero) return {};
  const bool up = speed.sign() == Sign::positive;
  const Sign fore = up ? Sign::positive : Sign::negative;
  BigDyadic way = end_along(b, n, -fore) - end_along(a, n, fore);
  if (!up) way = zero - way, speed = zero - speed;
  if (way.sign() == Sign::negative) way = zero;
  return AxisEntry{std::move(way), std::move(speed)};
}

namespace {

FeatureBox grown(FeatureBox box, double by) {
  for (std::size_t k = 0; k < 3; ++k)
    box.low[k] = Interval::sum_down(box.low[k], -by), box.high[k] = Interval::sum_up(box.high[k], by);
  return box;
}

}  // namespace

FeatureBox bounding_box(const PosedView& v) {
  constexpr double all = Interval::infinity;
  std::optional<WeightedPose<Running>> pose;
  if (!v.pose.stands()) pose = weighted_pose<Running>(v.pose);
  const auto box_at = [&](const Vec3<Running>& p) {
    if (!pose) return box_of(p);
    const Vec3<Running> q = pose->image(p);
    if (!pose->has_weight) return box_of(q);
    return box_of(Vec3<Running>{quotient(q.x, pose->weight), quotient(q.y, pose->weight), quotient(q.z, pose->weight)});
  };
  std::optional<FeatureBox> box;
  double reach = 0;
  with_figure(v.figure, [&]<class Shape>(const Shape& s) {
    if constexpr (has_boundary<Shape>)
      for_each_corner<Running>(s, [&](const Vec3<Running>& p) { box = box ? joined(*box, box_at(p)) : box_at(p); });
    if constexpr (requires { s.radius; })
      reach = is_rigid(v.pose) || s.radius == 0 ? s.radius : (Running(s.radius) * Running(*scale_of(v.pose))).upper();
  });
  return box ? grown(*box, reach) : FeatureBox{{-all, -all, -all}, {all, all, all}};
}

}  // namespace plumb::query
