#include "query/convex/core.hpp"

#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"

namespace plumb::query {
double radius_of(const FigureView& figure) {
  return with_figure(figure, [](const auto& s) -> double {
    if constexpr (requires { s.radius; }) {
      return s.radius;
    } else {
      return 0;
    }
  });
}

FlatSet core_of(const FigureView& figure) {
  return with_figure(figure, [&]<class Shape>(const Shape& s) -> FlatSet {
    if constexpr (has_boundary<Shape> && !FlatFigure<Shape>) {
      FlatSet core;
      for_each_corner<mpq_class>(s, [&](const arith::Vec<mpq_class>& p) { core.points.push_back({p.x, p.y, p.z}); });
      return core;
    } else {
      return flat_set(figure);
    }
  });
}

}  // namespace plumb::query
