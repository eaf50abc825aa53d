// Plane intersection: where do two or three planes meet, and if three have no point in common, why?
//
//   intersection(Plane3{{1, 0, 0}, 1}, Plane3{{0, 1, 0}, 2})    // the line x = 1, y = 2
//   intersection(p, q, r).arrangement                           // PlaneArrangement::prism, say
//
// Planes are given by normal and offset or by three points, in any mix.
// Laws: (1) the common points, in real arithmetic; the order of the planes changes nothing, nor does scaling a plane's
// normal and offset, where nothing is rounded.  (2) A point or line is told by the one reduced form of its equations:
// a line by a direction and that point of it whose coordinate is zero where the direction's is one.  (3) A
// plane of zero normal is all of space or nothing, three points on one line are that line, at one place that point:
// their intersection is answered, their arrangement is `degenerate`.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 5.4.4, 5.4.5 (figure 5.31).
// Cost: some 10 us, rational arithmetic.  Nothing is searched.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "plumb/arith/exact_vector.hpp"
#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/plane.hpp"

namespace plumb {

using AnyPlane3 = std::variant<Plane3, ThreePointPlane3>;

/// The nearest doubles; throws BeyondDoubles where there are none.
Vector3 approximate(const ExactVector3& a);

enum class FlatKind : signed char { nothing = -1, point = 0, line = 1, plane = 2, space = 3 };

/// All point + sum of t_i directions_i; nothing without a point.
struct FlatIntersection {
  FlatKind kind = FlatKind::nothing;
  std::optional<ExactPoint3> point;  // a ThreePlanePoint3 where three planes of three points each meet in it
  std::vector<ExactVector3> directions;
};

/// Of two planes: nothing where they are parallel, a plane where they are the same, a line elsewhere.
FlatIntersection intersection(const AnyPlane3& a, const AnyPlane3& b);

/// Figure 5.31: how three planes lie to one another.
enum class PlaneArrangement : unsigned char {
  point,         // in one point
  line,          // in one line; `distinct` is 2 where two are the same
  prism,         // each two in a line, the three lines parallel: nothing
  two_parallel,  // two are parallel, the third crosses both: nothing
  parallel,      // all are; where they are the same, `distinct` is 1 and the intersection a plane
  degenerate,    // one of them is no plane
};

struct ThreePlanes {
  PlaneArrangement arrangement;
  int distinct;  // how many different planes there are
  FlatIntersection common;
};

ThreePlanes intersection(const AnyPlane3& a, const AnyPlane3& b, const AnyPlane3& c);

}  // namespace plumb
