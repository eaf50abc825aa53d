#include "arith/exact_number.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/convex/bound_value.hpp"
#include "query/convex/set.hpp"

namespace plumb::query::meeting {
namespace {

template <std::size_t N>
std::optional<ConvexSet<N>> set_of_view(const FigureView& v) {
  return with_figure(v, [](const auto& s) -> std::optional<ConvexSet<N>> {
    if constexpr (requires {
                    { convex_set(s) } -> std::same_as<ConvexSet<N>>;
                  }) {
      return convex_set(s);
    } else {
      return {};
    }
  });
}

template <std::size_t N>
std::vector<ExactHalfspace> halfspaces_of_set(const ConvexSet<N>& set) {
  if (set.dimension < 0) return {{{0, 0, 0}, -1}};
  std::vector<ExactHalfspace> all;
  const auto unit = [](std::size_t axis) {
    Vec<BigDyadic, N> e;
    for (std::size_t k = 0; k < N; ++k) e[k] = BigDyadic(k == axis ? 1.0 : 0.0);
    return e;
  };
  for (const Bound<N>& b : set.bounds) {
    ExactHalfspace h{{}, -gmp_number(value<BigDyadic, N>(b, unit(N)))};
    for (std::size_t axis = 0; axis < N; ++axis) h.normal[axis] = gmp_number(slope<BigDyadic, N>(b, unit(axis)));
    const ExactHalfspace against{mpq_class(-1) * h.normal, -h.offset};
    if (b.side >= 0) all.push_back(h);
    if (b.side <= 0) all.push_back(against);
  }
  return all;
}

}  // namespace

std::optional<ConvexSet<2>> convex_set2(const FigureView& v) { return set_of_view<2>(v); }
std::optional<ConvexSet<3>> convex_set3(const FigureView& v) { return set_of_view<3>(v); }

std::vector<ExactHalfspace> halfspaces_of(const ConvexSet<3>& set) { return halfspaces_of_set(set); }

std::vector<ExactHalfspace> halfspaces_of(const FigureView& v) {
  if (const auto set = convex_set3(v)) return halfspaces_of_set(*set);
  if (const auto set = convex_set2(v)) return halfspaces_of_set(*set);
  return with_figure(v, []<class Shape>(const Shape& s) -> std::vector<ExactHalfspace> {
    if constexpr (is_one_of(figure_kind<Shape>,
                            {FigureKind::halfspace, FigureKind::k_dop, FigureKind::halfspace_intersection})) {
      return numbered_sides(s);
    } else {
      return {};
    }
  });
}

}  // namespace plumb::query::meeting
