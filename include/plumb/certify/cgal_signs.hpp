// Which functor of CGAL's is which sign of ours?  Function objects for a kernel, in CGAL's conventions.
//
// Each takes points as its Epick namesake does, and leaves other arguments (vectors, circles, spheres) to that.
// Laws: equal to the exact answer by CGAL's definition.  CGAL's Orientation_3 and Side_of_oriented_sphere_3 have the
// opposite sign of orient3d and insphere.
// Source: CGAL 5.5's manual, "2D and 3D Linear Geometry Kernel".
// Cost: that of the signs.
#pragma once

#include <CGAL/enum.h>

#include <array>
#include <cstddef>

#include "plumb/certify/sign_of.hpp"
#include "plumb/predicates/distance.hpp"
#include "plumb/predicates/plane_distance.hpp"

namespace plumb::cgal {

constexpr CGAL::Sign to_cgal(Sign s) { return static_cast<CGAL::Sign>(static_cast<int>(s)); }
constexpr CGAL::Bounded_side bounded(Sign s) { return static_cast<CGAL::Bounded_side>(static_cast<int>(s)); }

/// A point of CGAL's as an argument of sign_of, not copied.
template <class P>
struct At {
  const P& point;
};
template <class P>
constexpr auto coordinates(const At<P>& at) {
  if constexpr (P::Ambient_dimension::value == 2) {
    return std::array<double, 2>{at.point.x(), at.point.y()};
  } else {
    return std::array<double, 3>{at.point.x(), at.point.y(), at.point.z()};
  }
}

template <Formula F, class... P>
Sign sign_of_points(const P&... points) {
  return sign_of(F{}, At<P>{points}...);
}

// Our signs of CGAL's points; they keep our conventions.
template <class P>
Sign orient2d(const P& p, const P& q, const P& r) {
  return sign_of_points<predicates::Orient2d>(p, q, r);
}
template <class P>
Sign incircle(const P& p, const P& q, const P& r, const P& t) {
  return sign_of_points<predicates::InCircle>(p, q, r, t);
}
template <class P>
Sign orient3d(const P& p, const P& q, const P& r, const P& s) {
  return sign_of_points<predicates::Orient3d>(p, q, r, s);
}
template <class P>
Sign insphere(const P& p, const P& q, const P& r, const P& s, const P& t) {
  return sign_of_points<predicates::InSphere>(p, q, r, s, t);
}

using Xyz = std::array<double, 3>;
template <class P>
Xyz xyz(const P& p) {
  return {p.x(), p.y(), p.z()};
}

/// orient2d of three points in space, seen along an axis; the other two follow it cyclically.
inline Sign orient2d_along(std::size_t axis, const Xyz& p, const Xyz& q, const Xyz& r) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return decide<predicates::Orient2d>({p[u], p[v], q[u], q[v], r[u], r[v]});
}

/// An axis along which p, q, r are seen as a triangle, and how it turns there; zero for collinear points.  The order of
/// the axes is CGAL's, which decides what orientation a plane has.
struct View {
  std::size_t axis;
  Sign turn;
};
inline View view_of(const Xyz& p, const Xyz& q, const Xyz& r) {
  for (const std::size_t axis : {2U, 0U, 1U}) {
    if (const Sign turn = orient2d_along(axis, p, q, r); turn != Sign::zero) return {axis, turn};
  }
  return {2, Sign::zero};
}

/// p moved along the axis, toward zero and beyond by about the size of the triangle p, q, r; and whether that is up.
struct OffPlane {
  Xyz point;
  bool up;
};
inline OffPlane off_plane(std::size_t axis, const Xyz& p, const Xyz& q, const Xyz& r) {
  OffPlane off{p, p[axis] < 0};
  const std::size_t u = (axis + 1) % 3;
  const double size = magnitude_of(q[u] - p[u]) + magnitude_of(r[u] - p[u]);
  const double from = p[axis], to = off.up ? from + size : from - size;
  // Rounding may keep it where it is, and doubles may end on the way.
  off.point[axis] = to != from && to - to == 0 ? to : from != 0 ? -from : -1;
  return off;
}

/// The signed distance of d from the plane of a, b, c against that of e.
template <class P>
Sign signed_plane_distance(const P& a, const P& b, const P& c, const P& d, const P& e) {
  return sign_of_points<predicates::SignedPlaneDistance>(a, b, c, d, e);
}

template <class Kernel>
struct Orientation2 : Kernel::Orientation_2 {
  using Point = typename Kernel::Point_2;
  using Kernel::Orientation_2::operator();
  CGAL::Orientation operator()(const Point& p, const Point& q, const Point& r) const {
    return to_cgal(orient2d(p, q, r));
  }
};

template <class Kernel>
struct Orientation3 : Kernel::Orientation_3 {
  using Point = typename Kernel::Point_3;
  using Kernel::Orientation_3::operator();
  CGAL::Orientation operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return to_cgal(-orient3d(p, q, r, s));
  }
};

