// A figure with straight edges and flat faces whose type was forgotten: the type again.
//
// Cost: a jump.
#pragma once

#include <cstdlib>
#include <type_traits>

#include "plumb/query/body/detail/with_figure.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// Calls f with the figure as it was.
template <class F>
decltype(auto) with_shape(const FlatView& v, F f) {
  using Answer = std::invoke_result_t<F&, const Point3&>;
  return with_figure(v, [&f]<class Shape>(const Shape& s) -> Answer {
    if constexpr (FlatFigure<Shape>) {
      return f(s);
    } else {
      std::abort();  // no FlatView is made of such a kind
    }
  });
}

inline bool is_polygon(const FlatView& v) {
  return is_one_of(v.kind, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon});
}

}  // namespace plumb::query
