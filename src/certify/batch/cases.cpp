#include "certify/batch/cases.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

#include "certify/batch/all_threads.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::certify::batch {
namespace {

constexpr std::size_t chunk = 2048;
constexpr std::size_t chunks_for_a_thread = 4;
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

class Run {
 public:
  Run(const BatchQuestion& question, const Cases& cases, Filter filter, const void* given, std::span<Sign> out)
      : question_(question), cases_(cases), filter_(filter), given_(given), out_(out) {}

  [[nodiscard]] std::size_t chunks() const { return (out_.size() + chunk - 1) / chunk; }

  /// Decides a chunk; returns the first of its cases that is no case, or none.
  [[nodiscard]] std::size_t decide(std::size_t number) const {
    assert_sound_thread();
    const std::size_t begin = number * chunk, n = std::min(chunk, out_.size() - begin);
    std::array<const double*, most_coordinates> at;
    for (std::size_t k = 0; k < question_.arity; ++k) at[k] = cases_.at[k] + begin * cases_.stride[k];
    std::array<std::uint32_t, chunk> unsure;
    const std::size_t count =
        filter_(given_, at.data(), n, reinterpret_cast<signed char*>(out_.data() + begin), unsure.data());
    std::size_t bad = none;
    std::array<double, most_coordinates> place;
    for (std::size_t u = 0; u < count; ++u) {
      const std::size_t i = begin + unsure[u];
      const std::span<const double> p = coordinates(i, place);
      const bool good = std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
      if (good) {
        out_[i] = question_.exactly(p.data());
      } else {
        bad = std::min(bad, i);
      }
    }
    return bad;
  }

  /// Says what is wrong with case i.
  [[noreturn]] void refuse(std::size_t i) const {
    std::array<double, most_coordinates> place;
    try {
      throw_non_finite(question_.name, question_.arguments, coordinates(i, place), question_.axes,
                       question_.argument_names);
    } catch (const NonFinite& error) {
      std::string text = error.what();  // "orient3d: b.y is nan, ..."
      text.insert(text.find(" is "), std::string(" of item ").append(std::to_string(i)));
      throw NonFinite(text);
    }
  }

 private:
  [[nodiscard]] std::span<const double> coordinates(std::size_t i, std::array<double, most_coordinates>& place) const {
    for (std::size_t k = 0; k < question_.arity; ++k) place[k] = cases_.at[k][i * cases_.stride[k]];
    return std::span(place).first(question_.arity);
  }

  const BatchQuestion& question_;
  const Cases& cases_;
  Filter filter_;
  const void* given_;
  std::span<Sign> out_;
};

std::size_t first_bad_serially(const Run& run) {
  for (std::size_t c = 0; c < run.chunks(); ++c) {
    if (const std::size_t bad = run.decide(c); bad != none) return bad;
  }
  return none;
}

std::size_t first_bad_in_parallel(const Run& run) {
  std::atomic<std::size_t> first = none;
  const auto decide = [&](std::size_t part) {
    const std::size_t begin = part * chunks_for_a_thread, end = std::min(run.chunks(), begin + chunks_for_a_thread);
    for (std::size_t c = begin; c < end && c * chunk < first.load(); ++c) {
      const std::size_t bad = run.decide(c);
      std::size_t known = first.load();
      while (bad < known && !first.compare_exchange_weak(known, bad)) {
      }
    }
  };
  for_each_part(Execution::parallel, (run.chunks() + chunks_for_a_thread - 1) / chunks_for_a_thread, decide);
  return first.load();
}

}  // namespace

void decide_cases(const BatchQuestion& question, const Cases& cases, Filter filter, const void* given,
                  std::span<Sign> out, Execution execution) {
  const Run run(question, cases, filter, given, out);
  const bool alone = execution == Execution::serial || run.chunks() <= chunks_for_a_thread;
  const std::size_t bad = alone ? first_bad_serially(run) : first_bad_in_parallel(run);
  if (bad != none) run.refuse(bad);
}

void throw_unequal(std::string_view formula, std::string_view name, std::size_t length, std::string_view other,
                   std::size_t other_length) {
  throw UnequalLengths(std::string(formula)
                           .append(": ")
                           .append(name)
                           .append(" has ")
                           .append(std::to_string(length))
                           .append(" items, but ")
                           .append(other)
                           .append(" has ")
                           .append(std::to_string(other_length))
                           .append("; give spans of equal length"));
}

}  // namespace plumb::certify::batch
