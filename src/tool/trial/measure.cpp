#include "tool/trial/measure.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "tool/trial/allocations.hpp"

namespace plumb::tool::trial {
namespace {

constexpr double least_ns = 20'000;    // of a block's measurement: shorter ones are repeated for the clock's sake
constexpr double long_ns = 2'000'000;  // what takes longer is measured once: a disturbance is a small part of it
constexpr int least_repeats = 3, most_repeats = 16;

double elapsed_ns(Round& round) {
  const auto start = std::chrono::steady_clock::now();
  round.answer();
  const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

/// The least of some repetitions: what disturbs a measurement makes it longer.
double time_of(Round& round) {
  double least = elapsed_ns(round), sum = least;
  for (int i = 1; i < most_repeats && least < long_ns && (i < least_repeats || sum < least_ns); ++i) {
    const double ns = elapsed_ns(round);
    least = std::min(least, ns);
    sum += ns;
  }
  return least;
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::vector<double> changed(std::span<const double> questions, std::size_t numbers, const Symmetry& symmetry) {
  std::vector<double> turned(questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i) {
    turned[i] = questions[i - i % numbers + symmetry.from[i % numbers]];
  }
  return turned;
}

class Inputs {
 public:
  Inputs(const Task& task, const InputClass& input, const Settings& settings)
      : task_(task), all_(settings.cases / task.fewer * task.numbers), size_(settings.block * task.numbers) {
    for (std::uint64_t i = 0; i < settings.cases / task.fewer; ++i) {
      Entropy entropy(settings.seed, i);
      input.fill(std::span(all_).subspan(i * task.numbers, task.numbers), entropy);
    }
    for (std::size_t i = 0; i < all_.size(); i += task.numbers) {
      truths_.push_back(task.judge(std::span(all_).subspan(i, task.numbers)));
    }
    for (const Symmetry& s : task.symmetries) changed_.push_back(changed(all_, task.numbers, s));
  }

  [[nodiscard]] std::span<const double> all() const { return all_; }
  [[nodiscard]] std::span<const double> truths() const { return truths_; }
  [[nodiscard]] std::size_t blocks() const { return (all_.size() + size_ - 1) / size_; }
  [[nodiscard]] std::span<const double> block(std::size_t b) const { return part(all_, b); }
  [[nodiscard]] std::span<const double> changed_block(std::size_t symmetry, std::size_t b) const {
    return part(changed_[symmetry], b);
  }
  [[nodiscard]] std::span<const double> truths_of(std::size_t b) const {
    const std::size_t first = b * size_ / task_.numbers;
    return std::span(truths_).subspan(first, block(b).size() / task_.numbers);
  }

 private:
  [[nodiscard]] std::span<const double> part(const std::vector<double>& all, std::size_t b) const {
    return std::span(all).subspan(b * size_, std::min(size_, all.size() - b * size_));
  }

  const Task& task_;
  std::vector<double> all_, truths_;
  std::vector<std::vector<double>> changed_;
  std::size_t size_;
};

void judge(const Round& round, std::span<const double> truths, AnswerKind kind, Score& score) {
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const double said = round.given(i);
    ++score.asked;
    if (std::isnan(said)) {
      ++score.unsure;
    } else {
      score.wrong += said != truths[i];
      if (kind == AnswerKind::decision) continue;
      const double off = doubles_apart(said, truths[i]);
      score.largest_ulps = std::max(score.largest_ulps, off);
      score.mean_ulps += off;  // their sum, to begin with
    }
  }
}

Score score_of(const Method& method, const Task& task, const Inputs& inputs, const Scene& scene) {
  Score score{};
  score.method = method.name;
  std::vector<double> block_ns;
  std::uint64_t taken = 0;
  for (std::size_t b = 0; b < inputs.blocks(); ++b) {
    const std::span<const double> truths = inputs.truths_of(b);
    const auto round = method.prepare(inputs.block(b), scene);
    if (!round) return score;
    const std::uint64_t before = allocations();
    round->answer();  // also brings code and questions into the caches
    taken += allocations() - before;
    block_ns.push_back(time_of(*round) / static_cast<double>(truths.size()));
    judge(*round, truths, task.kind, score);
    std::vector<bool> contradicted(truths.size());
    for (std::size_t s = 0; s < task.symmetries.size(); ++s) {
      const auto other = method.prepare(inputs.changed_block(s, b), scene);
      other->answer();
      for (std::size_t i = 0; i < truths.size(); ++i) {
        const double said = task.symmetries[s].factor * round->given(i), again = other->given(i);
        contradicted[i] = contradicted[i] || (said != again && !std::isnan(said) && !std::isnan(again));
      }
    }
    score.inconsistent += static_cast<std::uint64_t>(std::ranges::count(contradicted, true));
  }
  score.ns = median(block_ns);
  score.allocations = score.share(taken);
  score.mean_ulps = score.asked == score.unsure ? 0 : score.mean_ulps / static_cast<double>(score.asked - score.unsure);
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
  const Inputs inputs(task, input, settings);
  const Scene scene = scene_of(inputs.all());
  if (task.kind == AnswerKind::decision) {
    for (const double truth : inputs.truths()) ++trial.truths[truth < 0 ? 0 : truth == 0 ? 1 : 2];
  }
  for (const Method& method : task.methods) {
    const Score score = score_of(method, task, inputs, scene);
    if (score.asked != 0) trial.scores.push_back(score);
    tried();
  }
  return trial;
}

}  // namespace plumb::tool::trial
