#include "space/bsp/ray_planes.hpp"

#include <limits>

#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/ray_order.hpp"
#include "plumb/predicates/line_triangle.hpp"

namespace plumb::space {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Running difference(double a, double b) { return Running(a) - Running(b); }

}  // namespace

RayPlanes::RayPlanes(const BspTree& tree, const AnyRay& ray)
    : tree_(tree), ray_(ray), direction_{Running(ray.direction.x), Running(ray.direction.y), Running(ray.direction.z)} {
  if (ray.kind != AnyRay::Kind::segment) return;
  const Point3 &p = ray.origin, &q = ray.end;
  direction_ = {difference(q.x, p.x), difference(q.y, p.y), difference(q.z, p.z)};
}

RayPlace RayPlanes::begin() const {
  const double t = ray_.kind == AnyRay::Kind::line ? -infinity : 0;
  return {ray_begin, t, t};
}

RayPlace RayPlanes::end() const {
  const double t = ray_.kind == AnyRay::Kind::segment ? 1 : infinity;
  return {ray_end, t, t};
}

Sign RayPlanes::heading(std::uint32_t plane) const {
  const bool is_segment = ray_.kind == AnyRay::Kind::segment;
  if (is_axis_plane(plane)) {
    const std::uint32_t axis = tree_.axis_planes[number_of_plane(plane)].axis;
    if (is_segment) return beyond(along_axis(ray_.end, axis), along_axis(ray_.origin, axis));
    const Vector3& d = ray_.direction;
    return beyond(axis == 0 ? d.x : axis == 1 ? d.y : d.z, 0);
  }
  const auto& [a, b, c] = tree_.planes[number_of_plane(plane)];
  if (!is_segment) return orient_seen_from(ray_.direction, a, b, c);
  const Point3 &p = ray_.origin, &q = ray_.end;
  return decide<predicates::OrientSeenAlong>(
      {p.x, p.y, p.z, q.x, q.y, q.z, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
}

RayPassage RayPlanes::passage(const BspNode& node) const {
  const Point3& o = ray_.origin;
  if (node.axis < 3) {
    const std::uint32_t plane = BspCorner::axis_plane | node.plane;
    const Running t = quotient(difference(node.at, along_axis(o, node.axis)), direction_[node.axis]);
    return {node_side(tree_, node, o), heading(plane), {plane, t.lower(), t.upper()}};
  }
  const std::uint32_t plane = BspCorner::face_plane | node.plane;
  const auto& [a, b, c] = tree_.planes[node.plane];
  const std::array<Running, 3> u{difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z)},
      v{difference(c.x, a.x), difference(c.y, a.y), difference(c.z, a.z)},
      w{difference(a.x, o.x), difference(a.y, o.y), difference(a.z, o.z)};
  Running above, below;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Running normal = u[i] * v[j] - u[j] * v[i];
    above = above + normal * w[k];
    below = below + normal * direction_[k];
  }
  const Unsure<Sign> behind = above.sign(), heading_told = below.sign();
  const Running t = quotient(above, below);
  return {behind.certain() ? -behind.value() : node_side(tree_, node, o),
          heading_told.certain() ? heading_told.value() : heading(plane),
          {plane, t.lower(), t.upper()}};
}

Sign RayPlanes::order_to_end(std::uint32_t plane, const RayPlace& end) const {
  if (end.plane == ray_begin && ray_.kind == AnyRay::Kind::line) return Sign::positive;
  if (end.plane == ray_end && ray_.kind != AnyRay::Kind::segment) return Sign::negative;
  const Sign side = plane_side(tree_, plane, end.plane == ray_begin ? ray_.origin : ray_.end);
  return -(side * heading(plane));
}

Sign RayPlanes::exact_order(const RayPlace& a, const RayPlace& b) const {
  const bool a_ends = a.plane >= ray_end, b_ends = b.plane >= ray_end;
  if (a_ends && b_ends) return a.plane == ray_begin ? Sign::negative : Sign::positive;
  if (b_ends) return order_to_end(a.plane, b);
  if (a_ends) return -order_to_end(b.plane, a);
  const auto first = tree_.points_of_plane(a.plane), second = tree_.points_of_plane(b.plane);
  return ray_.kind == AnyRay::Kind::segment ? *compare_segment_parameters(ray_.origin, ray_.end, first, second)
                                            : *compare_ray_parameters(ray_.origin, ray_.direction, first, second);
}

Sign RayPlanes::compare(const RayPlace& a, const RayPlace& b) const {
  if (a.plane == b.plane) return Sign::zero;
  if (a.most < b.least) return Sign::negative;
  if (a.least > b.most) return Sign::positive;
  return exact_order(a, b);
}

Sign RayPlanes::side(const RayPassage& passage, const RayPlace& place) const {
  if (passage.heading == Sign::zero) return passage.from;
  return passage.heading * compare(place, passage.place);
}

}  // namespace plumb::space
