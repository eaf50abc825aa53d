// How does time grow with the size of a figure?  Names are sizes/question/size/method, on one thread; beside CGAL's and
// Qhull's on the same input.
//
// polygon, convex: a point in a polygon, jagged or round, by its corners; ns a point asked.  hull2, hull3: of points of a
// disk and a ball; ball: the smallest around points of a ball; ns a point given.  relate, distance: of two convex polyhedra,
// the hulls of points of a sphere, that overlap, that are apart; by their vertices, ns a pair.  nearest, pairs: a point and a
// mesh, two meshes through each other, by their triangles; ns a point, ns a triangle of both.
// tests/bench/report/sizes.py draws it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bench/rivals/hull2_rival.hpp"
#include "bench/rivals/hull_rival.hpp"
#include "bench/rivals/mesh_rival.hpp"
#include "bench/rivals/polygon_rival.hpp"
#include "bench/rivals/qhull_rival.hpp"
#include "bench/rivals/sphere_rival.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bench {
namespace {

/// What is timed, and how many are asked by each call.
struct Work {
  std::function<double()> run;
  double asked;
};
using Make = std::function<Work(std::size_t size)>;

/// What the work needs is made when its turn comes.
void add(const std::string& question, const std::vector<std::size_t>& sizes, const std::string& method,
         const Make& make) {
  for (const std::size_t size : sizes) {
    const std::string name = "sizes/" + question + "/" + std::to_string(size) + "/" + method;
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
      const Work work = make(size);
      double said = 0;
      for (auto _ : state) benchmark::DoNotOptimize(said = work.run());
      state.counters["said"] = said;
      state.counters["ns"] = benchmark::Counter(static_cast<double>(state.iterations()) * work.asked * 1e-9,
                                                benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    })->MinTime(0.05);
  }
}

constexpr std::size_t asked = 256;

template <class Point>
std::vector<Point> places(std::uint64_t seed) {
  std::vector<Point> points(asked);
  Entropy entropy(seed);
  for (Point& p : points) {
    p.x = signed_unit_coordinate(entropy), p.y = signed_unit_coordinate(entropy);
    if constexpr (requires { p.z; }) p.z = signed_unit_coordinate(entropy);
  }
  return points;
}

Polygon2 polygon(std::size_t corners, bool jagged) {
  Entropy entropy(2060);
  Polygon2 p;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double r = jagged ? (unit_coordinate(entropy) + 1) / 2 : 1;
    p.vertices.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return p;
}

template <class Locate>
Work located(Locate locate_one) {
  return {[=, at = places<Point2>(2061)] {
            int sum = 0;
            for (const Point2& p : at) sum += static_cast<int>(locate_one(p));
            return sum;
          },
          asked};
}
Work located_by_cgal(const Polygon2& p) {
  return {[run = cgal_bounded_side(p, places<Point2>(2061))] { return static_cast<double>(run()); }, asked};
}

/// Calls run(points) on points of this cloud.
template <class Run>
Make of_cloud(Cloud kind, Run run) {
  return [=](std::size_t n) {
    Entropy entropy(2062);
    return Work{run(cloud3(kind, n, entropy)), static_cast<double>(n)};
  };
}
template <class Run>
Make of_disk(Run run) {
  return [=](std::size_t n) {
    Entropy entropy(2063);
    return Work{run(cloud2(Cloud::ball, n, entropy)), static_cast<double>(n)};
  };
}

ConvexPolyhedron3 rock(std::size_t vertices, const Vector3& by) {
  Entropy entropy(2064);
  std::vector<Point3> points = cloud3(Cloud::sphere, vertices, entropy);
  for (Point3& p : points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return convex_polyhedron(convex_hull(points), points);
}
template <class Ask>
Make of_rocks(const Vector3& by, Ask ask) {
  return [=](std::size_t n) { return Work{[=, a = rock(n, {0, 0, 0}), b = rock(n, by)] { return ask(a, b); }, 1}; };
}

/// Near so many triangles.
TriangleMesh ring_of(std::size_t triangles) {
  return meshes::ring(static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 4))));
}
TriangleMesh turned(TriangleMesh mesh) {
  for (Point3& p : mesh.vertices) p = {p.z + 0.25, p.x, p.y};
  return mesh;
}

