#include "plumb/certify/direction.hpp"

#include "certify/finite.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

using predicates::OrderOnAxis;

// The first that is not zero of some signs.
Sign first_of(Sign s, auto next) { return s != Sign::zero ? s : next(); }

}  // namespace

Sign compare_x(const Point2& a, const Point2& b) { return sign_of(OrderOnAxis{}, a.x, b.x); }
Sign compare_y(const Point2& a, const Point2& b) { return sign_of(OrderOnAxis{}, a.y, b.y); }
Sign compare_x(const Point3& a, const Point3& b) { return sign_of(OrderOnAxis{}, a.x, b.x); }
Sign compare_y(const Point3& a, const Point3& b) { return sign_of(OrderOnAxis{}, a.y, b.y); }
Sign compare_z(const Point3& a, const Point3& b) { return sign_of(OrderOnAxis{}, a.z, b.z); }

Sign compare_lexicographically(const Point2& a, const Point2& b) {
  require_finite("compare_lexicographically", a, b);
  return first_of(compare_x(a, b), [&] { return compare_y(a, b); });
}
Sign compare_lexicographically(const Point3& a, const Point3& b) {
  require_finite("compare_lexicographically", a, b);
  return first_of(compare_x(a, b), [&] { return first_of(compare_y(a, b), [&] { return compare_z(a, b); }); });
}

Sign compare_along_direction(const Point2& a, const Point2& b, const Vector2& direction) {
  return sign_of(predicates::OrderAlongDirection2d{}, a, b, direction);
}
Sign compare_along_direction(const Point3& a, const Point3& b, const Vector3& direction) {
  return sign_of(predicates::OrderAlongDirection3d{}, a, b, direction);
}

Sign compare_along_line(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of(predicates::OrderAlongLine2d{}, a, b, c, d);
}
Sign compare_along_line(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(predicates::OrderAlongLine3d{}, a, b, c, d);
}

// Of collinear points b is between a and c when they do not lie on the same side of it.
bool are_ordered_along_line(const Point2& a, const Point2& b, const Point2& c) {
  return collinear(a, b, c) && angle_sign(a, b, c) != Sign::positive;
}
bool are_ordered_along_line(const Point3& a, const Point3& b, const Point3& c) {
  return collinear(a, b, c) && angle_sign(a, b, c) != Sign::positive;
}

Sign dot_sign(const Vector2& a, const Vector2& b) { return sign_of(predicates::Dot2d{}, a, b); }
Sign dot_sign(const Vector3& a, const Vector3& b) { return sign_of(predicates::Dot3d{}, a, b); }

Sign angle_sign(const Point2& a, const Point2& b, const Point2& c) { return sign_of(predicates::Angle2d{}, a, b, c); }
Sign angle_sign(const Point3& a, const Point3& b, const Point3& c) { return sign_of(predicates::Angle3d{}, a, b, c); }

Sign cross_sign(const Vector2& a, const Vector2& b) { return sign_of(predicates::Cross2d{}, a, b); }

bool perpendicular(const Vector2& a, const Vector2& b) { return dot_sign(a, b) == Sign::zero; }
bool perpendicular(const Vector3& a, const Vector3& b) { return dot_sign(a, b) == Sign::zero; }

bool parallel(const Vector2& a, const Vector2& b) { return cross_sign(a, b) == Sign::zero; }
bool parallel(const Vector3& a, const Vector3& b) {
  require_finite("parallel", a, b);
  return sign_of(predicates::CrossZ{}, a.x, a.y, b.x, b.y) == Sign::zero &&
         sign_of(predicates::CrossX{}, a.y, a.z, b.y, b.z) == Sign::zero &&
         sign_of(predicates::CrossY{}, a.z, a.x, b.z, b.x) == Sign::zero;
}

bool collinear(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of(predicates::Orient2d{}, a, b, c) == Sign::zero;
}
bool collinear(const Point3& a, const Point3& b, const Point3& c) {
  require_finite("collinear", a, b, c);
  return sign_of(predicates::OrientZ{}, a.x, a.y, b.x, b.y, c.x, c.y) == Sign::zero &&
         sign_of(predicates::OrientX{}, a.y, a.z, b.y, b.z, c.y, c.z) == Sign::zero &&
         sign_of(predicates::OrientY{}, a.z, a.x, b.z, b.x, c.z, c.x) == Sign::zero;
}

}  // namespace plumb
