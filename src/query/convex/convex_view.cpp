#include "query/convex/convex_view.hpp"

#include "arith/exact_number.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/convex/bound_value.hpp"

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

template <class Vector>
ExactHalfspace exact_halfspace(const Vector& normal, double offset, int sign) {
  ExactHalfspace h{{sign * mpq_class(normal.x), sign * mpq_class(normal.y), 0}, sign * mpq_class(offset)};
  if constexpr (requires { normal.z; }) h.normal[2] = sign * mpq_class(normal.z);
  return h;
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
  std::vector<ExactHalfspace> all;
  with_figure(v, [&](const auto& s) {
    if constexpr (requires { s.halfspaces; }) {
      for (const auto& h : s.halfspaces) all.push_back(exact_halfspace(h.normal, h.offset, 1));
    } else if constexpr (requires { s.directions; }) {
      for (std::size_t i = 0; i < s.min.size(); ++i) {
        all.push_back(exact_halfspace(s.directions.all()[i], s.max[i], 1));
        all.push_back(exact_halfspace(s.directions.all()[i], s.min[i], -1));
      }
    } else if constexpr (requires { s.normal; }) {
      all.push_back(exact_halfspace(s.normal, s.offset, 1));
    }
  });
  return all;
}

}  // namespace plumb::query::meeting
