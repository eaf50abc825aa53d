// Would a slip in a statement be noticed?  It is run over numbers of which one operation is wrong, one after another.
//
// The mutants: a sum is a difference, a difference a sum, a product a sum; of two numbers the smaller is the larger; a
// magnitude and an opposite are the number itself.  A mutant is noticed where it tells what is not so.
// Law: the inputs are small multiples of a quarter, so that doubles hold every number of a statement.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "certify/exact_axes.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/certify/certainly.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::mutants {

/// Counts the operations from 0; that of this number is wrong.
inline int operations = 0, wrong = -1;
inline bool slips() { return operations++ == wrong; }

class Number {
 public:
  explicit Number(double x) : value_(x) {}

  /// With a slip or without.
  static Number sum(const Number& a, const Number& b, bool slip) {
    return Number(a.value_ + (slip ? -b.value_ : b.value_));
  }
  static Number difference(const Number& a, const Number& b, bool slip) { return sum(a, b, !slip); }
  static Number product(const Number& a, const Number& b, bool slip) {
    return Number(slip ? a.value_ + b.value_ : a.value_ * b.value_);
  }
  static Number opposite(const Number& a, bool slip) { return Number(slip ? a.value_ : -a.value_); }
  static Number size(const Number& a, bool slip) { return opposite(a, slip || a.value_ >= 0); }
  static Number larger_of(const Number& a, const Number& b, bool slip) { return (a.value_ < b.value_) != slip ? b : a; }

  friend Number operator+(const Number& a, const Number& b) { return sum(a, b, slips()); }
  friend Number operator-(const Number& a, const Number& b) { return difference(a, b, slips()); }
  friend Number operator*(const Number& a, const Number& b) { return product(a, b, slips()); }
  friend Number negated(const Number& a) { return opposite(a, slips()); }
  friend Number plus_product(const Number& sum, const Number& a, const Number& b) { return sum + a * b; }
  friend Number minus_product(const Number& sum, const Number& a, const Number& b) { return sum - a * b; }
  friend Number difference_of_unlike(const Number& a, const Number& b) { return a - b; }
  friend Number twice(const Number& a) { return a + a; }
  friend Number between(const Number& a, const Number& b, double t) { return a + (b - a) * Number(t); }
  friend Number select(bool first, const Number& a, const Number& b) { return first ? a : b; }
  friend Number magnitude(const Number& a) { return size(a, slips()); }
  friend Number larger(const Number& a, const Number& b) { return larger_of(a, b, slips()); }
  friend Number smaller(const Number& a, const Number& b) { return larger_of(a, b, !slips()); }
  [[nodiscard]] Sign sign() const { return static_cast<Sign>((value_ > 0) - (value_ < 0)); }

 private:
  double value_;
};

/// Of three axes an operation is wrong in all lanes, as a slip in the statement's text is.
using Three = certify::exact_axes::Axes<Number>;
inline Three lanes(const Three& a, const Three& b, Number (*f)(const Number&, const Number&, bool), bool slip) {
  return {f(a.x, b.x, slip), f(a.y, b.y, slip), f(a.z, b.z, slip)};
}
inline Three lanes(const Three& a, Number (*f)(const Number&, bool), bool slip) {
  return {f(a.x, slip), f(a.y, slip), f(a.z, slip)};
}
inline Three operator+(const Three& a, const Three& b) { return lanes(a, b, Number::sum, slips()); }
inline Three operator-(const Three& a, const Three& b) { return lanes(a, b, Number::difference, slips()); }
inline Three operator*(const Three& a, const Three& b) { return lanes(a, b, Number::product, slips()); }
inline Three negated(const Three& a) { return lanes(a, Number::opposite, slips()); }
inline Three magnitude(const Three& a) { return lanes(a, Number::size, slips()); }
inline Three larger(const Three& a, const Three& b) { return lanes(a, b, Number::larger_of, slips()); }
inline Three smaller(const Three& a, const Three& b) { return lanes(a, b, Number::larger_of, !slips()); }

