// Batches against single cases: on any bytes, every form of a batch tells the signs that the predicate tells one by
// one, on each instruction set; where a coordinate is no real number it names the first such item.
//
// Bytes: formula, instruction set and form; number of cases; then as predicate_fuzz.hpp reads them, one family for all
// cases (odd) or doubles as they lie in memory (even), repeated while cases are wanted.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/case_line.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/side.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/predicates.hpp"

namespace plumb::fuzz {
namespace {

using Bytes = std::span<const std::uint8_t>;

template <class F>
certify::side::PointOf<F> point_of(const Coordinates<F>& c, std::size_t p) {
  if constexpr (F::dimension == 2) {
    return {c[2 * p], c[2 * p + 1]};
  } else {
    return {c[3 * p], c[3 * p + 1], c[3 * p + 2]};
  }
}

template <class F>
std::vector<Coordinates<F>> cases_from(Bytes bytes, std::size_t count) {
  std::vector<Coordinates<F>> cases(count);
  if (bytes.empty()) return cases;
  const bool family = bytes[0] % 2 == 1;
  bytes = bytes.subspan(1);
  Entropy entropy = Entropy::from_bytes(bytes);
  const Family which = any_family(entropy);
  for (std::size_t i = 0; i < count; ++i) {
    if (family) {
      fill_points(which, degeneracies[entropy.below(degeneracies.size())], F::dimension, cases[i], entropy);
      continue;
    }
    auto* to = reinterpret_cast<std::uint8_t*>(cases[i].data());
    for (std::size_t b = 0; b < sizeof cases[i] && !bytes.empty(); ++b)
      to[b] = bytes[(i * sizeof cases[i] + b) % bytes.size()];
  }
  return cases;
}

template <class F>
struct Batch {
  std::vector<Coordinates<F>> cases;
  std::vector<Sign> out;

  /// form 0: arrays of points, 1: arrays of coordinates, 2 and 3: likewise against the first case's other points.
  void ask(unsigned form) {
    constexpr std::size_t points = certify::side::points<F>;
    std::array<std::vector<certify::side::PointOf<F>>, points> p;
    std::array<std::vector<double>, arity<F>> x;
    for (const Coordinates<F>& c : cases) {
      for (std::size_t k = 0; k < points; ++k) p[k].push_back(point_of<F>(c, k));
      for (std::size_t k = 0; k < arity<F>; ++k) x[k].push_back(c[k]);
    }
    const auto view = [&](std::size_t k) {
      if constexpr (F::dimension == 2) {
        return Points2View{x[2 * k], x[2 * k + 1]};
      } else {
        return Points3View{x[3 * k], x[3 * k + 1], x[3 * k + 2]};
      }
    };
    const auto batch = [&](const auto&... arguments) {
      if constexpr (F::points == 3) orient2d(arguments..., out);
      if constexpr (F::points == 4 && F::dimension == 2) incircle(arguments..., out);
      if constexpr (F::points == 4 && F::dimension == 3) orient3d(arguments..., out);
      if constexpr (F::points == 5) insphere(arguments..., out);
    };
    const auto each = [&]<std::size_t... K>(std::index_sequence<K...>, auto argument) { batch(argument(K)...); };
    if (form == 0) {
      each(std::make_index_sequence<points>(),
           [&](std::size_t k) { return std::span<const certify::side::PointOf<F>>(p[k]); });
    } else if (form == 1) {
      each(std::make_index_sequence<points>(), view);
    } else {
      const Side<F> side = [&]<std::size_t... K>(std::index_sequence<K...>) {
        return Side<F>(point_of<F>(cases[0], K)...);
      }
      (std::make_index_sequence<points - 1>());
      form == 2 ? side(p[points - 1], out) : side(view(points - 1), out);
    }
  }
};

[[noreturn]] void fail(const std::string& text) {
  std::cerr << text << std::endl;
  std::abort();
}

/// What one case after the other says: the refusal of the first that is none, or nothing and all signs.
template <class F>
std::string one_by_one(const std::vector<Coordinates<F>>& cases, bool against, std::vector<Sign>& signs) {
  constexpr std::size_t given = arity<F> - static_cast<std::size_t>(F::dimension);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    try {
      signs.push_back(decide<F>(cases[i]));
    } catch (const NonFinite& error) {
      std::string text = error.what();
      const bool of_given = against && !std::all_of(cases[i].begin(), cases[i].begin() + given,
                                                    [](double x) { return std::isfinite(x); });
      if (!of_given) text.insert(text.find(" is "), " of item " + std::to_string(i));
      return text;
    }
  }
  return {};
}

template <class F>
void run(Bytes bytes, unsigned form, std::size_t count) {
  Batch<F> batch{cases_from<F>(bytes, count), std::vector<Sign>(count)};
  const bool against = form >= 2;
  if (against) {
    for (Coordinates<F>& c : batch.cases) {
      std::copy_n(batch.cases[0].begin(), arity<F> - static_cast<std::size_t>(F::dimension), c.begin());
    }
  }
  std::vector<Sign> truth;
  const std::string refusal = one_by_one<F>(batch.cases, against, truth);
  std::string said;
  try {
    batch.ask(form);
  } catch (const NonFinite& error) {
    said = error.what();
  }
  if (said != refusal) fail("the batch says '" + said + "', one by one '" + refusal + "'");
  if (!refusal.empty()) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (batch.out[i] == truth[i]) continue;
    const Coordinates<F>& c = batch.cases[i];
    fail("item " + std::to_string(i) + " of form " + std::to_string(form) + " differs\n" +
         to_string(CaseLine{std::string(F::name), {c.begin(), c.end()}, Unsure{truth[i]}}));
  }
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  if (size < 2) return 0;
  static const std::vector<std::string_view> sets = batch_instruction_sets();
  const unsigned choice = data[0], form = choice / 16 % 4;
  const std::size_t set = choice / 4 % 4;  // those that there are not: the best
  const std::size_t count = 1 + data[1] % 40;
  certify::batch::take_instruction_set(set < sets.size() ? sets[set] : std::string_view());
  const fuzz::Bytes rest{data + 2, size - 2};
  switch (choice % 4) {
    case 0:
      fuzz::run<predicates::Orient2d>(rest, form, count);
      break;
    case 1:
      fuzz::run<predicates::Orient3d>(rest, form, count);
      break;
    case 2:
      fuzz::run<predicates::InCircle>(rest, form, count);
      break;
    default:
      fuzz::run<predicates::InSphere>(rest, form, count);
  }
  return 0;
}
