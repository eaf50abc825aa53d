#include "query/penetration/separating_axes.hpp"

#include <cmath>

#include "query/penetration/box_axes.hpp"
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

/// A guess in doubles: the axis of two boxes along which they overlap least.
std::array<std::uint32_t, 2> guessed_axis(const GivenBox& a, const GivenBox& b) {
  std::array<arith::Plain, 6> g;
  std::array<double, 6> s;
  for (std::size_t k = 0; k < 6; ++k) {
    g[k] = arith::vec<double>((k < 3 ? a : b).axes[k % 3]);
    const GivenBox::Ends& e = (k < 3 ? a : b).length[k % 3];
    s[k] = e.to - e.from;
  }
  const auto middle = [&](std::size_t k) {
    return (a.middle[k].to - a.middle[k].from) - (b.middle[k].to - b.middle[k].from);
  };
  const arith::Plain c{middle(0), middle(1), middle(2)};
  std::array<std::uint32_t, 2> best{0, 1};
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < 6; ++i) {
    for (std::uint32_t j = i + 1; j < 6; ++j) {
      const arith::Plain n = cross(g[i], g[j]);
      double overlap = -std::fabs(dot(n, c));
      for (std::size_t k = 0; k < 6; ++k) overlap += std::fabs(dot(n, g[k])) * s[k];  // of i and j nearly nothing
      const double square = overlap * overlap / dot(n, n);
      if (square < least) least = square, best = {i, j};
    }
  }
  return best;
}

/// Of two boxes no two edges of which are parallel: where doubles tell the one way that is shortest.
std::optional<SumParting> quick_boxes(const EdgeSum& sum) {
  const Difference& d = sum.difference();
  if (sum.groups() != 6) return {};
  const auto a = d.a.given_box(), b = d.b.given_box();
  if (!a || !b) return {};
  const auto [i, j] = guessed_axis(*a, *b);
  FloatWorld<IsLeastAxis> world;
  const IsLeastAxis::Told axis = IsLeastAxis{}(world, *a, *b, i, j);
  if (!axis.is_least || !world.certain()) return {};
  SumParting told{.known = SumParting::Known::parting, .is_plain = {true, true}};
  const auto facet = facet_of(sum, i, j, -axis.middle, [&](std::uint32_t g) { return axis.along[g]; });
  const Vector3 u = (i < 3 ? *a : *b).axes[i % 3], v = (j < 3 ? *a : *b).axes[j % 3];
  const bool up = axis.middle == Sign::positive;
  told.level = facet.level;
  told.parting = Parting{Way::across(up ? u : v, up ? v : u, facet.points[0]), false, true};
  return told;
}

}  // namespace

SumParting parted_sums(const Difference& d, Gap gap) {
  SumParting told;
  const EdgeSum sum(d);
  if (sum.groups() < 3) return told;
  if (sum.groups() == 3 && sum.axis(0) && sum.axis(1) && sum.axis(2)) return parted_along_axes(sum);
  if (const auto quick = quick_boxes(sum)) return *quick;
  Zonotope z(sum);
  if (const auto quick = quick_axis(z, gap)) return *quick;
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
