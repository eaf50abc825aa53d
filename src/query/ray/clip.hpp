// Ray cast, slab test: when does a line enter a convex set that is given by halfspaces, and one quadric at the most?
//
// A model is such a set: size() constraints linear<T>(line, i), a feature for the constraints that are tight, a normal
// for each; perhaps a quadratic<T>(line).
// Laws: decided in any numbers; where a sign was not certain the answer means nothing.  A model with
// `feature_by_point` is told the point as well.
// Source: RTCD 5.3.3, 5.3.8 (figures 5.23, 5.27), 5.3.2, 5.3.7.
// Cost: a comparison of quotients for each constraint.
#pragma once

#include <vector>

#include "plumb/certify/radical.hpp"
#include "query/ray/shot.hpp"

namespace plumb::query {

template <class T>
struct End {
  bool is = false;
  Time<T> time = time_zero<T>();
  When when;
};

/// The parameters that are left.
template <class T>
struct Remaining {
  End<T> lower, upper;

  explicit Remaining(const AnyRay& ray) {
    lower.is = begins(ray);
    if (ends(ray)) upper = {true, {T(1.0), T(1.0)}, {}};
  }

  /// False where nothing is left for certain.
  bool cut(const Linear<T>& c, std::uint32_t index, RaySigns& ask) {
    const Sign slope = ask(c.slope);
    if (slope == Sign::zero) return ask(c.constant) != Sign::positive;
    const When when{When::At::quotient, index, 0};
    if (slope == Sign::negative) {
      const End<T> end{true, {c.constant, T(0.0) - c.slope}, when};
      const bool later =
          !lower.is ||
          (lower.when.at == When::At::zero ? ask(c.constant) : compare(end.time, lower.time, ask)) == Sign::positive;
      if (later) lower = end;
    } else {
      const End<T> end{true, {T(0.0) - c.constant, c.slope}, when};
      if (!upper.is || compare(end.time, upper.time, ask) == Sign::negative) upper = end;
    }
    return true;
  }

  bool is_empty(RaySigns& ask) const {
    return lower.is && upper.is && compare(lower.time, upper.time, ask) == Sign::positive;
  }

  /// The least that is left, or that nearest to zero.
  When first(RaySigns& ask) const {
    if (lower.is) return lower.when;
    return upper.is && ask(upper.time.numerator) == Sign::negative ? upper.when : When{};
  }
};

/// The quadratic's value at n / d, times d^2.
template <class T>
T value_at(const Quadratic<T>& q, const Time<T>& t) {
  return (q.square * t.numerator + (q.half + q.half) * t.denominator) * t.numerator +
         q.constant * t.denominator * t.denominator;
}

/// When the quadratic's interval is entered among what is left: at the lower end of that, or at the lesser root.
template <class T>
std::optional<When> enter(const Quadratic<T>& q, const Remaining<T>& left, std::uint32_t index, RaySigns& ask) {
  if (left.is_empty(ask)) return {};
  if (ask(q.square) == Sign::zero) {  // then `half` is zero as well
    if (ask(q.constant) == Sign::positive) return {};
    return left.first(ask);
  }
  const auto slope_at = [&](const Time<T>& t) { return ask(q.square * t.numerator + q.half * t.denominator); };
  if (left.lower.is) {
    const bool at_zero = left.lower.when.at == When::At::zero;
    if (ask(at_zero ? q.constant : value_at(q, left.lower.time)) != Sign::positive) return left.lower.when;
    if ((at_zero ? ask(q.half) : slope_at(left.lower.time)) != Sign::negative) return {};
  }
  if (ask(q.discriminant) == Sign::negative) return {};
  if (left.upper.is && slope_at(left.upper.time) == Sign::negative &&
      ask(value_at(q, left.upper.time)) == Sign::positive)
    return {};
  return When{When::At::root, index, 0};
}

/// The sign of constant + slope t at the lesser root, times its denominator.
template <class T>
Sign sign_at_root(const Linear<T>& c, const Quadratic<T>& q, RaySigns& ask) {
  const T straight = c.constant * q.square - c.slope * q.half;
  return certify::radical::sum(ask(straight), -ask(c.slope) * ask(q.discriminant),
                               [&] { return ask(straight * straight - c.slope * c.slope * q.discriminant); });
}

/// The sign of constant + slope t, where t is zero, a quotient or the lesser root.
template <class T>
Sign sign_at(const Linear<T>& c, const When& when, const Time<T>& time, const Quadratic<T>* q, RaySigns& ask) {
  switch (when.at) {
    case When::At::zero:
      return ask(c.constant);
    case When::At::quotient:
      return ask(c.constant * time.denominator + c.slope * time.numerator);
    default:
      return sign_at_root(c, *q, ask);
  }
}

template <class Model>
concept HasQuadratic = requires(const Model& m, const ShotLine<Ball>& line) {
  m.template quadratic<Ball>(line);
};

/// Models whose features need the point.
template <class Model>
concept FeatureByPoint = Model::feature_by_point;

template <class T, class Model>
std::optional<Decided> clip(const ShotLine<T>& line, const Model& model, RaySigns& ask) {
  const auto size = static_cast<std::uint32_t>(model.size());
  std::vector<Linear<T>> linear;
  linear.reserve(size);
  Remaining<T> left(line.ray);
  for (std::uint32_t i = 0; i < size; ++i) {
    linear.push_back(model.template linear<T>(line, i, ask));
    if (!left.cut(linear.back(), i, ask)) return {};
  }
  if (left.is_empty(ask)) return {};
  std::optional<When> when;
  std::optional<Quadratic<T>> quadratic;
  std::vector<std::uint32_t> tight;
  if constexpr (HasQuadratic<Model>) {
    quadratic = model.template quadratic<T>(line);
    when = enter(*quadratic, left, size, ask);
  } else {
    when = left.first(ask);
  }
  if (!when) return {};
  // Of what is a quotient the constraint is known.
  Time<T> time = time_zero<T>();
  if (when->at == When::At::quotient) {
    const Linear<T>& c = linear[when->index];
    time = with_positive_denominator(c.constant, T(0.0) - c.slope, -ask(c.slope));
  }
  Decided decided{*when, {FeatureKind::interior, 0}, false, 0};
  bool faced = false;
  const auto note = [&](std::uint32_t index, bool faces) {
    tight.push_back(index);
    if (!decided.has_normal || (faces && !faced)) decided.normal = index;
    decided.has_normal = true;
    faced = faced || faces;
  };
  for (std::uint32_t i = 0; i < size; ++i) {
    const bool known = when->at == When::At::quotient && when->index == i;
    if (known || sign_at(linear[i], *when, time, quadratic ? &*quadratic : nullptr, ask) == Sign::zero)
      note(i, ask(linear[i].slope) == Sign::negative);
  }
  if (quadratic) {
    const bool root = when->at == When::At::root;
    if (root || ask(value_at(*quadratic, time)) == Sign::zero)
      note(size, root ? ask(quadratic->discriminant) == Sign::positive
                      : ask(quadratic->square * time.numerator + quadratic->half * time.denominator) == Sign::negative);
  }
  if (tight.empty()) return decided;
  if constexpr (FeatureByPoint<Model>) {
    decided.feature = model.feature(line, time, tight, ask);
  } else {
    decided.feature = model.feature(tight);
  }
  return decided;
}

}  // namespace plumb::query
