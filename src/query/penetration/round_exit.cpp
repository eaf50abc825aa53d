#include "query/penetration/round_exit.hpp"

#include "query/penetration/furthest.hpp"
#include "query/separation/exact_corners.hpp"

namespace plumb::query::parting {
namespace {

using certify::QuadraticNumber;

/// A double that holds no bound: for the guess.
struct Guessed {
  double value;

  explicit Guessed(double x) : value(x) {}
  [[nodiscard]] Sign sign() const { return sign_of_number(value); }
  friend Guessed operator+(Guessed a, Guessed b) { return Guessed(a.value + b.value); }
  friend Guessed operator-(Guessed a, Guessed b) { return Guessed(a.value - b.value); }
  friend Guessed operator*(Guessed a, Guessed b) { return Guessed(a.value * b.value); }
};

/// over / under, under above zero.
template <class T>
struct Radius {
  T over, under;
};

/// Of the affine hull of up to three corners; nothing where it has no exit, or the corners are dependent.  With r the
/// radius: of a point w |d|^2 r^2 - |d x w|^2 is under the root; of a line the same of what is left of d and w beside
/// it; of a plane its height is r away.
template <class T>
std::optional<ExitTime<T>> exit_time(const std::array<Vec<T>, 4>& at, std::size_t size, const Vec<T>& d,
                                     const Radius<T>& r) {
  const T zero(0.0), over = r.over * r.over, under = r.under * r.under;
  const Vec<T>& w = at[0];
  std::optional<ExitTime<T>> e;
  if (size == 1) {
    const Vec<T> aside = cross(d, w);
    e = {zero - dot(d, w) * r.under, dot(d, d) * over - dot(aside, aside) * under, dot(d, d) * r.under};
  } else if (size == 2) {
    const Vec<T> u = at[1] - w, across = cross(d, u), from = cross(w, u);
    const T volume = dot(d, from);
    e = {zero - dot(across, from) * r.under, dot(u, u) * (dot(across, across) * over - volume * volume * under),
         dot(across, across) * r.under};
  } else {
    const Vec<T> normal = cross(at[1] - w, at[2] - w);
    const T along = dot(normal, d), height = dot(normal, w);
    const bool is_back = along.sign() == Sign::negative;
    e = {(is_back ? height : zero - height) * r.under, dot(normal, normal) * over,
         (is_back ? zero - along : along) * r.under};
  }
  if (e->whole.sign() != Sign::positive || e->radicand.sign() == Sign::negative) return {};
  return e;
}

/// A time as quotient of two numbers.
template <class Q>
struct Place {
  Q times, whole;
};
Place<QuadraticNumber> place_at(const ExitTime<BigDyadic>& e) {
  return {QuadraticNumber(e.before, BigDyadic(1.0), e.radicand), QuadraticNumber(e.whole)};
}
Place<Guessed> place_at(const ExitTime<Guessed>& e) {
  return {Guessed(e.before.value + __builtin_sqrt(e.radicand.value)), e.whole};
}

template <class T, class Q>
struct Exit {
  DifferenceCorners corners;
  std::shared_ptr<const ExitTime<T>> time;
  Vec<Q> normal;
};

/// The exit from the hull of up to four corners.  Of every face of theirs it is asked whether the place is nearest to
/// it.
template <class T, class Q>
std::optional<Exit<T, Q>> exit_of(const Difference& of, const DifferenceCorners& all, const Vector3& direction,
                                  const Radius<T>& radius) {
  const unsigned end = 1u << all.size;
  const std::array<Vec<T>, 4> at = differences_of<T>(of.a, of.b, all);
  const std::array<Vec<Q>, 4> seen = differences_of<Q>(of.a, of.b, all);
  for (int size = std::min(3, static_cast<int>(all.size)); size > 0; --size) {
    for (unsigned mask = 1; mask < end; ++mask) {
      if (std::popcount(mask) != size) continue;
      std::array<Vec<T>, 4> part{no_way<T>(), no_way<T>(), no_way<T>(), no_way<T>()};
      for (std::size_t i = 0, k = 0; i < all.size; ++i) {
        if ((mask >> i & 1) != 0) part[k++] = at[i];
      }
      const auto of_part = static_cast<std::size_t>(size);
      const auto found = exit_time(part, of_part, arith::vec<T>(direction), radius);
      if (!found) continue;
      const auto time = std::make_shared<const ExitTime<T>>(*found);
      const Place<Q> place = place_at(*time);
      const Vec<Q> by = arith::vec<Q>(direction) * place.times;
      const auto from_place = [&](std::size_t i) { return seen[i] * place.whole + by; };
      std::array<Vec<Q>, 4> beside{no_way<Q>(), no_way<Q>(), no_way<Q>(), no_way<Q>()};
      for (std::size_t i = 0, k = 0; i < all.size; ++i) {
        if ((mask >> i & 1) != 0) beside[k++] = from_place(i);
      }
      CertainSigns ask;
      const NearestOfCorners<Q> n = nearest_of<Q>(beside, of_part, ask);
      bool is_nearest = is_within(n, of_part, ask);
      for (std::size_t i = 0; i < all.size && is_nearest; ++i) {
        if ((mask >> i & 1) == 0) is_nearest = dot(n.way, from_place(i) - beside[0]).sign() != Sign::negative;
      }
      if (is_nearest) return Exit<T, Q>{all.part(mask), time, turned_round(n.way)};
    }
  }
  return {};
}

bool has(const DifferenceCorners& corners, const Ends& e) {
  return std::find(corners.ends.begin(), corners.ends.begin() + corners.size, e) !=
         corners.ends.begin() + static_cast<std::ptrdiff_t>(corners.size);
}

DifferenceCorners guessed_exit(const Difference& d, const Vector3& direction, double radius,
                               DifferenceCorners corners) {
  constexpr int most_rounds = 64;
  for (int round = 0; round < most_rounds; ++round) {
    const auto found = exit_of<Guessed, Guessed>(d, corners, direction, {Guessed(radius), Guessed(1)});
    if (!found) return corners;
    corners = found->corners;
    const arith::Plain n{found->normal.x.value, found->normal.y.value, found->normal.z.value};
    const Ends &from = corners.ends[0], e{guessed_furthest(d.a, n, from[0]), guessed_furthest(d.b, n * -1, from[1])};
    if (has(corners, e) || !(dot(n, d.at<double>(e) - d.at<double>(from)) > 0)) return corners;
    corners.add(e);
  }
  return corners;
}

}  // namespace

RoundExit round_exit(const Difference& d, const Vector3& direction, const mpq_class& radius,
                     const DifferenceCorners& around) {
  const Radius<BigDyadic> r{BigDyadic(radius.get_num()), BigDyadic(radius.get_den())};
  const auto exit_from = [&](const DifferenceCorners& corners) {
    return exit_of<BigDyadic, QuadraticNumber>(d, corners, direction, r);
  };
  auto found = exit_from(guessed_exit(d, direction, radius.get_d(), around));
  if (!found) found = exit_from(around);
  for (;;) {  // ends: each leaves later
    const Ends from = found->corners.ends[0];
    CertainSigns ask;
    const Vec<QuadraticNumber> inward = turned_round(found->normal);
    const Ends e{least_corner(d.a, from[0], inward, ask), least_corner(d.b, from[1], found->normal, ask)};
    const Vec<QuadraticNumber> way = d.at<QuadraticNumber>(e) - d.at<QuadraticNumber>(from);
    if (dot(found->normal, way).sign() != Sign::positive) {
      return {found->corners, found->time, {found->normal}};
    }
    DifferenceCorners more = found->corners;
    more.add(e);
    found = exit_from(more);
  }
}

}  // namespace plumb::query::parting
