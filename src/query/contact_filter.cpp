#include "query/contact_filter.hpp"

#include <array>
#include <cstddef>

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
// The sums of X, Y, Z's own roundings are far below what the constants leave; `least` pays for underflow.
constexpr double unit = 0x1p-53;
constexpr double least = 0x1p-960;
constexpr double cross_constant = 2 * 16 * unit;
constexpr double cubic_constant = 6 * 32 * unit;
constexpr double finest = 0x1p-40;  // pieces of time

struct Vec {
  double x, y, z;
};

Vec difference(const Point3& a, const Point3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec cross(const Vec& a, const Vec& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec half_sum(const Vec& a, const Vec& b) { return {(a.x + b.x) * 0.5, (a.y + b.y) * 0.5, (a.z + b.z) * 0.5}; }

/// A vector that moves linearly, and the Bernstein coefficients of a product of two.
struct Linear {
  Vec at_0, at_1;
};
struct Quadratic {
  std::array<Vec, 3> c;
};
using Cubic = std::array<double, 4>;

Quadratic cross(const Linear& a, const Linear& b) {
  return {{cross(a.at_0, b.at_0), half_sum(cross(a.at_0, b.at_1), cross(a.at_1, b.at_0)), cross(a.at_1, b.at_1)}};
}
Cubic dot(const Linear& a, const Quadratic& q) {
  return {dot(a.at_0, q.c[0]), (2 * dot(a.at_0, q.c[1]) + dot(a.at_1, q.c[0])) * (1.0 / 3),
          (dot(a.at_0, q.c[2]) + 2 * dot(a.at_1, q.c[1])) * (1.0 / 3), dot(a.at_1, q.c[2])};
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
  std::array<Quadratic, Count> sides;  // 3 for a triangle, 4 for two edges
  Vec bound;                           // of a coefficient of a side
};

double smaller(double a, double b) { return a < b ? a : b; }
double larger(double a, double b) { return a > b ? a : b; }

template <std::size_t Count>
Vec largest(const std::array<Linear, Count>& all) {
  Vec m{0, 0, 0};
  for (const Linear& l : all) {
    for (const Vec& v : {l.at_0, l.at_1}) {
      m.x = larger(m.x, __builtin_fabs(v.x));
      m.y = larger(m.y, __builtin_fabs(v.y));
      m.z = larger(m.z, __builtin_fabs(v.z));
    }
  }
  return m;
}

/// Along one axis, over a piece: do the projections stay apart, or cross strictly?
enum class Crossing : unsigned char { apart, across, unknown };

template <std::size_t Count, double Vec::*axis>
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
  for (const Crossing c :
       {crossing<Count, &Vec::x>(f, s, t), crossing<Count, &Vec::y>(f, s, t), crossing<Count, &Vec::z>(f, s, t)}) {
    if (c == Crossing::apart) return c;
    across |= c == Crossing::across;
  }
  return across ? Crossing::across : Crossing::unknown;
}

/// All of time, halved where it does not tell.
template <std::size_t Count>
Verdict search(const Figures<Count>& f, const Cubic& cubic, double bound) {
  struct Piece {
    double from, to;
  };
  std::array<Piece, 48> waiting;  // halves that come later: one for each size
  std::size_t count = 0;
  waiting[count++] = {0, 1};
  bool doubt = false;
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
    if (c == Crossing::across && changes) return Verdict::yes;
    if (tiny || t - s <= finest || steps > 80) {
      doubt = true;
      continue;
    }
    const double middle = 0.5 * (s + t);
    waiting[count++] = {middle, t};
    waiting[count++] = {s, middle};
  }
  return doubt ? Verdict::unsure : Verdict::no;
}

template <std::size_t Count>
Verdict decide(Figures<Count>& f, const Linear& normal_to, const Quadratic& product) {
  const Vec m = largest(f.differences);
  const Cubic cubic = dot(normal_to, product);
  const double bound = cubic_constant * m.x * m.y * m.z + least;
  f.bound = {cross_constant * m.y * m.z + least, cross_constant * m.z * m.x + least,
             cross_constant * m.x * m.y + least};
  return search(f, cubic, bound);
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

}  // namespace

Verdict contact_filter(MovingKind kind, std::span<const Point3, 4> p, std::span<const Point3, 4> q) {
  const auto linear = [&](std::size_t i, std::size_t j) {
    return Linear{difference(p[i], p[j]), difference(q[i], q[j])};
  };
  if (kind == MovingKind::vertex_triangle) {
    if (apart<1>(p, q)) return Verdict::no;
    Figures<3> f;
    f.differences = {linear(1, 0), linear(2, 0), linear(3, 0)};
    const auto& [a, b, c] = f.differences;
    f.sides = {cross(a, b), cross(b, c), cross(c, a)};
    return decide(f, c, f.sides[0]);
  }
  if (apart<2>(p, q)) return Verdict::no;
  Figures<4> f;
  f.differences = {linear(2, 0), linear(3, 0), linear(2, 1), linear(3, 1)};
  const auto& [ac, ad, bc, bd] = f.differences;
  f.sides = {cross(ac, ad), cross(bc, bd), cross(ac, bc), cross(ad, bd)};
  return decide(f, bc, f.sides[0]);
}

}  // namespace plumb::query::moving
