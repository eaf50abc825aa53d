#include "query/ray/posed_round.hpp"

#include "arith/rounded_radical.hpp"
#include "plumb/arith/big.hpp"
#include "query/convex/exact_gap.hpp"

namespace plumb::query {
namespace {

Rational exact_ratio(const mpq_class& x) { return Rational(BigRational{x}); }

/// The sign of constant + slope t.
int sign_of_line(const mpq_class& constant, const mpq_class& slope, const RayParameter& t) {
  if (sgn(slope) == 0) return sgn(constant);
  const auto order = t <=> RayParameter{exact_ratio(-constant / slope)};
  const int above = order > 0 ? 1 : order < 0 ? -1 : 0;
  return sgn(slope) * above;
}

/// Where parts are entered, of which the first in the span counts.
class FirstEntry {
 public:
  FirstEntry(const ExactShot& shot, const mpq_class& radius) : shot_(shot), square_(radius * radius) {}

  void see_ball(const Exact3& center) {
    const Exact3 w = shot_.from - center;
    if (const auto t = lesser_root(dot(shot_.along, shot_.along), dot(w, shot_.along), dot(w, w) - square_)) see(*t);
  }

  /// About the axis, between its ends.
  void see_cylinder(const Exact3& a, const Exact3& b) {
    const Exact3 h = b - a, w = shot_.from - a;
    const mpq_class length = dot(h, h);
    if (sgn(length) == 0) return;
    const mpq_class height = dot(w, h), rise = dot(shot_.along, h);
    const Exact3 off = w - mpq_class(height / length) * h, change = shot_.along - mpq_class(rise / length) * h;
    const auto t = lesser_root(dot(change, change), dot(off, change), dot(off, off) - square_);
    if (t && sign_of_line(height, rise, *t) >= 0 && sign_of_line(height - length, rise, *t) <= 0) see(*t);
  }

  /// The plates above and below all corner + s u + t v.
  void see_plates(const Exact3& corner, const Exact3& u, const Exact3& v) {
    const Exact3 normal = cross(u, v), w = shot_.from - corner;
    const mpq_class slope = dot(shot_.along, normal);
    if (sgn(slope) == 0) return;  // none, or beside them
    const RayParameter t{exact_ratio(-dot(w, normal) / slope),
                         exact_ratio(square_ * dot(normal, normal) / (slope * slope))};
    // The foot is within where it is on the inner side of each edge; in the plane's own coordinates.
    const auto is_between = [&](const Exact3& out, const mpq_class& end) {
      const mpq_class at = dot(w, out), change = dot(shot_.along, out);
      return sign_of_line(at, change, t) >= 0 && sign_of_line(at - end, change, t) <= 0;
    };
    const Exact3 of_u = cross(v, normal), of_v = cross(normal, u);
    if (is_between(of_u, dot(u, of_u)) && is_between(of_v, dot(v, of_v))) see(t);
  }

  [[nodiscard]] const std::optional<RayParameter>& first() const { return first_; }

 private:
  /// Of square t^2 + 2 half t + rest.
  static std::optional<RayParameter> lesser_root(const mpq_class& square, const mpq_class& half,
                                                 const mpq_class& rest) {
    const mpq_class discriminant = half * half - square * rest;
    if (sgn(square) == 0 || sgn(discriminant) < 0) return {};
    return RayParameter{exact_ratio(-half / square), exact_ratio(discriminant / (square * square))};
  }
  void see(const RayParameter& t) {
    if (shot_.least && (t <=> RayParameter{exact_ratio(*shot_.least)}) < 0) return;
    if (shot_.most && (t <=> RayParameter{exact_ratio(*shot_.most)}) > 0) return;
    if (!first_ || (t <=> *first_) < 0) first_ = t;
  }

  const ExactShot& shot_;
  mpq_class square_;
  std::optional<RayParameter> first_;
};

}  // namespace

RoundMeeting round_meeting(const ExactShot& shot, const FlatSet& core, const mpq_class& radius, const RayParameter& t) {
  RoundMeeting met{0, shot.from - core.points[0], shot.along};
  if (t.square.sign() == Sign::zero) {
    const FlatSet place{{shot.from + t.base.value().value * shot.along}, {}, {}};
    if (*squared_distance(core, place) < radius * radius) met.part.reset();
  }
  if (core.points.size() < 2 || core.points[0] == core.points[1]) return met;
  const Exact3 axis = core.points[1] - core.points[0];
  const mpq_class length = dot(axis, axis), height = dot(met.still, axis), rise = dot(shot.along, axis);
  if (sign_of_line(height, rise, t) < 0) {
    if (met.part) met.part = 1;
  } else if (sign_of_line(height - length, rise, t) > 0) {
    if (met.part) met.part = 2;
    met.still = shot.from - core.points[1];
  } else {
    met.still = met.still - mpq_class(height / length) * axis;
    met.moving = met.moving - mpq_class(rise / length) * axis;
  }
  return met;
}

double rounded_at(const mpq_class& base, const mpq_class& share, const RayParameter& t) {
  const mpq_class& square = t.square.value().value;
  const auto number = [](const mpz_class& x) { return BigDyadic(x); };
  const mpz_class root = square.get_num() * square.get_den();  // of (share / den) sqrt(num den)
  mpq_class over = share / square.get_den();
  if (!t.greater) over = -over;
  const mpz_class scale = base.get_den() * over.get_den();
  return rounded_radical(Rounding::nearest, number(base.get_num() * over.get_den()),
                         number(over.get_num() * base.get_den()), number(root), number(scale)) +
         0.0;
}

std::optional<RayParameter> first_in_fat(const ExactShot& shot, const FlatSet& core, const mpq_class& radius) {
  if (shot.least) {
    const Exact3 start = shot.from + *shot.least * shot.along;
    if (*squared_distance(core, FlatSet{{start}, {}, {}}) <= radius * radius)
      return RayParameter{exact_ratio(*shot.least)};
  }
  FirstEntry entry(shot, radius);
  const auto& p = core.points;
  for (const Exact3& corner : p) entry.see_ball(corner);
  if (p.size() == 2) entry.see_cylinder(p[0], p[1]);
  if (p.size() == 4) {
    entry.see_cylinder(p[0], p[1]), entry.see_cylinder(p[0], p[2]);
    entry.see_cylinder(p[1], p[3]), entry.see_cylinder(p[2], p[3]);
    entry.see_plates(p[0], p[1] - p[0], p[2] - p[0]);
  }
  return entry.first();
}

}  // namespace plumb::query
