// Is every number of a figure real?  Its parts by name.
//
// Cost: a subtraction for each number.
#pragma once

#include <string>

#include "figure/chain_input.hpp"
#include "query/convex_set.hpp"

namespace plumb::meeting {

/// Throws NonFinite for the first that is none: "intersection: b.direction.y is nan, ...".
template <class... Parts>
void require_real(char figure, const std::array<std::string_view, sizeof...(Parts)>& names, const Parts&... parts) {
  const auto all = std::apply([](auto... x) { return std::array<double, sizeof...(x)>{x...}; },
                              std::tuple_cat(coordinates(parts)...));
  double zero = 0;
  for (const double x : all) zero += x - x;
  if (zero == 0) [[likely]]
    return;
  std::array<std::string, sizeof...(Parts)> whole;
  std::array<std::string_view, sizeof...(Parts)> views;
  for (std::size_t i = 0; i < names.size(); ++i) {
    whole[i] = std::string(1, figure).append(".").append(names[i]);
    views[i] = whole[i];
  }
  require_finite_parts("intersection", views, parts...);
}

template <class P, class V>
void require_line(char f, const P& point, const V& direction, std::string_view name) {
  require_real(f, {name, "direction"}, point, direction);
}
inline void require_figure(char f, const Line2& s) { require_line(f, s.point, s.direction, "point"); }
inline void require_figure(char f, const Line3& s) { require_line(f, s.point, s.direction, "point"); }
inline void require_figure(char f, const Ray2& s) { require_line(f, s.origin, s.direction, "origin"); }
inline void require_figure(char f, const Ray3& s) { require_line(f, s.origin, s.direction, "origin"); }
inline void require_figure(char f, const Segment2& s) { require_real(f, {"a", "b"}, s.a, s.b); }
inline void require_figure(char f, const Segment3& s) { require_real(f, {"a", "b"}, s.a, s.b); }
inline void require_figure(char f, const Plane3& s) { require_real(f, {"normal", "offset"}, s.normal, s.offset); }
inline void require_figure(char f, const Halfspace3& s) { require_real(f, {"normal", "offset"}, s.normal, s.offset); }
inline void require_figure(char f, const ThreePointPlane3& s) { require_real(f, {"a", "b", "c"}, s.a, s.b, s.c); }
inline void require_figure(char f, const Triangle2& s) { require_real(f, {"a", "b", "c"}, s.a, s.b, s.c); }
inline void require_figure(char f, const Triangle3& s) { require_real(f, {"a", "b", "c"}, s.a, s.b, s.c); }
inline void require_figure(char f, const Tetrahedron3& s) { require_real(f, {"a", "b", "c", "d"}, s.a, s.b, s.c, s.d); }
inline void require_figure(char f, const Aabb2& s) { require_real(f, {"min", "max"}, s.min, s.max); }
inline void require_figure(char f, const Aabb3& s) { require_real(f, {"min", "max"}, s.min, s.max); }
inline void require_figure(char f, const Obb3& s) {
  require_real(f, {"center", "axes[0]", "axes[1]", "axes[2]", "half"}, s.center, s.axes[0], s.axes[1], s.axes[2],
               s.half);
}
inline void require_figure(char f, const Polygon2& s) {
  require_chain<Point2>("intersection", std::string(1, f).append(".vertices"), s.vertices);
}
inline void require_figure(char, const ConvexPolyhedron3&) {}  // proved when it was made

}  // namespace plumb::meeting
