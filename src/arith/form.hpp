// Where is a polynomial between 0 and 1?  Binary forms: c[0] u^n + c[1] u^(n-1) t + ... + c[n] t^n, of time t / (u +
// t).
//
// With u = 1 - t these are Bernstein coefficients times binomials: products need no binomials, the signs' variations
// tell of roots between 0 and 1, and a piece of time is a change of u and t by integers.
// Laws: exact, as far as nothing is lost (arith/brief_integer.hpp).  Degrees are formal and at most 3: the leading
// coefficients may be zero.
// Source: RTCD 5.5; Farouki 2012.
// Cost: an integer product for each pair of coefficients.
#pragma once

#include <array>

#include "arith/brief_integer.hpp"

namespace plumb::arith {

struct Form {
  static constexpr int most = 3;

  int degree = 0;
  std::array<BriefInteger, most + 1> c{};

  Form() = default;
  explicit Form(int n) : degree(n) {}
  template <class... N>
  explicit Form(const BriefInteger& first, const N&... rest)
      : degree(static_cast<int>(sizeof...(rest))), c{first, rest...} {}
  Form(const Form& f) : degree(f.degree) { copy(f); }
  Form& operator=(const Form& f) {
    degree = f.degree;
    copy(f);
    return *this;
  }

  [[nodiscard]] bool is_lost() const {
    for (int i = 0; i <= degree; ++i) {
      if (at(i).is_lost()) return true;
    }
    return false;
  }
  [[nodiscard]] const BriefInteger& at(int i) const { return c[static_cast<std::size_t>(i)]; }
  [[nodiscard]] BriefInteger& at(int i) { return c[static_cast<std::size_t>(i)]; }

  [[nodiscard]] bool is_short() const {
    for (int i = 0; i <= degree; ++i) {
      if (!at(i).is_short()) return false;
    }
    return true;
  }
  /// Are all coefficients zero?
  [[nodiscard]] bool is_zero() const {
    for (int i = 0; i <= degree; ++i) {
      if (at(i).is_lost() || at(i).sign() != 0) return false;
    }
    return true;
  }

  friend Form operator+(const Form& a, const Form& b) {  // of one degree
    Form r(a.degree);
    for (int i = 0; i <= a.degree; ++i) r.at(i) = a.at(i) + b.at(i);
    return r;
  }
  friend Form operator-(const Form& a, const Form& b) {
    Form r(a.degree);
    for (int i = 0; i <= a.degree; ++i) r.at(i) = a.at(i) - b.at(i);
    return r;
  }
  friend Form operator*(const Form& a, const Form& b) {
    Form r(a.degree + b.degree);
    if (a.is_short() && b.is_short()) {
      for (int k = 0; k <= r.degree; ++k) {
        Int128 sum = 0;
        for (int i = k > b.degree ? k - b.degree : 0; i <= a.degree && i <= k; ++i)
          sum += a.at(i).short_value() * b.at(k - i).short_value();
        r.at(k) = BriefInteger::of(sum);
      }
      return r;
    }
    for (int k = 0; k <= r.degree; ++k) {
      const int from = k > b.degree ? k - b.degree : 0, to = k < a.degree ? k : a.degree;
      BriefInteger sum = a.at(from) * b.at(k - from);
      for (int i = from + 1; i <= to; ++i) sum = sum + a.at(i) * b.at(k - i);
      r.at(k) = sum;
    }
    return r;
  }

  /// At u and t.
  [[nodiscard]] BriefInteger value(const BriefInteger& u, const BriefInteger& t) const {
    BriefInteger sum = at(0), power = t;
    for (int i = 1; i <= degree; ++i) {
      sum = sum * u + at(i) * power;
      if (i < degree) power = power * t;
    }
    return sum;
  }

 private:
  void copy(const Form& f) {
    for (int i = 0; i <= degree; ++i) at(i) = f.at(i);
  }
};

/// A piece of time, from a / 2^places to b / 2^places.
struct DyadicPiece {
  BriefInteger a, b{1};
  int places = 0;
};

/// The form on a piece: u and t are changed so that its ends become 0 and 1.
Form on_piece(const Form& f, const DyadicPiece& piece);

/// Both halves of [0, 1].
struct Halves {
  Form first, second;
};
Halves halves(const Form& f);

/// How often the coefficients change their sign, zeros left out; and the sign that all have that are not zero, if they
/// have only one.
struct SignChanges {
  int count, sign;
};
SignChanges sign_changes(const Form& f);

}  // namespace plumb::arith
