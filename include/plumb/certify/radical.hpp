// What sign has a + b sqrt(c), or a + b sqrt(c) + d sqrt(e)?  Exact, for numbers and for polynomials of the input.
//
// The signs of the terms decide where they agree; otherwise squaring does, again and again (predicates/radical.hpp).
// Laws: (1) negating a, b (and d) flips the sign.  (2) The two roots may be swapped.  (3) A perfect square under the
// root gives what its root gives.
// Any finite numbers, subnormals and the largest included; a radicand below zero throws NegativeRadicand, NaN and
// infinity throw NonFinite.
// Source: RTCD 4.3 (radii); repeated squaring.
// Cost: for numbers a square root or two where floating point suffices, otherwise signs of degree up to 6; for formulas
// those of the parts, and where they disagree of up to six times their degree.
#pragma once

#include <concepts>

#include "plumb/certify/decide.hpp"
#include "plumb/predicates/radical.hpp"

namespace plumb {

namespace certify::radical {

/// Sign of x + y with the signs of both, where square(): the sign of x^2 - y^2.
template <class Square>
constexpr Sign sum(Sign x, Sign y, Square square) {
  if (x == y || y == Sign::zero) return x;
  if (x == Sign::zero) return y;
  return x * square();
}

/// Over any number, beside roots that are given.
struct WithRoot {
  template <class T>
  constexpr T operator()(const T& a, const T& b, const T& root) const {
    return a + b * root;
  }
};
struct WithRoots {
  template <class T>
  constexpr T operator()(const T& a, const T& b, const T& root, const T& d, const T& other) const {
    return a + b * root + d * other;
  }
};

/// A number as it is given, or the square root of one: that is rounded once, and never subnormal.
struct Term {
  static constexpr Bound given{0, 0}, root{Bound::eps, 0};
  static Filtered of(double x) { return Filtered(Filtered::Input{x}); }
  static Filtered root_of(double x) { return of(__builtin_sqrt(x)); }
};
/// What filter_constant is to polynomials, this is to sums with roots.
consteval double constant_of(const Bound& sum) { return static_cast<double>(sum.root + 2) * Bound::unit; }

Sign decide_exactly(double a, double b, double c);
Sign decide_exactly(double a, double b, double c, double d, double e);

}  // namespace certify::radical

/// The sign of a + b sqrt(c).
inline Sign sign_of_radical(double a, double b, double c) {
  using certify::radical::Term;
  constexpr certify::radical::WithRoot sum;
  constexpr double constant = certify::radical::constant_of(sum(Term::given, Term::given, Term::root));
  const Filtered value = sum(Term::of(a), Term::of(b), Term::root_of(c));
  if (const int s = beyond(value.value, constant * value.magnitude); s != 0) [[likely]]
    return static_cast<Sign>(s);
  return certify::radical::decide_exactly(a, b, c);
}

/// The sign of a + b sqrt(c) + d sqrt(e).
inline Sign sign_of_radicals(double a, double b, double c, double d, double e) {
  using certify::radical::Term;
  constexpr certify::radical::WithRoots sum;
  constexpr double constant =
      certify::radical::constant_of(sum(Term::given, Term::given, Term::root, Term::given, Term::root));
  const Filtered value = sum(Term::of(a), Term::of(b), Term::root_of(c), Term::of(d), Term::root_of(e));
  if (const int s = beyond(value.value, constant * value.magnitude); s != 0) [[likely]]
    return static_cast<Sign>(s);
  return certify::radical::decide_exactly(a, b, c, d, e);
}

/// In a radical of formulas: coordinate number I as it is given.  Like is any formula with the same input.
template <std::size_t I, Formula Like>
struct Given {
  static constexpr std::string_view name = "given";
  static constexpr auto arguments = plumb::arguments<Like>;
  static constexpr std::size_t index = I;
  template <class T>
  constexpr T operator()(const std::array<T, arity<Like>>& p) const {
    return p[I];
  }
};

namespace certify::radical {

/// A factor: a formula, Given, or predicates::One.
template <class F>
concept Factor = Formula<F> || std::same_as<F, predicates::One>;

template <Factor F>
consteval int degree_of() {
  if constexpr (!Formula<F>) {
    return 0;
  } else if constexpr (requires { F::index; }) {
    return 1;
  } else {
    return degree<F>();
  }
}

/// Have a^2 and b^2 c one degree?
template <Formula A, Factor B, Formula C>
consteval bool alike() {
  if constexpr (Formula<B>) {
    if constexpr (!is_homogeneous<B>) return false;
  }
  if constexpr (!is_homogeneous<A> || !is_homogeneous<C>) {
    return false;
  } else {
    return 2 * degree_of<A>() == 2 * degree_of<B>() + degree_of<C>();
  }
}

template <Formula A, Factor B, Formula C>
struct Norm {
  static constexpr std::string_view name = "radical_norm";
  static constexpr auto arguments = plumb::arguments<A>;
  static constexpr bool homogeneous = alike<A, B, C>();
  template <class T>
  constexpr auto operator()(const std::array<T, arity<A>>& p) const {
    return predicates::radical_norm(A{}(p), B{}(p), C{}(p));
  }
};

template <Formula A, Factor B, Formula C, Factor D, Formula E>
struct PairPart {
  static constexpr std::string_view name = "radical_pair_part";
  static constexpr auto arguments = plumb::arguments<A>;
  static constexpr bool homogeneous = alike<A, B, C>() && alike<A, D, E>();
  template <class T>
  constexpr auto operator()(const std::array<T, arity<A>>& p) const {
    return predicates::radical_pair_part(A{}(p), B{}(p), C{}(p), D{}(p), E{}(p));
  }
};

template <Formula A, Factor B, Formula C, Factor D, Formula E>
struct PairNorm {
  static constexpr std::string_view name = "radical_pair_norm";
  static constexpr auto arguments = plumb::arguments<A>;
  static constexpr bool homogeneous = alike<A, B, C>() && alike<A, D, E>();
  template <class T>
  constexpr auto operator()(const std::array<T, arity<A>>& p) const {
    return predicates::radical_pair_norm(A{}(p), B{}(p), C{}(p), D{}(p), E{}(p));
  }
};

/// The sign of what a radical is made of: it need not use every coordinate, since all of them are known to be finite.
template <Formula F>
PLUMB_CHECKABLE Sign decide_part(const Coordinates<F>& p) {
  static_assert(is_polynomial<F>());
  assert_sound_thread();
  if (const int s = filter<F>(p); s != 0) return static_cast<Sign>(s);
  return plumb::decide_exactly<F>(p).sign;
}

template <Factor F, std::size_t N>
Sign sign_of_factor(const std::array<double, N>& p) {
  if constexpr (!Formula<F>) {
    return Sign::positive;
  } else if constexpr (requires { F::index; }) {
    return sign_of_number(p[F::index]);
  } else {
    return decide_part<F>(p);
  }
}

[[noreturn]] void throw_negative(std::string_view radicand);

/// The sign of the radicand's root.
template <Formula C, std::size_t N>
Sign sign_of_root(const std::array<double, N>& p) {
  const Sign s = sign_of_factor<C>(p);
  if (s == Sign::negative) throw_negative(C::name);
  return s;
}

}  // namespace certify::radical

/// The sign of A + B sqrt(C) at p, for formulas of the same input.  A and C may be Given, B may be predicates::One.
template <Formula A, certify::radical::Factor B, Formula C>
Sign sign_of_radical(const Coordinates<A>& p) {
  require_finite<A>(p, "radical");
  const Sign root = certify::radical::sign_of_root<C>(p);
  return certify::radical::sum(certify::radical::sign_of_factor<A>(p), certify::radical::sign_of_factor<B>(p) * root,
                               [&p] { return certify::radical::decide_part<certify::radical::Norm<A, B, C>>(p); });
}

/// The sign of A + B sqrt(C) + D sqrt(E) at p, likewise.
template <Formula A, certify::radical::Factor B, Formula C, certify::radical::Factor D, Formula E>
Sign sign_of_radicals(const Coordinates<A>& p) {
  require_finite<A>(p, "radical");
  const Sign a = certify::radical::sign_of_factor<A>(p),
             b = certify::radical::sign_of_factor<B>(p) * certify::radical::sign_of_root<C>(p),
             d = certify::radical::sign_of_factor<D>(p) * certify::radical::sign_of_root<E>(p);
  return certify::radical::sum(
      certify::radical::sum(a, b, [&p] { return certify::radical::decide_part<certify::radical::Norm<A, B, C>>(p); }),
      d, [&] {
        return certify::radical::sum(
            certify::radical::decide_part<certify::radical::PairPart<A, B, C, D, E>>(p), a * b,
            [&p] { return certify::radical::decide_part<certify::radical::PairNorm<A, B, C, D, E>>(p); });
      });
}

}  // namespace plumb
