#include "plumb/certify/side_of_plane.hpp"

#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

// Of a squared comparison: a negative number is below every distance.  The distance from everything is zero.
Sign unsquared(Sign s, double distance, bool everything) {
  if (distance < 0) return Sign::positive;
  return everything ? -sign_of_number(distance) : s;
}

}  // namespace

Sign side_of_line(const Vector2& normal, double offset, const Point2& p) {
  return sign_of(predicates::SideOfLine{}, normal, offset, p);
}
Sign side_of_plane(const Vector3& normal, double offset, const Point3& p) {
  return sign_of(predicates::SideOfPlane{}, normal, offset, p);
}

Sign compare_distance_to_line(const Vector2& normal, double offset, const Point2& p, double distance) {
  const Sign s = sign_of(predicates::NormalDistanceAgainst2d{}, normal, offset, p, distance);
  return unsquared(s, distance, normal == Vector2{} && offset == 0);
}
Sign compare_distance_to_plane(const Vector3& normal, double offset, const Point3& p, double distance) {
  const Sign s = sign_of(predicates::NormalDistanceAgainst3d{}, normal, offset, p, distance);
  return unsquared(s, distance, normal == Vector3{} && offset == 0);
}

}  // namespace plumb
