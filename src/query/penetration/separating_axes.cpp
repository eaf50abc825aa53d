#include "query/penetration/separating_axes.hpp"

#include "query/penetration/quick_axis.hpp"
#include "query/penetration/zonotope.hpp"

namespace plumb::query::parting {
namespace {

/// The facets to which the way is least, by their normals' numbers.
struct Nearest {
  std::array<std::uint32_t, 15> normal{};
  std::size_t size = 0;
  bool is_apart = false, is_solid = false;
};

Nearest nearest_normals(Zonotope& z) {
  Nearest n;
  double most = std::numeric_limits<double>::infinity();  // of the least square
  bool touches = false;
  const auto take = [&](std::uint32_t i) { n.normal[n.size++] = i; };
  for (std::uint32_t i = 0; i < z.normals(); ++i) {
    const Sign overlap = z.sign_of_overlap(i);
    if (overlap == Sign::zero && z.is_parallel(i)) continue;
    if (overlap == Sign::negative) {
      n.is_apart = true;
      return n;
    }
    n.is_solid = n.is_solid || z.has_reach(i);
    if (overlap == Sign::zero && !touches) touches = true, n.size = 0;
    if ((overlap == Sign::zero) != touches) continue;
    if (!touches && z.square(i).lower() > most) continue;
    if (!touches) most = std::min(most, z.square(i).upper());
    take(i);
  }
  if (touches) return n;
  const Nearest all = n;
  n.size = 0;
  for (std::size_t k = 0; k < all.size; ++k) {
    const std::uint32_t i = all.normal[k];
    if (z.square(i).lower() > most) continue;
    const Sign order = n.size == 0 ? Sign::zero : z.compare(i, n.normal[0]);
    if (order == Sign::negative) n.size = 0;
    if (order != Sign::positive) take(i);
  }
  return n;
}

}  // namespace

SumParting parted_sums(const Difference& d, Gap gap) {
  SumParting told;
  const EdgeSum sum(d);
  if (sum.groups() < 3) return told;
  if (sum.groups() == 3 && sum.axis(0) && sum.axis(1) && sum.axis(2)) return parted_along_axes(sum);
  if (const auto quick = quick_axis(sum, gap)) return *quick;
  Zonotope z(sum);
  const Nearest nearest = nearest_normals(z);
  if (nearest.is_apart) {
    told.known = SumParting::Known::apart;
    return told;
  }
  if (!nearest.is_solid) return told;
  std::array<SumFacet, 30> facets;
  std::array<std::array<Ends, 3>, 30> points;
  std::size_t size = 0;
  for (std::size_t k = 0; k < nearest.size; ++k) {
    const std::uint32_t normal = nearest.normal[k];
    const std::uint32_t i = z.pair(normal)[0], j = z.pair(normal)[1];
    const Sign middle = z.sign_of_middle(normal);  // the facet on the other side is nearer
    for (const Sign side : {Sign::negative, Sign::positive}) {
      if (middle == side) continue;
      facets[size] = facet_of(sum, i, j, side, [&](std::uint32_t g) { return z.sign_along(normal, g); });
      points[size] = facets[size].points, ++size;
    }
  }
  const FirstWay first = first_way(d, std::span(points).first(size));
  told.known = SumParting::Known::parting;
  told.parting = Parting{Way::through(points[first.index]), false, first.is_unique};
  told.level = facets[first.index].level;
  told.is_plain = {z.is_independent(0), z.is_independent(1)};
  return told;
}

}  // namespace plumb::query::parting
