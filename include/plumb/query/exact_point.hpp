// Where exactly is a point that two figures have in common?  As given, as constructed, or in rational coordinates.
//
//   const ExactPoint3 p = intersection(segment, triangle).vertices[0];
//   approximate(p)                    // the nearest doubles
//   orient3d(p, a, b, c)              // decided about the point itself
//   std::get_if<LinePlanePoint3>(&p.as)   // the construction, which certify/implicit.hpp takes as well
//
// Laws: (1) an exact point stands for one point, and two that are held differently may be equal: == compares the
// points.  (2) What the doubles hold is held as Point2 or Point3 where that is seen without computing; else the
// construction is kept, and rational coordinates where points as given do not construct it (a ray's direction, a
// plane's normal).  (3) The signs are those of predicates.hpp, for any mix; points as given convert.
// A construction without a point throws DegeneratePoint, a coordinate whose nearest double is infinite BeyondDoubles,
// NaN and infinity NonFinite.
// Source: RTCD 5.1.9.1, 5.3.1, 5.4.5.  Cost: intervals, some 100 ns a point; some microseconds where they cannot tell.
#pragma once

#include <variant>

#include "plumb/arith/implicit_point.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb {

struct RationalPoint2 {
  Rational x, y;
  friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
};
struct RationalPoint3 {
  Rational x, y, z;
  friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
};

struct ExactPoint2 {
  std::variant<Point2, LineLinePoint2, SegmentPoint2, RationalPoint2> as;

  ExactPoint2() = default;
  ExactPoint2(const Point2& p) : as(p) {}              // NOLINT: mixes with points as given
  ExactPoint2(const LineLinePoint2& p) : as(p) {}      // NOLINT
  ExactPoint2(const SegmentPoint2& p) : as(p) {}       // NOLINT
  ExactPoint2(RationalPoint2 p) : as(std::move(p)) {}  // NOLINT
};

struct ExactPoint3 {
  std::variant<Point3, LinePlanePoint3, ThreePlanePoint3, SegmentPoint3, RationalPoint3> as;

  ExactPoint3() = default;
  ExactPoint3(const Point3& p) : as(p) {}              // NOLINT: mixes with points as given
  ExactPoint3(const LinePlanePoint3& p) : as(p) {}     // NOLINT
  ExactPoint3(const ThreePlanePoint3& p) : as(p) {}    // NOLINT
  ExactPoint3(const SegmentPoint3& p) : as(p) {}       // NOLINT
  ExactPoint3(RationalPoint3 p) : as(std::move(p)) {}  // NOLINT
};

/// The nearest double of each coordinate, rounded once.
Point2 approximate(const ExactPoint2& a);
Point3 approximate(const ExactPoint3& a);

RationalPoint2 rational_point(const ExactPoint2& a);
RationalPoint3 rational_point(const ExactPoint3& a);

/// Lexicographic order; zero when a equals b.
Sign compare_xy(const ExactPoint2& a, const ExactPoint2& b);
Sign compare_xyz(const ExactPoint3& a, const ExactPoint3& b);

inline bool operator==(const ExactPoint2& a, const ExactPoint2& b) { return compare_xy(a, b) == Sign::zero; }
inline bool operator==(const ExactPoint3& a, const ExactPoint3& b) { return compare_xyz(a, b) == Sign::zero; }

Sign orient2d(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& c);
Sign orient3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, const ExactPoint3& d);

/// Do the points lie on one line?
bool collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c);

}  // namespace plumb