template <class Kernel>
struct Coplanar3 : Kernel::Coplanar_3 {
  using Point = typename Kernel::Point_3;
  bool operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return orient3d(p, q, r, s) == Sign::zero;
  }
};

/// The orientation of coplanar points, in the first of CGAL's three views in which p, q, r are a triangle.
template <class Kernel>
struct CoplanarOrientation3 : Kernel::Coplanar_orientation_3 {
  using Point = typename Kernel::Point_3;
  CGAL::Orientation operator()(const Point& p, const Point& q, const Point& r) const {
    const View view = view_of(xyz(p), xyz(q), xyz(r));
    return to_cgal(view.axis == 1 ? -view.turn : view.turn);  // CGAL looks at x and z, not at z and x
  }
  CGAL::Orientation operator()(const Point& p, const Point& q, const Point& r, const Point& s) const {
    const View view = view_of(xyz(p), xyz(q), xyz(r));
    return to_cgal(view.turn * orient2d_along(view.axis, xyz(p), xyz(q), xyz(s)));
  }
};

template <class Kernel>
struct SideOfOrientedCircle2 : Kernel::Side_of_oriented_circle_2 {
  using Point = typename Kernel::Point_2;
  using Kernel::Side_of_oriented_circle_2::operator();
  CGAL::Oriented_side operator()(const Point& p, const Point& q, const Point& r, const Point& t) const {
    return to_cgal(incircle(p, q, r, t));
  }
};

template <class Kernel>
struct SideOfBoundedCircle2 : Kernel::Side_of_bounded_circle_2 {
  using Point = typename Kernel::Point_2;
  using Kernel::Side_of_bounded_circle_2::operator();
  CGAL::Bounded_side operator()(const Point& p, const Point& q, const Point& r, const Point& t) const {
    return bounded(incircle(p, q, r, t) * orient2d(p, q, r));
  }
};

template <class Kernel>
struct SideOfOrientedSphere3 : Kernel::Side_of_oriented_sphere_3 {
  using Point = typename Kernel::Point_3;
  using Kernel::Side_of_oriented_sphere_3::operator();
  CGAL::Oriented_side operator()(const Point& p, const Point& q, const Point& r, const Point& s, const Point& t) const {
    return to_cgal(-insphere(p, q, r, s, t));
  }
};

template <class Kernel>
struct SideOfBoundedSphere3 : Kernel::Side_of_bounded_sphere_3 {
  using Point = typename Kernel::Point_3;
  using Kernel::Side_of_bounded_sphere_3::operator();
  CGAL::Bounded_side operator()(const Point& p, const Point& q, const Point& r, const Point& s, const Point& t) const {
    return bounded(insphere(p, q, r, s, t) * orient3d(p, q, r, s));
  }
};

/// Whether p lies lower than q, seen from the side of a plane that sees its points a, b, c counterclockwise.
template <class Kernel>
struct LessSignedDistanceToPlane3 : Kernel::Less_signed_distance_to_plane_3 {
  using Point = typename Kernel::Point_3;
  using Kernel::Less_signed_distance_to_plane_3::operator();
  bool operator()(const Point& a, const Point& b, const Point& c, const Point& p, const Point& q) const {
    return signed_plane_distance(a, b, c, p, q) == Sign::negative;
  }
};

/// The distance from p to q against that from p to r.
template <class Kernel>
struct CompareDistance2 : Kernel::Compare_distance_2 {
  using Point = typename Kernel::Point_2;
  using Kernel::Compare_distance_2::operator();
  CGAL::Comparison_result operator()(const Point& p, const Point& q, const Point& r) const {
    return to_cgal(sign_of_points<predicates::CompareDistanceFrom2d>(p, q, r));
  }
};

template <class Kernel>
struct CompareDistance3 : Kernel::Compare_distance_3 {
  using Point = typename Kernel::Point_3;
  using Kernel::Compare_distance_3::operator();
  CGAL::Comparison_result operator()(const Point& p, const Point& q, const Point& r) const {
    return to_cgal(sign_of_points<predicates::CompareDistanceFrom3d>(p, q, r));
  }
};

/// The circle of p, q, r in their plane, and a point of that plane.  Any sphere through p, q, r cuts the plane in their
/// circle; that through a point beside the plane serves.
template <class Kernel>
struct CoplanarSideOfBoundedCircle3 : Kernel::Coplanar_side_of_bounded_circle_3 {
  using Point = typename Kernel::Point_3;
  CGAL::Bounded_side operator()(const Point& p, const Point& q, const Point& r, const Point& t) const {
    const Xyz a = xyz(p), b = xyz(q), c = xyz(r);
    const View view = view_of(a, b, c);
    if (view.turn == Sign::zero) return CGAL::ON_BOUNDARY;  // as CGAL says of collinear points
    const auto [o, up] = off_plane(view.axis, a, b, c);
    const Sign inside = decide<predicates::InSphere>({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2],  //
                                                      o[0], o[1], o[2], t.x(), t.y(), t.z()});
    return bounded(inside * (up ? -view.turn : view.turn));  // orient3d(p, q, r, o), which is positive below
  }
};

}  // namespace plumb::cgal
