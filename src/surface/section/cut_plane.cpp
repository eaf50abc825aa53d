#include "surface/section/cut_plane.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/certify/constructed.hpp"
#include "plumb/certify/side_of_plane.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb::surface {
namespace {

// A coordinate of the point where the edge pq meets the plane: p's and q's, each weighted by the other's height.
struct AxisCut {  // (p's coordinate and height, q's, the plane's height)
  static constexpr std::string_view name = "section";
  static constexpr std::array arguments{2, 2, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return p[0] * (p[3] - p[4]) - p[2] * (p[1] - p[4]);
  }
};
struct AxisWeight {
  static constexpr std::string_view name = "section";
  static constexpr std::array arguments{2, 2, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return p[3] - p[1];
  }
};

template <std::size_t Axis>
struct ObliqueCut {  // (normal, offset, p, q)
  static constexpr std::string_view name = "section";
  static constexpr std::array arguments{3, 1, 3, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto below = p[0] * p[4] + p[1] * p[5] + p[2] * p[6] - p[3];
    const auto above = p[0] * p[7] + p[1] * p[8] + p[2] * p[9] - p[3];
    return p[4 + Axis] * above - p[7 + Axis] * below;
  }
};
struct ObliqueWeight {
  static constexpr std::string_view name = "section";
  static constexpr std::array arguments{3, 1, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    return p[0] * (p[7] - p[4]) + p[1] * (p[8] - p[5]) + p[2] * (p[9] - p[6]);
  }
};

Point2 along(const Point3& p, std::size_t axis) {
  return {coordinate(p, (axis + 1) % 3), coordinate(p, (axis + 2) % 3)};
}

// The axes, the one of the largest magnitude first.
std::array<std::size_t, 3> by_magnitude(const std::array<double, 3>& x) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::ranges::stable_sort(axes, std::ranges::greater{}, [&](std::size_t k) { return std::fabs(x[k]); });
  return axes;
}

[[noreturn]] void throw_no_plane(const char* why) {
  throw InvalidShape(std::string("section: ").append(why).append(", so that it has no sides"));
}

}  // namespace

CutPlane::CutPlane(const AnyPlane3& plane) : form_(AxisPlane{}) {
  if (const auto* const given = std::get_if<Plane3>(&plane)) {
    require_finite_parts<Vector3, double>("section", {"plane.normal", "plane.offset"}, given->normal, given->offset);
    const std::array<double, 3> n = coordinates(given->normal);
    const std::size_t axis = by_magnitude(n)[0];
    if (n[axis] == 0) throw_no_plane("the plane has a zero normal");
    show_along(axis, n[axis] < 0);
    if (std::fabs(n[axis]) == 1 && n[shown_[0]] == 0 && n[shown_[1]] == 0) {
      form_ = AxisPlane{axis, n[axis] * given->offset, n[axis] < 0};
    } else {
      form_ = *given;
    }
    return;
  }
  const auto& [a, b, c] = std::get<ThreePointPlane3>(plane);
  require_finite_parts<Point3, Point3, Point3>("section", {"plane.a", "plane.b", "plane.c"}, a, b, c);
  form_ = ThroughPoints{{a, b, c}, Side<predicates::Orient3d>(a, b, c)};
  // A guess of the normal says where to look first; the sign decides.
  const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
  const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  for (const std::size_t axis :
       by_magnitude({n[0] - n[0] == 0 ? n[0] : 0, n[1] - n[1] == 0 ? n[1] : 0, n[2] - n[2] == 0 ? n[2] : 0})) {
    const Sign s = orient2d(along(a, axis), along(b, axis), along(c, axis));
    if (s == Sign::zero) continue;
    show_along(axis, s == Sign::negative);
    return;
  }
  throw_no_plane("the plane's three points lie on one line");
}

void CutPlane::show_along(std::size_t axis, bool down) {
  shown_ = {(axis + (down ? 2 : 1)) % 3, (axis + (down ? 1 : 2)) % 3};
}

Sign CutPlane::side(const Point3& p) const {
  if (const AxisPlane* const flat = axis_plane()) {
    const double x = coordinate(p, flat->axis);
    const Sign s = x > flat->height ? Sign::positive : x < flat->height ? Sign::negative : Sign::zero;
    return flat->down ? -s : s;
  }
  if (const auto* const plane = std::get_if<Plane3>(&form_)) return side_of_plane(plane->normal, plane->offset, p);
  return -std::get<ThroughPoints>(form_).side(p);
}

Point3 CutPlane::nearest(const Point3& p, const Point3& q) const {
  if (const AxisPlane* const flat = axis_plane()) {
    std::array<double, 3> at{};
    at[flat->axis] = flat->height;
    const double hp = coordinate(p, flat->axis), hq = coordinate(q, flat->axis);
    for (const std::size_t k : shown_) {
      const double from = coordinate(p, k), to = coordinate(q, k);
      at[k] = from == to ? from
                         : rounded_quotient(Rounding::nearest, AxisCut{}, AxisWeight{}, std::array{from, hp},
                                            std::array{to, hq}, flat->height);
    }
    return {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0};
  }
  if (const auto* const plane = std::get_if<Plane3>(&form_)) {
    const auto at = [&]<class Cut>(Cut) {
      return rounded_quotient(Rounding::nearest, Cut{}, ObliqueWeight{}, plane->normal, plane->offset, p, q);
    };
    return {at(ObliqueCut<0>{}), at(ObliqueCut<1>{}), at(ObliqueCut<2>{})};
  }
  const auto& [a, b, c] = std::get<ThroughPoints>(form_).plane;
  return approximate(LinePlanePoint3{p, q, a, b, c});
}

ExactPoint3 CutPlane::exact(const Point3& p, const Point3& q) const {
  if (const AxisPlane* const flat = axis_plane()) {
    std::array<std::array<double, 3>, 3> at{};  // three points of the plane
    for (auto& point : at) point[flat->axis] = flat->height;
    at[1][shown_[0]] = at[2][shown_[1]] = 1;
    const auto point = [&](std::size_t i) { return Point3{at[i][0], at[i][1], at[i][2]}; };
    return LinePlanePoint3{p, q, point(0), point(1), point(2)};
  }
  if (const auto* const plane = std::get_if<Plane3>(&form_)) return intersection(Segment3{p, q}, *plane).vertices[0];
  const auto& [a, b, c] = std::get<ThroughPoints>(form_).plane;
  return LinePlanePoint3{p, q, a, b, c};
}

}  // namespace plumb::surface
