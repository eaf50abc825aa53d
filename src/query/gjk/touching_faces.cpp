#include "query/gjk/touching_faces.hpp"

#include "arith/rational_lp.hpp"

namespace plumb::query {

std::optional<Exact3> touching_plane(const std::vector<Exact3>& a, const std::vector<Exact3>& b, const Exact3& x) {
  // Over a normal and a slack of [0, 1] for each point, which is no more than how far the point is beyond the plane: the
  // greatest sum of slacks.  The normal may be of any length, so that every slack that can be above zero is one.
  const std::size_t n = a.size() + b.size();
  arith::Constraints all;
  arith::RationalVector objective(3 + n);
  for (std::size_t i = 0; i < n; ++i) {
    const Exact3 way = i < a.size() ? a[i] - x : x - b[i - a.size()];
    arith::RationalVector within(3 + n), at_most(3 + n), not_negative(3 + n);
    for (std::size_t k = 0; k < 3; ++k) within[k] = -way[k];
    within[3 + i] = at_most[3 + i] = objective[3 + i] = 1, not_negative[3 + i] = -1;
    all.add(std::move(within), 0), all.add(std::move(at_most), 1), all.add(std::move(not_negative), 0);
  }
  const arith::Optimum best = arith::maximize(objective, all);
  if (sgn(arith::dot(objective, best.at)) == 0) return {};
  return Exact3{best.at[0], best.at[1], best.at[2]};
}

}  // namespace plumb::query
