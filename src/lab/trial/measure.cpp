#include "lab/trial/measure.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <optional>

#include "lab/trial/allocations.hpp"

namespace plumb::lab::trial {
namespace {

constexpr double least_ns = 20'000;  // shorter measurements are repeated for the clock's sake
constexpr int least_repeats = 3, most_repeats = 16;

double elapsed_ns(Round& round) {
  const auto start = std::chrono::steady_clock::now();
  round.answer();
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

/// The least of some repetitions: what disturbs a measurement makes it longer.
double time_of(Round& round, double long_ns) {
  double least = elapsed_ns(round), sum = least;
  for (int i = 1; i < most_repeats && least < long_ns && (i < least_repeats || sum < least_ns); ++i) {
    const double ns = elapsed_ns(round);
    least = std::min(least, ns);
    sum += ns;
  }
  return least;
}

std::vector<double> changed(std::span<const double> questions, std::size_t numbers, const Symmetry& symmetry) {
  std::vector<double> turned(questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i) {
    turned[i] = questions[i - i % numbers + symmetry.from[i % numbers]];
  }
  return turned;
}

struct Inputs {
  std::vector<double> questions, truths;
  std::vector<std::vector<double>> changed;  // by each symmetry

  [[nodiscard]] std::span<const double> question(std::size_t i, std::size_t numbers) const {
    return std::span(questions).subspan(i * numbers, numbers);
  }
};

Inputs inputs_of(const Task& task, const InputClass& input, const Settings& settings) {
  Inputs all;
  const std::uint64_t cases = std::max<std::uint64_t>(1, settings.cases / task.fewer);
  all.questions.resize(cases * task.numbers);
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(settings.seed, i);
    const std::span<double> question = std::span(all.questions).subspan(i * task.numbers, task.numbers);
    input.fill(question, entropy);
    all.truths.push_back(task.judge(question));
  }
  for (const Symmetry& s : task.symmetries) all.changed.push_back(changed(all.questions, task.numbers, s));
  return all;
}

void judge(const Round& round, const Task& task, const Inputs& inputs, Score& score) {
  score.tallied.resize(task.tallies.size());
  for (std::size_t i = 0; i < inputs.truths.size(); ++i) {
    const double said = round.given(i), truth = inputs.truths[i];
    ++score.asked;
    if (std::isnan(said)) {
      ++score.unsure;
    } else {
      const auto question = inputs.question(i, task.numbers);
      if (!task.is_right(question, truth, said)) ++score.wrong;
      for (std::size_t t = 0; t < task.tallies.size(); ++t)
        score.tallied[t] += task.tallies[t].count(question, truth, round, i);
      if (task.kind != AnswerKind::number) continue;
      const double off = doubles_apart(said, truth);
      score.largest_ulps = std::max(score.largest_ulps, off);
      score.mean_ulps += off;  // their sum, to begin with
    }
  }
}

/// Nothing where the method is not asked.
std::optional<Score> score_of(const Method& method, const Task& task, const Inputs& inputs, const Scene& scene,
                              double long_ns) {
  const auto round = method.prepare(inputs.questions, scene);
  if (!round) return {};
  Score score{};
  score.method = method.name;
  const std::uint64_t before = allocations();
  round->answer();  // also brings code and questions into the caches
  const std::uint64_t taken = allocations() - before;
  score.ns = time_of(*round, long_ns) / static_cast<double>(inputs.truths.size());
  judge(*round, task, inputs, score);
  score.allocations = score.share(taken);
  score.mean_ulps = score.asked == score.unsure ? 0 : score.mean_ulps / static_cast<double>(score.asked - score.unsure);
  std::vector<bool> contradicted(inputs.truths.size());
  for (std::size_t s = 0; s < task.symmetries.size(); ++s) {
    const auto other = method.prepare(inputs.changed[s], scene);
    if (!other) return {};
    other->answer();
    for (std::size_t i = 0; i < contradicted.size(); ++i) {
      const double said = task.symmetries[s].factor * round->given(i), again = other->given(i);
      if (contradicted[i] || said == again || std::isnan(said) || std::isnan(again)) continue;
      const auto right = [&](double answer) {
        return task.is_right(inputs.question(i, task.numbers), inputs.truths[i], answer);
      };
      contradicted[i] = !right(said) || !right(again);
    }
  }
  score.inconsistent = static_cast<std::uint64_t>(std::ranges::count(contradicted, true));
  return score;
}

}  // namespace

double doubles_apart(double a, double b) {
  const auto place = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
  };
  if (!std::isfinite(a) || !std::isfinite(b)) return a == b ? 0 : 0x1p64;
  const std::int64_t i = place(a), j = place(b);
  return i > j ? static_cast<double>(static_cast<std::uint64_t>(i) - static_cast<std::uint64_t>(j))
               : static_cast<double>(static_cast<std::uint64_t>(j) - static_cast<std::uint64_t>(i));
}

Trial measure(const Task& task, const InputClass& input, const Settings& settings, const std::function<void()>& tried) {
  Trial trial{task.name, task.question, input.name, input.about, task.kind, {}, {}};
  for (const Tally& t : task.tallies) trial.tallies.push_back({t.name, t.about});
  const Inputs inputs = inputs_of(task, input, settings);
  const Scene scene = scene_of(inputs.questions);
  if (task.kind == AnswerKind::decision) {
    for (const double truth : inputs.truths) ++trial.truths[truth < 0 ? 0 : truth == 0 ? 1 : 2];
  }
  for (const Method& method : task.methods) {
    if (auto score = score_of(method, task, inputs, scene, settings.long_ns)) trial.scores.push_back(std::move(*score));
    tried();
  }
  return trial;
}

}  // namespace plumb::lab::trial
