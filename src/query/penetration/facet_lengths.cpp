#include "query/penetration/facet_lengths.hpp"

namespace plumb::query::parting {
namespace {

template <class W, class N>
Ball as_ball(const W& w, const N& x) {
  const Rounded s = two_sum(x.value.high, x.value.low);
  return {s.value, s.error, w.template doubt<N::track>()};
}

}  // namespace

std::optional<FacetLengthsTold> facet_lengths(const Difference& d, const std::array<Ends, 3>& facet) {
  const auto a = d.a.points(), b = d.b.points();
  if (a.empty() || b.empty() || !d.a.stands() || !d.b.stands()) return {};
  TrianglePairs of;
  for (std::size_t i = 0; i < 3; ++i) of.a[i] = a[facet[i][0]], of.b[i] = b[facet[i][1]];
  PairWorld<FacetLengths> w;
  std::optional<FacetLengthsTold> told;
  FacetLengths{}(w, of, [&](const auto& x, const auto& y, const auto& z, const auto& square, const auto& overlap) {
    if (!w.in_range()) return;
    told = {{as_ball(w, x), as_ball(w, y), as_ball(w, z)}, as_ball(w, square), as_ball(w, overlap)};
  });
  return told;
}

}  // namespace plumb::query::parting
