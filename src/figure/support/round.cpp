#include "figure/support/forms.hpp"
#include "plumb/figure/support/support.hpp"

namespace plumb {
namespace {

template <class Shape>
Support3 of(const Shape& shape, const Vector3& direction) {
  const Vector3 d = figure::support::handy(direction);
  const figure::support::Choice c = figure::support::choose(shape, d);
  const auto nearest = [&](const auto& take) { return figure::support::rounded(Rounding::nearest, shape, d, c, take); };
  const Point3 p{nearest([](const auto&, const auto& v) { return v.x; }),
                 nearest([](const auto&, const auto& v) { return v.y; }),
                 nearest([](const auto&, const auto& v) { return v.z; })};
  return {figure::support::within_doubles(p), c.feature, c.unique};
}

Support2 flat(const Support3& s) { return {{s.point.x, s.point.y}, s.feature, s.unique}; }

template <class Shape>
Support3 checked(const Shape& shape, const Vector3& direction) {
  figure::require_sound("support_point", shape, part::axis("direction", direction));
  return of(shape, direction);
}

}  // namespace

Support2 support_point(const Circle2& s, const Vector2& direction) {
  figure::require_sound("support_point", s, part::axis("direction", direction));
  return flat(of(Sphere3{figure::support::raised(s.center), s.radius}, figure::support::raised(direction)));
}
Support2 support_point(const Capsule2& s, const Vector2& direction) {
  figure::require_sound("support_point", s, part::axis("direction", direction));
  return flat(of(Capsule3{figure::support::raised(s.a), figure::support::raised(s.b), s.radius},
                 figure::support::raised(direction)));
}

Support3 support_point(const Sphere3& s, const Vector3& direction) { return checked(s, direction); }
Support3 support_point(const Capsule3& s, const Vector3& direction) { return checked(s, direction); }
Support3 support_point(const Lozenge3& s, const Vector3& direction) { return checked(s, direction); }
Support3 support_point(const Cylinder3& s, const Vector3& direction) { return checked(s, direction); }
Support3 support_point(const Cone3& s, const Vector3& direction) { return checked(s, direction); }
Support3 support_point(const Ellipsoid3& s, const Vector3& direction) { return checked(s, direction); }

}  // namespace plumb
