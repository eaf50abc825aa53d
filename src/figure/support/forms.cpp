#include "figure/support/forms.hpp"

#include "plumb/certify/direction.hpp"

namespace plumb::figure::support {
namespace {

/// Is the direction parallel to the axis from a to b?
bool is_along(const Point3& a, const Point3& b, const Vector3& d) {
  const auto turns = [](double ax, double ay, double bx, double by, double dx, double dy) {
    return sign_of([](auto px, auto py, auto qx, auto qy, auto x, auto y) { return (qx - px) * y - (qy - py) * x; }, ax,
                   ay, bx, by, dx, dy) != Sign::zero;
  };
  return !turns(a.x, a.y, b.x, b.y, d.x, d.y) && !turns(a.y, a.z, b.y, b.z, d.y, d.z) &&
         !turns(a.z, a.x, b.z, b.x, d.z, d.x);
}

/// How far the apex lies beyond the disk, by squares: ((a - b) . d)^2 |a - b|^2 against r^2 |(a - b) x d|^2, for a cone
/// from a to b.
struct ApexAgainstRim {
  static constexpr std::string_view name = "support_point";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto x = p[0] - p[3], y = p[1] - p[4], z = p[2] - p[5];
    const auto along = x * p[6] + y * p[7] + z * p[8];
    const auto cx = y * p[8] - z * p[7], cy = z * p[6] - x * p[8], cz = x * p[7] - y * p[6];
    return along * along * (x * x + y * y + z * z) - (cx * cx + cy * cy + cz * cz) * (p[9] * p[9]);
  }
};

Choice of_ball(double radius, const Vector3& d) {
  const bool round = radius > 0 && !is_zero(d);
  return {0, round || radius == 0, round};
}

}  // namespace

Choice choose(const Sphere3& s, const Vector3& d) { return of_ball(s.radius, d); }

Choice choose(const Capsule3& s, const Vector3& d) {
  Choice c = of_ball(s.radius, d);
  const Sign farther = compare_along_direction(s.b, s.a, d);
  c.feature = farther == Sign::positive ? 1 : 0;
  c.unique = c.unique && (farther != Sign::zero || s.a == s.b);
  return c;
}

Choice choose(const Lozenge3& s, const Vector3& d) {
  Choice c = of_ball(s.radius, d);
  for (std::uint32_t i = 0; i < 2; ++i) {
    const Sign farther = dot_sign(s.edges[i], d);
    if (farther == Sign::positive) c.feature |= 1u << i;
    c.unique = c.unique && (farther != Sign::zero || is_zero(s.edges[i]));
  }
  return c;
}

Choice choose(const Cylinder3& s, const Vector3& d) {
  if (s.a == s.b) return of_ball(s.radius, d);
  const Sign farther = compare_along_direction(s.b, s.a, d);
  const bool whole_disk = s.radius > 0 && is_along(s.a, s.b, d);
  return {farther == Sign::positive ? 1u : 0u, farther != Sign::zero && !whole_disk, s.radius > 0 && !whole_disk};
}

Choice choose(const Cone3& s, const Vector3& d) {
  if (s.apex == s.base) return of_ball(s.radius, d);
  Sign farther = compare_along_direction(s.apex, s.base, d);
  if (farther == Sign::positive) {
    farther = sign_of(ApexAgainstRim{}, s.apex, s.base, d, s.radius);
  } else if (farther == Sign::zero && s.radius > 0 && !is_zero(d)) {
    farther = Sign::negative;
  }
  if (farther != Sign::negative) return {0, farther == Sign::positive, false};
  const bool whole_disk = s.radius > 0 && is_along(s.apex, s.base, d);
  return {1, !whole_disk, s.radius > 0 && !whole_disk};
}

Choice choose(const Ellipsoid3& s, const Vector3& d) {
  const std::array<double, 3> half{s.half.x, s.half.y, s.half.z};
  bool round = false, point = true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (half[i] == 0 || is_zero(s.axes[i])) continue;
    point = false;
    round = round || dot_sign(s.axes[i], d) != Sign::zero;
  }
  return {0, round || point, round};
}

}  // namespace plumb::figure::support
