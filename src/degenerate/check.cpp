#include "plumb/degenerate/check.hpp"

#include <algorithm>
#include <chrono>
#include <exception>

#include "degenerate/fields.hpp"
#include "degenerate/kept_environment.hpp"
#include "plumb/degenerate/shrink_case.hpp"

namespace plumb::degenerate {

namespace {

// A generator's cases are its own, whichever others are asked for: FNV-1a of its name.
std::uint64_t start_of(std::uint64_t seed, std::string_view generator) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : generator) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return seed ^ hash;
}

const Generator* generator_named(const Kind& kind, std::string_view name) {
  const auto at = std::ranges::find(kind.generators, name, &Generator::name);
  return at == kind.generators.end() ? nullptr : &*at;
}

[[noreturn]] void refuse_generator(const Kind& kind, std::string_view name) {
  std::string text =
      std::string("check: ").append(kind.name).append(" has no generator ").append(name).append("; it has");
  for (const Generator& g : kind.generators) text.append(" ").append(g.name);
  throw Error(text.append(" ").append(mutated_generator));
}

constexpr int kTries = 32;  // for a case that is in the domain

std::optional<Numbers> make(const Kind& kind, std::string_view generator, Entropy& entropy,
                            std::span<const Numbers> corpus, const Domain& domain) {
  const bool mutated = generator == mutated_generator;
  const Generator* const named = mutated ? nullptr : generator_named(kind, generator);
  if (!mutated && named == nullptr) refuse_generator(kind, generator);
  for (int i = 0; i < kTries; ++i) {
    Numbers numbers;
    if (!mutated) {
      named->make(numbers, entropy);
    } else {
      if (!corpus.empty() && entropy.coin()) {
        numbers = corpus[entropy.below(corpus.size())];
      } else {
        kind.generators[entropy.below(kind.generators.size())].make(numbers, entropy);
      }
      mutate(kind, numbers, entropy);
    }
    if (std::optional<Numbers> within = fitted(domain, kind, std::move(numbers))) return within;
  }
  return std::nullopt;
}

Answer asked(const Callable& function, std::span<const double> numbers) {
  const KeptEnvironment kept;
  try {
    return function(numbers);
  } catch (const std::exception& e) {
    return Answer(Outcome::threw, e.what());
  } catch (...) {
    return Answer(Outcome::threw, "no std::exception");
  }
}

class Run {
 public:
  Run(const Kind& kind, const Batch& function, const CheckOptions& options)
      : kind_(kind), function_(function), options_(options), tolerance_(options.tolerance.value_or(kind.tolerance)) {
    if (options.cases == 0 && !(options.seconds > 0)) throw Error("check: neither cases nor seconds; give either");
    require_sense(options.domain);
    if (options.block == 0) throw Error("check: a block of 0 cases; ask at least one at once");
    for (const Numbers& numbers : options.corpus) {
      if (const std::string flaw = flaw_of(kind, numbers); !flaw.empty()) throw Error("check: corpus: " + flaw);
      if (is_in(options.domain, kind, numbers)) corpus_.push_back(numbers);
    }
    for (const std::string& name : options.generators) {
      if (name != mutated_generator && generator_named(kind, name) == nullptr) refuse_generator(kind, name);
    }
    if (!corpus_.empty()) add(corpus_generator);
    for (const Generator& g : kind.generators) {
      if (wanted(g.name)) add(g.name);
    }
    if (wanted(mutated_generator)) add(mutated_generator);
    found_.kind = kind.name;
    found_.seed = options.seed;
  }

  Findings findings() && {
    ask_all();
    for (Finding& finding : found_.findings) shrink(finding);
    std::ranges::stable_sort(found_.findings, {}, [&](const Finding& f) { return place_of(f.generator); });
    return std::move(found_);
  }

 private:
  [[nodiscard]] bool wanted(std::string_view name) const {
    return options_.generators.empty() || std::ranges::find(options_.generators, name) != options_.generators.end();
  }
  void add(std::string_view name) {
    found_.tallies.emplace_back();
    found_.tallies.back().generator = name;
  }
  [[nodiscard]] std::ptrdiff_t place_of(const std::string& generator) const {
    return std::ranges::find(found_.tallies, generator, &Tally::generator) - found_.tallies.begin();
  }

  static std::uint64_t made(const Tally& tally) { return tally.asked + tally.passed_over; }

