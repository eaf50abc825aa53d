// How long does it take to locate a point in a polygon, beside CGAL?  Polygons of 8 and of 1000 corners.
//
// round: on a circle.  jagged: of random distances from the middle.  teeth: from left to right, up and down.  chain:
// any points, which CGAL takes as well, whatever it makes of them.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/rivals/polygon_rival.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/convex/location.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t points = 2048;

Polygon2 polygon_named(const std::string& name, std::size_t corners) {
  Entropy entropy(2040);
  Polygon2 polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double x = signed_unit_coordinate(entropy), y = signed_unit_coordinate(entropy);
    const double along = static_cast<double>(i) / static_cast<double>(corners), angle = 2 * std::acos(-1.0) * along;
    const double r = name == "jagged" ? (std::fabs(x) + 1) / 2 : 1;
    polygon.vertices.push_back(name == "chain"   ? Point2{x, y}
                               : name == "teeth" ? Point2{2 * along - 1, (i % 2 == 0 ? 1 : -1) * std::fabs(y)}
                                                 : Point2{r * std::cos(angle), r * std::sin(angle)});
  }
  return polygon;
}

void add(const std::string& name, std::function<long()> run) {
  benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run)](benchmark::State& state) {
    long sum = 0;
    for (auto _ : state) benchmark::DoNotOptimize(sum = run());
    state.counters["sum"] = static_cast<double>(sum);
    state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * points * 1e-9,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  });
}

[[maybe_unused]] const bool registered = [] {
  std::vector<Point2> at(points);
  Entropy entropy(2041);
  for (Point2& p : at) p = {signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)};
  const auto each = [&at](auto locate_one) {
    return [at, locate_one] {
      long sum = 0;
      for (const Point2& p : at) sum += static_cast<long>(locate_one(p));
      return sum;
    };
  };
  for (const std::size_t corners : {std::size_t{8}, std::size_t{1000}}) {
    for (const std::string name : {"round", "jagged", "teeth", "chain"}) {
      const Polygon2 polygon = polygon_named(name, corners);
      const std::string label = "polygon/" + name + "/" + std::to_string(corners);
      add(label + "/plumb", each([polygon](const Point2& p) { return locate(polygon, p); }));
      add(label + "/cgal", cgal_bounded_side(polygon, at));
      if (name == "round") {
        const auto locator = std::make_shared<const ConvexLocator2>(polygon);
        add(label + "/plumb-convex", each([locator](const Point2& p) { return locator->locate(p); }));
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench
