#include "query/convex/core.hpp"

#include "figure/basic/in_space.hpp"
#include "query/convex/exact_gap.hpp"

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
  return with_figure(figure, [&](const auto& s) -> FlatSet {
    if constexpr (requires { core_set(in_space(s)); }) {
      return core_set(in_space(s));
    } else if constexpr (requires { core_set(s); }) {
      return core_set(s);
    } else {
      return flat_set(figure);
    }
  });
}

}  // namespace plumb::query
