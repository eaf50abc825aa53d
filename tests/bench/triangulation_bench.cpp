// How long do triangulations take, beside CGAL's on the same input in the same run?
//
// star: a polygon of long thin rays about a point.  holes: a square with holes of eight corners each.  uniform: points
// of the unit square.  degenerate: 8,000 closed paths of small lattices, of which those that cross themselves are
// refused.  The names are kind/vertices/library.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/surface/planar/convex_pieces.hpp"

namespace plumb::bench {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Constrained =
    CGAL::Constrained_Delaunay_triangulation_2<Epick, CGAL::Default, CGAL::No_constraint_intersection_tag>;

Point2 at_angle(const Point2& center, double radius, double turn) {
  const double angle = 2 * std::numbers::pi * turn;
  return {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)};
}

Polygon2 star(std::size_t corners) {
  Entropy entropy(2026);
  Polygon2 polygon;
  for (std::size_t k = 0; k < corners; ++k)
    polygon.vertices.push_back(
        at_angle({0, 0}, 0.1 + 0.9 * unit_coordinate(entropy), static_cast<double>(k) / static_cast<double>(corners)));
  return polygon;
}

HoledPolygon2 with_holes(std::size_t corners) {
  Entropy entropy(2026);
  const auto edge = static_cast<std::size_t>(std::sqrt(static_cast<double>(corners) / 8));
  const auto far = static_cast<double>(edge);
  HoledPolygon2 polygon{{{{-1, -1}, {far, -1}, {far, far}, {-1, far}}}, {}};
  for (std::size_t i = 0; i < edge; ++i) {
    for (std::size_t j = 0; j < edge; ++j) {
      Polygon2 hole;
      for (int k = 0; k < 8; ++k)
        hole.vertices.push_back(
            at_angle({static_cast<double>(i), static_cast<double>(j)}, 0.1 + 0.3 * unit_coordinate(entropy), -k / 8.0));
      polygon.holes.push_back(hole);
    }
  }
  return polygon;
}

std::vector<Point2> uniform_points(std::size_t count) {
  Entropy entropy(2026);
  std::vector<Point2> points(count);
  for (Point2& p : points) p = {unit_coordinate(entropy), unit_coordinate(entropy)};
  return points;
}

std::size_t cgal_triangles(const HoledPolygon2& polygon) {
  Constrained triangulation;
  std::vector<Epick::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  const auto add = [&](const Polygon2& ring) {
    const std::size_t first = points.size(), n = ring.vertices.size();
    for (const auto& [x, y] : ring.vertices) points.emplace_back(x, y);
    for (std::size_t k = 0; k < n; ++k) edges.emplace_back(first + k, first + (k + 1) % n);
  };
  add(polygon.outer);
  for (const Polygon2& hole : polygon.holes) add(hole);
  triangulation.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
  return triangulation.number_of_faces();
}

void report(benchmark::State& state, std::size_t triangles) {
  state.counters["triangles"] = static_cast<double>(triangles);
}

template <class Input>
void add_polygons(const std::string& name, const Input& input) {
  benchmark::RegisterBenchmark((name + "/plumb").c_str(), [input](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) n = triangulate(input).size();
    report(state, n);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/cgal").c_str(), [input](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) n = cgal_triangles(input);
    report(state, n);
  })->Unit(benchmark::kMillisecond);
}

void add_points(std::size_t count) {
  const std::string name = "uniform/" + std::to_string(count);
  const std::vector<Point2> points = uniform_points(count);
  benchmark::RegisterBenchmark((name + "/plumb").c_str(), [points](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) n = delaunay(points).triangles.size();
    report(state, n);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/cgal").c_str(), [points](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) {
      std::vector<Epick::Point_2> given;
      for (const auto& [x, y] : points) given.emplace_back(x, y);
      n = CGAL::Delaunay_triangulation_2<Epick>(given.begin(), given.end()).number_of_faces();
    }
    report(state, n);
  })->Unit(benchmark::kMillisecond);
}

void add_pieces(std::size_t corners) {
  const std::string name = "pieces/" + std::to_string(corners);
  const Polygon2 polygon = star(corners);
  benchmark::RegisterBenchmark((name + "/plumb").c_str(), [polygon](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) n = convex_pieces(polygon).size();
    report(state, n);
  })->Unit(benchmark::kMillisecond);
  if (corners > 10'000) return;  // the rival takes longer than anyone waits
  benchmark::RegisterBenchmark((name + "/cgal").c_str(), [polygon](benchmark::State& state) {
    using Traits = CGAL::Partition_traits_2<Epick>;
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) {
      Traits::Polygon_2 given;
      for (const auto& [x, y] : polygon.vertices) given.push_back({x, y});
      std::vector<Traits::Polygon_2> pieces;
      CGAL::approx_convex_partition_2(given.vertices_begin(), given.vertices_end(), std::back_inserter(pieces));
      n = pieces.size();
    }
    report(state, n);
  })->Unit(benchmark::kMillisecond);
}

void add_degenerate() {
  Entropy entropy(2026);
  std::vector<Polygon2> polygons(8'000);
  for (Polygon2& polygon : polygons) {
    polygon.vertices.resize(3 + entropy.below(10));
    for (Point2& p : polygon.vertices)
      p = {static_cast<double>(entropy.below(5)), static_cast<double>(entropy.below(5))};
  }
  benchmark::RegisterBenchmark("degenerate/8000/plumb", [polygons](benchmark::State& state) {
    std::size_t n = 0;
    for ([[maybe_unused]] auto _ : state) {
      n = 0;
      for (const Polygon2& polygon : polygons) {
        try {
          n += triangulate(polygon).size();
        } catch (const CrossingSegments&) {
        }
      }
    }
    report(state, n);
  })->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  for (const std::size_t n : {std::size_t{100'000}, std::size_t{1'000'000}}) {
    add_polygons("star/" + std::to_string(n), HoledPolygon2{star(n), {}});
    add_polygons("holes/" + std::to_string(n), with_holes(n));
    add_points(n);
  }
  for (const std::size_t n : {std::size_t{2'000}, std::size_t{100'000}}) add_pieces(n);
  add_degenerate();
  return true;
}();

}  // namespace
}  // namespace plumb::bench
