// The worked example of docs/add_a_figure.md.
#pragma once

#include <plumb/figure.hpp>
#include <plumb/query.hpp>

namespace mine {

/// All points within the radius of the triangle.
struct Cushion {
  plumb::Triangle3 core;
  double radius;
};

template <class Take>
constexpr auto body(const Cushion& s, Take take) {
  return take("cushion", plumb::part::figure("core", s.core), plumb::part::length("radius", s.radius));
}

inline plumb::Location locate(const Cushion& s, const plumb::Point3& p) {
  plumb::figure::require_sound("contains", s, plumb::part::place("p", p));
  return static_cast<plumb::Location>(-static_cast<int>(compare_distance(s.core, p, s.radius)));
}

/// The farthest of three balls: rounding keeps their order.
inline double support_value(const Cushion& s, const plumb::Vector3& direction, plumb::Rounding rounding) {
  plumb::figure::require_sound("support_value", s, plumb::part::axis("direction", direction));
  const auto reach = [&](const plumb::Point3& p) {
    return support_value(plumb::Sphere3{p, s.radius}, direction, rounding);
  };
  const double a = reach(s.core.a), b = reach(s.core.b), c = reach(s.core.c);
  return a > b ? (a > c ? a : c) : (b > c ? b : c);
}

}  // namespace mine

/// It is the convex hull of its places, and all within its length of that.
template <>
inline constexpr bool plumb::is_rounded_hull<mine::Cushion> = plumb::hull_of_places<mine::Cushion>();
