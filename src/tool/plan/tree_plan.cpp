#include "tool/plan/tree_plan.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/ray/mesh_ray.hpp"

namespace plumb::tool {
namespace {

constexpr std::array<BvhMethod, 3> measured{BvhMethod::linear, BvhMethod::binned, BvhMethod::sweep};
constexpr std::size_t asked = 2'000;
constexpr int tree_runs = 3;

/// What is asked: ends in the box of the mesh, whatever its size, so that nothing overflows.
struct Questions {
  std::vector<AnyRay> segments;
  std::vector<Point3> points;
  bool are_in_plane;

  explicit Questions(const TriangleMesh& mesh) {
    const Aabb3 box = fit_aabb(mesh.vertices);
    are_in_plane = box.min.x == box.max.x || box.min.y == box.max.y || box.min.z == box.max.z;
    Entropy entropy(77);
    const auto within = [&](double low, double high) {
      return std::lerp(low, high, static_cast<double>(entropy.below(1u << 20)) / (1u << 20));
    };
    const auto point = [&] {
      return Point3{within(box.min.x, box.max.x), within(box.min.y, box.max.y), within(box.min.z, box.max.z)};
    };
    for (std::size_t i = 0; i < asked; ++i) {
      segments.push_back(Segment3{point(), point()});
      points.push_back(point());
    }
  }
};

/// The least of some runs, in nanoseconds.
double least_time(const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < tree_runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
    least = std::min(least, elapsed.count());
  }
  return least;
}

struct Answers {
  std::vector<std::uint32_t> hit = std::vector<std::uint32_t>(asked);
  std::vector<ClosestOnMesh> nearest = std::vector<ClosestOnMesh>(asked);
};

TreeTimes times_of(BvhMethod method, const TriangleMesh& mesh, const Questions& questions, Answers& given) {
  const BvhOptions options{.method = method, .execution = Execution::serial};
  TreeTimes times{method, 1e-6 * least_time([&] { static_cast<void>(build_bvh(mesh, options)); }), 0, 0, 0, 0};
  const Bvh bvh = build_bvh(mesh, options);
  times.bytes = static_cast<double>(memory_of(bvh)) / static_cast<double>(mesh.triangles.size());
  times.ray_ns =
      least_time([&] { first_triangle(bvh, questions.segments, given.hit, {.execution = Execution::serial}); }) / asked;
  times.nearest_ns =
      least_time([&] { closest_on_mesh(bvh, questions.points, given.nearest, {.execution = Execution::serial}); }) /
      asked;
  return times;
}

}  // namespace

std::span<const BvhMethod> planned_methods() { return measured; }

std::vector<TreeChoice> TreePlan::choices() const {
  struct Line {
    std::optional<BvhMethod> method;
    double begin, each;
  };
  std::vector<Line> lines{{std::nullopt, 0, ray_ns_without}};
  for (const TreeTimes& t : trees) lines.push_back({t.method, 1e6 * t.build_ms, t.ray_ns});
  std::vector<TreeChoice> chosen{{0, std::nullopt}};
  Line now = lines.front();
  while (true) {
    const Line* next = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Line& l : lines) {
      if (!(l.each < now.each)) continue;
      const double from = std::max((l.begin - now.begin) / (now.each - l.each), chosen.back().from);
      if (next != nullptr && (from > least || (from == least && l.each >= next->each))) continue;
      least = from;
      next = &l;
    }
    if (next == nullptr) return chosen;
    if (least == chosen.back().from) chosen.pop_back();  // never the least
    chosen.push_back({least, next->method});
    now = *next;
  }
}

TreePlan plan_trees(const TriangleMesh& mesh) {
  TreePlan plan{0, {}};
  if (mesh.triangles.empty()) return plan;
  const Questions questions(mesh);
  plan.rays_in_plane = questions.are_in_plane;
  const TriangleBatch all = triangle_batch(mesh);
  constexpr std::size_t few = 4;  // each looks at all triangles
  plan.ray_ns_without = least_time([&] {
                          for (std::size_t i = 0; i < few; ++i)
                            static_cast<void>(first_hit(questions.segments[i], all));
                        }) /
                        few;
  Answers first, given;
  for (const BvhMethod method : measured) {
    Answers& answers = plan.trees.empty() ? first : given;
    plan.trees.push_back(times_of(method, mesh, questions, answers));
    if (plan.trees.size() == 1) continue;
    for (std::size_t i = 0; i < asked; ++i) {
      plan.trees.back().contradictions +=
          static_cast<std::uint64_t>(given.hit[i] != first.hit[i] || given.nearest[i] != first.nearest[i]);
    }
  }
  return plan;
}

}  // namespace plumb::tool
