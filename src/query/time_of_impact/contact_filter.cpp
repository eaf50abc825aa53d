#include "query/time_of_impact/contact_filter.hpp"

#include <array>
#include <cstddef>

#include "plumb/arith/lattice_integers.hpp"
#include "plumb/certify/decide.hpp"
#include "query/time_of_impact/contact_wanted.hpp"

namespace plumb::query::moving {
namespace {

// Bounds.  u = 2^-53.  A difference of coordinates is rounded once: it is the exact one times 1 + e, |e| <= u.  X, Y, Z
// are the largest differences in size, as rounded, at time 0 and 1.
// A coefficient of a cross product is x1 y2 - x2 y1 at an end, or half the sum of two of these in the middle: its terms
// are at most X Y (1 + u)^2 each, and it is off by 2 u of each term for the differences, u for the product, u for the
// sum, u for the sum of two (halving is exact): below 2 X Y * 6 u.  Taking it to a piece, by two convex combinations
// whose weights are exact, adds 3 u of 2 X Y each: in all below 2 X Y * 13 u.
// A coefficient of the cubic is a third of the sum of at most three products of a difference and a cross product's
// coefficient, along three axes: of size at most 6 X Y Z (1 + u)^3; to the 6 u of the cross product come u for the
// difference, u for the product, 2 u for the sum of three axes, 3 u for the combination of three and its third: below
// 6 X Y Z * 14 u; three combinations for the piece add 9 u: below 6 X Y Z * 24 u.
// The roundings of X, Y, Z and of the bounds themselves are far below what the constants leave.  `least_filtered` pays for
// underflow: of a cross product, times the largest difference, in the cubic.
constexpr double unit = 0x1p-53;
constexpr double least_filtered = 0x1p-960;
constexpr double cross_constant = 2 * 16 * unit;
constexpr double cubic_constant = 6 * 32 * unit;
constexpr double finest = 0x1p-10;  // pieces of time
constexpr int most_steps = 24;

struct DoubleVec {
  double x, y, z;
};

DoubleVec double_difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
DoubleVec cross_product(const DoubleVec& a, const DoubleVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot_product(const DoubleVec& a, const DoubleVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
DoubleVec half_sum(const DoubleVec& a, const DoubleVec& b) {
  return {(a.x + b.x) * 0.5, (a.y + b.y) * 0.5, (a.z + b.z) * 0.5};
}

/// A vector that moves linearly, and the Bernstein coefficients of a product of two.
struct Linear {
  DoubleVec at_0, at_1;
};
struct TimeQuadratic {
  std::array<DoubleVec, 3> c;
};
using Cubic = std::array<double, 4>;

TimeQuadratic cross_product(const Linear& a, const Linear& b) {
  return {{cross_product(a.at_0, b.at_0), half_sum(cross_product(a.at_0, b.at_1), cross_product(a.at_1, b.at_0)),
           cross_product(a.at_1, b.at_1)}};
}
Cubic dot_product(const Linear& a, const TimeQuadratic& q) {
  return {dot_product(a.at_0, q.c[0]), (2 * dot_product(a.at_0, q.c[1]) + dot_product(a.at_1, q.c[0])) * (1.0 / 3),
          (dot_product(a.at_0, q.c[2]) + 2 * dot_product(a.at_1, q.c[1])) * (1.0 / 3), dot_product(a.at_1, q.c[2])};
}

double between(double a, double b, double t) { return (1 - t) * a + t * b; }

/// The polar form, whose values at ends of a piece are the coefficients there.
double polar(double a, double b, double c, double s, double t) {
  return between(between(a, b, s), between(b, c, s), t);
}
Cubic piece_of(const Cubic& b, double s, double t) {
  const Cubic first{between(b[0], b[1], s), between(b[1], b[2], s), between(b[2], b[3], s), 0};
  const Cubic last{between(b[0], b[1], t), between(b[1], b[2], t), between(b[2], b[3], t), 0};
  return {polar(first[0], first[1], first[2], s, s), polar(first[0], first[1], first[2], s, t),
          polar(first[0], first[1], first[2], t, t), polar(last[0], last[1], last[2], t, t)};
}

/// The sign that all of some numbers have, certainly: bit 0 where they are positive, bit 1 where negative.
constexpr unsigned either = 3;
unsigned certain_sign(double x, double bound) {
  return static_cast<unsigned>(x > bound) | static_cast<unsigned>(x < -bound) << 1;
}
constexpr unsigned opposite(unsigned signs) { return (signs << 1 | signs >> 1) & either; }

template <std::size_t Count>
struct Figures {
  std::array<Linear, Count> differences;
  std::array<TimeQuadratic, Count> sides;  // 3 for a triangle, 4 for two edges
  DoubleVec bound;                         // of a coefficient of a side
};

double smaller(double a, double b) { return a < b ? a : b; }
double larger(double a, double b) { return a > b ? a : b; }

void include(DoubleVec& largest, const Linear& l) {
  for (const DoubleVec& v : {l.at_0, l.at_1}) {
    largest.x = larger(largest.x, __builtin_fabs(v.x));
    largest.y = larger(largest.y, __builtin_fabs(v.y));
    largest.z = larger(largest.z, __builtin_fabs(v.z));
  }
}

/// Along one axis, over a piece.
template <std::size_t Count, double DoubleVec::*axis>
Crossing crossing(const Figures<Count>& f, double s, double t) {
  std::array<unsigned, Count> side{};
  const double bound = f.bound.*axis;
  for (std::size_t i = 0; i < Count; ++i) {
    const double a = f.sides[i].c[0].*axis, b = f.sides[i].c[1].*axis, c = f.sides[i].c[2].*axis;
    side[i] = certain_sign(polar(a, b, c, s, s), bound) & certain_sign(polar(a, b, c, s, t), bound) &
              certain_sign(polar(a, b, c, t, t), bound);
  }
  if constexpr (Count == 3) {
    if ((side[0] | side[1] | side[2]) == either) return Crossing::apart;
    return (side[0] & side[1] & side[2]) != 0 ? Crossing::across : Crossing::unknown;
  } else {
    if (((side[0] & side[1]) | (side[2] & side[3])) != 0) return Crossing::apart;
    const bool across = (side[0] & opposite(side[1])) != 0 && (side[2] & opposite(side[3])) != 0;
    return across ? Crossing::across : Crossing::unknown;
  }
}

template <std::size_t Count>
Crossing crossing(const Figures<Count>& f, double s, double t) {
  bool across = false;
  for (const Crossing c : {crossing<Count, &DoubleVec::x>(f, s, t), crossing<Count, &DoubleVec::y>(f, s, t),
                           crossing<Count, &DoubleVec::z>(f, s, t)}) {
    if (c == Crossing::apart) return c;
    across |= c == Crossing::across;
  }
  return across ? Crossing::across : Crossing::unknown;
}

/// The part of time in which the cubic has exactly one root, if its coefficients there say so.
std::optional<Bracket> bracket_of(const Cubic& b, double bound, double from, double to) {
  if ((certain_sign(b[0], bound) & opposite(certain_sign(b[3], bound))) == 0) return {};
  const std::array<double, 3> steps{b[1] - b[0], b[2] - b[1], b[3] - b[2]};
  unsigned signs = either;
  for (const double step : steps) signs &= certain_sign(step, 4 * bound);
  if (signs == 0) return {};
  // A step is off by 2 bounds at most, besides its rounding.
  const auto size = [](double x) { return __builtin_fabs(x); };
  const double step = smaller(size(steps[0]), smaller(size(steps[1]), size(steps[2])));
  const double width = to - from;
  double x = b[0] / (b[0] - b[3]), slope = 0;
  for (int i = 0; i < 5; ++i) {
    slope = polar(steps[0], steps[1], steps[2], x, x);
    x -= polar(between(b[0], b[1], x), between(b[1], b[2], x), between(b[2], b[3], x), x, x) / (3 * slope);
    x = x > 0 ? smaller(x, 1) : 0;
  }
  return Bracket{from, to, from + x * width, 3 * slope / width, 1.25 * step / width};
}

/// At the one root in a piece: over a part of it so short that the cubic's sign at its ends is just certain.
template <std::size_t Count>
Crossing crossing_near_root(const Figures<Count>& f, const Cubic& cubic, double bound, const Bracket& b) {
  double reach = 4 * bound / __builtin_fabs(b.slope) + b.guess * 0x1p-52;  // a guess, as far as it tells
  for (int i = 0; i < 2; ++i, reach *= 16) {
    const double from = larger(b.guess - reach, b.from), to = smaller(b.guess + reach, b.to);
    const Cubic there = piece_of(cubic, from, to);
    if ((certain_sign(there[0], bound) & opposite(certain_sign(there[3], bound))) != 0) return crossing(f, from, to);
  }
  return Crossing::unknown;
}

/// Along the axis that shows the figures largest.
template <std::size_t Count>
Crossing crossing_at_root(const Figures<Count>& f, const ContactAtRoot& close, const Ball& time) {
  std::array<double, 3> size{};
  const auto at = [&](std::size_t i, double DoubleVec::*axis) {
    const std::array<DoubleVec, 3>& c = f.sides[i].c;
    return polar(c[0].*axis, c[1].*axis, c[2].*axis, time.high, time.high);
  };
  constexpr std::array axes{&DoubleVec::x, &DoubleVec::y, &DoubleVec::z};
  for (std::size_t k = 0; k < 3; ++k) {
    const double whole =
        Count == 3 ? at(0, axes[k]) + at(1, axes[k]) + at(2, axes[k]) : at(0, axes[k]) - at(1, axes[k]);
    size[k] = __builtin_fabs(whole);
  }
  const std::size_t axis = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : size[1] > size[2] ? 1 : 2;
  return close.crossing(time, axis);
}

/// A guess: on coarse lattices what doubles leave open is as a rule zero, which integers tell sooner.
bool pairs_may_tell(const ContactQuestion& q) {
  constexpr int few_bits = 30;
  std::array<double, 24> all;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array six{q.at_0[i].x, q.at_0[i].y, q.at_0[i].z, q.at_1[i].x, q.at_1[i].y, q.at_1[i].z};
    for (std::size_t k = 0; k < 6; ++k) all[6 * i + k] = six[k];
  }
  const LatticeIntegers<24> lattice(all);
  return lattice.bits() == 0 || lattice.bits() - lattice.zeros() > few_bits;
}

/// All of time, halved where it does not tell, from its start on.
template <ContactWanted asked, std::size_t Count>
FilteredContact search(const Figures<Count>& f, const Cubic& cubic, double bound, const ContactQuestion& question) {
  struct Piece {
    double from, to;
  };
  std::array<Piece, 48> waiting;  // halves that come later: one for each size
  std::size_t count = 0;
  waiting[count++] = {0, 1};
  bool doubt = false;
  std::optional<ContactAtRoot> close;
  for (int steps = 0; count > 0; ++steps) {
    const auto [s, t] = waiting[--count];
    const Cubic b = piece_of(cubic, s, t);
    unsigned signs = either;
    bool tiny = true;
    for (const double c : b) {
      signs &= certain_sign(c, bound);
      tiny &= __builtin_fabs(c) <= 4 * bound;
    }
    if (signs != 0) continue;
    const Crossing c = crossing(f, s, t);
    if (c == Crossing::apart) continue;
    const bool changes = (certain_sign(b[0], bound) & opposite(certain_sign(b[3], bound))) != 0;
    if (asked == ContactWanted::whether && c == Crossing::across && changes) return {ContactVerdict::yes, {}};
    if (changes) {
      if (const auto bracket = bracket_of(b, bound, s, t)) {
        Crossing there = c == Crossing::across ? c : crossing_near_root(f, cubic, bound, *bracket);
        if (asked == ContactWanted::whether && there == Crossing::across) return {ContactVerdict::yes, {}};
        if (there == Crossing::across || (there == Crossing::unknown && pairs_may_tell(question))) {
          if (!close) close.emplace(question.kind, question.at_0, question.at_1);
          const auto time = close->root(*bracket);
          if (time && there == Crossing::unknown) there = crossing_at_root(f, *close, *time);
          if (time && there == Crossing::across) return {ContactVerdict::yes, time};
        }
        if (there == Crossing::apart) continue;
        if (asked == ContactWanted::when) return {ContactVerdict::unsure, {}};
        doubt = true;
        continue;
      }
    }
    if (tiny || t - s <= finest || steps > most_steps) {
      if (asked == ContactWanted::when) return {ContactVerdict::unsure, {}};
      doubt = true;
      continue;
    }
    const double middle = 0.5 * (s + t);
    waiting[count++] = {middle, t};
    waiting[count++] = {s, middle};
  }
  return {doubt ? ContactVerdict::unsure : ContactVerdict::no, {}};
}

bool coplanar(std::span<const Point3, 4> p) {
  return plumb::decide<predicates::Orient3d>({p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z,  //
                                              p[2].x, p[2].y, p[2].z, p[3].x, p[3].y, p[3].z}) == Sign::zero;
}

TimeQuadratic side(const Figures<3>& f, std::size_t i) {
  return cross_product(f.differences[i], f.differences[(i + 1) % 3]);
}
TimeQuadratic side(const Figures<4>& f, std::size_t i) {  // of the differences ac, ad, bc, bd
  constexpr std::array<std::size_t, 4> left{0, 2, 0, 1}, right{1, 3, 2, 3};
  return cross_product(f.differences[left[i]], f.differences[right[i]]);
}

template <ContactWanted asked, std::size_t Count>
FilteredContact decide(Figures<Count>& f, const ContactQuestion& question) {
  const auto linear = [&](std::size_t i, std::size_t j) {
    return Linear{double_difference(question.at_0[i], question.at_0[j]),
                  double_difference(question.at_1[i], question.at_1[j])};
  };
  // The cubic takes three differences.
  constexpr bool edges = Count == 4;
  f.differences[0] = edges ? linear(2, 0) : linear(1, 0);
  f.differences[1] = edges ? linear(3, 0) : linear(2, 0);
  f.differences[2] = edges ? linear(2, 1) : linear(3, 0);
  DoubleVec m{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) include(m, f.differences[i]);
  f.sides[0] = side(f, 0);
  const Cubic cubic = dot_product(f.differences[2], f.sides[0]);
  // Products of the bounds must not vanish before they are done, and what has overflowed is certain of nothing: NaN.
  const auto product = [](double x, double y, double z) {
    constexpr double floor = 0x1p-320;
    return larger(x, floor) * larger(y, floor) * larger(z, floor);
  };
  double bound = cubic_constant * product(m.x, m.y, m.z) + least_filtered * (1 + m.x + m.y + m.z);
  for (const double c : cubic) bound += c - c;
  unsigned signs = either;
  for (const double c : cubic) signs &= certain_sign(c, bound);
  if (signs != 0) return {ContactVerdict::no, {}};
  if constexpr (edges) include(m, f.differences[3] = linear(3, 1));
  f.bound = {cross_constant * product(1, m.y, m.z) + least_filtered,
             cross_constant * product(1, m.z, m.x) + least_filtered,
             cross_constant * product(1, m.x, m.y) + least_filtered};
  for (std::size_t i = 1; i < Count; ++i) f.sides[i] = side(f, i);
  for (const TimeQuadratic& side : f.sides) {
    for (const DoubleVec& c : side.c)
      f.bound = {f.bound.x + (c.x - c.x), f.bound.y + (c.y - c.y), f.bound.z + (c.z - c.z)};
  }
  // In one plane at an end of time: no piece around that root would ever do.
  const auto meet_at = [&](double coefficient, std::span<const Point3, 4> p, double time) {
    return certain_sign(coefficient, bound) == 0 && crossing(f, time, time) == Crossing::across && coplanar(p);
  };
  if (meet_at(cubic[0], question.at_0, 0)) return {ContactVerdict::yes, Ball{0}};
  if (asked == ContactWanted::whether && meet_at(cubic[3], question.at_1, 1)) return {ContactVerdict::yes, {}};
  return search<asked>(f, cubic, bound, question);
}

/// Do the coordinates along an axis keep one order?  Between the first `Count` points and the others, by comparisons.
template <std::size_t Count, double Point3::*axis>
unsigned apart(std::span<const Point3, 4> p, std::span<const Point3, 4> q) {
  double below_0 = p[0].*axis, above_0 = below_0, below_1 = q[0].*axis, above_1 = below_1;
  if constexpr (Count == 2) {
    below_0 = smaller(p[0].*axis, p[1].*axis), above_0 = larger(p[0].*axis, p[1].*axis);
    below_1 = smaller(q[0].*axis, q[1].*axis), above_1 = larger(q[0].*axis, q[1].*axis);
  }
  double least_0 = p[Count].*axis, most_0 = least_0, least_1 = q[Count].*axis, most_1 = least_1;
  for (std::size_t i = Count + 1; i < 4; ++i) {
    least_0 = smaller(least_0, p[i].*axis), most_0 = larger(most_0, p[i].*axis);
    least_1 = smaller(least_1, q[i].*axis), most_1 = larger(most_1, q[i].*axis);
  }
  const unsigned before = static_cast<unsigned>(above_0 < least_0) & static_cast<unsigned>(above_1 < least_1);
  const unsigned after = static_cast<unsigned>(below_0 > most_0) & static_cast<unsigned>(below_1 > most_1);
  return before | after;
}
template <std::size_t Count>
bool apart(std::span<const Point3, 4> p, std::span<const Point3, 4> q) {
  return (apart<Count, &Point3::x>(p, q) | apart<Count, &Point3::y>(p, q) | apart<Count, &Point3::z>(p, q)) != 0;
}

template <ContactWanted asked>
FilteredContact filter(const ContactQuestion& question) {
  const std::span<const Point3, 4> p = question.at_0, q = question.at_1;
  if (question.kind == MovingKind::vertex_triangle) {
    Figures<3> f;
    return apart<1>(p, q) ? FilteredContact{ContactVerdict::no, {}} : decide<asked>(f, question);
  }
  Figures<4> f;
  return apart<2>(p, q) ? FilteredContact{ContactVerdict::no, {}} : decide<asked>(f, question);
}

}  // namespace

ContactVerdict contact_filter(const ContactQuestion& question) {
  return filter<ContactWanted::whether>(question).verdict;
}

FilteredContact first_contact_filter(const ContactQuestion& question) { return filter<ContactWanted::when>(question); }

}  // namespace plumb::query::moving
