#include "query/penetration/parted.hpp"

#include "arith/exact_number.hpp"

namespace plumb::query::parting {
namespace {

/// Of a difference without an inside: of two directions the one that comes first.
Way beside(const Difference& d, const Basis& basis) {
  const auto is_below_zero = [&](const Way& way) {  // the first of its numbers that is not zero
    Sign s = Sign::zero;
    for (int axis = 0; axis < 3 && s == Sign::zero; ++axis) {
      s = sign_of([&]<class T>() -> T { return along_axis(way.along<T>(d), axis); });
    }
    return s == Sign::negative;
  };
  if (basis.size() == 3) {
    const Way way = Way::through({basis[0], basis[1], basis[2]});
    return is_below_zero(way) ? way : Way::through({basis[0], basis[2], basis[1]});
  }
  if (basis.size() == 1) return Way::against_axis(0);
  const auto along = [&](int axis) {
    return sign_of([&]<class T>() -> T {
      const Vec<T> u = d.between<T>(basis[0], basis[1]);
      return axis == 1 ? u.y : u.z;
    });
  };
  const bool is_along_x = along(1) == Sign::zero && along(2) == Sign::zero;
  return Way::beside_line(basis[0], basis[1], is_along_x ? 1 : 0);
}

/// From the nearest point of cores that are apart.
Way back_from(const Difference& d, const DifferenceCorners& nearest) {
  const auto& e = nearest.ends;
  if (nearest.size == 1) return Way::to_point(e[0]);
  if (nearest.size == 2) return Way::to_line(e[0], e[1]);
  const Sign height =
      sign_of([&]<class T>() -> T { return PlaneOf<T>(d.at<T>(e[0]), d.at<T>(e[1]), d.at<T>(e[2])).height(); });
  return height == Sign::negative ? Way::through({e[0], e[1], e[2]}) : Way::through({e[0], e[2], e[1]});
}

}  // namespace

Sign compare_with_radii(const Difference& d, const DifferenceCorners& nearest, const mpq_class& radii) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic, Sought::square>(d.a, d.b, nearest, ask);
  const BigDyadic scale = d.a.scale<BigDyadic>();
  return sign_of_number(cmp(gmp_number(n.square), radii * radii * gmp_number(n.square_whole * (scale * scale))));
}

FirstWay first_way(const Difference& d, std::span<const std::array<Ends, 3>> facets) {
  FirstWay r{0, true};
  for (std::size_t i = 1; i < facets.size(); ++i) {
    const Sign order = compare_directions(d, Way::through(facets[i]), Way::through(facets[r.index]));
    if (order == Sign::negative) r.index = i;
    if (order != Sign::zero) r.is_unique = false;
  }
  return r;
}

Parting first_of(const Difference& d, const NearestPlanes& planes) {
  const FirstWay first = first_way(d, {planes.facets.begin(), planes.facets.size()});
  return {Way::through(planes.facets[first.index]), false, first.is_unique, planes.origin == Origin::on_boundary,
          planes.level};
}

Parting parted_from(const Difference& d, const CoreDistance& core) {
  if (!core.meet) return {back_from(d, core.nearest), true, true};
  const NearestPlanes planes = nearest_planes(d, core, EveryWay());
  if (planes.facets.empty()) return {beside(d, planes.flat), false, false, true};
  return first_of(d, planes);
}

std::optional<Parting> parted(const Difference& d, const std::optional<mpq_class>& radii) {
  if (const auto proved = proved_planes(d)) return first_of(d, *proved);
  const CoreDistance core = core_distance(d);
  if (!core.meet && (!radii || compare_with_radii(d, core.nearest, *radii) == Sign::positive)) return {};
  return parted_from(d, core);
}

}  // namespace plumb::query::parting
