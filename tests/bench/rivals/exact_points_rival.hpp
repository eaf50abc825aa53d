// What do questions about constructed points cost, on first use and later?  The same runs for every kernel.
//
// A kernel says what its points are, how figures construct one, and how two or three compare.  `first` runs construct
// the points as well, as no kernel can be asked about a point before; `construct` runs do that alone.
#pragma once

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "bench/rivals/intersection_rival.hpp"

namespace plumb::bench {

enum class PointQuestion { construct, order_first, order, turn_first, turn, equal_first, equal, sort };

template <class Kernel, class A, class B>
auto constructed(const Pairs<A, B>& pairs) {
  std::vector<decltype(Kernel::point(pairs[0].first, pairs[0].second))> points;
  points.reserve(pairs.size());
  for (const auto& [a, b] : pairs) points.push_back(Kernel::point(a, b));
  return points;
}

/// Each point and its neighbors, those 2k and 2k + 1 for equality; the sum of the answers.
template <class Kernel>
long asked(PointQuestion question, const auto& p) {
  long sum = 0;
  using enum PointQuestion;
  if (question == order_first || question == order) {
    for (std::size_t i = 0; i + 1 < p.size(); ++i) sum += Kernel::before(p[i], p[i + 1]) ? 1 : 0;
  } else if (question == turn_first || question == turn) {
    for (std::size_t i = 0; i + 3 < p.size(); ++i) sum += Kernel::turn(p[i], p[i + 1], p[i + 2], p[i + 3]);
  } else {
    for (std::size_t i = 0; i + 1 < p.size(); i += 2) sum += p[i] == p[i + 1] ? 1 : 0;
  }
  return sum;
}

/// The first call makes the points and asks them once, if they are to be used again.
template <class Kernel, class A, class B>
Run point_run(PointQuestion question, const Pairs<A, B>& given) {
  using enum PointQuestion;
  const auto pairs = std::make_shared<const std::decay_t<decltype(Kernel::taken(given))>>(Kernel::taken(given));
  if (question == construct) return [pairs] { return static_cast<long>(constructed<Kernel>(*pairs).size()); };
  if (question == order_first || question == turn_first || question == equal_first)
    return [pairs, question] { return asked<Kernel>(question, constructed<Kernel>(*pairs)); };
  return [pairs, question, points = decltype(constructed<Kernel>(*pairs))()]() mutable {
    if (points.empty()) points = constructed<Kernel>(*pairs);
    if (question != sort) return asked<Kernel>(question, points);
    auto all = points;
    std::sort(all.begin(), all.end(), [](const auto& p, const auto& q) { return Kernel::before(p, q); });
    return static_cast<long>(all.size());
  };
}

/// CGAL's lazily exact points (Epeck).
Run cgal_points(PointQuestion question, const Pairs<Segment2, Segment2>& pairs);
Run cgal_points(PointQuestion question, const Pairs<Segment3, Triangle3>& pairs);

}  // namespace plumb::bench
