// Every shape is, seen from a point, a flat: the point, line or plane that carries what is nearest.
#include "plumb/certify/compare_distance.hpp"

#include "certify/finite.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

namespace p = predicates;

template <class Point>
inline constexpr bool in_plane = coordinate_count<Point> == 2;
template <class Point, class In2d, class In3d>
using ByPoint = std::conditional_t<in_plane<Point>, In2d, In3d>;

template <class Point>
using PointPoint = ByPoint<Point, p::CompareDistance2d, p::CompareDistance3d>;
template <class Point>
using PointLine = ByPoint<Point, p::ComparePointLine2d, p::ComparePointLine3d>;
template <class Point>
using LineLine = ByPoint<Point, p::CompareLineLine2d, p::CompareLineLine3d>;
template <class Point>
using PointAgainst = ByPoint<Point, p::DistanceAgainst2d, p::DistanceAgainst3d>;
template <class Point>
using LineAgainst = ByPoint<Point, p::LineDistanceAgainst2d, p::LineDistanceAgainst3d>;

/// The affine hull of a, of a and b, or of a, b and c, which are spanning, and a point to measure from.
template <class Point>
struct Flat {
  int dimension;
  Point a, b, c, from;
};

template <class Point>
Flat<Point> point_flat(const Point& a, const Point& from) {
  return {0, a, a, a, from};
}
template <class Point>
Flat<Point> line_flat(const Point& a, const Point& b, const Point& from) {
  return {a == b ? 0 : 1, a, b, b, from};
}
Flat<Point3> plane_flat(const Point3& a, const Point3& b, const Point3& c, const Point3& from) {
  if (collinear(a, b, c)) return line_flat(a, a == b ? c : b, from);
  return {2, a, b, c, from};
}

/// The nearest point of the segment ab lies on the line, or is an end.
template <class Point>
Flat<Point> segment_flat(const Point& a, const Point& b, const Point& from) {
  if (angle_sign(from, a, b) != Sign::positive) return point_flat(a, from);
  if (angle_sign(from, b, a) != Sign::positive) return point_flat(b, from);
  return line_flat(a, b, from);
}

/// The distance to f against that to g.
template <class Point>
Sign compare(const Flat<Point>& f, const Flat<Point>& g) {
  if (f.dimension > g.dimension) return -compare(g, f);
  if constexpr (!in_plane<Point>) {
    if (g.dimension == 2) {
      if (f.dimension == 0) return sign_of(p::ComparePointPlane{}, f.a, f.from, g.a, g.b, g.c, g.from);
      if (f.dimension == 1) return sign_of(p::CompareLinePlane{}, f.a, f.b, f.from, g.a, g.b, g.c, g.from);
      return sign_of(p::ComparePlanePlane{}, f.a, f.b, f.c, f.from, g.a, g.b, g.c, g.from);
    }
  }
  if (g.dimension == 0) return sign_of(PointPoint<Point>{}, f.a, f.from, g.a, g.from);
  if (f.dimension == 0) return sign_of(PointLine<Point>{}, f.a, f.from, g.a, g.b, g.from);
  return sign_of(LineLine<Point>{}, f.a, f.b, f.from, g.a, g.b, g.from);
}

template <class Point>
Sign compare(const Flat<Point>& f, double distance) {
  const auto squared = [&] {
    if constexpr (!in_plane<Point>) {
      if (f.dimension == 2) return sign_of(p::PlaneDistanceAgainst{}, f.a, f.b, f.c, f.from, distance);
    }
    if (f.dimension == 1) return sign_of(LineAgainst<Point>{}, f.a, f.b, f.from, distance);
    return sign_of(PointAgainst<Point>{}, f.a, f.from, distance);
  };
  return distance < 0 ? Sign::positive : squared();
}

template <class Point>
Sign from_segment(const Point& a, const Point& b, const Point& c, const Point& d) {
  require_finite("compare_distance_to_segment", a, b, c, d);
  const Flat<Point> f = segment_flat(a, b, c), g = segment_flat(a, b, d);
  return f.dimension == 1 && g.dimension == 1 ? compare_distance_to_line(a, b, c, d) : compare(f, g);
}

template <class Point>
Sign from_segment(const Point& a, const Point& b, const Point& c, double distance) {
  require_finite("compare_distance_to_segment", a, b, c, distance);
  return compare(segment_flat(a, b, c), distance);
}

template <class Point>
Sign from_segments(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e, const Point& f) {
  require_finite("compare_distance_to_segments", a, b, c, d, e, f);
  return compare(segment_flat(a, b, c), segment_flat(d, e, f));
}

