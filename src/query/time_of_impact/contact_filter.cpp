#include "query/time_of_impact/contact_filter.hpp"

#include <array>
#include <cstddef>

#include "arith/running_error.hpp"
#include "plumb/arith/lattice_integers.hpp"
#include "plumb/certify/decide.hpp"
#include "query/time_of_impact/contact_wanted.hpp"
#include "query/time_of_impact/swept_signs.hpp"

namespace plumb::query::moving {
namespace {

constexpr double finest = 0x1p-10;  // a guess: the piece of time that pays
constexpr int most_steps = 24;      // likewise

/// The sign that all of some numbers have, certainly: bit 0 where they are positive, bit 1 where negative.
constexpr unsigned either = 3;
constexpr unsigned opposite(unsigned signs) { return (signs << 1 | signs >> 1) & either; }
template <class W>
unsigned certain_sign(const W& w, const auto& x) {
  return static_cast<unsigned>(w.positive(x)) | static_cast<unsigned>(w.negative(x)) << 1;
}
template <class W, class N, std::size_t Count>
unsigned common_sign(const W& w, const std::array<N, Count>& all) {
  unsigned signs = either;
  for (const N& x : all) signs &= certain_sign(w, x);
  return signs;
}
/// Does it go from one certain sign to the other?
template <class W, class N>
bool changes_sign(const W& w, const std::array<N, 4>& b) {
  return (certain_sign(w, b[0]) & opposite(certain_sign(w, b[3]))) != 0;
}

using Floats = SweptFloats<>;
using Difference = Swept<decltype(swept_difference(std::declval<Floats&>(), {}, {}))>;
using Side = decltype(swept_side(std::declval<Difference>(), std::declval<Difference>()));
using Cubic = decltype(swept_cubic(std::declval<Difference>(), std::declval<Side>()));
using CubicPiece = decltype(piece_of(std::declval<Cubic>(), 0, 0));

/// Three differences and sides for a triangle, four for two edges.
template <std::size_t Count>
struct Figures {
  Floats w;
  std::array<Difference, Count> differences;
  std::array<Side, Count> sides;
};

double interpolated(double a, double b, double t) { return (1 - t) * a + t * b; }
double smaller(double a, double b) { return a < b ? a : b; }
double larger(double a, double b) { return a > b ? a : b; }

/// Along one axis, over a piece.
template <std::size_t Count>
Crossing crossing(const Figures<Count>& f, auto axis, double s, double t) {
  std::array<unsigned, Count> side{};
  for (std::size_t i = 0; i < Count; ++i) side[i] = common_sign(f.w, piece_of(f.sides[i].*axis, s, t));
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
  for (const Crossing c : {crossing(f, &Side::x, s, t), crossing(f, &Side::y, s, t), crossing(f, &Side::z, s, t)}) {
    if (c == Crossing::apart) return c;
    across |= c == Crossing::across;
  }
  return across ? Crossing::across : Crossing::unknown;
}

/// The part of time in which the cubic has exactly one root, if its coefficients there say so.
std::optional<Bracket> bracket_of(const Floats& w, const CubicPiece& piece, double from, double to) {
  if (!changes_sign(w, piece)) return {};
  const std::array certain{piece[1] - piece[0], piece[2] - piece[1], piece[3] - piece[2]};
  if (common_sign(w, certain) == 0) return {};
  const auto size = [](double x) { return __builtin_fabs(x); };
  const std::array b{piece[0].value, piece[1].value, piece[2].value, piece[3].value};
  const std::array steps{certain[0].value, certain[1].value, certain[2].value};
  const double width = to - from;
  double x = b[0] / (b[0] - b[3]), slope = 0;
  for (int i = 0; i < 5; ++i) {  // a guess
    slope = interpolated(interpolated(steps[0], steps[1], x), interpolated(steps[1], steps[2], x), x);
    const auto of_three = [&](std::size_t k) {
      return interpolated(interpolated(b[k], b[k + 1], x), interpolated(b[k + 1], b[k + 2], x), x);
    };
    x -= interpolated(of_three(0), of_three(1), x) / (3 * slope);
    x = x > 0 ? smaller(x, 1) : 0;
  }
  // Thrice the least step that is possible, of six times the cubic.
  const double step = smaller(size(steps[0]), smaller(size(steps[1]), size(steps[2])));
  const Running off = Running::rounded(step, w.doubt<std::remove_cvref_t<decltype(certain[0])>::track>());
  const double least = quotient(Interval(off.lower()) * Interval(0.5), Interval(to) - Interval(from)).lower;
  if (!(least > 0)) return {};
  return Bracket{from, to, from + x * width, 0.5 * slope / width, least};
}

/// At the one root in a piece: over a part of it so short that the cubic's sign at its ends is just certain.
template <std::size_t Count>
Crossing crossing_near_root(const Figures<Count>& f, const Cubic& cubic, const Bracket& b) {
  const double doubt = f.w.template doubt<CubicPiece::value_type::track>();
  constexpr double ulp = 0x1p-52;                                  // of the guess
  double reach = doubt / __builtin_fabs(b.slope) + b.guess * ulp;  // a guess: six times the cubic, and more
  for (int i = 0; i < 2; ++i, reach *= 16) {
    const double from = larger(b.guess - reach, b.from), to = smaller(b.guess + reach, b.to);
    if (changes_sign(f.w, piece_of(cubic, from, to))) return crossing(f, from, to);
  }
  return Crossing::unknown;
}

/// Along the axis that shows the figures largest.
template <std::size_t Count>
Crossing crossing_at_root(const Figures<Count>& f, const ContactAtRoot& close, const Ball& time) {
  const double t = time.high;  // a guess
  const auto size_along = [&](auto axis) {
    const auto at = [&](std::size_t i) {
      const auto& c = f.sides[i].*axis;
      return interpolated(interpolated(c[0].value, c[1].value, t), interpolated(c[1].value, c[2].value, t), t);
    };
    return __builtin_fabs(Count == 3 ? at(0) + at(1) + at(2) : at(0) - at(1));
  };
  const std::array size{size_along(&Side::x), size_along(&Side::y), size_along(&Side::z)};
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
FilteredContact search(const Figures<Count>& f, const Cubic& cubic, const ContactQuestion& question) {
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
    const CubicPiece b = piece_of(cubic, s, t);
    if (common_sign(f.w, b) != 0) continue;
    const bool tells =
        (certain_sign(f.w, b[0]) | certain_sign(f.w, b[1]) | certain_sign(f.w, b[2]) | certain_sign(f.w, b[3])) != 0;
    const Crossing c = crossing(f, s, t);
    if (c == Crossing::apart) continue;
    const bool changes = changes_sign(f.w, b);
    if (asked == ContactWanted::whether && c == Crossing::across && changes) return {ContactVerdict::yes, {}};
    if (changes) {
      if (const auto bracket = bracket_of(f.w, b, s, t)) {
        Crossing there = c == Crossing::across ? c : crossing_near_root(f, cubic, *bracket);
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
    if (!tells || t - s <= finest || steps > most_steps) {
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

Side side(const Figures<3>& f, std::size_t i) { return swept_side(f.differences[i], f.differences[(i + 1) % 3]); }
Side side(const Figures<4>& f, std::size_t i) {  // of the differences ac, ad, bc, bd
  constexpr std::array<std::size_t, 4> left{0, 2, 0, 1}, right{1, 3, 2, 3};
  return swept_side(f.differences[left[i]], f.differences[right[i]]);
}

template <ContactWanted asked, std::size_t Count>
FilteredContact decide(Figures<Count>& f, const ContactQuestion& question) {
  const auto linear = [&](std::size_t i, std::size_t j) {
    return Swept{swept_difference(f.w, question.at_0[i], question.at_0[j]),
                 swept_difference(f.w, question.at_1[i], question.at_1[j])};
  };
  // The cubic takes three differences.
  constexpr bool edges = Count == 4;
  f.differences[0] = edges ? linear(2, 0) : linear(1, 0);
  f.differences[1] = edges ? linear(3, 0) : linear(2, 0);
  f.differences[2] = edges ? linear(2, 1) : linear(3, 0);
  f.sides[0] = side(f, 0);
  const Cubic cubic = swept_cubic(f.differences[2], f.sides[0]);
  if (!f.w.certain()) return {ContactVerdict::unsure, {}};
  if (common_sign(f.w, cubic) != 0) return {ContactVerdict::no, {}};
  if constexpr (edges) f.differences[3] = linear(3, 1);
  if (edges && !f.w.certain()) return {ContactVerdict::unsure, {}};
  for (std::size_t i = 1; i < Count; ++i) f.sides[i] = side(f, i);
  // In one plane at an end of time: no piece around that root would ever do.
  const auto meet_at = [&](const auto& coefficient, std::span<const Point3, 4> p, double time) {
    return certain_sign(f.w, coefficient) == 0 && crossing(f, time, time) == Crossing::across && coplanar(p);
  };
  if (meet_at(cubic[0], question.at_0, 0)) return {ContactVerdict::yes, Ball{0}};
  if (asked == ContactWanted::whether && meet_at(cubic[3], question.at_1, 1)) return {ContactVerdict::yes, {}};
  return search<asked>(f, cubic, question);
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
