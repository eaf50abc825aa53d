// How far does a hull reach beyond the convex parts that it is the hull of?
//
// Law: what is told is proved: no point of the hull's surface is farther from all parts.  On a triangle the distance
// from one convex set is convex: none of its points is farther than the farthest of its corners.
// Source: branch and bound; Lien and Amato 2007 for the question.
// Cost: some 10 us for each corner of a patch and part near it, once; a budget ends it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/figure/bound/proxy.hpp"

namespace plumb::surface {

/// A convex part in doubles.
struct RoundedPart {
  std::vector<Point3> around;  // their hull holds it
  std::vector<Point3> near;    // corners of the hull, of which no point is farther from the part than `off`
  ConvexPolyhedron3 hull;
  double off = 0;  // nor is one of that around it
  Point3 low, high;
  std::vector<std::array<double, 4>> planes{};  // of the hull's faces, normals of length 1 and offsets: a guess
};

/// A guess of the planes of a hull's faces.
std::vector<std::array<double, 4>> guessed_planes(const ConvexPolyhedron3& hull);

struct Reach {
  double at_most = 0;   // proved
  double at_least = 0;  // a guess
};

/// Ends where it is known to be at most `enough`, or thought to be more than `too_far`: then nothing may be proved, and
/// at_most is infinite.
Reach find_reach(const HullProxy& hull, std::span<const RoundedPart* const> parts, double enough, double too_far);

}  // namespace plumb::surface