class World : public ExactNumbers<Number, WorldKind::rationals> {
 public:
  static double given(double x) { return x; }
  template <std::size_t scale = 0>
  static Number sum(double a, double b) {
    return Number(a) + Number(b);
  }
  static Number difference_within(double b, double a, const auto&, const auto&) { return Number(b) - Number(a); }
  static bool positive(const Number& x) { return x.sign() == Sign::positive; }
  static bool negative(const Number& x) { return x.sign() == Sign::negative; }
  void leave_open() { open_ = true; }
  [[nodiscard]] bool certain() const { return !open_; }

 private:
  bool open_ = false;
};

class Axes : public certify::exact_axes::ExactAxes<Number, WorldKind::rationals> {
 public:
  template <std::size_t scale = 0>
  static auto difference_within(const Given& b, const Given& a, const auto&, const auto&) {
    return difference<scale>(b, a);
  }
};

/// What the statement says over this world, where it is certain.
template <class W, class Statement, class... Input>
auto told(const Statement& statement, const Input&... input) {
  W world;
  const auto answer = statement(world, input...);
  return world.certain() ? std::optional(answer) : std::nullopt;
}

/// Small numbers and what is made of them.
class Draw {
 public:
  explicit Draw(std::uint64_t i) : entropy_(26, i) {}
  double number() { return static_cast<double>(entropy_.within(4)); }
  double positive() { return 1 + static_cast<double>(entropy_.below(3)); }
  double quarter() { return static_cast<double>(entropy_.below(3)) / 4; }
  Point3 point() { return {number(), number(), number()}; }
  Vector3 vector() { return {number(), number(), number()}; }
  Aabb3 box() {
    const Point3 p = point();
    return {p, {p.x + positive(), p.y + positive(), p.z + positive()}};
  }
  Obb3 turned_box() { return {point(), {axis(), axis(), axis()}, {half(), half(), half()}}; }

 private:
  Vector3 axis() {
    const auto one = [&] { return static_cast<double>(entropy_.within(2)); };
    return {one(), one(), one()};
  }
  double half() { return std::array{1.0, -0.5, 3.0}[entropy_.below(3)]; }

  Entropy entropy_;
};

/// The numbers of the operations of which no input notices that they are wrong: draw(Draw&) makes one, ask(input) says
/// what is told of it, and truth(input) what is so.  From operation number `first` on.
template <class Drawn, class Ask, class Truth>
std::string unnoticed(const Drawn& draw, const Ask& ask, const Truth& truth, int first = 0,
                      std::uint64_t count = 20000) {
  std::vector<std::pair<std::remove_cvref_t<decltype(draw(std::declval<::plumb::mutants::Draw&>()))>, int>> inputs;
  std::vector<std::remove_cvref_t<decltype(truth(inputs[0].first))>> is_so;
  int most = 0;
  wrong = -1;
  for (std::uint64_t i = 0; i < count; ++i) {
    Draw one(i);
    inputs.emplace_back(draw(one), 0);
    is_so.push_back(truth(inputs.back().first));
    operations = 0;
    const auto answer = ask(inputs.back().first);
    if (answer && *answer != is_so.back()) return "what is told of input " + std::to_string(i) + " is not so";
    inputs.back().second = operations;
    most = operations > most ? operations : most;
  }
  if (most <= first) return "there is no operation";
  std::string all;
  for (int at = first; at < most; ++at) {
    bool is_noticed = false;
    for (std::size_t i = 0; i < count && !is_noticed; ++i) {
      if (inputs[i].second <= at) continue;
      operations = 0, wrong = at;
      const auto answer = ask(inputs[i].first);
      is_noticed = answer && *answer != is_so[i];
    }
    if (!is_noticed) all += std::to_string(at) + ' ';
  }
  wrong = -1;
  std::printf("%d mutants\n", most);
  return all;
}

/// Operations are counted in the order in which they are done, which for operands is the compiler's.
constexpr const char* by_compiler(const char* of_gcc, const char* of_clang) {
#ifdef __clang__
  return static_cast<void>(of_gcc), of_clang;
#else
  return static_cast<void>(of_clang), of_gcc;
#endif
}

/// Of the statement of this name in tests/certify/statements/golden_statements.txt.  The harmless ones, too, tell what
/// is so: the reason stands beside them.
inline void expect_noticed(const char* name, const std::string& unnoticed, const std::string& harmless = "") {
  EXPECT_EQ(unnoticed, harmless) << name;
}

}  // namespace plumb::mutants
