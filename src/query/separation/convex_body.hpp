// Convex body: where are its corners, over any number type, and how far does it reach beyond their hull?
//
// Laws: what is looked at is sound: finite numbers, radii that are not negative, polygons that are planar and convex, at least
// one point; else NonFinite or InvalidShape by name, UnevenPose for a round body whose image is none.
// Source: query/separation/corners.hpp; RTCD 4.5.
// Cost: an addition a number; of a polygon its proof of convexity; under a pose GMP where the body is round.
#pragma once

#include <string_view>

#include "plumb/query/separation/convex_body.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query {

/// The hull of the corners, and all within the radius of it, which is 0 of what is not round.
struct Body {
  CoreCorners corners;
  mpq_class radius;
};

/// The names are those of the arguments, "a" and "b" where both are of one kind, else what the figures are called.
std::array<Body, 2> bodies_of(std::string_view function, const BodyView& a, const BodyView& b);
Body body_of(std::string_view function, std::string_view name, const BodyView& body);

/// The same without the radius, and without GMP; of what is round it is known to be sound, but for an uneven pose.
std::array<CoreCorners, 2> corners_of(std::string_view function, const BodyView& a, const BodyView& b);
/// Before its pose.
double radius_of(const BodyView& body);
inline bool has_radius(const BodyView& body) { return radius_of(body) != 0; }

/// What a text calls it.
std::string_view spoken(const BodyView& body);

}  // namespace plumb::query
