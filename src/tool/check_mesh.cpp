#include "check_mesh.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <span>
#include <vector>

#include "plumb/certify/case_line.hpp"
#include "rational_sign.hpp"

namespace plumb::tool {
namespace {

constexpr std::uint64_t block_size = 1024;  // fits the second-level cache with all its answers

using Answers = std::array<Unsure<Sign>, block_size>;

// What one thread has gathered of one kind.
struct Gathered {
  Comparison comparison;
  std::array<std::vector<double>, method_count> block_ns;  // per decision, one entry a block
};

// Not inlined: each method gets the registers that it would have in a loop of its own.
template <class Input, class Take>
[[gnu::noinline]] double timed(std::span<const Input> inputs, Answers& answers, Take take) {
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < inputs.size(); ++i) answers[i] = take(inputs[i]);
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>(inputs.size());
}

// One block of decisions, in the form that each method takes.
template <Formula F>
struct Block {
  std::vector<Coordinates<F>> coordinates;
  std::vector<RealCoordinates<F, float>> floats;
  std::vector<PlannedPoints<F>> points;

  Block(const MeshDecisions& decisions, const Kernel& kernel, Kind kind, std::uint64_t first, std::uint64_t count)
      : coordinates(count), floats(count), points(count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      coordinates[i] = decisions.coordinates<F>(kind, first + i);
      floats[i] = converted<F, float>(coordinates[i]);
      points[i] = taken_in<F>(kernel, coordinates[i]);
    }
  }
};

template <Formula F>
double take_all(Method method, const Block<F>& all, const Kernel& kernel, Answers& answers) {
  const std::span<const Coordinates<F>> block = all.coordinates;
  const std::span<const RealCoordinates<F, float>> floats = all.floats;
  const auto plain = [](const auto& p) { return Unsure{sign_of_number(F{}(p))}; };
  switch (method) {
    case Method::float32:
      return timed(floats, answers, plain);
    case Method::double_plain:
      return timed(block, answers, plain);
    case Method::absolute:
      return timed(block, answers, [](const Coordinates<F>& p) {
        return Unsure{static_cast<Sign>(beyond(F{}(p), customary_epsilon))};
      });
    case Method::relative:
      return timed(block, answers, [](const Coordinates<F>& p) {
        return Unsure{static_cast<Sign>(beyond(F{}(p), customary_epsilon * size_of_terms<F>(p)))};
      });
    case Method::long_double:
      return timed(block, answers, [&](const Coordinates<F>& p) { return plain(converted<F, long double>(p)); });
    case Method::interval:
      return timed(block, answers, interval_sign<F>);
    case Method::plan:
      return kernel.with<F>([&](const auto& sign) {
        return timed(std::span<const PlannedPoints<F>>(all.points), answers,
                     [&](const PlannedPoints<F>& p) { return Unsure{std::apply(sign, p)}; });
      });
    case Method::exact:
      return timed(block, answers, [](const Coordinates<F>& p) { return Unsure{decide<F>(p)}; });
  }
  return 0;
}

// How wrong is a claimed value?  Its distance from the exact value (to long double's precision) in units of the
// magnitude; only to rank wrong signs, never to decide one.
template <Formula F>
double badness(long double claimed, const Coordinates<F>& p) {
  const double magnitude = Filtered(evaluate<F>([&](std::size_t i) { return Filtered::Input{p[i]}; })).magnitude;
  const long double value = F{}(converted<F, long double>(p));
  const auto ratio = static_cast<double>(std::fabs(claimed - value) / static_cast<long double>(magnitude));
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::max();
}

template <Formula F>
void judge(Method method, Kind kind, std::uint64_t first, std::span<const Coordinates<F>> block, const Answers& given,
           const Answers& exact, Tally& tally) {
  for (std::size_t i = 0; i < block.size(); ++i) {
    ++tally.taken;
    const Sign truth = exact[i].value();
    if (!given[i].certain()) {
      ++tally.unsure;
      continue;
    }
    const Sign said = given[i].value();
    if (said == truth) continue;
    ++(truth == Sign::zero ? tally.zeros_missed : said == Sign::zero ? tally.zeros_invented : tally.opposite);
    const long double claimed = claimed_value<F>(method, block[i]);
    const double bad = badness<F>(claimed, block[i]);
    if (!tally.worst.yields_to(bad, kind, first + i)) continue;
    const CaseLine line{std::string(F::name), {block[i].begin(), block[i].end()}, Unsure{truth}};
    tally.worst = {bad, first + i, kind, static_cast<double>(claimed), to_string(line)};
  }
}

