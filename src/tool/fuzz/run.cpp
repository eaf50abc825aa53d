#include "tool/fuzz/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <csignal>
#include <map>
#include <tuple>

#include "plumb/degenerate/paste.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

using degenerate::Answer;
using degenerate::Findings;
using degenerate::Kind;
using degenerate::Numbers;
using degenerate::Outcome;

constexpr std::size_t kReplacements = 250;            // for each finding that is shrunk
constexpr std::size_t kHangs = 10, kHangsOfAll = 30;  // the same, of which the last findings get two at least

constexpr std::chrono::milliseconds kHeardAgain(
    25);                                         // how often the clock and the user are heard, if the function lets us
constexpr double kLeastShrinking = 10;           // seconds
constexpr std::chrono::milliseconds kLong(300);  // for a call: its time is told

volatile std::sig_atomic_t interrupted = 0;

/// While it lives, Ctrl-C and a polite request to end are heard; after the second time they do what they always do.
class Hearing {
 public:
  Hearing() {
    interrupted = 0;
    struct sigaction action {};
    action.sa_handler = [](int signal) {
      interrupted = interrupted + 1;
      if (interrupted == 2) std::signal(signal, SIG_DFL);
    };
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &action, &before_[i]);
  }
  Hearing(const Hearing&) = delete;
  Hearing& operator=(const Hearing&) = delete;
  ~Hearing() {
    for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &before_[i], nullptr);
  }

 private:
  static constexpr std::array signals = {SIGINT, SIGTERM};
  std::array<struct sigaction, 2> before_{};
};

/// Bits, for -0.0 is another case than 0.0.
std::vector<std::uint64_t> bits_of(const Numbers& numbers) {
  std::vector<std::uint64_t> bits;
  for (const double x : numbers) bits.push_back(std::bit_cast<std::uint64_t>(x));
  return bits;
}

class Fuzz {
 public:
  Fuzz(const Kind& kind, ForeignProcess& process, degenerate::CheckOptions options)
      : kind_(kind),
        process_(process),
        options_(std::move(options)),
        by_time_(options_.cases == 0),
        progress_("fuzz", by_time_ ? static_cast<std::uint64_t>(options_.seconds * 1000)
                                   : options_.cases * (options_.generators.empty() ? kind.generators.size() + 1
                                                                                   : options_.generators.size())) {}

