#include "query/time_of_impact/moving_axes.hpp"

namespace plumb::query {
namespace {

class Axes {
 public:
  Axes(const MovingBody<Running>& a, const MovingBody<Running>& b, const Vec3<Running>& velocity)
      : a_(a), b_(b), velocity_(velocity), reach_((a.reach + b.reach).upper()) {}

  /// Narrows the window; is there any left?  `length` is no less than that of the axis.
  bool meet(const Vec3<Running>& axis, double length) {
    return meet(ends(a_, axis), ends(b_, axis), dot(velocity_, axis), length);
  }
  /// A plane has an extent along its normal alone.
  void meet_plane() {
    const bool plane_is_a = a_.vertices.empty();
    const auto& face = (plane_is_a ? a_ : b_).faces[0];
    const FeatureEnds at{face.offset.lower(), face.offset.upper()}, other = ends(plane_is_a ? b_ : a_, face.normal);
    meet(plane_is_a ? at : other, plane_is_a ? other : at, dot(velocity_, face.normal), length_of(face.normal));
  }
  static double length_of(const Vec3<Running>& axis) { return root_above(dot(axis, axis).upper()); }

  [[nodiscard]] const TimeWindow& window() const { return window_; }

 private:
  struct FeatureEnds {
    double low, high;
  };
  static double root_above(double x) { return __builtin_sqrt(x) * (1 + 0x1p-50) + 0x1p-500; }

  static FeatureEnds ends(const MovingBody<Running>& body, const Vec3<Running>& axis) {
    FeatureEnds e{Interval::infinity, -Interval::infinity};
    for (const auto& v : body.vertices) {
      const Running at = dot(v, axis);
      e = {std::min(e.low, at.lower()), std::max(e.high, at.upper())};
    }
    return e;
  }
  bool meet(const FeatureEnds& of_a, const FeatureEnds& of_b, const Running& speed, double length) {
    const double reach = reach_ == 0 ? 0 : reach_ * length * (1 + 0x1p-50) + 0x1p-1060;
    const Slabs slab({speed, Running(0.0), Running(0.0)}, Running(reach));
    const auto [from, to] = slab.times({{of_a.low, 0, 0}, {of_a.high, 0, 0}}, {{of_b.low, 0, 0}, {of_b.high, 0, 0}});
    window_ = {std::max(window_.from, from), std::min(window_.to, to)};
    return !window_.empty();
  }

  const MovingBody<Running>&a_, &b_;
  const Vec3<Running>& velocity_;
  double reach_;
  TimeWindow window_;
};

Vec3<Running> along(const MovingBody<Running>& body, const MovingBody<Running>::Edge& e) {
  return body.vertices[e.ends[1]] - body.vertices[e.ends[0]];
}

void narrow(Axes& axes, const MovingBody<Running>& a, const MovingBody<Running>& b) {
  if (a.vertices.empty() || b.vertices.empty()) {
    axes.meet_plane();
    return;
  }
  const Running one(1.0), zero(0.0);
  if (!axes.meet({one, zero, zero}, 1) || !axes.meet({zero, one, zero}, 1) || !axes.meet({zero, zero, one}, 1)) return;
  for (const auto* body : {&a, &b}) {
    for (const auto& f : body->faces) {
      if (!axes.meet(f.normal, Axes::length_of(f.normal))) return;
    }
  }
  constexpr std::size_t few = 12;  // edges: of more the faces tell enough
  if (a.edges.size() > few || b.edges.size() > few) return;
  for (const auto& e : a.edges) {
    for (const auto& f : b.edges) {
      const Vec3<Running> axis = cross(along(a, e), along(b, f));
      if (!axes.meet(axis, Axes::length_of(axis))) return;
    }
  }
  // Of what is round: the ways from vertex to vertex.
  constexpr std::size_t few_ways = 16;
  if (!(a.swept || b.swept) || a.vertices.size() * b.vertices.size() > few_ways) return;
  for (const auto& v : a.vertices) {
    for (const auto& w : b.vertices) {
      if (!axes.meet(w - v, Axes::length_of(w - v))) return;
    }
  }
}

}  // namespace

TimeWindow time_window(const MovingBody<Running>& a, const MovingBody<Running>& b, const Vec3<Running>& velocity) {
  Axes axes(a, b, velocity);
  narrow(axes, a, b);
  return axes.window();
}

namespace {

struct BoxAround {
  FeatureBox operator()(const Point3* p) const { return {{p->x, p->y, p->z}, {p->x, p->y, p->z}}; }
  FeatureBox operator()(const Segment3* s) const { return joined((*this)(&s->a), (*this)(&s->b)); }
  FeatureBox operator()(const Triangle3* t) const {
    return joined(joined((*this)(&t->a), (*this)(&t->b)), (*this)(&t->c));
  }
  FeatureBox operator()(const Aabb3* b) const { return joined((*this)(&b->min), (*this)(&b->max)); }
  FeatureBox operator()(const Obb3* b) const {
    const auto reach = [&](double x, double y, double z) {
      return size(x * b->half.x) + size(y * b->half.y) + size(z * b->half.z);
    };
    const auto& [u, v, w] = b->axes;
    return grown((*this)(&b->center), {reach(u.x, v.x, w.x), reach(u.y, v.y, w.y), reach(u.z, v.z, w.z)});
  }
  FeatureBox operator()(const ConvexPolyhedron3* p) const {
    FeatureBox box = (*this)(p->mesh.vertices.data());
    for (const Point3& v : p->mesh.vertices) box = joined(box, (*this)(&v));
    return box;
  }
  FeatureBox operator()(const Sphere3* s) const {
    return grown((*this)(&s->center), {s->radius, s->radius, s->radius});
  }
  FeatureBox operator()(const Capsule3* c) const {
    return grown(joined((*this)(&c->a), (*this)(&c->b)), {c->radius, c->radius, c->radius});
  }
  FeatureBox operator()(const Plane3*) const {
    constexpr double all = Interval::infinity;
    return {{-all, -all, -all}, {all, all, all}};
  }

  static double size(double x) { return __builtin_fabs(x); }
  static FeatureBox grown(FeatureBox box, const std::array<double, 3>& by) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double slack = (size(box.low[k]) + size(box.high[k]) + by[k]) * 0x1p-50 + 0x1p-1060;
      box.low[k] -= by[k] + slack, box.high[k] += by[k] + slack;
    }
    return box;
  }
};

}  // namespace

FeatureBox bounding_box(const BodyShape& shape) { return std::visit(BoxAround{}, shape); }

}  // namespace plumb::query
