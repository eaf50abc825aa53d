#include "tool/check/mesh.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "certify/batch/all_threads.hpp"
#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/predicates/manifest.hpp"
#include "tool/mesh/decision_sample.hpp"
#include "tool/mesh/rational_sign.hpp"
#include "tool/trial/task.hpp"

namespace plumb::tool {
namespace {

constexpr std::uint64_t block_size = 1024;  // fits the second-level cache with all its answers

/// The methods of `plumb-lab chart` that are compared here.
using Methods = std::array<trial::Method, method_count>;

// What is gathered of one kind, by a block or by all.
struct Gathered {
  Comparison comparison;
  std::array<std::vector<double>, method_count> block_ns;  // per decision, one entry a block

  void add(const Gathered& other) {
    comparison += other.comparison;
    for (std::size_t m = 0; m < method_count; ++m)
      block_ns[m].insert(block_ns[m].end(), other.block_ns[m].begin(), other.block_ns[m].end());
  }
};

double elapsed_ns(trial::Round& round) {
  const auto start = std::chrono::steady_clock::now();
  round.answer();
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

// How wrong is a claimed value?  Its distance from the exact value (to long double's precision) in units of the
// magnitude; only to rank wrong signs, never to decide one.
template <Formula F>
double badness(long double claimed, long double value, const Coordinates<F>& p) {
  const double magnitude = Filtered(evaluate<F>([&](std::size_t i) { return Filtered::Input{p[i]}; })).magnitude;
  const auto ratio = static_cast<double>(std::fabs(claimed - value) / static_cast<long double>(magnitude));
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::max();
}

template <Formula F>
void judge(const Methods& methods, std::size_t m, Kind kind, std::span<const std::uint64_t> numbers,
           std::span<const Coordinates<F>> block, const trial::Round& given, const trial::Round& exact, Tally& tally) {
  const auto& value = methods[m].value ? methods[m].value : methods[method_number("double")].value;
  for (std::size_t i = 0; i < block.size(); ++i) {
    ++tally.taken;
    const double truth = exact.given(i), said = given.given(i);
    if (std::isnan(said)) ++tally.unsure;
    if (std::isnan(said) || said == truth) continue;
    ++(truth == 0 ? tally.zeros_missed : said == 0 ? tally.zeros_invented : tally.opposite);
    const long double claimed = value(block[i]);
    const double bad = badness<F>(claimed, methods[method_number("long-double")].value(block[i]), block[i]);
    if (!tally.worst.yields_to(bad, kind, numbers[i])) continue;
    const CaseLine line{std::string(F::name), {block[i].begin(), block[i].end()}, Unsure{sign_of_number(truth)}};
    tally.worst = {bad, numbers[i], kind, static_cast<double>(claimed), to_string(line)};
  }
}

/// What the decisions of a kind are taken from, and by.
struct Source {
  const MeshDecisions& decisions;
  const CatalogEntry& predicate;
  Kind kind;
  Methods methods;
  trial::Scene scene;
  Asked asked;
  DecisionSample sample;
  std::uint64_t verify_stride;
};

template <Formula F>
void compare_block(const Source& source, std::uint64_t first, std::uint64_t count, Gathered& gathered) {
  std::vector<Coordinates<F>> block(count);
  std::vector<std::uint64_t> numbers(count);
  std::vector<double> coordinates;
  coordinates.reserve(count * arity<F>);
  for (std::uint64_t i = 0; i < count; ++i) {
    numbers[i] = source.sample.number(first + i);
    block[i] = source.decisions.coordinates<F>(source.kind, numbers[i]);
    coordinates.insert(coordinates.end(), block[i].begin(), block[i].end());
  }
  std::array<std::unique_ptr<trial::Round>, method_count> rounds;
  for (std::size_t m = method_count; m-- > 0;) {
    if (!is_asked(m, source.asked) && m != exact_method) continue;  // which judges
    rounds[m] = source.methods[m].prepare(coordinates, source.scene);
    gathered.block_ns[m].push_back(elapsed_ns(*rounds[m]) / static_cast<double>(count));
  }
  Comparison& comparison = gathered.comparison;
  const trial::Round& exact = *rounds[exact_method];
  for (std::size_t m = 0; m < method_count; ++m) {
    if (is_asked(m, source.asked))
      judge<F>(source.methods, m, source.kind, numbers, block, *rounds[m], exact, comparison.method[m]);
  }
  if (source.asked == Asked::inexact) return;
  for (const Coordinates<F>& p : block) comparison.stages.decided(source.predicate.decide(p).stage);
  const std::uint64_t stride = source.verify_stride;
  if (stride == 0) return;
  for (std::uint64_t i = (stride - first % stride) % stride; i < count; i += stride) {
    ++comparison.verified;
    if (trial::as_answer(rational_sign(F::name, block[i])) != exact.given(i)) ++comparison.refuted;
  }
}

using CompareBlock = void (*)(const Source&, std::uint64_t, std::uint64_t, Gathered&);

CompareBlock comparer_of(std::string_view predicate) {
#define PLUMB_COMPARE(formula) \
  if (predicate == predicates::formula::name) return compare_block<predicates::formula>;
  PLUMB_CLASSICS(PLUMB_COMPARE)
#undef PLUMB_COMPARE
  return nullptr;
}

Methods methods_of(std::string_view predicate) {
  Methods methods;
  for (const auto task : {trial::orient2d_task, trial::orient3d_task, trial::incircle_task, trial::insphere_task}) {
    const trial::Task asked = task();
    if (asked.name != predicate) continue;
    for (std::size_t m = 0; m < method_count; ++m)
      methods[m] = *std::ranges::find(asked.methods, method_names[m], &trial::Method::name);
  }
  return methods;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Asks these methods of the kind's decisions: of the sample, or the exact ones of all.
void compare_kind(const MeshDecisions& decisions, const Lattice& lattice, Kind kind, Asked asked,
                  const CheckSettings& settings, Progress& progress, Comparison& comparison) {
  const std::uint64_t of_kind = decisions.count(kind);
  const DecisionSample sample(of_kind, asked == Asked::exact ? of_kind : settings.asked_of_kind());
  const std::uint64_t count = sample.size(), blocks = (count + block_size - 1) / block_size;
  if (count == 0) return;
  const std::uint64_t stride = settings.verify ? count / (settings.verified_of_kind + 1) + 1 : 0;
  const CatalogEntry& predicate = *find_predicate(kinds[static_cast<std::size_t>(kind)].predicate);
  const CompareBlock compare = comparer_of(predicate.name);
  const Source source{decisions, predicate, kind, methods_of(predicate.name), {lattice, 0}, asked, sample, stride};
  Gathered all;
  std::mutex adding;
  certify::batch::for_each_part(Execution::parallel, blocks, [&](std::size_t b) {
    const std::uint64_t first = b * block_size, size = std::min(block_size, count - first);
    Gathered of_block;
    compare(source, first, size, of_block);
    progress.advance(size);
    const std::scoped_lock lock(adding);
    all.add(of_block);
  });
  comparison += all.comparison;
  const auto total_ns = [&](std::size_t m) { return median(all.block_ns[m]) * static_cast<double>(count); };
  for (std::size_t m = 0; m < method_count; ++m)
    if (is_asked(m, asked)) comparison.method[m].nanoseconds = total_ns(m);
  if (asked == Asked::inexact) comparison.judge_nanoseconds = total_ns(exact_method);
}

std::span<const double> coordinates_of(const TriangleMesh& mesh) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return {&mesh.vertices.front().x, 3 * mesh.vertices.size()};
}

}  // namespace

Comparison MeshCheck::of_predicate(std::string_view predicate) const {
  Comparison sum;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k].predicate == predicate) sum += kind[k];
  }
  return sum;
}

