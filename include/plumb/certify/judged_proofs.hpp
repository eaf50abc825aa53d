// Can a machine check the bounds that were derived from my statement?  Each of them as a claim for Gappa.
//
//   for (const std::string& script : judged_proofs("is beyond", IsBeyond{}, p, q, r, s)) ...
//
// A number that the statement judges is a polynomial in its leaves: the world below writes down which.  The claim: for
// leaves of which each rounded difference, and each number as given, is at most 1 in magnitude, in IEEE doubles, the
// computed number is off by no more than the very constant that the code compares with, before its last rounding; and
// where the exact number is not positive (negative), the computed one is at most that constant (at least minus that).
// Laws: a script for each bound and each polynomial for which it stands, as far as this input leads there; `gappa FILE`
// exits with 0 exactly when it found the proof.  Of the larger or smaller of two, and of a magnitude, the claim is that
// of what it is on this input: docs/proof.md says why that is enough.
// Source: docs/proof.md, "What a machine has checked".
// Cost: microseconds for each operation; Gappa takes up to seconds for a script.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/rational.hpp"
#include "plumb/arith/track.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb {
namespace certify::written {

/// What was computed, and what of it was judged.
class Book {
 public:
  /// Operands are earlier entries; a leaf has none: a number as given, a rounded difference or a rounded sum of two.
  struct Entry {
    enum class Kind : char { given, difference, sum, plus = '+', minus = '-', times = '*' } kind;
    std::size_t left = 0, right = 0;
  };

  std::size_t write(Entry e) { return entries_.push_back(e), entries_.size() - 1; }
  void judge(std::size_t entry, const Track& track);
  [[nodiscard]] std::vector<std::string> scripts(std::string_view name) const;

 private:
  struct Claim {
    std::size_t entry;
    Track track;
  };
  std::vector<Entry> entries_;
  std::vector<Claim> claims_;
};

/// A number that is written down, or its opposite, with what it is.
class Number {
 public:
  Number(Book& book, Book::Entry entry, const Track& track, const Rational& value)
      : book_(&book), entry_(book.write(entry)), track_(track), value_(value) {}
  /// Zero, of which nothing is asked but which of it and another is larger.
  explicit Number(double zero) : value_(zero) {}

  friend Number operator+(const Number& a, const Number& b) {
    if (a.negative_ && !b.negative_) return b - -a;
    Number sum = b.negative_ == a.negative_ ? computed(Kind::plus, a, b) : computed(Kind::minus, a, b);
    sum.track_ = a.entry_ == b.entry_ && a.negative_ == b.negative_ ? arith::track::twice(a.track_)
                                                                    : arith::track::sum(a.track_, b.track_);
    sum.negative_ = a.negative_;
    sum.value_ = a.value_ + b.value_;
    return sum;
  }
  friend Number operator-(const Number& a, const Number& b) { return a + -b; }
  friend Number operator*(const Number& a, const Number& b) {
    Number product = computed(Kind::times, a, b);
    product.track_ = arith::track::product(a.track_, b.track_);
    product.negative_ = a.negative_ != b.negative_;
    product.value_ = a.value_ * b.value_;
    return product;
  }
  friend Number operator-(Number a) {
    a.negative_ = !a.negative_, a.value_ = -a.value_;
    return a;
  }
  friend Number negated(const Number& a) { return -a; }
  friend Number plus_product(const Number& sum, const Number& a, const Number& b) { return sum + a * b; }
  friend Number minus_product(const Number& sum, const Number& a, const Number& b) { return sum - a * b; }
  friend Number twice(const Number& a) { return a + a; }
  friend Number magnitude(const Number& a) { return a.value_.sign() == Sign::negative ? -a : a; }
  friend Number larger(const Number& a, const Number& b) { return select(b < a, a, b); }
  friend Number smaller(const Number& a, const Number& b) { return select(a < b, a, b); }
  friend Number select(bool first, const Number& a, const Number& b) {
    if (a.book_ == nullptr) return chosen(first, b - b, b, b.track_);
    if (b.book_ == nullptr) return chosen(first, a, a - a, a.track_);
    return chosen(first, a, b, arith::track::either(a.track_, b.track_));
  }
  friend bool operator<(const Number& a, const Number& b) { return a.value_ < b.value_; }

