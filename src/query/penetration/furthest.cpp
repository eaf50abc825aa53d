// A guess in doubles, which holds no bound.
#include "query/penetration/furthest.hpp"

namespace plumb::query::parting {

std::uint32_t guessed_furthest(const CoreCorners& c, const arith::Plain& along, std::uint32_t from) {
  if (const ConvexPolyhedron3* p = c.polyhedron()) {
    double most = dot(c.at<double>(from), along);
    for (bool better = true; better;) {  // ends, for `most` rises with each vertex
      better = false;
      for (const std::uint32_t i : p->neighbors_of(from)) {
        const double d = dot(c.at<double>(i), along);
        if (d > most) most = d, from = i, better = true;
      }
    }
    return from;
  }
  std::uint32_t best = 0;
  if (c.ways() > 0) {
    for (std::uint32_t k = 0; k < c.ways(); ++k) best |= dot(c.way<double>(k), along) > 0 ? 1u << k : 0u;
    return best;
  }
  double most = dot(c.at<double>(0), along);
  for (std::uint32_t i = 1; i < c.size(); ++i) {
    const double d = dot(c.at<double>(i), along);
    if (d > most) best = i, most = d;
  }
  return best;
}

}  // namespace plumb::query::parting
