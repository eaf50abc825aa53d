// How does each method take the sign of a formula?  The formula, run over the numbers that software commonly uses.
//
// Laws: every method gets the same doubles, turned beforehand into the numbers that software keeps which computes so:
// floats, long doubles, quadruples, rationals, and those of the kernel of the scene's lattice.  An epsilon makes zeros
// of small values, as is commonly written; no decision of ours uses one.  `plumb check` tries some of these methods on
// meshes, `plumb-lab chart` all.
// Source: RTCD 11.2, 11.3.1 (tolerances).
// Cost: what is measured.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "plumb/arith/big.hpp"
#include "plumb/certify/bounded_points.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/kernel.hpp"
#include "tool/trial/adaptive.hpp"
#include "tool/trial/compensated.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::tool::trial {

/// What counts as zero in the size of the formula's terms: the largest difference to the last point, to the degree.
template <Formula F>
double size_of_terms(const Coordinates<F>& p) {
  constexpr auto dimension = static_cast<std::size_t>(F::dimension);
  double largest = 0;
  for (std::size_t i = 0; i + dimension < p.size(); ++i) {
    largest = std::max(largest, std::fabs(p[i] - p[p.size() - dimension + i % dimension]));
  }
  return power<degree<F>()>(largest);
}

/// The formula over another kind of floating-point number, which takes every double's value or rounds it.
template <Formula F, class Real>
std::array<Real, arity<F>> converted(const Coordinates<F>& p) {
  std::array<Real, arity<F>> r{};
  std::ranges::transform(p, r.begin(), [](double x) { return static_cast<Real>(x); });
  return r;
}

/// The points of a formula as a plan's kernel keeps them.
template <Formula F>
using PlannedPoints =
    std::array<LatticePoint<static_cast<std::size_t>(F::dimension)>, static_cast<std::size_t>(F::points)>;

/// Takes them in, checked.
template <Formula F>
PlannedPoints<F> taken_in(const Kernel& kernel, const Coordinates<F>& p) {
  PlannedPoints<F> taken;
  for (std::size_t i = 0; i < taken.size(); ++i) {
    std::array<double, static_cast<std::size_t>(F::dimension)> x{};
    std::copy_n(p.begin() + static_cast<std::ptrdiff_t>(i * x.size()), x.size(), x.begin());
    taken[i] = kernel.point(x);
  }
  return taken;
}

template <Formula F>
std::vector<Coordinates<F>> sets_of(std::span<const double> questions) {
  std::vector<Coordinates<F>> sets(questions.size() / arity<F>);
  for (std::size_t i = 0; i < sets.size(); ++i) std::copy_n(&questions[i * arity<F>], arity<F>, sets[i].begin());
  return sets;
}

template <Formula F>
class PlannedRound final : public Round {
 public:
  PlannedRound(std::span<const double> questions, const Scene& scene)
      : kernel_(plan(scene.lattice)), signs_(questions.size() / arity<F>) {
    for (const Coordinates<F>& p : sets_of<F>(questions)) sets_.push_back(taken_in<F>(kernel_, p));
  }
  void answer() override {
    kernel_.with<F>([&](const auto& sign) { take_all(sign); });
  }
  [[nodiscard]] double given(std::size_t i) const override { return as_answer(signs_[i]); }

 private:
  template <class Take>
  [[gnu::noinline]] void take_all(const Take& sign) {
    for (std::size_t i = 0; i < sets_.size(); ++i) signs_[i] = std::apply(sign, sets_[i]);
  }

  const Kernel kernel_;
  std::vector<PlannedPoints<F>> sets_;
  std::vector<Sign> signs_;
};

/// A method that asks `take` of each set of coordinates by itself.
template <Formula F, class Take>
Method each(std::string_view name, std::string_view about, Take take) {
  if constexpr (stateless<Take>) {
    return method(name, about, [](std::span<const double> questions, const Scene&) {
      return one_by_one(sets_of<F>(questions), Take{});
    });
  } else {
    return method(name, about, [take](std::span<const double> questions, const Scene&) {
      return one_by_one(sets_of<F>(questions), take);
    });
  }
}

template <Formula F, class Value>
Method valued(Method method, Value value) {
  method.value = [value](std::span<const double> question) {
    return static_cast<long double>(value(sets_of<F>(question).front()));
  };
  return method;
}

