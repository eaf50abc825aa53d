// Time of impact: when exactly do two features come as near as a distance, given about when?  Pairs of doubles.
//
// Laws: a yes is certain.  During a short piece of time at whose beginning the figures are farther apart and at whose
// end nearer, bounds tell that one pair of features is nearest throughout and that its distance falls; so the time is
// the one zero there of a polynomial of the pair, between two times at which pairs of doubles tell its signs.
// Source: RTCD 5.5; Ziv 1991 (arith/ball.hpp).
// Cost: some 3 us.
#pragma once

#include <cmath>
#include <optional>

#include "query/time_of_impact/moving_hulls.hpp"
#include "query/time_of_impact/quick_corner.hpp"
#include "query/time_of_impact/separation_filter.hpp"

namespace plumb::query::moving {

using quick::Corner, quick::Parts, quick::ExtremeFace;

template <template <class> class Figures>
class NearFeatures {
 public:
  NearFeatures(const Parts& of_a, const Parts& of_b)
      : a(quick::place_of<typename Figures<double>::HullA>(of_a)),
        b(quick::place_of<typename Figures<double>::HullB>(of_b)) {}

  [[nodiscard]] bool few() const { return a.inside_count + b.inside_count <= 2; }
  template <class N>
  [[nodiscard]] Corner<N> corner(const Figures<N>& f, const auto& when) const {
    return Corner<N>(when(f.apart), f.hull_a(when), f.hull_b(when), a, b);
  }
  [[nodiscard]] NearContact at(double time) const { return {ContactVerdict::yes, {time, a.feature, b.feature}}; }

 private:
  ExtremeFace a, b;
};

/// The square of the distance less the limit, times what it takes to divide by nothing.
template <class N>
N excess(const Corner<N>& c, const N& limit) {
  if (c.inside_count == 0) return dot(c.at, c.at) - limit;
  if (c.inside_count == 1) {
    const Vec3<N> n = cross(c.at, c.inside[0]);
    return dot(n, n) - limit * dot(c.inside[0], c.inside[0]);
  }
  const Vec3<N> n = cross(c.inside[0], c.inside[1]);
  const N gap = dot(c.at, n);
  return gap * gap - limit * dot(n, n);
}

struct TimePiece {
  double from, to;
};

/// The zero of a function that falls through it in the piece: a guess by Newton's method, and signs on both sides.
template <class Function>
std::optional<Ball> falling_zero(const Function& f, const TimePiece& piece) {
  // Guesses at where to stop, how wide to take the slope, and what is left then, as parts of the time.
  constexpr double still = 0x1p-50, wide = 0x1p-16, enough = 0x1p-90, least = 0x1p-100;
  const auto size = [](double x) { return __builtin_fabs(x); };
  const auto within = [&](double t) { return std::fmin(std::fmax(t, piece.from), piece.to); };
  double t = piece.from, slope = (f(piece.to) - f(piece.from)) / (piece.to - piece.from);
  constexpr int steps = 12;
  for (int i = 0; i < steps; ++i) {
    const double next = within(t - f(t) / slope), step = next - t;
    t = next;
    if (!(size(step) > size(t) * still)) break;
  }
  const double h = (piece.to - piece.from) * wide, below = within(t - h), above = within(t + h);
  slope = (f(above) - f(below)) / (above - below);
  Ball zero(t);
  double left = 0;
  for (int i = 0; i < 4; ++i) {
    const Ball there = f(zero);
    left = (size(there.high) + there.radius) / size(slope);
    if (!(left < 1)) return {};
    if (left < size(zero.high) * enough) break;
    zero = zero - Ball((there.high + there.low) / slope);
    zero.radius = 0;  // whichever number that is
  }
  const double off = 8 * left + size(zero.high) * least;  // the last guess
  Ball before = zero - Ball(off), after = zero + Ball(off);
  before.radius = after.radius = 0;
  if (!(before.high > piece.from && after.high < piece.to)) return {};
  if (certain_sign(f(before)) <= 0 || certain_sign(f(after)) >= 0) return {};
  zero.radius = std::fmax(most_of(zero - before), most_of(after - zero));
  return zero;
}

template <template <class> class Figures>
NearContact first_contact_within(const ContactQuestion& question, double separation, const TimePiece& piece,
                                 const Parts& of_a, const Parts& of_b) {
  const NearFeatures<Figures> features(of_a, of_b);
  if (!features.few()) return {};
  const double middle = 0.5 * (piece.from + piece.to);
  const Figures<Running> bounds(question);
  const auto nearest = features.corner(bounds, Span<Running>{{middle, 0.5 * (piece.to - piece.from)}}).nearest();
  if (!nearest) return {};
  const Corner<Running> change = features.corner(bounds, Change{});
  const Vec3<Running> way = change.at * nearest->whole + change.inside[0] * nearest->x + change.inside[1] * nearest->y;
  if (certain_sign(dot(nearest->direction, way)) >= 0) return {};
  const Figures<double> quick(question);
  const Figures<Ball> precise(question);
  const auto of_pair = [&]<class N>(const N& time) {
    const auto limit = [&] { return N(separation) * N(separation); };
    if constexpr (std::is_same_v<N, double>) {
      return excess(features.corner(quick, Span<double>{time}), limit());
    } else {
      return excess(features.corner(precise, Span<Ball>{time}), limit());
    }
  };
  const std::optional<Ball> time = falling_zero(of_pair, piece);
  const std::optional<double> down = time ? time->rounded(Rounding::down) : std::nullopt;
  return down ? features.at(*down) : NearContact{};
}

/// The features that are nearest at time 0, where they are near enough.
template <template <class> class Figures>
NearContact contact_at_start(const Figures<Approximate>& sure, const Parts& of_a, const Parts& of_b) {
  const NearFeatures<Figures> features(of_a, of_b);
  return features.few() && features.corner(sure, Moment{0}).nearest() ? features.at(0) : NearContact{};
}

}  // namespace plumb::query::moving
