#include "bench/rivals/cgal_rival.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace plumb::bench {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

template <std::size_t Points, class Decide>
std::function<long()> over_2d(std::span<const double> c, Decide decide) {
  std::vector<K::Point_2> p;
  for (std::size_t i = 0; i + 1 < c.size(); i += 2) p.emplace_back(c[i], c[i + 1]);
  return [p, decide] {
    long sum = 0;
    for (std::size_t i = 0; i < p.size(); i += Points) sum += static_cast<long>(decide(&p[i]));
    return sum;
  };
}

template <std::size_t Points, class Decide>
std::function<long()> over_3d(std::span<const double> c, Decide decide) {
  std::vector<K::Point_3> p;
  for (std::size_t i = 0; i + 2 < c.size(); i += 3) p.emplace_back(c[i], c[i + 1], c[i + 2]);
  return [p, decide] {
    long sum = 0;
    for (std::size_t i = 0; i < p.size(); i += Points) sum += static_cast<long>(decide(&p[i]));
    return sum;
  };
}

}  // namespace

std::function<long()> epick(std::string_view predicate, std::span<const double> c) {
  const K kernel;
  if (predicate == "orient2d") {
    return over_2d<3>(c, [f = kernel.orientation_2_object()](const K::Point_2* p) { return f(p[0], p[1], p[2]); });
  }
  if (predicate == "orient3d") {
    return over_3d<4>(c,
                      [f = kernel.orientation_3_object()](const K::Point_3* p) { return f(p[0], p[1], p[2], p[3]); });
  }
  if (predicate == "incircle") {
    return over_2d<4>(
        c, [f = kernel.side_of_oriented_circle_2_object()](const K::Point_2* p) { return f(p[0], p[1], p[2], p[3]); });
  }
  return over_3d<5>(c, [f = kernel.side_of_oriented_sphere_3_object()](const K::Point_3* p) {
    return f(p[0], p[1], p[2], p[3], p[4]);
  });
}

}  // namespace plumb::bench
