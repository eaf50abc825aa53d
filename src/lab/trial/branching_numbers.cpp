#include "lab/trial/branching_numbers.hpp"

namespace plumb::lab::trial {

template <class Number>
template <class Add>
Fraction<Number> Fraction<Number>::sum(const Fraction& a, const Fraction& b, Add add) {
  if (a.whole_ && b.whole_) return Fraction(add(a.above_, b.above_));
  if (a.whole_) return {add(a.above_ * b.below_, b.above_), b.below_};
  if (b.whole_) return {add(a.above_, b.above_ * a.below_), a.below_};
  if ((a.below_ - b.below_).sign() == Sign::zero) return {add(a.above_, b.above_), a.below_};
  return {add(a.above_ * b.below_, b.above_ * a.below_), a.below_ * b.below_};
}

template <class Number>
Fraction<Number> Fraction<Number>::plus(const Fraction& b) const {
  return sum(*this, b, [](const Number& x, const Number& y) { return x + y; });
}
template <class Number>
Fraction<Number> Fraction<Number>::minus(const Fraction& b) const {
  return sum(*this, b, [](const Number& x, const Number& y) { return x - y; });
}

template <class Number>
Fraction<Number> Fraction<Number>::times(const Fraction& b) const {
  if (whole_ && b.whole_) return Fraction(above_ * b.above_);
  return {above_ * b.above_, whole_ ? b.below_ : b.whole_ ? below_ : below_ * b.below_};
}

template <class Number>
Fraction<Number> Fraction<Number>::over(const Fraction& b) const {
  const Sign sign = b.above_.sign();
  if (sign == Sign::zero) {
    in_doubt = true;
    return *this;
  }
  const Number above = b.whole_ ? above_ : above_ * b.below_;
  const Number below = whole_ ? b.above_ : below_ * b.above_;
  return sign == Sign::positive ? Fraction(above, below) : Fraction(Number() - above, Number() - below);
}

template <class Number>
int Fraction<Number>::against(const Fraction& b) const {
  return static_cast<int>(minus(b).above_.sign());
}

template class Fraction<BigDyadic>;
template class Fraction<Expansion>;

double root_as_double(const IntegerFraction& square) {
  const mpq_class above = gmp_number(square.above());
  return nearest_root(square.whole() ? above : mpq_class(above / gmp_number(square.below())));
}

}  // namespace plumb::lab::trial
