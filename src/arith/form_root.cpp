#include "arith/form_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/arith/lattice.hpp"

namespace plumb::arith {
namespace {

/// Of a form that is not zero at t = 1 in its last coefficients: as a polynomial in t / u without leading zeros.
Form without_leading_zeros(Form f) {
  while (f.degree > 0 && f.at(f.degree).sign() == 0) --f.degree;
  return f;
}

/// A multiple of p, less a multiple of q.
Form remainder(Form p, const Form& q) {
  while (p.degree >= q.degree) {
    const BriefInteger lead = p.at(p.degree), by = q.at(q.degree);
    const int shift = p.degree - q.degree;
    for (int i = 0; i < p.degree; ++i) {
      p.at(i) = p.at(i) * by;
      if (i >= shift) p.at(i) = p.at(i) - lead * q.at(i - shift);
    }
    if (p.degree == 0) return Form(0);
    --p.degree;
    p = without_leading_zeros(std::move(p));
    if (p.degree == 0 && p.at(0).sign() == 0) return p;
  }
  return p;
}

}  // namespace

FormRoot::FormRoot(const BriefInteger& u, const BriefInteger& t) : rational_(true), u_(u), t_(t) {}

FormRoot::FormRoot(const Form& on_piece, const DyadicPiece& piece)
    : rational_(false), sign_below_(on_piece.at(0).sign()), form_(on_piece), piece_(piece) {
  if (form_.degree != 1) return;
  // A linear form: u_ (2^places - ...) and so on, back on all of time.
  const BriefInteger &x = form_.at(0), &y = form_.at(1);
  const BriefInteger u = y.sign() < 0 ? -y : y, t = x.sign() < 0 ? -x : x;
  const BriefInteger whole = BriefInteger(1) << piece.places;
  u_ = (whole - piece.a) * u + (whole - piece.b) * t;
  t_ = piece.a * u + piece.b * t;
  rational_ = true;
}

double FormRoot::guess_on_piece() const {
  if (guess_ >= 0) return guess_;
  guess_ = new_guess();
  return guess_;
}
/// Newton's way in doubles, from the chord's zero, kept between the ends; whatever they make of it is of [0, 1].
double FormRoot::new_guess() const {
  int bits = 0;
  for (int i = 0; i <= form_.degree; ++i) bits = std::max(bits, form_.at(i).bits());
  std::array<double, Form::most + 1> c{};
  for (int i = 0; i <= form_.degree; ++i) c[static_cast<std::size_t>(i)] = form_.at(i).guess(bits);
  const auto at = [&](double t) {
    const double u = 1 - t;
    double sum = c[0], power = 1;
    for (int i = 1; i <= form_.degree; ++i) {
      power *= t;
      sum = sum * u + c[static_cast<std::size_t>(i)] * power;
    }
    return sum;
  };
  double low = 0, high = 1, at_low = c[0], at_high = c[static_cast<std::size_t>(form_.degree)];
  double t = at_low / (at_low - at_high);
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i) {
    if (!(t > low && t < high)) t = 0.5 * (low + high);
    const double y = at(t);
    if (y == 0) return t;
    ((y < 0) == (at_low < 0) ? (low = t, at_low = y) : (high = t, at_high = y));
    const double h = 0x1p-20, slope = (at(t + h) - at(t - h)) / (2 * h), step = y / slope;
    if (std::fabs(step) < t * 0x1p-52) return t;
    t -= step;
  }
  return t > low && t < high ? t : low;
}

/// A guess.
bool FormRoot::seems_zero(const Form& q) const {
  int bits = 0;
  for (int i = 0; i <= q.degree; ++i) bits = std::max(bits, q.at(i).bits());
  const double t = guess_on_piece(), u = 1 - t;
  double sum = q.at(0).guess(bits), power = 1;
  for (int i = 1; i <= q.degree; ++i) {
    power *= t;
    sum = sum * u + q.at(i).guess(bits) * power;
  }
  return std::fabs(sum) < 0x1p-40;
}

double FormRoot::guess() const {
  if (rational_) {
    const int bits = std::max(u_.bits(), t_.bits());
    const double u = u_.guess(bits), t = t_.guess(bits);
    return t / (u + t);
  }
  const double a = piece_.a.guess(piece_.places), b = piece_.b.guess(piece_.places);
  return a + (b - a) * guess_on_piece();
}

/// From `from` to `to` in parts of 2^-places of the piece, between which the form changes its sign.
void FormRoot::take_part(const BriefInteger& from, const BriefInteger& to, int places) {
  form_ = on_piece(form_, {from, to, places});
  guess_ = -1;
  const BriefInteger whole = piece_.a << places, width = piece_.b - piece_.a;
  piece_ = {whole + from * width, whole + to * width, piece_.places + places};
  certain_ = certain_ && !form_.is_lost() && !piece_.b.is_lost();
}

/// Many are a quotient of small integers: the nearest to a guess, by its continued fraction.
void FormRoot::look_for_rational() {
  const double x = guess_on_piece();
  std::int64_t p = 1, q = 0, before_p = 0, before_q = 1;
  double rest = x;
  constexpr std::int64_t most = 4096;
  for (int i = 0; i < 8; ++i) {
    const double floor = std::floor(rest);
    if (!(floor < static_cast<double>(most))) return;
    const auto whole = static_cast<std::int64_t>(floor);
    const std::int64_t next_p = whole * p + before_p, next_q = whole * q + before_q;
    if (next_q > most) return;
    before_p = p, before_q = q, p = next_p, q = next_q;
    const double off = std::fabs(x * static_cast<double>(q) - static_cast<double>(p));
    if (off < 0x1p-24) break;
    rest = 1 / (rest - floor);
  }
  if (!(p > 0 && p < q)) return;
  const BriefInteger u(q - p), t(p);
  const BriefInteger value = form_.value(u, t);
  if (value.sign() != 0 || value.is_lost()) return;
  u_ = (BriefInteger(1) << piece_.places) * BriefInteger(q);
  t_ = piece_.a * u + piece_.b * t;
  u_ = u_ - t_;
  rational_ = true;
  certain_ = certain_ && !u_.is_lost();
}