[[maybe_unused]] const bool registered = [] {
  const std::vector<std::size_t> few{8, 30, 100, 300, 1'000}, many{10, 100, 1'000, 10'000, 100'000},
      of_meshes{100, 1'024, 10'000, 99'856};
  add("polygon", many, "plumb",
      [](std::size_t n) { return located([p = polygon(n, true)](const Point2& at) { return locate(p, at); }); });
  add("polygon", many, "cgal", [](std::size_t n) { return located_by_cgal(polygon(n, true)); });
  add("convex", many, "plumb", [](std::size_t n) {
    return located([p = ConvexLocator2(polygon(n, false))](const Point2& at) { return p.locate(at); });
  });
  add("convex", many, "cgal", [](std::size_t n) { return located_by_cgal(polygon(n, false)); });

  const auto count = [](const auto& hull) { return static_cast<double>(hull.vertices.size()); };
  add("hull2", many, "plumb", of_disk([=](auto p) { return [=] { return count(convex_hull(std::span(p))); }; }));
  add("hull2", many, "cgal",
      of_disk([](auto p) { return [held = CgalPoints2(p)] { return static_cast<double>(held.hull_vertices()); }; }));
  add("hull2", many, "qhull", of_disk([](auto p) { return [=] { return static_cast<double>(qhull_vertices(p)); }; }));
  add("hull3", many, "plumb",
      of_cloud(Cloud::ball, [=](auto p) { return [=] { return count(convex_hull(std::span(p))); }; }));
  add("hull3", many, "cgal", of_cloud(Cloud::ball, [](auto p) {
        return [held = std::make_shared<CgalPoints>(p)] { return static_cast<double>(held->hull_vertices()); };
      }));
  add("hull3", many, "qhull",
      of_cloud(Cloud::ball, [](auto p) { return [=] { return static_cast<double>(qhull_vertices(p)); }; }));
  add("ball", many, "plumb",
      of_cloud(Cloud::ball, [](auto p) { return [=] { return minimum_sphere(p).sphere.radius; }; }));
  add("ball", many, "cgal", of_cloud(Cloud::ball, [](auto p) {
        return cgal_minimum_sphere(std::span<const double>(&p[0].x, 3 * p.size()));
      }));

  const auto relate_them = [](const auto& a, const auto& b) { return static_cast<double>(relate(a, b)); };
  add("relate", few, "plumb", of_rocks({1.25, 0.5, 0.25}, relate_them));
  add("relate apart", few, "plumb", of_rocks({2.5, 0.5, 0.25}, relate_them));
  add("distance", few, "plumb",
      of_rocks({2.5, 0.5, 0.25}, [](const auto& a, const auto& b) { return distance(a, b); }));

  add("nearest", of_meshes, "plumb", [](std::size_t n) {
    return Work{[mesh = build_bvh(ring_of(n)), at = places<Point3>(2065)] {
                  double sum = 0;
                  for (const Point3& p : at) sum += closest_on_mesh(mesh, p)->distance;
                  return sum;
                },
                asked};
  });
  add("nearest", of_meshes, "cgal", [](std::size_t n) {
    return Work{[mesh = std::make_shared<CgalMesh>(ring_of(n)), at = places<Point3>(2065)] {
                  return mesh->squared_distances(at);
                },
                asked};
  });
  add("pairs", of_meshes, "plumb", [](std::size_t n) {
    return Work{[a = build_bvh(ring_of(n)), b = build_bvh(turned(ring_of(n)))] {
                  return static_cast<double>(intersecting_pairs(a, b, {.execution = Execution::serial}).size());
                },
                2.0 * static_cast<double>(ring_of(n).triangles.size())};
  });
  add("pairs", of_meshes, "cgal", [](std::size_t n) {
    return Work{[a = std::make_shared<CgalMesh>(ring_of(n)), b = turned(ring_of(n))] {
                  return static_cast<double>(a->pairs_with(b));
                },
                2.0 * static_cast<double>(ring_of(n).triangles.size())};
  });
  return true;
}();

}  // namespace
}  // namespace plumb::bench