  /// Judges it.
  [[nodiscard]] Sign sign() const { return book_->judge(entry_, track_), value_.sign(); }

 private:
  using Kind = Book::Entry::Kind;
  static Number chosen(bool first, const Number& a, const Number& b, const Track& track) {
    Number one = first ? a : b;
    one.track_ = track;
    return one;
  }
  static Number computed(Kind kind, const Number& a, const Number& b) {
    Number c = a;
    c.entry_ = c.book_->write({kind, a.entry_, b.entry_});
    return c;
  }

  Book* book_ = nullptr;
  std::size_t entry_ = 0;
  bool negative_ = false;
  Track track_{};
  Rational value_;
};

/// No number is of a higher power of its scales than `highest`.
template <int highest, Scales of>
class World {
 public:
  static constexpr double given(double x) { return x; }
  template <std::size_t scale = 0>
  Number number(double a, std::size_t axis = 0) {
    return {book_, {Book::Entry::Kind::given}, on_axis<scale>(arith::track::given(scale, start), axis), a};
  }
  template <std::size_t scale = 0>
  Number difference(double b, double a, std::size_t axis = 0) {
    return {book_,
            {Book::Entry::Kind::difference},
            on_axis<scale>(arith::track::difference(scale, start), axis),
            Rational(b) - Rational(a)};
  }
  template <std::size_t scale = 0>
  Number sum(double a, double b) {
    return {book_, {Book::Entry::Kind::sum}, arith::track::difference(scale, start), Rational(a) + Rational(b)};
  }
  template <std::size_t scale = 0>
  Number difference_within(double b, double a, std::size_t axis) {
    return {book_,
            {Book::Entry::Kind::difference},
            on_axis<scale>(arith::track::within(scale, start, (of.maxima >> scale & 1) != 0 ? 2 : 1), axis),
            Rational(b) - Rational(a)};
  }
  template <std::size_t scale = 0>
  Number difference_within(double b, double a, const Number&, const Number&) {
    return difference_within<scale>(b, a, std::size_t{0});
  }
  template <std::size_t over>
  Number weight(double a, std::size_t axis = 0) {
    return {book_, {Book::Entry::Kind::given}, on_axis<over>(arith::track::weight(0, over, start), axis), a};
  }
  Number portion(double t) { return {book_, {Book::Entry::Kind::given}, arith::track::portion(start), portion_of(t)}; }
  static Sign sign(const Number& x) { return x.sign(); }
  static Sign compare(const Number& x, const Number& y) { return (x - y).sign(); }
  static bool positive(const Number& x) { return x.sign() == Sign::positive; }
  static bool negative(const Number& x) { return x.sign() == Sign::negative; }
  static bool zero(const Number& x) { return x.sign() == Sign::zero; }
  static constexpr void leave_open() {}
  static constexpr bool certain() { return true; }
  [[nodiscard]] const Book& book() const { return book_; }

 private:
  static constexpr Track start{0, 0, 0, 0, 0, highest, of.each_axis};
  template <std::size_t scale>
  static Track on_axis(Track t, std::size_t axis) {
    if (axis == 0 || !start.is_of_axes(scale)) return t;
    t.set_power(scale, axis, t.power(scale, 0));
    t.set_power(scale, 0, 0);
    return t;
  }

  Book book_;
};

}  // namespace certify::written

/// Of what the statement judges on this input, over doubles.  The name is for the scripts' first lines.
template <class Statement, class... Input>
std::vector<std::string> judged_proofs(std::string_view name, const Statement& statement, const Input&... input) {
  certify::written::World<highest_power<Statement>, scales_of<Statement>> world;
  static_cast<void>(statement(world, input...));
  return world.book().scripts(name);
}

}  // namespace plumb
