// Certifying convex hull: is this the convex hull of these points in space?  A proof by exact signs, which makes no
// hull.
//
//   if (const HullVerdict verdict = verify_hull(hull, points); !verdict) std::cerr << verdict.flaw;
//
// Laws: (1) it holds exactly when the hull is what convex_hull gives for the points and options, number for number up
//       to how flat faces are cut into triangles.  (2) A hull of any content is judged: indices out of range, open
//       faces and the like are flaws, not errors.  (3) `flaw` names the first thing that is wrong, with its face, edge
//       or point.
// A point that is NaN or infinite throws NonFinite.
// Looked at: the order of the lists, that faces close edge by edge, each is planar and convex, convex at every ridge,
// Euler's formula, that the faces seen from above cover a convex region once, those from below likewise, that the
// vertical ones stand on its rim, and of every point that it lies between the two.  That this suffices: docs/hulls.md.
// Source: RTCD 3.8.1, 3.9; Mehlhorn et al., "Checking geometric programs or verification of geometric structures".
// Cost: (n + faces) log faces, as a rule.  Bounded by n^2 signs, on integers as long as the exponents' span.
#pragma once

#include <string>

#include "plumb/figure/hull/hull3.hpp"

namespace plumb {

struct HullVerdict {
  std::string flaw;  // empty: there is none
  explicit operator bool() const { return flaw.empty(); }
};

/// The options say what the hull was asked for; the method does not matter.
HullVerdict verify_hull(const Hull3& hull, std::span<const Point3> points, const HullOptions& options = {});

}  // namespace plumb
