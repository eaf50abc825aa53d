#include "tool/plan/times.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "certify/catalog.hpp"
#include "plumb/predicates/manifest.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "tool/mesh/decisions.hpp"
#include "tool/trial/task.hpp"

namespace plumb::tool {
namespace {

constexpr std::uint64_t block = 1024, most_decisions = 8 * block;  // a block fits the second-level cache
constexpr int runs = 5;

/// Of decisions whose points are vertices: not those put beside flat edges, nor the fixed ones.
bool takes_vertices(Kind kind) { return kind != Kind::edge_delaunay_flat && kind != Kind::face_side; }

/// Evenly spread ones, at most so many, of all meshes.
template <Formula F>
std::vector<double> sampled(std::span<const MeshDecisions> meshes) {
  struct Part {
    const MeshDecisions* mesh;
    Kind kind;
    std::uint64_t count;
  };
  std::vector<Part> parts;
  std::uint64_t total = 0;
  for (const MeshDecisions& mesh : meshes) {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const auto kind = static_cast<Kind>(k);
      if (kinds[k].predicate != F::name || !takes_vertices(kind)) continue;
      parts.push_back({&mesh, kind, mesh.count(kind)});
      total += parts.back().count;
    }
  }
  std::vector<double> coordinates;
  const std::uint64_t stride = total / most_decisions + 1;
  std::uint64_t next = 0;  // of the part at hand
  for (const Part& part : parts) {
    for (; next < part.count; next += stride) {
      const Coordinates<F> p = part.mesh->template coordinates<F>(part.kind, next);
      coordinates.insert(coordinates.end(), p.begin(), p.end());
    }
    next -= part.count;
  }
  return coordinates;
}

/// The tasks of the classics, which know the ways of taking these decisions; made once.
const trial::Task& task_of(std::size_t predicate) {
  static const std::array<trial::Task, classic_count> tasks{trial::orient2d_task(), trial::orient3d_task(),
                                                            trial::incircle_task(), trial::insphere_task()};
  return tasks[predicate];
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// All blocks by one method: its time a decision, and its answers.
double take(const trial::Task& task, std::string_view method, std::span<const double> questions,
            const trial::Scene& scene, std::vector<double>& answers) {
  const auto found = std::ranges::find(task.methods, method, &trial::Method::name);
  std::vector<double> ns;
  answers.clear();
  for (std::size_t first = 0; first < questions.size(); first += block * task.numbers) {
    const auto asked = questions.subspan(first, std::min<std::size_t>(block * task.numbers, questions.size() - first));
    const std::size_t count = asked.size() / task.numbers;
    const auto round = found->prepare(asked, scene);
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
      const auto start = std::chrono::steady_clock::now();
      round->answer();
      const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
      least = std::min(least, elapsed.count() / static_cast<double>(count));
    }
    ns.push_back(least);
    for (std::size_t i = 0; i < count; ++i) answers.push_back(round->given(i));
  }
  return median(std::move(ns));
}

}  // namespace

SceneDecisions::SceneDecisions(std::span<const NamedMesh> meshes) {
  std::vector<MeshDecisions> decisions;
  decisions.reserve(meshes.size());
  for (const NamedMesh& m : meshes) decisions.emplace_back(m.mesh, find_edges(m.mesh));
  std::size_t i = 0;
#define PLUMB_SAMPLED(formula) questions_[i++] = sampled<predicates::formula>(decisions);
  PLUMB_CLASSICS(PLUMB_SAMPLED)
#undef PLUMB_SAMPLED
}

DecisionTimes SceneDecisions::measure(std::size_t predicate, const Lattice& lattice, int exponent) const {
  std::vector<double> questions = questions_[predicate];
  double largest = 0;
  for (double& x : questions) {
    x = nearest_multiple(x, exponent);
    largest = std::max(largest, std::fabs(x));
  }
  const trial::Task& task = task_of(predicate);
  const trial::Scene scene{lattice, largest};
  DecisionTimes times;
  times.decisions = questions.size() / task.numbers;
  if (times.decisions == 0) return times;
  std::vector<double> of_decide, of_plan, others;
  times.plain = take(task, "double", questions, scene, others);
  times.decide = take(task, "exact", questions, scene, of_decide);
  times.batch = take(task, "batch", questions, scene, others);
  times.plan = take(task, "plan", questions, scene, of_plan);
  for (std::size_t k = 0; k < of_decide.size(); ++k) {
    times.contradictions += static_cast<std::uint64_t>(of_decide[k] != of_plan[k]);
  }
  return times;
}

}  // namespace plumb::tool
