// What does half of the memory cost?  Questions of a compact tree beside those of the tree that it is made of, one
// thread, on the same mesh: a closed wavy ring of 4 side^2 triangles.
//
// `s_query` is the time of each question; `bytes` are those of each triangle, all in, and `node_bytes` those of the nodes
// that the question goes by.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/space.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::bench {
namespace {

struct Trees {
  TriangleMesh mesh;
  Bvh bvh;
  CompactBvh small;
};

const Trees& trees_of(std::int64_t side) {
  static std::vector<std::pair<std::int64_t, Trees>> made;
  for (const auto& [n, trees] : made) {
    if (n == side) return trees;
  }
  Trees trees{meshes::ring(static_cast<std::uint32_t>(side)), {}, {}};
  trees.bvh = build_bvh(trees.mesh);
  trees.small = compact(trees.bvh);
  return made.emplace_back(side, std::move(trees)).second;
}

const Bvh& tree_of(const Trees& trees, const Bvh*) { return trees.bvh; }
const CompactBvh& tree_of(const Trees& trees, const CompactBvh*) { return trees.small; }
std::size_t nodes_of(const Bvh& bvh) {
  return bvh.tree.nodes.size() * sizeof(BoxNode) + bvh.wide.nodes.size() * sizeof(WideNode<8>);
}
std::size_t nodes_of(const CompactBvh& bvh) { return memory_of(bvh.tree); }

template <class Mesh>
void report(benchmark::State& state, const Trees& trees, const Mesh& tree, std::size_t questions) {
  const auto each = [&](std::size_t bytes) {
    return static_cast<double>(bytes) / static_cast<double>(trees.mesh.triangles.size());
  };
  state.counters["s_query"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(questions),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes"] = each(memory_of(tree));
  state.counters["node_bytes"] = each(nodes_of(tree));
}

/// From around the mesh to places in its box, or from one place through an image's pixels.
std::vector<AnyRay> rays_of(bool camera) {
  constexpr std::int64_t side = 256;
  std::vector<AnyRay> rays;
  Entropy e(78);
  const auto number = [&] { return signed_unit_coordinate(e); };
  for (std::int64_t i = 0; i < side * side; ++i) {
    const double u = static_cast<double>(i % side) / side - 0.5, v = static_cast<double>(i / side) / side - 0.5;
    const Point3 a = camera ? Point3{2.5, 1.5, 1.8} : Point3{3 * number(), 3 * number(), 3 * number()};
    const Point3 b =
        camera ? Point3{1.6 * u - 0.5 * v, -2.6 * u, 2 * v} : Point3{1.4 * number(), 1.4 * number(), 0.4 * number()};
    rays.emplace_back(Ray3{a, {b.x - a.x, b.y - a.y, b.z - a.z}});
  }
  return rays;
}

template <class Mesh, bool camera>
void rays(benchmark::State& state) {
  const Trees& trees = trees_of(state.range(0));
  const Mesh& tree = tree_of(trees, static_cast<const Mesh*>(nullptr));
  const std::vector<AnyRay> asked = rays_of(camera);
  std::vector<std::uint32_t> out(asked.size());
  for (auto _ : state) first_triangle(tree, asked, out, {.execution = Execution::serial});
  report(state, trees, tree, asked.size());
}

/// Points near to the surface.
template <class Mesh>
void closest(benchmark::State& state) {
  const Trees& trees = trees_of(state.range(0));
  const Mesh& tree = tree_of(trees, static_cast<const Mesh*>(nullptr));
  std::vector<Point3> points;
  for (std::uint64_t i = 0; i < 4096; ++i) {
    Entropy e(79, i);
    const Point3& p = trees.mesh.vertices[e.below(trees.mesh.vertices.size())];
    const auto near = [&](double x) { return x + 0.02 * signed_unit_coordinate(e); };
    const double x = near(p.x), y = near(p.y), z = near(p.z);
    points.push_back({x, y, z});
  }
  std::vector<ClosestOnMesh> out(points.size());
  for (auto _ : state) closest_on_mesh(tree, points, out, {.execution = Execution::serial});
  report(state, trees, tree, points.size());
}

/// Cubes about vertices.
template <class Mesh>
void boxes(benchmark::State& state) {
  const Trees& trees = trees_of(state.range(0));
  const Mesh& tree = tree_of(trees, static_cast<const Mesh*>(nullptr));
  std::vector<Aabb3> asked;
  for (std::uint64_t i = 0; i < 1024; ++i) {
    const Point3& p = trees.mesh.vertices[Entropy(80, i).below(trees.mesh.vertices.size())];
    asked.push_back({{p.x - 0.01, p.y - 0.01, p.z - 0.01}, {p.x + 0.01, p.y + 0.01, p.z + 0.01}});
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(meeting(tree, std::span<const Aabb3>(asked), {.execution = Execution::serial}));
  }
  report(state, trees, tree, asked.size());
}

void make(benchmark::State& state) {
  const Trees& trees = trees_of(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(compact(trees.bvh));
  report(state, trees, trees.small, trees.mesh.triangles.size());
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const std::int64_t side : {50, 500}) b->Arg(side);
  b->Unit(benchmark::kMillisecond);
}

BENCHMARK(rays<Bvh, false>)->Apply(sizes);
BENCHMARK(rays<CompactBvh, false>)->Apply(sizes);
BENCHMARK(rays<Bvh, true>)->Apply(sizes);
BENCHMARK(rays<CompactBvh, true>)->Apply(sizes);
BENCHMARK(closest<Bvh>)->Apply(sizes);
BENCHMARK(closest<CompactBvh>)->Apply(sizes);
BENCHMARK(boxes<Bvh>)->Apply(sizes);
BENCHMARK(boxes<CompactBvh>)->Apply(sizes);
BENCHMARK(make)->Apply(sizes);

}  // namespace
}  // namespace plumb::bench
