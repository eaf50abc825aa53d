// When is a figure of your own the convex hull of its places, and all within a radius of it?  When you say so.
//
//   struct Cushion { Triangle3 core; double radius; };               and its body (figure/basic/body.hpp)
//   template <> inline constexpr bool plumb::is_rounded_hull<Cushion> = true;
//
// A body says of what a figure is made, not which set that is: a capsule and a cylinder are made of the same.  Of what
// says that it is a rounded hull every question of two figures is asked (query/variant/own_figure.hpp), and whatever takes
// a ConvexBody3.
// Laws: the set is all points at most as far from the convex hull of the places as the length says; without a length it is
// the hull.  Places are points of space, lists of them, and those of figures that are made of places alone; there is at
// most one length.  Anything else does not compile.
// Source: RTCD 4.5.
// Cost: a list of the places.
#pragma once

#include <vector>

#include "plumb/figure/basic/sound.hpp"

namespace plumb {

template <class Shape>
inline constexpr bool is_rounded_hull = false;

template <class Shape>
concept RoundedHullFigure = is_rounded_hull<Shape> && Described<Shape>;

/// The hull of these points, of which any may be inside or repeated, and all within the radius of it.
struct RoundedHull3 {
  std::span<const Point3> vertices;
  double radius;
};

namespace query {

template <part::Role R, class Member>
void add_places(std::vector<Point3>& to, const part::Part<R, Member>& p) {
  if constexpr (R == part::Role::place && std::is_same_v<Member, Point3>) {
    to.push_back(p.is);
  } else if constexpr (R == part::Role::place && requires { to.push_back(*p.is.begin()); }) {
    to.insert(to.end(), p.is.begin(), p.is.end());
  } else if constexpr (R == part::Role::figure && Described<Member>) {
    body(p.is, [&to]<class... Parts>(std::string_view, const Parts&... parts) {
      static_assert(((Parts::role != part::Role::length) && ...),
                    "plumb: a rounded hull has a radius of its own alone; name the points of the figure within it");
      (add_places(to, parts), ...);
    });
  } else {
    static_assert(R == part::Role::length,
                  "plumb: a rounded hull is made of places of space, figures of such places, and at most one length");
  }
}

/// Its places, and its radius, zero without one; not yet looked at.
struct PlacesAndRadius {
  std::vector<Point3> places;
  double radius = 0;
};
template <RoundedHullFigure Shape>
PlacesAndRadius places_and_radius(const Shape& s) {
  PlacesAndRadius all;
  body(s, [&all]<class... Parts>(std::string_view, const Parts&... parts) {
    static_assert(((Parts::role == part::Role::length ? 1 : 0) + ... + 0) <= 1,
                  "plumb: a rounded hull is made of places of space, figures of such places, and at most one length");
    const auto take_length = [&all]<part::Role R, class Member>(const part::Part<R, Member>& p) {
      if constexpr (R == part::Role::length) all.radius = p.is;
    };
    (add_places(all.places, parts), ...);
    (take_length(parts), ...);
  });
  return all;
}

}  // namespace query

}  // namespace plumb