/// To a part of it around a guess, of 2^-places or so; where the guess does not prove itself, of less, down to one
/// half.
void FormRoot::shorten(int places) {
  const double guess = guess_on_piece();
  for (; places > 3; places /= 2) {
    const auto parts = static_cast<std::int64_t>(1) << places;
    const std::int64_t near =
        std::min(static_cast<std::int64_t>(guess * static_cast<double>(parts)), parts - 1);  // 1 would be past the end
    const auto sign_at = [&](std::int64_t part) {
      return form_.value(BriefInteger(parts - part), BriefInteger(part)).sign();
    };
    const std::int64_t from = std::max<std::int64_t>(near - 1, 0), to = std::min<std::int64_t>(near + 2, parts);
    const int first = from == 0 ? sign_below_ : sign_at(from);
    if (first != sign_below_) continue;
    const int last = to == parts ? -sign_below_ : sign_at(to);
    if (last != -sign_below_) continue;
    return take_part(BriefInteger(from), BriefInteger(to), places);
  }
  halve();
}

void FormRoot::halve() {
  guess_ = -1;
  const Halves h = halves(form_);
  const int middle = h.second.at(0).sign();
  const BriefInteger at_middle = piece_.a + piece_.b;
  if (middle == 0) {
    t_ = at_middle;
    u_ = (BriefInteger(1) << (piece_.places + 1)) - t_;
    rational_ = true;
  } else if (middle != sign_below_) {
    piece_ = {piece_.a << 1, at_middle, piece_.places + 1};
    form_ = h.first;
  } else {
    piece_ = {at_middle, piece_.b << 1, piece_.places + 1};
    form_ = h.second;
  }
  certain_ = certain_ && !form_.is_lost() && !h.second.at(0).is_lost();
}

/// Is the root one of q as well?  If so by a linear divisor, it becomes rational.
bool FormRoot::is_common(const Form& q_on_piece) {
  Form p = without_leading_zeros(form_), q = without_leading_zeros(q_on_piece);
  Form divisor = q;
  if (q.degree == 0) return false;
  Form rest = remainder(p, q);
  if (rest.is_lost()) {
    certain_ = false;
    return false;
  }
  if (!rest.is_zero()) {
    if (rest.degree == 0) return false;
    divisor = rest;
    rest = remainder(q, rest);
    certain_ = certain_ && !rest.is_lost();
    if (!rest.is_zero()) return false;
  }
  // The divisor's roots are roots of the form: none is at an end of the piece, and one at most between.
  if (divisor.at(0).sign() * divisor.at(divisor.degree).sign() >= 0) return false;
  if (divisor.degree == 1 && certain_) *this = FormRoot(divisor, piece_);
  return true;
}

int FormRoot::sign_of(const Form& q) {
  constexpr int places = 40, most_parts = 8, last_unasked = 2;
  bool asked = false;
  if (q.is_lost()) certain_ = false;
  for (int parts = 0; parts < most_parts && certain_; ++parts) {
    if (rational_) {
      const BriefInteger value = q.value(u_, t_);
      certain_ = certain_ && !value.is_lost();
      return value.sign();
    }
    const Form there = on_piece(q, piece_);
    if (there.is_lost()) break;
    const SignChanges changes = sign_changes(there);
    if (changes.count == 0) return changes.sign;  // at ends alone it may be zero, or it is everywhere
    if (parts == 0) look_for_rational();
    if (rational_) continue;
    if (!asked && (parts == last_unasked || seems_zero(there))) {
      asked = true;
      if (is_common(there)) return 0;
    }
    if (certain_) shorten(places);
  }
  certain_ = false;
  return 0;
}

/// Is the root above x (1), or below (-1), or there?
int FormRoot::side_of(double x) {
  const OddForm odd = odd_form(x);
  if (odd.exponent > 0) return -1;  // 2 or more
  const int places = -odd.exponent;
  const BriefInteger m(odd.mantissa);
  if (rational_) {
    const BriefInteger beyond = (t_ << places) - m * (u_ + t_);
    certain_ = certain_ && !beyond.is_lost();
    return beyond.sign();
  }
  const BriefInteger here = m << piece_.places;
  const BriefInteger u = (piece_.b << places) - here, t = here - (piece_.a << places);
  if (t.sign() <= 0) return 1;
  if (u.sign() <= 0) return -1;
  const BriefInteger value = form_.value(u, t);
  certain_ = certain_ && !value.is_lost();
  return value.sign() * sign_below_;
}

bool FormRoot::is_above_next(double x) {
  const int side = side_of(std::nextafter(x, std::numeric_limits<double>::infinity()));
  return side >= 0 && certain_;
}

double FormRoot::rounded_down() {
  if (rational_ && t_.sign() == 0) return 0;
  if (rational_ && u_.sign() == 0) return 1;
  if (!rational_) look_for_rational();
  if (!rational_ && piece_.places < 40) shorten(40);
  constexpr int most = 8;
  const double above = std::numeric_limits<double>::infinity();
  double x = std::fmax(guess(), 0);
  for (int i = 0; i < most && certain_; ++i) {
    if (side_of(x) < 0) {
      x = std::nextafter(x, 0);
      continue;
    }
    const double next = std::nextafter(x, above);
    if (side_of(next) < 0) return x;
    x = next;
  }
  certain_ = false;
  return 0;
}

}  // namespace plumb::arith
