// Where does a ray hit a triangle, when doubles leave a doubt or the numbers are not wanted yet?  The decision, kept, and
// what it tells: between which parameters, before which other triangle, at which numbers.
//
// Laws: decide_hit is nothing exactly where hits(ray, triangle, rule) is false; hit_of its answer are the numbers of
// first_hit, and compare_hits the order of the exact parameters.
// Source: RTCD 5.3.6, 11.5.
// Cost: integers on the stack decide, GMP's where those are too short; a corner on the line is proved by pairs of doubles
// where no difference is rounded, and hits at one corner, or inside of one edge, are equal without arithmetic.
#pragma once

#include <optional>

#include "plumb/query/ray/ray.hpp"
#include "query/ray/numbers.hpp"

namespace plumb::query {

/// Decides by integers, but for triangles that doubles prove to be beside the line.
std::optional<Decided> decide_hit(const AnyRay& ray, const Triangle3& triangle, HitRule rule);
/// Decides by the closed rule, where it is certain that the ray crosses the triangle's plane.
std::optional<Decided> decide_crossing(const AnyRay& ray, const Triangle3& triangle);

/// This is decided of a ray that passes through the inside of a triangle and has no end on it.
inline constexpr Decided crossed_inside{{When::At::quotient, 0, 0}, {FeatureKind::face, 0}, true, 0};

struct ParameterRange {
  double least, most;
};
ParameterRange range_of(const AnyRay& ray, const Triangle3& triangle, const Decided& decided);

Hit hit_of(const AnyRay& ray, const Triangle3& triangle, const Decided& decided);

struct DecidedTriangle {
  Triangle3 triangle;
  Decided decided;
};
Sign compare_hits(const AnyRay& ray, const DecidedTriangle& first, const DecidedTriangle& second);
/// The same, of triangles whose planes the ray crosses; nothing where it does not.
std::optional<Sign> compare_crossings(const AnyRay& ray, const Triangle3& first, const Triangle3& second);

}  // namespace plumb::query
