#include "oracle/cgal_minkowski.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <algorithm>
#include <iterator>

namespace plumb::oracle {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Exact>;

Polygon polygon_of(std::span<const double> c) {
  Polygon p;
  for (std::size_t i = 0; i + 1 < c.size(); i += 2) p.push_back(Exact::Point_2(c[i], c[i + 1]));
  return p;
}

/// From the smallest vertex on, without those that lie on an edge.
std::vector<Exact::Point_2> corners(const Polygon& p) {
  std::vector<Exact::Point_2> all(p.vertices_begin(), p.vertices_end()), strict;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!CGAL::collinear(all[(i + all.size() - 1) % all.size()], all[i], all[(i + 1) % all.size()]))
      strict.push_back(all[i]);
  }
  std::rotate(strict.begin(), std::min_element(strict.begin(), strict.end()), strict.end());
  return strict;
}

}  // namespace

std::vector<double> hull_2(std::span<const double> c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points, hull;
  for (std::size_t i = 0; i + 1 < c.size(); i += 2) points.emplace_back(c[i], c[i + 1]);
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  std::rotate(hull.begin(), std::min_element(hull.begin(), hull.end()), hull.end());
  std::vector<double> out;
  for (const auto& p : hull) out.insert(out.end(), {p.x(), p.y()});
  return out;
}

bool is_sum_2(std::span<const double> a, std::span<const double> b, std::span<const double> pairs) {
  const auto sum = CGAL::minkowski_sum_2(polygon_of(a), polygon_of(b));
  if (sum.has_holes()) return false;
  std::vector<Exact::Point_2> ours;
  for (std::size_t i = 0; i + 3 < pairs.size(); i += 4) {
    ours.emplace_back(Exact::FT(pairs[i]) + Exact::FT(pairs[i + 2]), Exact::FT(pairs[i + 1]) + Exact::FT(pairs[i + 3]));
  }
  std::rotate(ours.begin(), std::min_element(ours.begin(), ours.end()), ours.end());
  return corners(sum.outer_boundary()) == ours;
}

}  // namespace plumb::oracle
