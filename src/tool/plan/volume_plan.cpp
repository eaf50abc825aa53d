#include "tool/plan/volume_plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>

#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb::tool {
namespace {

const PairOptions one_thread{.execution = Execution::serial};

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Turned about the middle of its box by the angle of 3, 4, 5, and rounded; as it is where that leaves the doubles.
TriangleMesh turned_copy(const TriangleMesh& mesh) {
  const Aabb3 box = fit_aabb(mesh.vertices);
  const double x = std::midpoint(box.min.x, box.max.x), y = std::midpoint(box.min.y, box.max.y);
  TriangleMesh turned = mesh;
  for (Point3& p : turned.vertices) {
    const double u = p.x - x, v = p.y - y;
    p = {x + (0.8 * u - 0.6 * v), y + (0.6 * u + 0.8 * v), p.z};
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return mesh;
  }
  return turned;
}

struct Scene {
  Bvh a, b;
  std::vector<TrianglePair> pairs;  // by the trees of boxes
};

/// The least of some runs; of one where it takes long.
template <class Ask>
double least_ms(const Ask& ask) {
  double least = std::numeric_limits<double>::infinity(), all = 0;
  for (int run = 0; run < 3 && all < 500; ++run) {
    const auto start = std::chrono::steady_clock::now();
    ask();
    const double took = milliseconds_since(start);
    all += took;
    least = std::min(least, took);
  }
  return least;
}

template <class Volume>
void add_kind(VolumePlan& plan, std::string_view kind, const Scene& scene, VolumeOptions options) {
  options.execution = Execution::serial;
  try {
    const auto start = std::chrono::steady_clock::now();
    const VolumeTree<Volume> in_a = build_volume_tree<Volume>(scene.a, options);
    const double build_ms = milliseconds_since(start);
    const VolumeTree<Volume> in_b = build_volume_tree<Volume>(scene.b, options);
    const VolumeMesh<Volume> a(scene.a, in_a), b(scene.b, in_b);
    std::vector<TrianglePair> pairs;
    const double query_ms = least_ms([&] { pairs = intersecting_pairs(a, b, one_thread); });
    plan.kinds.push_back({kind, build_ms, query_ms, pair_work(a, b), pairs != scene.pairs});
  } catch (const BeyondDoubles&) {
    plan.left_out.push_back(kind);
  }
}

}  // namespace

const VolumeTimes& VolumePlan::chosen() const { return *std::ranges::min_element(kinds, {}, &VolumeTimes::query_ms); }

VolumePlan plan_volumes(const TriangleMesh& mesh) {
  VolumePlan plan;
  if (mesh.triangles.empty()) return plan;
  const BvhOptions serial{.execution = Execution::serial};
  Scene scene{build_bvh(mesh, serial), build_bvh(turned_copy(mesh), serial), {}};
  const double boxes_ms = least_ms([&] { scene.pairs = intersecting_pairs(scene.a, scene.b, one_thread); });
  plan.kinds.push_back({"boxes", 0, boxes_ms, {0, 0, 0, scene.pairs.size()}, false});
  add_kind<Sphere3>(plan, "sphere", scene, {});
  add_kind<Obb3>(plan, "obb", scene, {});
  add_kind<KDop3>(plan, "18-dop", scene, {.k = 18});
  return plan;
}

}  // namespace plumb::tool
