// Which sign has a polynomial where another one is zero?  Roots between 0 and 1 of forms of degree 3 or less, on the
// stack.
//
// Laws: (1) roots come in ascending order, each once.  (2) A sign is that of real arithmetic, or is_certain() is false
// from then on: integers were too long for the limbs there are, or two roots too near to each other for the steps that
// are taken. The discriminant tells how many roots there are, and where those that are double or triple lie: they are
// rational. A single root is kept as a piece of time in which the form changes its sign, which becomes shorter by
// guesses that are proved by signs; a common divisor tells a zero.
// Source: Knuth, TAOCP 4.6.1; Abbott 2012 (refinement by guesses); arith/isolated_root.hpp is the same for any degree
// and length.
// Cost: some 100 ns to find a root, 50 to 300 ns a sign.
#pragma once

#include <optional>

#include "arith/form.hpp"

namespace plumb::arith {

class FormRoot {
 public:
  /// t / (u + t), with u and t not negative and not both zero.
  FormRoot(const BriefInteger& u, const BriefInteger& t);
  /// Of a form that has no root at either end of the piece and one, at which its sign changes, between.
  FormRoot(const Form& on_piece, const DyadicPiece& piece);

  /// -1, 0, 1.
  int sign_of(const Form& q);
  /// The largest double that is no larger.
  [[nodiscard]] double rounded_down();
  /// Is the root at least the double after x?  False where that is not certain.
  [[nodiscard]] bool is_above_next(double x);
  [[nodiscard]] bool is_certain() const { return certain_; }

 private:
  [[nodiscard]] double guess() const;
  [[nodiscard]] double guess_on_piece() const;
  [[nodiscard]] bool seems_zero(const Form& q_on_piece) const;
  bool is_common(const Form& q_on_piece);
  void look_for_rational();
  void shorten(int places);
  void halve();
  void take_part(const BriefInteger& from, const BriefInteger& to, int places);
  [[nodiscard]] int side_of(double x);

  [[nodiscard]] double new_guess() const;

  bool rational_;
  bool certain_ = true;
  int sign_below_ = 0;
  mutable double guess_ = -1;  // on the piece; below 0 where there is none yet
  BriefInteger u_, t_;
  Form form_;  // on the piece
  DyadicPiece piece_;
};

/// How many roots a form has strictly between 0 and 1, of one that has none at 0 and 1; and which of them are rational
/// because they are repeated, or beside repeated ones, in ascending order.
struct RootCount {
  int single = 0;  // all of them, unless some are listed
  int listed = 0;
  std::array<std::array<BriefInteger, 2>, 2> root{};  // u, t
  bool certain = true;
};
RootCount count_roots(const Form& form);

/// Single roots in the piece, at whose ends the form is not zero.
template <class Visit>
class SingleRoots {
 public:
  explicit SingleRoots(Visit& visit) : visit_(visit) {}

  [[nodiscard]] bool certain() const { return certain_; }
  /// False: stop.
  bool between(const Form& form, const DyadicPiece& piece) {
    const int changes = sign_changes(form).count;
    if (changes == 0) return true;
    if (changes == 1) {
      FormRoot root(form, piece);
      return visit_(root);
    }
    if (piece.places >= most_places) {
      certain_ = false;
      return false;
    }
    Halves h = halves(form);
    if (h.first.is_lost() || h.second.is_lost()) {
      certain_ = false;
      return false;
    }
    const BriefInteger middle = piece.a + piece.b;
    const DyadicPiece first{piece.a << 1, middle, piece.places + 1}, second{middle, piece.b << 1, piece.places + 1};
    const bool at_middle = h.second.at(0).sign() == 0;
    if (at_middle) {  // divided out: by t on one side, by u on the other
      --h.first.degree;
      --h.second.degree;
      for (int i = 0; i <= h.second.degree; ++i) h.second.at(i) = h.second.at(i + 1);
    }
    if (!between(h.first, first)) return false;
    if (at_middle) {
      FormRoot root((BriefInteger(1) << second.places) - middle, middle);
      if (!visit_(root)) return false;
    }
    return between(h.second, second);
  }

 private:
  static constexpr int most_places = 64;

  Visit& visit_;
  bool certain_ = true;
};

/// Calls visit(FormRoot&) for the roots of a form that is not zero in [0, 1], until it says false.  False where that is
/// not certain; then roots may be missing after those that were visited.
template <class Visit>
bool visit_roots(const Form& whole, Visit visit) {
  if (whole.is_lost()) return false;
  Form form = whole;
  bool at_0 = false, at_1 = false;
  while (form.degree > 0 && form.at(0).sign() == 0) {
    at_0 = true;
    --form.degree;
    for (int i = 0; i <= form.degree; ++i) form.at(i) = form.at(i + 1);
  }
  while (form.degree > 0 && form.at(form.degree).sign() == 0) at_1 = true, --form.degree;
  if (at_0) {
    FormRoot root(BriefInteger(1), BriefInteger(0));
    if (!visit(root)) return true;
  }
  const RootCount count = count_roots(form);
  if (!count.certain) return false;
  for (int i = 0; i < count.listed; ++i) {
    const auto& [u, t] = count.root[static_cast<std::size_t>(i)];
    FormRoot root(u, t);
    if (!visit(root)) return true;
  }
  if (count.single > 0) {
    SingleRoots single(visit);
    if (!single.between(form, {})) return single.certain();
  }
  if (at_1) {
    FormRoot root(BriefInteger(0), BriefInteger(1));
    if (!visit(root)) return true;
  }
  return true;
}

}  // namespace plumb::arith
