// Balls, capsules, cylinders and cones.
#include "figure/containment/contains_input.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates/distance.hpp"

namespace plumb {
namespace figure::containment {
namespace {

/// For a ball of radius zero the sign is never negative: it has no inside.
Location in_ball(const Point3& center, double radius, const Point3& p) {
  return location(sign_of(predicates::DistanceAgainst3d{}, center, p, radius));
}

template <class Capsule, class Point>
Location locate_in_capsule(const Capsule& capsule, const Point& p) {
  figure::require_sound("contains", capsule, part::place("p", p));
  return location(compare_distance_to_segment(capsule.a, capsule.b, p, capsule.radius));
}

/// Between the planes through a and b that are perpendicular to ab, for a != b.
Location between_ends(const Point3& a, const Point3& b, const Point3& p) {
  return both(location(compare_along_line(a, p, a, b)), location(compare_along_line(p, b, a, b)));
}

/// (apex, base, p, radius): with h from the apex to the base and w to p, the cone's surface is at |w x h| / |h| =
/// radius (w . h) / |h|^2 from its axis; this is the difference of the squares, times |h|^4.
struct BeyondCone {
  static constexpr std::string_view name = "contains";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& x) const {
    const auto h = predicates::difference(x, 0, 1), w = predicates::difference(x, 0, 2);
    const auto across = predicates::cross(w, h);
    const auto reach = predicates::dot(w, h) * x[9];
    return predicates::dot(across, across) * predicates::dot(h, h) - reach * reach;
  }
};

}  // namespace
}  // namespace figure::containment

using namespace figure::containment;

Location locate(const Circle2& circle, const Point2& p) {
  figure::require_sound("contains", circle, part::place("p", p));
  return location(sign_of(predicates::DistanceAgainst2d{}, circle.center, p, circle.radius));
}

Location locate(const Sphere3& sphere, const Point3& p) {
  figure::require_sound("contains", sphere, part::place("p", p));
  return in_ball(sphere.center, sphere.radius, p);
}

Location locate(const Capsule2& capsule, const Point2& p) { return locate_in_capsule(capsule, p); }
Location locate(const Capsule3& capsule, const Point3& p) { return locate_in_capsule(capsule, p); }

Location locate(const Cylinder3& cylinder, const Point3& p) {
  const auto& [a, b, radius] = cylinder;
  figure::require_sound("contains", cylinder, part::place("p", p));
  if (a == b) return in_ball(a, radius, p);
  const Location ends = between_ends(a, b, p);
  if (ends == Location::outside) return ends;
  return both(ends, location(compare_distance_to_line(a, b, p, radius)));
}

/// A cap without interior is on the boundary of the ball or of the halfspace.
Location locate(const SphericalCap3& cap, const Point3& p) {
  figure::require_sound("contains", cap, part::place("p", p));
  const Location ball = in_ball(cap.sphere.center, cap.sphere.radius, p);
  return ball == Location::outside ? ball : both(ball, locate(cap.halfspace, p));
}

Location locate(const Cone3& cone, const Point3& p) {
  const auto& [apex, base, radius] = cone;
  figure::require_sound("contains", cone, part::place("p", p));
  if (apex == base) return in_ball(apex, radius, p);
  const Location ends = between_ends(apex, base, p);
  if (ends == Location::outside) return ends;
  return both(ends, location(sign_of(BeyondCone{}, apex, base, p, radius)));
}

}  // namespace plumb