  FuzzRun run() && {
    options_.progress = [this](const Findings& so_far) { return seen(so_far); };
    options_.shrinks = [this](const degenerate::Finding& found) { begin_shrinking(found); };
    options_.asks = [this](std::string_view generator, std::span<const std::uint64_t> indices) {
      generator_ = generator;
      indices_ = indices;
    };
    process_.watch([this](std::size_t number, std::chrono::milliseconds since) { tell(number, since); });
    const degenerate::Batch batch = [this](std::span<const Numbers> cases, std::span<Answer> answers) {
      shrinking_since_ ? shrink(cases[0], answers[0]) : search(cases, answers);
    };
    FuzzRun result;
    result.findings = degenerate::check_in_batches(kind_, batch, options_);
    for (degenerate::Tally& tally : result.findings.tallies) {
      if (tally.generator == cut_short_) tally.asked -= unasked_;
    }
    result.end = end_;
    process_.watch({});
    return result;
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  [[nodiscard]] bool time_is_up() const {
    return options_.seconds > 0 && Seconds(Clock::now() - start_).count() >= options_.seconds;
  }

  /// Which call is being made, and for how long where that is long.
  void tell(std::size_t number, std::chrono::milliseconds since) {
    if (!progress_.shown()) return;
    std::string what = shrinking_since_ ? fmt::format("making {} of {} simple", sort_, generator_)
                                        : fmt::format("{} {}", generator_, indices_[begun_ + number]);
    if (since >= kLong) what += fmt::format(" for {:.1f} s", Seconds(since).count());
    if (process_.hangs() > 0) what += fmt::format("; {} hung", process_.hangs());
    progress_.note(std::move(what));
  }

  /// A few at once while the function is slow, many where it is not.
  void search(std::span<const Numbers> cases, std::span<Answer> answers) {
    std::size_t asked = 0;
    do {
      const Clock::time_point begin = Clock::now();
      const std::size_t count = std::min(at_once_, cases.size() - asked);
      begun_ = asked;
      asked += process_.ask(cases.subspan(asked, count), answers.subspan(asked, count));
      at_once_ = Clock::now() - begin < kHeardAgain ? std::min(2 * at_once_, options_.block) : (at_once_ + 1) / 2;
    } while (asked < cases.size() && !process_.exhausted() && interrupted == 0 && !time_is_up());
    unasked_ = cases.size() - asked;
    for (std::size_t i = asked; i < cases.size(); ++i) answers[i] = kind_.exact(cases[i]);  // no finding
  }

  /// After every block: what was just asked, and whether to go on.
  bool seen(const Findings& so_far) {
    asked_.resize(so_far.tallies.size());
    std::uint64_t steps = 0;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
      const degenerate::Tally& tally = so_far.tallies[i];
      const std::uint64_t asked = tally.asked + tally.passed_over;
      if (asked == asked_[i]) continue;
      steps += asked - asked_[i];
      asked_[i] = asked;
      if (unasked_ > 0) cut_short_ = tally.generator;
    }
    if (by_time_) {
      const auto taken = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start_).count();
      steps = static_cast<std::uint64_t>(taken) - progress_.done();
    }
    progress_.advance(steps);
    if (unasked_ == 0 && interrupted == 0) return true;
    end_ = process_.exhausted() ? FuzzRun::End::exhausted
           : interrupted != 0   ? FuzzRun::End::interrupted
                                : FuzzRun::End::budget;
    return false;
  }

  void begin_shrinking(const degenerate::Finding& found) {
    if (!shrinking_since_) {
      shrinking_since_ = Clock::now();
      heard_ = interrupted;
    }
    generator_ = found.generator;
    sort_ = found.sort;
    tell(0, {});
    process_.allow(kReplacements, std::clamp(hangs_left_, std::size_t{2}, kHangs));
    known_.clear();
    if (given_up()) known_.emplace(bits_of(found.found), found.given);
  }

  [[nodiscard]] bool given_up() const {
    const double taken = Seconds(Clock::now() - *shrinking_since_).count();
    return interrupted != heard_ || (options_.seconds > 0 && taken > std::max(options_.seconds, kLeastShrinking));
  }

  /// What was answered is remembered: asking again may take its time, and there may be no more asking.
  void shrink(const Numbers& numbers, Answer& answer) {
    const std::vector<std::uint64_t> bits = bits_of(numbers);
    if (const auto known = known_.find(bits); known != known_.end()) {
      answer = known->second;
      return;
    }
    if (given_up() || process_.ask(std::span(&numbers, 1), std::span(&answer, 1)) == 0) {
      answer = kind_.exact(numbers);  // as if it did not fail: nothing simpler is found any more
      return;
    }
    if (answer.outcome == Outcome::hung && hangs_left_ > 0) --hangs_left_;
    known_.emplace(bits, answer);
  }

  const Kind& kind_;
  ForeignProcess& process_;
  degenerate::CheckOptions options_;
  const bool by_time_;
  const Clock::time_point start_ = Clock::now();
  Progress progress_;
  Hearing hearing_;
  std::vector<std::uint64_t> asked_;
  std::string generator_, sort_;            // what is asked, or shrunk
  std::span<const std::uint64_t> indices_;  // of the block that is asked
  std::size_t begun_ = 0;                   // where in it the process is asked from
  std::size_t at_once_ = 1;
  std::size_t unasked_ = 0;  // of the last block
  std::string cut_short_;    // the generator that it was of
  FuzzRun::End end_ = FuzzRun::End::budget;
  std::optional<Clock::time_point> shrinking_since_;
  int heard_ = 0;  // how often Ctrl-C had been, when shrinking began
  std::size_t hangs_left_ = kHangsOfAll;
  std::map<std::vector<std::uint64_t>, Answer> known_;  // of the finding that is shrunk
};

}  // namespace

FuzzRun fuzz(const Kind& kind, ForeignProcess& process, degenerate::CheckOptions options) {
  return Fuzz(kind, process, std::move(options)).run();
}

std::vector<SortOfFailure> sorts_of_failure(const Kind& kind, const Findings& findings) {
  // What fails again goes before what does not, proper figures before degenerate ones, and a short line has few points
  // and short numbers.
  const auto rank = [&](const degenerate::Finding& f) {
    return std::tuple(!f.repeated, f.degenerate, case_line(kind, f.smallest).size());
  };
  std::vector<SortOfFailure> sorts;
  for (const degenerate::Finding& f : findings.findings) {
    const auto same = [&](const SortOfFailure& s) { return s.simplest->sort == f.sort; };
    const auto at = std::ranges::find_if(sorts, same);
    if (at == sorts.end()) {
      sorts.push_back({&f, {f.generator}});
      continue;
    }
    at->generators.push_back(f.generator);
    if (rank(f) < rank(*at->simplest)) at->simplest = &f;
  }
  return sorts;
}

}  // namespace plumb::tool
