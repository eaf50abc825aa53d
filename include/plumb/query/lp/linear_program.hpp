// Linear programming: which point of an intersection of halfspaces lies farthest along a direction?  Seidel's algorithm
// in the plane and in space, exactly.
//
//   const LinearAnswer3 best = maximize(Vector3{0, 0, 1}, halfspaces);
//   best.kind                         // optimal, infeasible or unbounded
//   best.at                           // the nearest doubles of the point
//   exact_point(best)                 // the point itself
//   verify(direction, halfspaces, proof_of(best))        // query/lp/verify.hpp
//
// Constraints come in random order.  As long as the best point so far meets the next one it stays; where it does not,
// the best point lies in that constraint's plane, which is a program of one dimension less over those before.  Before
// that a guess is tried: planes that doubles find, where signs prove them.
// Laws: (1) the kind is that of real arithmetic, of zero normals (which hold everywhere or nowhere), of parallel,
// repeated and redundant constraints, and of any exponents, too.  (2) Of several optimal points it is the
// lexicographically least; where the optimal points have no least x that with the greatest, where no greatest either
// that with x = 0, and so for y and z.  `is_unique` says whether there is one alone.  (3) Kind, point, ray and
// is_unique do not depend on the order of the constraints, and nothing depends on the seed.  (4) What is named proves
// the answer: proof_of.  (5) With the direction zero every point is optimal: `at` is the first of the feasible ones; it
// is also the point of an unbounded program.
// NaN and infinity throw NonFinite, by name; more than 2^32 - 2 constraints throw Error.
// Source: Seidel, "Small-dimensional linear programming and convex hulls made easy", 1991; RTCD 9.4.1.
// Cost: expected linear in the constraints, whatever they are; docs/measurements.md.  A unique optimum of which doubles
// tell the signs allocates nothing but the scratch, which a caller may keep.  Bounded by n expected signs for each
// variable, on integers as long as the exponents' span; at worst n^3.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/query/lp/linear_proof.hpp"

namespace plumb {

struct LinearOptions {
  std::uint64_t seed = 0;  // of the order in which constraints come: another one for whoever fears that this is known
};

/// A constraint and its number in the list that was given.
inline constexpr std::uint32_t no_constraint = 0xffffffff;
struct NamedHalfspace2 {
  Halfspace2 halfspace;
  std::uint32_t number;
  friend bool operator==(const NamedHalfspace2&, const NamedHalfspace2&) = default;
};
struct NamedHalfspace3 {
  Halfspace3 halfspace;
  std::uint32_t number;
  friend bool operator==(const NamedHalfspace3&, const NamedHalfspace3&) = default;
};

struct LinearAnswer2 {
  LinearKind kind = LinearKind::optimal;
  bool is_unique = false;  // there is one optimal point
  Point2 at{};             // the nearest doubles of the optimal point; of a feasible one where the program is unbounded
  Vector2 ray{};           // of an unbounded program: the nearest doubles of a direction, of which the greatest is 1
  Vector2 direction{};     // as it was asked
  std::uint32_t deciding_count = 0;
  std::array<NamedHalfspace2, 3> deciding{};  // these make an optimum no farther, or leave nothing together
  std::array<NamedHalfspace2, 2> corner{};    // their lines meet in the point alone; no_constraint: a coordinate is 0
  std::array<Halfspace2, 2> ray_lines{};      // the ray is the point of these
  friend bool operator==(const LinearAnswer2&, const LinearAnswer2&) = default;
};
struct LinearAnswer3 {
  LinearKind kind = LinearKind::optimal;
  bool is_unique = false;
  Point3 at{};
  Vector3 ray{};
  Vector3 direction{};
  std::uint32_t deciding_count = 0;
  std::array<NamedHalfspace3, 4> deciding{};
  std::array<NamedHalfspace3, 3> corner{};
  std::array<Halfspace3, 3> ray_planes{};
  friend bool operator==(const LinearAnswer3&, const LinearAnswer3&) = default;
};

LinearAnswer2 maximize(const Vector2& direction, std::span<const Halfspace2> constraints, const LinearOptions& = {});
LinearAnswer3 maximize(const Vector3& direction, std::span<const Halfspace3> constraints, const LinearOptions& = {});

/// The same; `scratch` may hold anything, and holds room for the next program.
LinearAnswer2 maximize(const Vector2& direction, std::span<const Halfspace2> constraints,
                       std::vector<NamedHalfspace2>& scratch, const LinearOptions& = {});
LinearAnswer3 maximize(const Vector3& direction, std::span<const Halfspace3> constraints,
                       std::vector<NamedHalfspace3>& scratch, const LinearOptions& = {});

/// The optimal point, or the feasible one of an unbounded program; of an infeasible one throws DegeneratePoint.
ExactPoint2 exact_point(const LinearAnswer2& answer);
ExactPoint3 exact_point(const LinearAnswer3& answer);

/// What the answer rests on, in exact numbers: the weights of those that decide, the point, the ray.
LinearProof proof_of(const LinearAnswer2& answer);
LinearProof proof_of(const LinearAnswer3& answer);

}  // namespace plumb