template <class Point>
Sign from_line(const Point& a, const Point& b, const Point& c, double distance) {
  require_finite("compare_distance_to_line", a, b, c, distance);
  return compare(line_flat(a, b, c), distance);
}

template <class Point>
Sign from_lines(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e, const Point& f) {
  require_finite("compare_distance_to_lines", a, b, c, d, e, f);
  return compare(line_flat(a, b, c), line_flat(d, e, f));
}

template <class Point>
Sign from_point(const Point& a, const Point& b, double distance) {
  const Sign s = sign_of(PointAgainst<Point>{}, a, b, distance);
  return distance < 0 ? Sign::positive : s;
}

}  // namespace

Sign compare_distance(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of(p::CompareDistance2d{}, a, b, c, d);
}
Sign compare_distance(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(p::CompareDistance3d{}, a, b, c, d);
}

Sign compare_distance(const Point2& a, const Point2& b, const Point2& c) {
  return sign_of(p::CompareDistanceFrom2d{}, a, b, c);
}
Sign compare_distance(const Point3& a, const Point3& b, const Point3& c) {
  return sign_of(p::CompareDistanceFrom3d{}, a, b, c);
}

Sign compare_distance(const Point2& a, const Point2& b, double distance) { return from_point(a, b, distance); }
Sign compare_distance(const Point3& a, const Point3& b, double distance) { return from_point(a, b, distance); }

// |x|^2 - |y|^2 = (x - y) (x + y), of signed distances in the plane.
Sign compare_distance_to_line(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Sign difference = sign_of(p::SignedLineDistance{}, a, b, c, d);
  if (difference != Sign::zero) return difference * sign_of(p::LineDistanceSum{}, a, b, c, d);
  return a == b ? compare_distance(a, c, d) : Sign::zero;
}
Sign compare_distance_to_line(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Sign s = sign_of(p::CompareLineDistance{}, a, b, c, d);
  return s == Sign::zero && a == b ? compare_distance(a, c, d) : s;
}

Sign compare_distance_to_line(const Point2& a, const Point2& b, const Point2& c, double distance) {
  return from_line(a, b, c, distance);
}
Sign compare_distance_to_line(const Point3& a, const Point3& b, const Point3& c, double distance) {
  return from_line(a, b, c, distance);
}

Sign compare_distance_to_lines(const Point2& a, const Point2& b, const Point2& c, const Point2& d, const Point2& e,
                               const Point2& f) {
  return from_lines(a, b, c, d, e, f);
}
Sign compare_distance_to_lines(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                               const Point3& f) {
  return from_lines(a, b, c, d, e, f);
}

Sign compare_signed_distance_to_line(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return sign_of(p::SignedLineDistance{}, a, b, c, d);
}

Sign compare_distance_to_segment(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return from_segment(a, b, c, d);
}
Sign compare_distance_to_segment(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return from_segment(a, b, c, d);
}

Sign compare_distance_to_segment(const Point2& a, const Point2& b, const Point2& c, double distance) {
  return from_segment(a, b, c, distance);
}
Sign compare_distance_to_segment(const Point3& a, const Point3& b, const Point3& c, double distance) {
  return from_segment(a, b, c, distance);
}

Sign compare_distance_to_segments(const Point2& a, const Point2& b, const Point2& c, const Point2& d, const Point2& e,
                                  const Point2& f) {
  return from_segments(a, b, c, d, e, f);
}
Sign compare_distance_to_segments(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                                  const Point3& f) {
  return from_segments(a, b, c, d, e, f);
}

Sign compare_distance_to_plane(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e) {
  const Sign difference = sign_of(p::SignedPlaneDistance{}, a, b, c, d, e);
  if (difference != Sign::zero) return difference * sign_of(p::PlaneDistanceSum{}, a, b, c, d, e);
  if (!collinear(a, b, c)) return Sign::zero;
  return compare_distance_to_line(a, a == b ? c : b, d, e);
}

Sign compare_distance_to_plane(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double distance) {
  require_finite("compare_distance_to_plane", a, b, c, d, distance);
  return compare(plane_flat(a, b, c, d), distance);
}

Sign compare_distance_to_planes(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                                const Point3& f, const Point3& g, const Point3& h) {
  require_finite("compare_distance_to_planes", a, b, c, d, e, f, g, h);
  return compare(plane_flat(a, b, c, d), plane_flat(e, f, g, h));
}

Sign compare_signed_distance_to_plane(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                      const Point3& e) {
  return sign_of(p::SignedPlaneDistance{}, a, b, c, d, e);
}

}  // namespace plumb
