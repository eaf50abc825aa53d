// What does a query cost with each bounding volume?  T = N_v C_v + N_p C_p of RTCD 6.1.2, by count and by time.
//
// A model against itself, turned by a quarter radian and moved by an eighth of its size; one thread; volumes of both are
// built beforehand.  `volumes` is N_v, `triangles` N_p, `s_volume` C_v: the descent alone, for each of N_v.  The time of
// `pairs` is that of intersecting_pairs, so that C_p is what is left of it for each of N_p.  `build` builds a tree, of
// `bytes` a node; `boxes` is intersecting_pairs by the mesh's own tree of boxes.  Sphere trees: `spheres` of the last
// level, and the tests until the surfaces are known to be apart by a tenth of their distance.
// Each row has all counters, 0 where it measures something else: the library's table as CSV takes its columns from the
// first row and ends the program at a counter that this one lacks.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "plumb/space.hpp"
#include "plumb/space/bvh/sphere_tree.hpp"
#include "plumb/space/pairs/sphere_levels.hpp"
#include "plumb/space/pairs/volume_pairs.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb::bench {
namespace {

struct Scene {
  explicit Scene(const std::string& file) : bvh(build_bvh(read_mesh(file))) {
    const Aabb3 box = fit_aabb(bvh.vertices.view());
    size = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
    const double c = std::cos(0.25), s = std::sin(0.25);
    turn = {{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}}, {size / 8, 0, 0}};
    std::vector<Point3> vertices;
    for (const Point3& p : bvh.vertices) vertices.push_back({c * p.x - s * p.y + size / 8, s * p.x + c * p.y, p.z});
    std::vector<Bvh::Corners> triangles(bvh.triangles.size());
    for (std::size_t slot = 0; slot < triangles.size(); ++slot) triangles[bvh.tree.items[slot]] = bvh.triangles[slot];
    turned = build_bvh(vertices, triangles);
  }
  Bvh bvh, turned;  // rounded, so that both stand
  Pose turn;
  double size = 0;
};

/// Each counter of this file, at 0.
void name_counters(benchmark::State& state) {
  for (const char* name : {"nodes", "s_volume", "volumes", "triangles", "found", "spheres", "radius", "tests"})
    state.counters[name] = 0;
}

template <class Volume>
void add_volume(const std::string& name, const std::shared_ptr<Scene>& scene, const VolumeOptions& options) {
  using Node = VolumeNode<Volume>;
  struct Trees {
    VolumeTree<Volume> a, b;
  };
  const auto trees = std::make_shared<Trees>();
  const auto built = [=] {
    if (!trees->a.nodes.empty()) return;
    *trees = {build_volume_tree<Volume>(scene->bvh, options), build_volume_tree<Volume>(scene->turned, options)};
  };
  benchmark::RegisterBenchmark((name + "/build").c_str(), [=](benchmark::State& state) {
    name_counters(state);
    VolumeOptions serial = options;
    serial.execution = Execution::serial;
    for (auto _ : state) benchmark::DoNotOptimize(build_volume_tree<Volume>(scene->bvh, serial).nodes.size());
    state.counters["nodes"] = static_cast<double>(scene->bvh.tree.nodes.size());
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/descent").c_str(), [=](benchmark::State& state) {
    name_counters(state);
    built();
    std::size_t tests = 0;
    for (auto _ : state) {
      tests = 0;
      const auto meet = [&](const Node& x, const Node& y) {
        ++tests;
        return volumes_meet{}(x, y);
      };
      benchmark::DoNotOptimize(
          descend_pairs(trees->a, trees->b, descend_larger{}, meet, [](const Node&, const Node&) {}));
    }
    state.counters["s_volume"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * static_cast<double>(tests),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark((name + "/pairs").c_str(), [=](benchmark::State& state) {
    name_counters(state);
    built();
    const VolumeMesh a(scene->bvh, trees->a), b(scene->turned, trees->b);
    for (auto _ : state) benchmark::DoNotOptimize(intersecting_pairs(a, b, {.execution = Execution::serial}).size());
    const PairWork work = pair_work(a, b);
    state.counters["volumes"] = static_cast<double>(work.volume_tests);
    state.counters["triangles"] = static_cast<double>(work.triangle_pairs);
    state.counters["found"] = static_cast<double>(work.pairs);
  })->Unit(benchmark::kMillisecond);
}

void add_spheres(const std::string& name, const std::shared_ptr<Scene>& scene, SphereCover cover) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    name_counters(state);
    const SphereTreeOptions options{cover, 6};
    for (auto _ : state) benchmark::DoNotOptimize(build_sphere_tree(scene->bvh, options).nodes.size());
    const SphereTree tree = build_sphere_tree(scene->bvh, options);
    const SphereTree other = transform(tree, Pose{identity_pose.columns, {0, 0, 1.5 * scene->size}});
    double sum = 0;
    for (const SphereNode& n : tree.level(tree.levels() - 1)) sum += n.sphere.radius;
    const auto last = static_cast<double>(tree.level(tree.levels() - 1).size());
    state.counters["spheres"] = last;
    state.counters["radius"] = sum / last / scene->size;
    state.counters["tests"] = static_cast<double>(distance_bounds(tree, other, {.relative = 0.1}).tests);
  })->Unit(benchmark::kMillisecond);
}

const bool added = [] {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SOURCE_DIR "/../shared") / "models";
  for (const char* model : {"fandisk", "stanford-bunny"}) {
    const std::filesystem::path file = folder / (std::string(model) + ".obj");
    if (!std::filesystem::exists(file)) continue;
    const auto scene = std::make_shared<Scene>(file.string());
    const std::string name = std::string("volumes/") + model;
    benchmark::RegisterBenchmark((name + "/boxes").c_str(), [=](benchmark::State& state) {
      name_counters(state);
      for (auto _ : state) {
        benchmark::DoNotOptimize(
            intersecting_pairs(scene->bvh, scene->turned, {.execution = Execution::serial}).size());
      }
    })->Unit(benchmark::kMillisecond);
    add_volume<Aabb3>(name + "/aabb", scene, {});
    add_volume<Sphere3>(name + "/sphere", scene, {});
    add_volume<Sphere3>(name + "/sphere_tight", scene, {.fit = VolumeFit::tight});
    add_volume<Sphere3>(name + "/sphere_merged", scene, {.fit = VolumeFit::merged});
    add_volume<Obb3>(name + "/obb", scene, {});
    add_volume<Obb3>(name + "/obb_tight", scene, {.fit = VolumeFit::tight});
    add_volume<Obb3>(name + "/obb_merged", scene, {.fit = VolumeFit::merged});
    for (const int k : {14, 18, 26}) add_volume<KDop3>(name + "/dop" + std::to_string(k), scene, {.k = k});
    add_spheres(name + "/octree_spheres", scene, SphereCover::octree);
    add_spheres(name + "/piece_spheres", scene, SphereCover::pieces);
    add_spheres(name + "/pruned_spheres", scene, SphereCover::pruned);
  }
  return true;
}();

}  // namespace
}  // namespace plumb::bench
