#include "query/separation/aligned_boxes.hpp"

#include "figure/basic/in_space.hpp"
#include "query/body/figure_input.hpp"

namespace plumb::query {
namespace {

std::optional<Aabb3> aligned_box(const FigureView& v) {
  if (v.kind != FigureKind::aabb) return {};
  const Aabb3 box =
      v.dimension == 2 ? in_space(*static_cast<const Aabb2*>(v.shape)) : *static_cast<const Aabb3*>(v.shape);
  if (!is_sound(box) || is_empty(box)) return {};
  return box;
}

/// Along one axis.
void face(double min_a, double max_a, double min_b, double max_b, double& on_a, double& on_b) {
  if (max_a < min_b) {
    on_a = max_a, on_b = min_b;
  } else if (max_b < min_a) {
    on_a = min_a, on_b = max_b;
  } else {
    on_a = on_b = min_a < min_b ? min_b : min_a;
  }
}

}  // namespace

std::optional<FacingPoints> facing_points(const FigureView& a, const FigureView& b) {
  const auto p = aligned_box(a), q = aligned_box(b);
  if (!p || !q) return {};
  FacingPoints f{*p, *q, {}, {}};
  face(p->min.x, p->max.x, q->min.x, q->max.x, f.on_a.x, f.on_b.x);
  face(p->min.y, p->max.y, q->min.y, q->max.y, f.on_a.y, f.on_b.y);
  face(p->min.z, p->max.z, q->min.z, q->max.z, f.on_a.z, f.on_b.z);
  return f;
}

}  // namespace plumb::query
