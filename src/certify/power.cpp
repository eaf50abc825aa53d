#include "plumb/certify/power.hpp"

#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

std::array<double, 3> numbers(const WeightedPoint2& a) { return {a.point.x, a.point.y, a.weight}; }
std::array<double, 4> numbers(const WeightedPoint3& a) { return {a.point.x, a.point.y, a.point.z, a.weight}; }

}  // namespace

Sign in_power_circle(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                     const WeightedPoint2& d) {
  return sign_of(predicates::PowerCircle{}, numbers(a), numbers(b), numbers(c), numbers(d));
}
Sign in_power_sphere(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c, const WeightedPoint3& d,
                     const WeightedPoint3& e) {
  return sign_of(predicates::PowerSphere{}, numbers(a), numbers(b), numbers(c), numbers(d), numbers(e));
}

Sign compare_power(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b) {
  return sign_of(predicates::ComparePower2d{}, p, numbers(a), numbers(b));
}
Sign compare_power(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b) {
  return sign_of(predicates::ComparePower3d{}, p, numbers(a), numbers(b));
}

Sign power_sign(const Point2& p, const WeightedPoint2& a) { return power_sign(WeightedPoint2{p, 0}, a); }
Sign power_sign(const Point3& p, const WeightedPoint3& a) { return power_sign(WeightedPoint3{p, 0}, a); }
Sign power_sign(const WeightedPoint2& a, const WeightedPoint2& b) {
  return sign_of(predicates::PowerProduct2d{}, numbers(a), numbers(b));
}
Sign power_sign(const WeightedPoint3& a, const WeightedPoint3& b) {
  return sign_of(predicates::PowerProduct3d{}, numbers(a), numbers(b));
}

}  // namespace plumb