Comparison MeshCheck::total() const {
  Comparison sum;
  for (const Comparison& c : kind) sum += c;
  return sum;
}

void check_mesh(const TriangleMesh& mesh, const CheckSettings& settings, MeshCheck& check,
                const CheckWatcher& watcher) {
  const MeshEdges edges = find_edges(mesh);
  check.statistics = mesh_statistics(mesh, edges);
  check.surface = check_surface(mesh, edges, check.statistics, check.name, settings.nearer_than);
  check.lattice = lattice_of(coordinates_of(mesh));
  const MeshDecisions decisions(mesh, edges);
  check.edges = decisions.edge_answers();
  if (watcher) watcher(CheckStep::mesh);
  if (!settings.decisions) return;
  const Lattice lattice = decisions.lattice();
  for (std::size_t k = 0; k < kinds.size(); ++k)
    if (decisions.count(static_cast<Kind>(k)) > settings.asked_of_kind())
      check.sampled_of_kind = settings.sampled_of_kind;
  for (const Asked asked : {Asked::inexact, Asked::exact}) {
    std::uint64_t steps = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const std::uint64_t all = decisions.count(static_cast<Kind>(k));
      steps += asked == Asked::exact ? all : std::min(all, settings.asked_of_kind());
    }
    {
      Progress progress(check.name, steps);
      for (std::size_t k = 0; k < kinds.size(); ++k)
        compare_kind(decisions, lattice, static_cast<Kind>(k), asked, settings, progress, check.kind[k]);
    }
    if (watcher) watcher(asked == Asked::inexact ? CheckStep::inexact : CheckStep::exact);
  }
}

}  // namespace plumb::tool
