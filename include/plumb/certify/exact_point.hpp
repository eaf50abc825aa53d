// Implicit point: where exactly is a point that two figures have in common?  As given, as constructed, or in rational
// coordinates.
//
//   const ExactPoint3 p = intersection(segment, triangle).vertices[0];
//   approximate(p)                    // the nearest doubles
//   orient3d(p, a, b, c)              // decided about the point itself
//   std::get_if<LinePlanePoint3>(&p.as())   // the construction, which certify/implicit.hpp takes as well
//   std::ranges::sort(points);              // exactly, by x, then y, then z; std::map and std::unordered_map take them
//
// Laws: (1) an exact point stands for one point, and two that are held differently may be equal: ==, <=> and std::hash
// go by the points.  (2) What the doubles hold is held as Point2 or Point3 where that is seen without computing; else
// the construction is kept, and rational coordinates where points as given do not construct it (a ray's direction, a
// plane's normal).  (3) The signs are those of predicates.hpp, for any mix; points as given convert.
// (4) A point keeps its nearest doubles from the first question on, copies keep them too; any thread may ask.
// A construction without a point throws DegeneratePoint, a coordinate whose nearest double is infinite BeyondDoubles
// where it is to be rounded, NaN and infinity NonFinite.
// Source: RTCD 5.1.9.1, 5.3.1, 5.4.5.
// Cost: some 100 ns once a point, 2 to 20 ns a question; microseconds once a point that equals another or lies on a
// line or plane with others, some 100 ns for each such question after that.
#pragma once

#include <compare>
#include <variant>

#include "plumb/arith/implicit_point.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/certify/detail/exact_point_cache.hpp"

namespace plumb {

struct RationalPoint2 {
  Rational x, y;
  friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
};
struct RationalPoint3 {
  Rational x, y, z;
  friend bool operator==(const RationalPoint3&, const RationalPoint3&) = default;
};

class ExactPoint2 {
 public:
  using Held = std::variant<Point2, LineLinePoint2, SegmentPoint2, RationalPoint2>;

  ExactPoint2() : ExactPoint2(Point2{0, 0}) {}
  ExactPoint2(const Point2& p) : as_(p), cache_({p.x, p.y}) {}  // NOLINT: mixes with points as given
  ExactPoint2(const LineLinePoint2& p) : as_(p) {}              // NOLINT
  ExactPoint2(const SegmentPoint2& p) : as_(p) {}               // NOLINT
  ExactPoint2(RationalPoint2 p) : as_(std::move(p)) {}          // NOLINT

  [[nodiscard]] const Held& as() const { return as_; }
  [[nodiscard]] const certify::ExactPointCache<2>& cache() const { return cache_; }

  /// That of compare_xy: points that are held differently may be equivalent.
  friend std::weak_ordering operator<=>(const ExactPoint2& a, const ExactPoint2& b);

 private:
  Held as_;
  certify::ExactPointCache<2> cache_;
};

class ExactPoint3 {
 public:
  using Held = std::variant<Point3, LinePlanePoint3, ThreePlanePoint3, SegmentPoint3, RationalPoint3>;

  ExactPoint3() : ExactPoint3(Point3{0, 0, 0}) {}
  ExactPoint3(const Point3& p) : as_(p), cache_({p.x, p.y, p.z}) {}  // NOLINT: mixes with points as given
  ExactPoint3(const LinePlanePoint3& p) : as_(p) {}                  // NOLINT
  ExactPoint3(const ThreePlanePoint3& p) : as_(p) {}                 // NOLINT
  ExactPoint3(const SegmentPoint3& p) : as_(p) {}                    // NOLINT
  ExactPoint3(RationalPoint3 p) : as_(std::move(p)) {}               // NOLINT

  [[nodiscard]] const Held& as() const { return as_; }
  [[nodiscard]] const certify::ExactPointCache<3>& cache() const { return cache_; }

  /// That of compare_xyz.
  friend std::weak_ordering operator<=>(const ExactPoint3& a, const ExactPoint3& b);

 private:
  Held as_;
  certify::ExactPointCache<3> cache_;
};

/// The nearest double of each coordinate, rounded once.
Point2 approximate(const ExactPoint2& a);
Point3 approximate(const ExactPoint3& a);

RationalPoint2 rational_point(const ExactPoint2& a);
RationalPoint3 rational_point(const ExactPoint3& a);

namespace certify {

/// Where the doubles that are kept do not tell.
Sign exact_order(const ExactPoint2& a, const ExactPoint2& b);
Sign exact_order(const ExactPoint3& a, const ExactPoint3& b);

template <class Point>
Sign order(const Point& a, const Point& b) {
  const Unsure<Sign> quick = order_by_doubles(a.cache(), b.cache());
  if (quick.certain()) [[likely]]
    return quick.value();
  return exact_order(a, b);
}

}  // namespace certify

/// Lexicographic order; zero when a equals b.
inline Sign compare_xy(const ExactPoint2& a, const ExactPoint2& b) { return certify::order(a, b); }
inline Sign compare_xyz(const ExactPoint3& a, const ExactPoint3& b) { return certify::order(a, b); }

inline bool operator==(const ExactPoint2& a, const ExactPoint2& b) { return certify::order(a, b) == Sign::zero; }
inline bool operator==(const ExactPoint3& a, const ExactPoint3& b) { return certify::order(a, b) == Sign::zero; }
inline std::weak_ordering operator<=>(const ExactPoint2& a, const ExactPoint2& b) {
  return static_cast<int>(certify::order(a, b)) <=> 0;
}
inline std::weak_ordering operator<=>(const ExactPoint3& a, const ExactPoint3& b) {
  return static_cast<int>(certify::order(a, b)) <=> 0;
}

/// Of the nearest doubles, which equal points have in common; what std::hash gives.
std::size_t hash_value(const ExactPoint2& a);
std::size_t hash_value(const ExactPoint3& a);

Sign orient2d(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& c);
Sign orient3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, const ExactPoint3& d);

namespace certify {

/// The turn of the points' shadows along the axis, 0, 1 or 2: of (y, z), (z, x) or (x, y).
Sign turn_along(int axis, const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c);

}  // namespace certify

/// Do the points lie on one line?
bool collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c);

}  // namespace plumb

template <>
struct std::hash<plumb::ExactPoint2> {
  std::size_t operator()(const plumb::ExactPoint2& p) const { return plumb::hash_value(p); }
};
template <>
struct std::hash<plumb::ExactPoint3> {
  std::size_t operator()(const plumb::ExactPoint3& p) const { return plumb::hash_value(p); }
};