template <Formula F>
void compare_block(const MeshDecisions& decisions, const Kernel& kernel, Kind kind, std::uint64_t first,
                   std::uint64_t count, std::uint64_t verify_stride, Gathered& gathered) {
  const Block<F> all(decisions, kernel, kind, first, count);
  const std::span<const Coordinates<F>> block = all.coordinates;
  Comparison& comparison = gathered.comparison;
  Answers given, exact;
  for (const Coordinates<F>& p : block) decide<F>(p, comparison.stages);
  for (std::size_t m = method_count; m-- > 0;) {  // the judge first
    const auto method = static_cast<Method>(m);
    Answers& answers = method == Method::exact ? exact : given;
    const double ns = take_all<F>(method, all, kernel, answers);
    gathered.block_ns[m].push_back(ns);
    judge<F>(method, kind, first, block, answers, exact, comparison.method[m]);
  }
  if (verify_stride == 0) return;
  for (std::uint64_t i = (verify_stride - first % verify_stride) % verify_stride; i < count; i += verify_stride) {
    ++comparison.verified;
    if (rational_sign(F::name, block[i]) != exact[i].value()) ++comparison.refuted;
  }
}

using CompareBlock = void (*)(const MeshDecisions&, const Kernel&, Kind, std::uint64_t, std::uint64_t, std::uint64_t,
                              Gathered&);

CompareBlock comparer_of(std::string_view predicate) {
#define PLUMB_COMPARE(formula) \
  if (predicate == predicates::formula::name) return compare_block<predicates::formula>;
  PLUMB_CLASSICS(PLUMB_COMPARE)
#undef PLUMB_COMPARE
  return nullptr;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

Comparison compare_kind(const MeshDecisions& decisions, const Kernel& kernel, Kind kind, const CheckSettings& settings,
                        Progress& progress) {
  const std::uint64_t count = decisions.count(kind);
  const std::uint64_t blocks = (count + block_size - 1) / block_size;
  const std::uint64_t stride = settings.verify ? count / (settings.verified_of_kind + 1) + 1 : 0;
  const CompareBlock compare = comparer_of(kinds[static_cast<std::size_t>(kind)].predicate);
  tbb::enumerable_thread_specific<Gathered> per_thread;
  tbb::parallel_for(std::uint64_t{0}, blocks, [&](std::uint64_t b) {
    const std::uint64_t first = b * block_size, size = std::min(block_size, count - first);
    compare(decisions, kernel, kind, first, size, stride, per_thread.local());
    progress.advance(size);
  });
  Gathered all;
  for (Gathered& g : per_thread) {
    all.comparison += g.comparison;
    for (std::size_t m = 0; m < method_count; ++m) {
      all.block_ns[m].insert(all.block_ns[m].end(), g.block_ns[m].begin(), g.block_ns[m].end());
    }
  }
  for (std::size_t m = 0; m < method_count; ++m) {
    if (count != 0) all.comparison.method[m].nanoseconds = median(all.block_ns[m]) * static_cast<double>(count);
  }
  return all.comparison;
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

void check_mesh(const TriangleMesh& mesh, const CheckSettings& settings, MeshCheck& check) {
  const MeshEdges edges = find_edges(mesh);
  check.statistics = mesh_statistics(mesh, edges);
  check.lattice = lattice_of(coordinates_of(mesh));
  const MeshDecisions decisions(mesh, edges);
  check.edges = decisions.edge_answers();
  const Kernel kernel(plan(decisions.lattice()));
  std::uint64_t steps = 0;
  for (std::size_t k = 0; k < kinds.size(); ++k) steps += decisions.count(static_cast<Kind>(k));
  Progress progress(check.name, steps);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    check.kind[k] = compare_kind(decisions, kernel, static_cast<Kind>(k), settings, progress);
  }
}

}  // namespace plumb::tool
