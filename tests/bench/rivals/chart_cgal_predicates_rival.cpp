#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include "bench/rivals/chart_rival.hpp"

namespace plumb::bench {
namespace {

/// CGAL's points, made beforehand from the numbers of a question.
template <class Point, std::size_t Dimension, std::size_t N>
auto points_of(const std::array<double, N>& q) {
  std::array<Point, N / Dimension> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double* const x = &q[i * Dimension];
    if constexpr (Dimension == 2)
      points[i] = Point(x[0], x[1]);
    else
      points[i] = Point(x[0], x[1], x[2]);
  }
  return points;
}

template <class Sign>
double answer(const Sign& sign) {
  return static_cast<double>(sign);
}
template <class Sign>
double answer(const CGAL::Uncertain<Sign>& sign) {
  return sign.is_certain() ? answer(sign.make_certain()) : lab::trial::unsure;
}

struct Nothing {};

/// A Guard lives while a question is answered.
template <class K, class Guard = Nothing>
void add_kernel(Rivals& all, const std::string& name, const std::string& about) {
  using P2 = typename K::Point_2;
  using P3 = typename K::Point_3;
  const auto add = [&]<std::size_t Dimension, std::size_t Points>(const char* task, auto take) {
    using Point = std::conditional_t<Dimension == 2, P2, P3>;
    constexpr std::size_t numbers = Dimension * Points;
    join<numbers>(all, task, name, about, points_of<Point, Dimension, numbers>, take);
  };
  add.template operator()<2, 3>("orient2d", [](const std::array<P2, 3>& p) {
    [[maybe_unused]] const Guard guard;
    return answer(typename K::Orientation_2()(p[0], p[1], p[2]));
  });
  // In space CGAL's signs are the opposite of the classic ones.
  add.template operator()<3, 4>("orient3d", [](const std::array<P3, 4>& p) {
    [[maybe_unused]] const Guard guard;
    return -answer(typename K::Orientation_3()(p[0], p[1], p[2], p[3]));
  });
  add.template operator()<2, 4>("incircle", [](const std::array<P2, 4>& p) {
    [[maybe_unused]] const Guard guard;
    return answer(typename K::Side_of_oriented_circle_2()(p[0], p[1], p[2], p[3]));
  });
  add.template operator()<3, 5>("insphere", [](const std::array<P3, 5>& p) {
    [[maybe_unused]] const Guard guard;
    return -answer(typename K::Side_of_oriented_sphere_3()(p[0], p[1], p[2], p[3], p[4]));
  });
}

}  // namespace

void add_cgal_predicates(Rivals& all) {
  add_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(all, "epick", "CGAL, exact predicates");
  add_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(all, "epeck", "CGAL, exact constructions as well");
  using Interval = CGAL::Interval_nt_advanced;
  add_kernel<CGAL::Simple_cartesian<Interval>, Interval::Protector>(
      all, "cgal-interval", "CGAL's intervals alone, the rounding mode switched for each question");
}

}  // namespace plumb::bench