/// A method that takes the sign in numbers made of the doubles beforehand.
template <Formula F, class Make, class Take>
Method each_kept(std::string_view name, std::string_view about, Make make, Take take) {
  return method(name, about, [=](std::span<const double> questions, const Scene&) {
    std::vector<std::invoke_result_t<Make, const Coordinates<F>&>> sets;
    for (const Coordinates<F>& p : sets_of<F>(questions)) sets.push_back(make(p));
    return one_by_one(std::move(sets), take);
  });
}
template <Formula F, class Real>
Method each_in(std::string_view name, std::string_view about) {
  return each_kept<F>(name, about, converted<F, Real>,
                      [](const std::array<Real, arity<F>>& p) { return sign_of_number(F{}(p)); });
}

template <Formula F>
Method static_filter() {
  return {"static-filter", "double against one bound for all inputs; unsure within it",
          [](std::span<const double> questions, const Scene& scene) {
            Bounds<static_cast<std::size_t>(F::dimension)> bounds;
            bounds.least.fill(-scene.largest);
            bounds.largest.fill(scene.largest);
            const double threshold = largest_threshold<F>(largest_within<F>(bounds));
            return one_by_one(sets_of<F>(questions), [threshold](const Coordinates<F>& p) {
              const int s = bounded_filter<F>(p, threshold);
              return s == 0 ? Unsure<Sign>() : Unsure{static_cast<Sign>(s)};
            });
          }};
}

/// All but the batch, which is not asked by formula.  The names are those of `plumb check` and `plumb-lab chart`.
template <Formula F>
std::vector<Method> formula_methods() {
  using P = Coordinates<F>;
  std::vector<Method> all;
  const auto within = [](double value, double epsilon) { return std::fabs(value) <= epsilon ? 0 : value; };
  all.push_back(valued<F>(each_in<F, float>("float32", "single precision, of coordinates rounded to it"),
                          [](const P& p) { return F{}(converted<F, float>(p)); }));
  all.push_back(valued<F>(
      each<F>("double", "the formula as it is written", [](const P& p) { return sign_of_number(F{}(p)); }), F{}));
  all.push_back(valued<F>(each<F>("absolute", "double; at most 1e-9 is zero",
                                  [](const P& p) { return static_cast<Sign>(beyond(F{}(p), customary_epsilon)); }),
                          [=](const P& p) { return within(F{}(p), customary_epsilon); }));
  all.push_back(valued<F>(
      each<F>("relative", "double; at most 1e-9 of the terms' size is zero",
              [](const P& p) { return static_cast<Sign>(beyond(F{}(p), customary_epsilon * size_of_terms<F>(p))); }),
      [=](const P& p) { return within(F{}(p), customary_epsilon * size_of_terms<F>(p)); }));
  all.push_back(valued<F>(each_in<F, long double>("long-double", "the compiler's long double"),
                          [](const P& p) { return F{}(converted<F, long double>(p)); }));
#ifdef __SIZEOF_FLOAT128__
  __extension__ using Float128 = __float128;
  all.push_back(each_in<F, Float128>("float128", "quadruple precision in software"));
#endif
  all.push_back(each<F>("compensated", "pairs of doubles that keep each rounding's error", [](const P& p) {
    return sign_of_number(evaluate<F>([&](std::size_t i) { return Compensated(p[i]); }).rounded());
  }));
  all.push_back(each<F>("interval", "interval arithmetic alone; unsure about zero", interval_sign<F>));
  all.push_back(static_filter<F>());
  all.push_back(each<F>("adaptive", "adaptive expansions of doubles, as in the literature", adaptive_sign<F>));
  all.push_back(each<F>("integers", "integers of any length, always",
                        [](const P& p) { return big_integer_sign(certify::tape::program<F>(), p); }));
  using Rationals = std::array<BigRational, arity<F>>;
  all.push_back(each_kept<F>(
      "rationals", "GMP's rationals, always",
      [](const P& p) {
        Rationals r;
        std::ranges::transform(p, r.begin(), [](double x) { return big_rational(x); });
        return r;
      },
      [](const Rationals& p) { return F{}(p).sign(); }));
  all.push_back({"plan", "ours, in the arithmetic that the lattice of all inputs needs",
                 [](std::span<const double> questions, const Scene& scene) -> std::unique_ptr<Round> {
                   return std::make_unique<PlannedRound<F>>(questions, scene);
                 }});
  all.push_back(each<F>("exact", "ours, one at a time", [](const P& p) { return decide<F>(p); }));
  return all;
}

}  // namespace plumb::tool::trial
