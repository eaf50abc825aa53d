// When is a figure of your own the convex hull of its places, and all within a radius of it?  When you say so.
//
//   struct Cushion { Triangle3 core; double radius; };               and its body (figure/basic/body.hpp)
//   template <> inline constexpr bool plumb::is_rounded_hull<Cushion> = plumb::hull_of_places<Cushion>();
//
// A body says of what a figure is made, not which set that is: a capsule and a cylinder are made of the same.  Of what
// says that it is a rounded hull every question of two figures is asked (query/variant/own_figure.hpp), and whatever takes
// a ConvexBody3.
// Laws: the set is all points at most as far from the convex hull of the places as the length says; without a length it is
// the hull.  Places are points of space, lists of them, and those of figures that are made of places alone; there is at
// most one length.  Anything else does not compile.
// Source: RTCD 4.5.
// Cost: a list of the places.  Nothing is searched.
#pragma once

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/figure/basic/sound.hpp"

namespace plumb {

namespace query {

template <class Place>
inline constexpr bool is_list_of_places = false;
template <>
inline constexpr bool is_list_of_places<std::vector<Point3>> = true;
template <std::size_t N>
inline constexpr bool is_list_of_places<std::array<Point3, N>> = true;

template <class Part>
struct IsOfPlaces : std::false_type {};
template <class Member>
struct IsOfPlaces<part::Part<part::Role::place, Member>>
    : std::bool_constant<std::is_same_v<Member, Point3> || is_list_of_places<Member>> {};
struct AreOfPlaces {
  template <class... Parts>
  constexpr auto operator()(std::string_view, const Parts&...) const {
    return std::bool_constant<(IsOfPlaces<Parts>::value && ...)>();
  }
};
template <Described Member>
struct IsOfPlaces<part::Part<part::Role::figure, Member>>
    : decltype(body(std::declval<const Member&>(), AreOfPlaces{})) {};

/// Places, figures of places, and at most one length?
struct MakeARoundedHull {
  template <class... Parts>
  constexpr auto operator()(std::string_view, const Parts&...) const {
    constexpr bool one_length = ((Parts::role == part::Role::length ? 1 : 0) + ... + 0) <= 1;
    constexpr bool rest = ((Parts::role == part::Role::length || IsOfPlaces<Parts>::value) && ...);
    return std::bool_constant < one_length && rest > ();
  }
};

}  // namespace query

/// To be said of a body that allows it.
template <Described Shape>
consteval bool hull_of_places() {
  using Allowed = decltype(body(std::declval<const Shape&>(), query::MakeARoundedHull{}));
  static_assert(Allowed::value,
                "plumb: a rounded hull is made of places of space, figures of such places, and at most one length");
  return Allowed::value;
}

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
  if constexpr (R == part::Role::figure) {
    body(p.is, [&to](std::string_view, const auto&... parts) { (add_places(to, parts), ...); });
  } else if constexpr (std::is_same_v<Member, Point3>) {
    to.push_back(p.is);
  } else if constexpr (R == part::Role::place) {
    to.insert(to.end(), p.is.begin(), p.is.end());
  }
}

/// Its places, and its radius, zero without one; not yet looked at.
struct PlacesAndRadius {
  std::vector<Point3> places;
  double radius = 0;
};
template <RoundedHullFigure Shape>
PlacesAndRadius places_and_radius(const Shape& s) {
  static_assert(hull_of_places<Shape>());
  PlacesAndRadius all;
  body(s, [&all]<class... Parts>(std::string_view, const Parts&... parts) {
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
