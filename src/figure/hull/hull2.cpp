#include "plumb/figure/hull/hull2.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "certify/batch/all_threads.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/hull/hull2_steps.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace figure::hull2 {

namespace {

/// The lower half and the upper one, each on a thread of its own where there is one.
void sort_halves(std::span<Indexed> points, int halvings) {
  constexpr std::size_t worth_a_task = 1 << 14;
  if (halvings == 0 || points.size() <= worth_a_task) {
    std::sort(points.begin(), points.end(), before);
    return;
  }
  const std::size_t middle = points.size() / 2;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle), points.end(), before);
  certify::batch::for_each_part(Execution::parallel, 2, [&](std::size_t half) {
    sort_halves(half == 0 ? points.first(middle) : points.subspan(middle), halvings - 1);
  });
}

}  // namespace

void sort_distinct(std::vector<Indexed>& points, Execution execution) {
  constexpr int most_halvings = 5;  // 32 parts: no more threads gain by it
  sort_halves(points, execution == Execution::parallel ? most_halvings : 0);
  const auto equal = [](const Indexed& a, const Indexed& b) { return a.p == b.p; };
  points.erase(std::unique(points.begin(), points.end(), equal), points.end());
}

Hull2 monotone_chain(std::span<const Indexed> points, bool all_boundary_points) {
  const std::size_t n = points.size();
  if (n <= 1) return {n == 0 ? -1 : 0, n == 0 ? std::vector<std::uint32_t>{} : std::vector{points[0].index}};
  const auto dents = [all_boundary_points](const Indexed& a, const Indexed& b, const Indexed& c) {
    const Sign s = turn(a, b, c);
    return s == Sign::negative || (s == Sign::zero && !all_boundary_points);
  };
  const bool flat =
      std::ranges::all_of(points, [&](const Indexed& p) { return turn(points[0], p, points[n - 1]) == Sign::zero; });
  // The lower chain from the first point to the last, then the upper one back: both end in a point of the other.
  std::vector<const Indexed*> chain;
  const auto extend = [&](std::size_t base, const Indexed& next) {
    while (chain.size() >= base + 2 && dents(*chain[chain.size() - 2], *chain.back(), next)) chain.pop_back();
    chain.push_back(&next);
  };
  for (const Indexed& next : points) extend(0, next);
  const std::size_t lower = chain.size();
  if (!flat) {
    for (std::size_t i = n - 1; i-- > 0;) extend(lower - 1, points[i]);
    chain.pop_back();
  }
  Hull2 hull{flat ? 1 : 2, {}};
  hull.vertices.reserve(chain.size());
  for (const Indexed* p : chain) hull.vertices.push_back(p->index);
  return hull;
}

}  // namespace figure::hull2

Hull2 convex_hull(std::span<const Point2> points, const Hull2Options& options) {
  if (points.size() > std::numeric_limits<std::uint32_t>::max())
    throw InvalidShape("convex_hull: more than 2^32 - 1 points; give fewer");
  std::vector<figure::hull2::Indexed> left = figure::hull2::candidates(points, options);
  if (options.method == Hull2Method::quickhull)
    return figure::hull2::quickhull(std::move(left), options.all_boundary_points);
  figure::hull2::sort_distinct(left, options.execution);
  return figure::hull2::monotone_chain(left, options.all_boundary_points);
}

std::vector<std::uint32_t> extreme_points(std::span<const Point2> points, const Vector2& direction) {
  figure::require_finite_points("extreme_points", "points", points);
  require_finite_parts("extreme_points", {"direction"}, direction);
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Sign s =
        all.empty() ? Sign::zero : sign_of(predicates::OrderAlongDirection2d{}, points[i], points[all[0]], direction);
    if (s == Sign::positive) all.clear();
    if (s != Sign::negative) all.push_back(static_cast<std::uint32_t>(i));
  }
  return all;
}

}  // namespace plumb
