// Which figure of the tables is the same set?  Boxes by widths or by their center and slabs are asked as that.
//
// Laws: (1) exact: a box whose ends are doubles is an Aabb3; else one by its center is an Obb3 along the axes, which has
// the same numbers, and one by its widths is the box of them, moved by its least corner: a Posed<Aabb3>.  A slab is the
// intersection of two halfspaces, that of `min` first.  (2) A box keeps the numbers of its features, and is never empty.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 4.2 (figure 4.3), 4.6.1.
// Cost: six sums whose errors are looked at.  Nothing is searched.
#pragma once

#include <optional>
#include <string_view>

#include "plumb/query/body/posed.hpp"

namespace plumb::query {

template <class Shape>
struct SaidAs {};
template <>
struct SaidAs<AabbWidths3> {
  using Type = Posed<Aabb3>;
};
template <>
struct SaidAs<AabbCenter3> {
  using Type = Obb3;
};
template <>
struct SaidAs<Slab2> {
  using Type = HalfspaceIntersection2;
};
template <>
struct SaidAs<Slab3> {
  using Type = HalfspaceIntersection3;
};

template <class Shape>
concept Restated = requires {
  typename SaidAs<Shape>::Type;
};
template <class Shape>
concept AnySlab = std::is_same_v<Shape, Slab2> || std::is_same_v<Shape, Slab3>;

template <class Shape>
struct SaidOrAsItIs {
  using Type = Shape;
};
template <Restated Shape>
struct SaidOrAsItIs<Shape> : SaidAs<Shape> {};
/// Of figures that are restated the one that always will do.
template <class Shape>
using SaidType = typename SaidOrAsItIs<Shape>::Type;

/// One of them at least is restated.
template <class A, class B>
concept RestatedPair = (Restated<A> || Restated<B>)&&(Restated<A> || Figure<A>)&&(Restated<B> || Figure<B>);

/// Nothing where an end is no double.  These, and all that follow, throw NonFinite.
std::optional<Aabb3> box_in_doubles(std::string_view function, const AabbWidths3& box);
std::optional<Aabb3> box_in_doubles(std::string_view function, const AabbCenter3& box);
Posed<Aabb3> box_as_it_is(const AabbWidths3& box);
Obb3 box_as_it_is(const AabbCenter3& box);
void require_slab(std::string_view function, const Slab2& slab);
void require_slab(std::string_view function, const Slab3& slab);

/// The halfspaces that a slab is between.
inline Halfspace2 lower_side(const Slab2& s) { return {{-s.normal.x, -s.normal.y}, -s.min}; }
inline Halfspace3 lower_side(const Slab3& s) { return {{-s.normal.x, -s.normal.y, -s.normal.z}, -s.min}; }
inline Halfspace2 upper_side(const Slab2& s) { return {s.normal, s.max}; }
inline Halfspace3 upper_side(const Slab3& s) { return {s.normal, s.max}; }

/// `ask` of the figure, or of what says it.
template <class Shape, class Ask>
auto restated(std::string_view function, const Shape& s, const Ask& ask) {
  if constexpr (!Restated<Shape>) {
    return ask(s);
  } else if constexpr (AnySlab<Shape>) {
    require_slab(function, s);
    return ask(SaidType<Shape>{{lower_side(s), upper_side(s)}});
  } else {
    if (const auto box = box_in_doubles(function, s)) return ask(*box);
    return ask(box_as_it_is(s));
  }
}
template <class A, class B, class Ask>
auto restated(std::string_view function, const A& a, const B& b, const Ask& ask) {
  return restated(function, a,
                  [&](const auto& p) { return restated(function, b, [&](const auto& q) { return ask(p, q); }); });
}

}  // namespace plumb::query
