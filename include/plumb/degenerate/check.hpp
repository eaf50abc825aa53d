// Property-based testing: on which inputs is a geometric function wrong?  Any function of a known kind against the
// exact answer.
//
//   const Findings findings = degenerate::check(kind, my_orient3d, {.seed = 7, .cases = 10'000});
//   EXPECT_TRUE(findings.clean()) << degenerate::text(kind, findings);
//
// Cases come from the kind's generators, from the corpus, and from both with small moves ("mutated").  The first case
// of each sort of failure is shrunk while the failure stays of that sort: by its choices and by its numbers, whichever
// gets farther.  Where not all are kept, those without degenerate figures are.
// Laws: (1) with a budget of cases, the same function, options and corpus give the same findings, whatever the machine.
// (2) Case i of a generator follows from the seed and i alone: case_of makes it again.  (3) A finding's smallest case
// still fails, and no step of shrink_case.hpp makes it smaller, unless the calls ran out.  (4) What a function throws
// is a finding, no error, and a rounding mode that it leaves behind is put back before it is judged; what it changes in
// memory that is not its own is its own affair: `plumb fuzz` runs it in a process of its own.  (5) Nothing is asked
// that is not in the domain, in shrinking neither; cases of the corpus that are not in it are passed over.
// Unknown generators and corpus cases that are none throw Error, by name.
// Source: RTCD 11.
// Cost: beside the function that of the exact answer, 1 to 15 us a case of most kinds, up to milliseconds of distances,
// and milliseconds for a finding.
#pragma once

#include <functional>
#include <optional>
#include <type_traits>
#include <typeinfo>

#include "plumb/arith/error.hpp"
#include "plumb/degenerate/domain.hpp"
#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

inline constexpr std::string_view corpus_generator = "corpus", mutated_generator = "mutated";

struct Tally {
  std::string generator;
  std::uint64_t asked = 0, wrong = 0, unsure = 0, failed = 0;  // unsure: answered NaN, which is no finding
  std::uint64_t degenerate = 0;   // of those wrong or failed, the cases with a degenerate figure
  std::uint64_t passed_over = 0;  // beside those asked: cases that the generator has not within the domain

  [[nodiscard]] double share_wrong() const {
    return asked == 0 ? 0 : static_cast<double>(wrong + failed) / static_cast<double>(asked);
  }
};

struct Finding {
  std::string generator;
  std::uint64_t index = 0;  // case_of(kind, generator, seed, index)
  std::string sort;
  bool degenerate = false;  // one of the figures of the case found
  Numbers found, smallest;
  Answer given, exact;   // of the smallest
  bool repeated = true;  // false: asked again, it did not fail: by memory or by chance
};

struct Findings {
  std::string kind;
  std::uint64_t seed = 0;
  std::vector<Tally> tallies;     // the corpus (if any), the generators in the kind's order, mutated ones
  std::vector<Finding> findings;  // in the order of the tallies

  [[nodiscard]] bool clean() const;  // nothing wrong, nothing failed, kept or not
  [[nodiscard]] std::uint64_t asked() const;
};

struct CheckOptions {
  std::uint64_t seed = 2026;
  std::uint64_t cases = 1000;                // of each generator; 0: until the time is up
  double seconds = 0;                        // 0: however long it takes
  std::vector<std::string> generators = {};  // of the kind's and "mutated"; none: all
  std::vector<Numbers> corpus = {};          // asked first; mutated cases start from them as well
  std::optional<Tolerance> tolerance = {};   // nothing: the kind's
  Domain domain = {};                        // numbers that the function is made for
  std::size_t keep = 1;                      // sorts of failure kept a generator
  std::size_t shrink_calls = 20'000;         // a finding; a hundredth where the function crashed, hung or exited
  std::size_t block = 256;                   // cases asked at once
  /// Told before every block, by number, which cases of which generator are asked.
  std::function<void(std::string_view generator, std::span<const std::uint64_t> indices)> asks = {};
  /// Told after every block, findings not yet shrunk; false ends the run.
  std::function<bool(const Findings&)> progress = {};
  /// Told before each finding is shrunk: what is asked from there on is asked one by one, and for it.
  std::function<void(const Finding&)> shrinks = {};
};

using Callable = std::function<Answer(std::span<const double> numbers)>;
/// Answers many cases, in order: for functions that live in another process.
using Batch = std::function<void(std::span<const Numbers> cases, std::span<Answer> answers)>;

Findings check(const Kind& kind, const Callable& function, const CheckOptions& options = {});
Findings check_in_batches(const Kind& kind, const Batch& function, const CheckOptions& options = {});

/// A function of the kind's C signature as a callable.
Callable callable_of(const Kind& kind, ForeignFunction function);

/// The same for a pointer to the function, whose type must be the kind's: throws Error naming the signature.
template <class R, class... A>
Callable callable_of(const Kind& kind, R (*function)(A...)) {
  if (kind.type != typeid(R(A...))) {
    throw Error(std::string("check: ").append(kind.name).append(" asks a function such as ").append(kind.signature));
  }
  return callable_of(kind, reinterpret_cast<ForeignFunction>(function));
}

template <class R, class... A>
requires(!std::is_same_v<R, Answer>)  // that is a callable
    Findings check(const Kind& kind, R (*function)(A...), const CheckOptions& options = {}) {
  return check(kind, callable_of(kind, function), options);
}

/// The case that check asks as number `index` of a generator, or of "mutated" (which the corpus has a part in); no
/// numbers where the generator has none within the domain.
Numbers case_of(const Kind& kind, std::string_view generator, std::uint64_t seed, std::uint64_t index,
                std::span<const Numbers> corpus = {}, const Domain& domain = {});

}  // namespace plumb::degenerate