  // A block of each in turn, so that a run that is stopped has asked all alike.
  void ask_all() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (bool any = true; any;) {
      any = false;
      for (Tally& tally : found_.tallies) {
        const std::uint64_t all = tally.generator == corpus_generator ? corpus_.size() : options_.cases;
        const std::uint64_t left = all == 0 ? options_.block : all - made(tally);
        if (left == 0) continue;
        any = true;
        ask_block(tally, std::min<std::uint64_t>(left, options_.block));
        if (options_.progress && !options_.progress(found_)) return;
        const double taken = std::chrono::duration<double>(Clock::now() - start).count();
        if (options_.seconds > 0 && taken >= options_.seconds) return;
      }
    }
  }

  void ask_block(Tally& tally, std::uint64_t count) {
    std::vector<Numbers> cases;
    std::vector<std::uint64_t> indices;
    const std::uint64_t first = made(tally);
    for (std::uint64_t i = first; i < first + count; ++i) {
      Numbers numbers = tally.generator == corpus_generator
                            ? corpus_[i]
                            : case_of(kind_, tally.generator, options_.seed, i, corpus_, options_.domain);
      if (numbers.empty()) continue;
      cases.push_back(std::move(numbers));
      indices.push_back(i);
    }
    tally.passed_over += count - cases.size();
    if (cases.empty()) return;
    if (options_.asks) options_.asks(tally.generator, indices);
    std::vector<Answer> answers(cases.size());
    function_(cases, answers);
    tally.asked += cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const Judgment j = judge(kind_, cases[i], answers[i], tolerance_);
      if (j.verdict == Verdict::right) continue;
      (j.verdict == Verdict::unsure ? tally.unsure : j.verdict == Verdict::wrong ? tally.wrong : tally.failed) += 1;
      if (j.verdict == Verdict::unsure) continue;
      const bool degenerate = is_degenerate(kind_, cases[i]);
      tally.degenerate += degenerate ? 1 : 0;
      keep({tally.generator, indices[i], std::string(j.sort), degenerate, cases[i], cases[i], answers[i], {}});
    }
  }

  void keep(Finding found) {
    Finding* worst = nullptr;  // of the same generator: one of the same sort, or the first that is degenerate
    std::size_t kept = 0;
    for (Finding& f : found_.findings) {
      if (f.generator != found.generator) continue;
      ++kept;
      if (f.sort == found.sort) {
        if (found.degenerate || !f.degenerate) return;
        worst = &f;
        break;
      }
      if (worst == nullptr && f.degenerate) worst = &f;
    }
    const bool replaces = worst != nullptr && !found.degenerate && (worst->sort == found.sort || kept >= options_.keep);
    if (replaces) {
      *worst = std::move(found);
    } else if (kept < options_.keep) {
      found_.findings.push_back(std::move(found));
    }
  }

  Answer ask_one(std::span<const double> numbers) {
    std::vector<Numbers> cases{Numbers(numbers.begin(), numbers.end())};
    std::vector<Answer> answers(1);
    function_(cases, answers);
    return std::move(answers[0]);
  }

  void shrink(Finding& f) {
    if (options_.shrinks) options_.shrinks(f);
    const bool process = f.given.outcome != Outcome::answered && f.given.outcome != Outcome::threw;
    const std::size_t calls = process ? options_.shrink_calls / 100 : options_.shrink_calls;
    const auto fails = [&](std::span<const double> numbers) {
      return is_in(options_.domain, kind_, numbers) &&
             judge(kind_, numbers, ask_one(numbers), tolerance_).sort == f.sort;
    };
    f.repeated = fails(f.found);
    if (f.repeated) {
      f.smallest = shrink_case(kind_, f.found, fails, calls / 2);
      if (f.generator != corpus_generator) {
        Numbers other = shrink_case(kind_, of_simpler_choices(f, fails, calls / 4), fails, calls / 4);
        if (std::pair(other.size(), is_simpler(f.smallest, other)) <
            std::pair(f.smallest.size(), is_simpler(other, f.smallest))) {
          f.smallest = std::move(other);
        }
      }
      f.given = ask_one(f.smallest);
      f.repeated = judge(kind_, f.smallest, f.given, tolerance_).sort == f.sort;
    }
    f.exact = kind_.exact(f.smallest);
  }

  // Choices know what must stay exactly so: points of one plane stay in it while its integers shrink.
  Numbers of_simpler_choices(const Finding& f, const FailsOnCoordinates& fails, std::size_t calls) {
    std::vector<std::uint64_t> choices;
    Entropy entropy(start_of(options_.seed, f.generator), f.index);
    entropy.record_into(&choices);
    make(kind_, f.generator, entropy, corpus_, options_.domain);
    const auto replayed = [&](std::span<const std::uint64_t> some) {
      Entropy replay = Entropy::from_choices(some);
      return make(kind_, f.generator, replay, corpus_, options_.domain).value_or(Numbers{});
    };
    return replayed(shrink_choices(
        choices,
        [&](std::span<const std::uint64_t> some) {
          const Numbers numbers = replayed(some);
          return !numbers.empty() && is_degenerate(kind_, numbers) <= f.degenerate && fails(numbers);
        },
        calls));
  }

  const Kind& kind_;
  const Batch& function_;
  const CheckOptions& options_;
  Tolerance tolerance_;
  std::vector<Numbers> corpus_;  // what of it is in the domain
  Findings found_;
};

}  // namespace

std::uint64_t Findings::asked() const {
  std::uint64_t all = 0;
  for (const Tally& t : tallies) all += t.asked;
  return all;
}

bool Findings::clean() const {
  return std::ranges::all_of(tallies, [](const Tally& t) { return t.wrong + t.failed == 0; });
}

Numbers case_of(const Kind& kind, std::string_view generator, std::uint64_t seed, std::uint64_t index,
                std::span<const Numbers> corpus, const Domain& domain) {
  Entropy entropy(start_of(seed, generator), index);
  return make(kind, generator, entropy, corpus, domain).value_or(Numbers{});
}

Findings check_in_batches(const Kind& kind, const Batch& function, const CheckOptions& options) {
  return Run(kind, function, options).findings();
}

Findings check(const Kind& kind, const Callable& function, const CheckOptions& options) {
  const Batch batch = [&](std::span<const Numbers> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = asked(function, cases[i]);
  };
  return check_in_batches(kind, batch, options);
}

Callable callable_of(const Kind& kind, ForeignFunction function) {
  return [kind, function](std::span<const double> numbers) { return ask(kind, function, numbers); };
}

}  // namespace plumb::degenerate
