#include "query/gjk/least_face.hpp"

#include "arith/rational_lp.hpp"

namespace plumb::query {

int dimension_of(const std::vector<Exact3>& points) {
  std::vector<Exact3> ways;
  for (const Exact3& p : points) {
    const Exact3 way = p - points[0];
    if (is_zero(way)) continue;
    if (ways.empty() || (ways.size() == 1 && !is_zero(cross(ways[0], way))) ||
        (ways.size() == 2 && sgn(dot(cross(ways[0], ways[1]), way)) != 0)) {
      ways.push_back(way);
    }
  }
  return static_cast<int>(ways.size());
}

Feature least_face(const std::vector<Exact3>& all_points, const Exact3& x, const Exact3& way) {
  std::vector<Exact3> points;
  std::vector<std::uint32_t> number;
  for (std::size_t i = 0; i < all_points.size(); ++i) {
    if (sgn(dot(all_points[i] - x, way)) == 0)
      points.push_back(all_points[i]), number.push_back(static_cast<std::uint32_t>(i));
  }
  // Over weights w_i >= 0 of the points about x and t_i of [0, 1], none above its weight: sum w_i (p_i - x) = 0, most
  // sum t_i.  Weights may be of any size, so that every t_i that can be above zero is one.
  const std::size_t n = points.size();
  arith::Constraints all;
  const auto row = [&] { return arith::RationalVector(2 * n); };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {1, -1}) {
      auto r = row();
      for (std::size_t i = 0; i < n; ++i) r[i] = side * mpq_class(points[i][axis] - x[axis]);
      all.add(std::move(r), 0);
    }
  }
  auto objective = row();
  for (std::size_t i = 0; i < n; ++i) {
    auto below_weight = row(), at_most = row(), not_negative = row();
    below_weight[n + i] = 1, below_weight[i] = -1;
    at_most[n + i] = 1;
    not_negative[n + i] = -1;
    all.add(std::move(below_weight), 0), all.add(std::move(at_most), 1), all.add(std::move(not_negative), 0);
    objective[n + i] = 1;
  }
  const arith::Optimum best = arith::maximize(objective, all);
  std::vector<Exact3> in_face;
  std::uint32_t first = 0;
  for (std::size_t i = n; i-- > 0;) {
    if (sgn(best.at[n + i]) > 0) in_face.push_back(points[i]), first = number[i];
  }
  constexpr std::array kinds{FeatureKind::vertex, FeatureKind::edge, FeatureKind::face, FeatureKind::interior};
  const FeatureKind kind = kinds[static_cast<std::size_t>(dimension_of(in_face))];
  return {kind, kind == FeatureKind::interior ? 0 : first};
}

}  // namespace plumb::query
