// What do the classics cost those who compile without NDEBUG, or without optimization?  This file by itself, compiled
// with the flags that METHOD names: bench_flags_O0, bench_flags_O2, bench_flags_O2_NDEBUG.
#include "bench/measure.hpp"
#include "plumb/predicates.hpp"

namespace plumb::bench {
namespace {

int take(const Point2* p, predicates::Orient2d) { return static_cast<int>(orient2d(p[0], p[1], p[2])); }
int take(const Point3* p, predicates::Orient3d) { return static_cast<int>(orient3d(p[0], p[1], p[2], p[3])); }
int take(const Point2* p, predicates::InCircle) { return static_cast<int>(incircle(p[0], p[1], p[2], p[3])); }
int take(const Point3* p, predicates::InSphere) { return static_cast<int>(insphere(p[0], p[1], p[2], p[3], p[4])); }

template <class Point>
std::vector<Point> points_of(const std::vector<double>& x) {
  std::vector<Point> all;
  if constexpr (std::is_same_v<Point, Point2>) {
    for (std::size_t i = 0; i < x.size(); i += 2) all.push_back({x[i], x[i + 1]});
  } else {
    for (std::size_t i = 0; i < x.size(); i += 3) all.push_back({x[i], x[i + 1], x[i + 2]});
  }
  return all;
}

template <class F>
void register_predicate() {
  using Point = std::conditional_t<F::dimension == 2, Point2, Point3>;
  for (const char* name : {"uniform", "degenerate_long"}) {
    add(F::name, name, METHOD, [all = points_of<Point>(inputs<F>(name))] {
      long sum = 0;
      const Point *p = all.data(), *end = p + all.size();
      for (; p != end; p += F::points) sum += take(p, F{});
      return sum;
    });
  }
}

[[maybe_unused]] const bool registered = register_classics([]<Formula F>(F) { register_predicate<F>(); });

}  // namespace
}  // namespace plumb::bench
