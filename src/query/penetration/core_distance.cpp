#include <algorithm>

#include "query/convex/integer_difference.hpp"
#include "query/penetration/parted.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query::parting {
namespace {

FlatSet exact_set(const CoreCorners& c) {
  FlatSet s;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const Vec<mpq_class> p = c.at<mpq_class>(i);
    s.points.push_back({p.x, p.y, p.z});
  }
  return s;
}

}  // namespace

CoreDistance core_distance(const Difference& d) {
  if (const auto proved = proved_nearest(d.a, d.b)) return {proved->corners, proved->meets};
  const IntegerDifference sets = in_integers(exact_set(d.a), exact_set(d.b));
  arith::DifferenceSearch<mpz_class> search(sets.difference, guessed_corners(sets.difference));
  while (search.step()) {  // ends: query/convex/nearest_pair.cpp
  }
  CoreDistance r{{}, search.square() == 0};
  for (const arith::DifferenceCorner& c : search.corners())
    r.nearest.add({static_cast<std::uint32_t>(c.first), static_cast<std::uint32_t>(c.second)});
  return r;
}

}  // namespace plumb::query::parting
