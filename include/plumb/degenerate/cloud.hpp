// Which sets of many points are hard?  Clouds for hulls, bounds and triangulations, of any size.
//
// Laws: (1) every coordinate is finite; (2) the same choices give the same points, bit for bit, everywhere; (3) plane,
// line, circle, exact_sphere, lattice, facets, moments and place are what they are called in real arithmetic; ball,
// sphere, prism and skew_plane are rounded.  (4) A cloud has as many points as asked for; equal ones only where there
// are no more (place; circle: 128 differ, in a lattice or exact_sphere nearly all).
// Source: RTCD 3.7.1 (figure 3.18), 3.9; cyclic polytopes are Caratheodory's.
// Cost: 10 to 100 ns a point.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {

enum class Cloud : unsigned char {
  ball,
  sphere,
  exact_sphere,
  lattice,
  facets,
  prism,
  moments,
  skew_plane,
  plane,
  circle,
  line,
  place,
};

struct CloudInfo {
  Cloud cloud;
  std::string_view name;
  std::string_view about;
};

/// In the plane a ball is a disk, a sphere a circle, a plane or prism as told in brackets.
inline constexpr std::array clouds = {
    CloudInfo{Cloud::ball, "ball", "uniform in the unit ball"},
    CloudInfo{Cloud::sphere, "sphere", "points of the unit sphere, rounded: nearly all are vertices of their hull"},
    CloudInfo{Cloud::exact_sphere, "exact_sphere", "integers exactly on one sphere about the origin"},
    CloudInfo{Cloud::lattice, "lattice", "all integers of a cube, shuffled: eight vertices, everything else coplanar"},
    CloudInfo{Cloud::facets, "facets", "integers on the faces, edges and corners of a cube"},
    CloudInfo{Cloud::prism, "prism", "two congruent rounded circles, one above the other (one circle, thrice)"},
    CloudInfo{Cloud::moments, "moments", "(t, t^2, t^3) for integers t: all are vertices, each joined to each"},
    CloudInfo{Cloud::skew_plane, "skew_plane", "a plane through the origin (a line), rounded: as thin as ulps"},
    CloudInfo{Cloud::plane, "plane", "exactly coplanar integers (collinear)"},
    CloudInfo{Cloud::circle, "circle", "exactly cocircular integers"},
    CloudInfo{Cloud::line, "line", "exactly collinear integers"},
    CloudInfo{Cloud::place, "place", "all equal, 0.0 beside -0.0"},
};

constexpr std::string_view name_of(Cloud cloud) { return clouds[static_cast<std::size_t>(cloud)].name; }

std::vector<Point2> cloud2(Cloud cloud, std::size_t count, Entropy& entropy);
std::vector<Point3> cloud3(Cloud cloud, std::size_t count, Entropy& entropy);

}  // namespace plumb
