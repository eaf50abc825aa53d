// How long does it take to find what of a mesh is nearest?  One thread; beside CGAL's tree of boxes.
//
// Points lie in the box of a torus, or within a hundredth of its size from its surface; trees are built beforehand.
// Of two meshes the second is moved so far: at 450 they cross, at 800 they are a rounding from touching.
// `s_query` is the time of each point, or pair of meshes.  CGAL's numbers are rounded on the way.
#include <benchmark/benchmark.h>

#include <functional>
#include <memory>
#include <string>

#include "bench/rivals/mesh_rival.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/space.hpp"

namespace plumb::bench {
namespace {

constexpr std::size_t questions = 1024;

void add_questions(const std::string& name, std::size_t n, std::function<double()> ask) {
  benchmark::RegisterBenchmark(name.c_str(), [n, ask = std::move(ask)](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(ask());
    state.counters["s_query"] = benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(n),
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  })->Unit(benchmark::kMillisecond);
}

std::vector<Point3> points_about(const TriangleMesh& mesh, bool near) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < questions; ++i) {
    Entropy entropy(2026, i);
    const auto number = [&](double size) { return size * (static_cast<double>(entropy.below(1 << 30)) * 0x1p-29 - 1); };
    const Point3& v = mesh.vertices[entropy.below(mesh.vertices.size())];
    points.push_back(near ? Point3{v.x + number(4), v.y + number(4), v.z + number(4)}
                          : Point3{number(400), number(400), number(100)});
  }
  return points;
}

void add_mesh(std::uint32_t around) {
  const auto mesh = std::make_shared<TriangleMesh>(solids::torus(300, 100, around, around / 2));
  const auto bvh = std::make_shared<Bvh>(build_bvh(*mesh));
  const auto cgal = std::make_shared<CgalMesh>(*mesh);
  const std::string size = std::to_string(mesh->triangles.size());
  for (const bool near : {false, true}) {
    const auto points = std::make_shared<std::vector<Point3>>(points_about(*mesh, near));
    const std::string name = "mesh_closest/" + std::string(near ? "near/" : "box/") + size;
    add_questions(name + "/plumb", questions, [=] {
      std::vector<ClosestOnMesh> out(points->size());
      closest_on_mesh(*bvh, *points, out, {.execution = Execution::serial});
      return out.back().distance;
    });
    add_questions(name + "/plumb_five", questions, [=] {
      double sum = 0;
      for (const Point3& p : *points) sum += nearest_triangles(*bvh, p, 5).back().distance;
      return sum;
    });
    add_questions(name + "/cgal", questions, [=] { return cgal->squared_distances(*points); });
  }
  for (const double by : {450.0, 800.0, 900.0, 2000.0}) {
    TriangleMesh moved = *mesh;
    for (Point3& p : moved.vertices) p = {p.x + by, p.z, p.y};
    const auto other = std::make_shared<Bvh>(build_bvh(moved));
    add_questions("mesh_distance/" + std::to_string(static_cast<int>(by)) + "/" + size + "/plumb", 1,
                  [=] { return closest_triangles(*bvh, *other)->closest.distance; });
  }
}

const bool added = [] {
  add_mesh(64);
  add_mesh(416);
  return true;
}();

}  // namespace
}  // namespace plumb::bench
