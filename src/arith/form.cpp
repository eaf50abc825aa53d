#include "arith/form.hpp"

namespace plumb::arith {
namespace {

Form turned_over(const Form& f) {
  Form r(f.degree);
  for (int i = 0; i <= f.degree; ++i) r.at(i) = f.at(f.degree - i);
  return r;
}
/// f(2 u + t, t).
Form first_half(Form f) {
  for (int i = 0; i < f.degree; ++i) {
    for (int j = 1; j <= f.degree - i; ++j) f.at(j) = f.at(j) + f.at(j - 1);
  }
  for (int i = 0; i < f.degree; ++i) f.at(i) = f.at(i) << (f.degree - i);
  return f;
}

}  // namespace

Halves halves(const Form& f) { return {first_half(f), turned_over(first_half(turned_over(f)))}; }

Form on_piece(const Form& f, const DyadicPiece& piece) {
  if (piece.places == 0) return f;
  const BriefInteger whole = BriefInteger(1) << piece.places, u_a = whole - piece.a, u_b = whole - piece.b;
  const BriefInteger &t_a = piece.a, &t_b = piece.b;
  if (f.degree == 1) return Form(f.at(0) * u_a + f.at(1) * t_a, f.at(0) * u_b + f.at(1) * t_b);
  if (f.degree == 2) {  // by its polar form, twice
    const BriefInteger first = f.at(0) << 1, last = f.at(2) << 1;
    const BriefInteger u = first * u_a + f.at(1) * t_a, t = f.at(1) * u_a + last * t_a;
    const BriefInteger v = first * u_b + f.at(1) * t_b, w = f.at(1) * u_b + last * t_b;
    return Form(u * u_a + t * t_a, (u * u_b + t * t_b) << 1, v * u_b + w * t_b);
  }
  const Form u(u_a, u_b), t(t_a, t_b);
  Form sum(f.at(0)), power(BriefInteger(1));
  for (int i = 1; i <= f.degree; ++i) {
    power = power * t;
    sum = sum * u + Form(f.at(i)) * power;
  }
  return sum;
}

SignChanges sign_changes(const Form& f) {
  int count = 0, last = 0;
  for (int i = 0; i <= f.degree; ++i) {
    const int s = f.at(i).sign();
    if (s != 0 && last != 0 && s != last) ++count;
    if (s != 0) last = s;
  }
  return {count, count == 0 ? last : 0};
}

}  // namespace plumb::arith
