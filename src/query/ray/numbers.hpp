// Ray cast: which doubles are the parameter, the point and the normal of a hit that is decided?  Pairs of doubles
// first, integers for those numbers that they leave in doubt.
//
// Every number is linear in the parameter; exactly it is (a + b sqrt(c)) / d, with b = 0 where the parameter is a
// quotient.
// Laws: the exact numbers rounded once, to nearest; never -0.
// Source: Ziv 1991.
// Cost: some 20 ns a number; microseconds in doubt.
#pragma once

#include <array>

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/figure_input.hpp"
#include "query/ray/clip.hpp"
#include "query/ray/quick_hit.hpp"

namespace plumb::query {

/// (a + b sqrt(c)) / d.
template <class T>
struct Form {
  T a, b, c, d;
};
template <class T>
Form<T> quotient_form(const T& a, const T& d) {
  return {a, T(0.0), T(0.0), d};
}

/// (still + moving t) / divisor, where it moves at all.
template <class T>
struct NormalForm {
  Vec3<T> still, moving;
  T divisor;
  bool moves;
};
template <class T>
NormalForm<T> still_normal(const Vec3<T>& n) {
  return {n, n, T(1.0), false};
}

/// Of a facet met by its plane: when, and its normal, which both take the same products.
template <class T>
struct PlaneMeeting {
  Time<T> time;
  Vec3<T> normal;
};

/// The quotient at which a model's constraint or facet is met.
template <class T, class Model>
Time<T> time_of(const ShotLine<T>& line, const Model& model, const When& when, RaySigns& ask) {
  if (when.at == When::At::zero) return time_zero<T>();
  if constexpr (requires { model.template time<T>(line, when, ask); }) {
    return model.template time<T>(line, when, ask);
  } else if constexpr (requires { model.template linear<T>(line, when.index, ask); }) {
    const Linear<T> c = model.template linear<T>(line, when.index, ask);
    return {T(0.0) - c.constant, c.slope};
  } else {
    return time_zero<T>();  // of what has no quotients
  }
}

template <class T, class Model>
Quadratic<T> quadratic_of(const ShotLine<T>& line, const Model& model, const When& when) {
  if constexpr (requires { model.template quadratic<T>(line, when); }) {
    return model.template quadratic<T>(line, when);
  } else if constexpr (HasQuadratic<Model>) {
    return model.template quadratic<T>(line);
  } else {
    return {T(1.0), T(0.0), T(0.0), T(0.0)};
  }
}

/// t, the point, the normal.
template <class T>
using Forms = std::array<Form<T>, 7>;

template <class T, class Model>
Forms<T> forms_of(const AnyRay& ray, const Model& model, const Decided& decided, RaySigns& ask) {
  const ShotLine<T> line(ray);
  const bool root = decided.when.at == When::At::root;
  // base + by t, over `divisor`.
  const Time<T> time = root ? time_zero<T>() : time_of<T>(line, model, decided.when, ask);
  const Quadratic<T> q =
      root ? quadratic_of<T>(line, model, decided.when) : Quadratic<T>{T(0.0), T(0.0), T(0.0), T(0.0)};
  const auto at = [&](const T& base, const T& by, const T& divisor) -> Form<T> {
    if (root) return {base * q.square - by * q.half, T(0.0) - by, q.discriminant, q.square * divisor};
    return quotient_form<T>(base * time.denominator + by * time.numerator, time.denominator * divisor);
  };
  const Vec3<T> o = vector_of<T>(ray.origin), &d = line.direction;
  const T zero(0.0), one(1.0);
  const Form<T> none = quotient_form(zero, one);
  Forms<T> all{at(zero, one, one), at(o.x, d.x, one), at(o.y, d.y, one), at(o.z, d.z, one), none, none, none};
  if (decided.has_normal) {
    const NormalForm<T> n = model.template normal<T>(line, decided, ask);
    const std::array<const T*, 3> still{&n.still.x, &n.still.y, &n.still.z},
        moving{&n.moving.x, &n.moving.y, &n.moving.z};
    for (std::size_t i = 0; i < 3; ++i)
      all[4 + i] = n.moves ? at(*still[i], *moving[i], n.divisor) : quotient_form(*still[i], n.divisor);
  }
  return all;
}

/// With a positive divisor.
inline double nearest(const Form<BigDyadic>& f) {
  if (f.d.sign() == Sign::positive) return rounded_radical(Rounding::nearest, f.a, f.b, f.c, f.d);
  const BigDyadic zero(0.0);
  return rounded_radical(Rounding::nearest, zero - f.a, zero - f.b, f.c, zero - f.d);
}

/// Coordinates of the point that are known without computing.
using Known = std::array<std::optional<double>, 3>;

inline Known known_of(const AnyRay& ray, const When& when) {
  const auto& o = ray.origin;
  if (when.at == When::At::zero) return {o.x, o.y, o.z};
  const bool by_end = ends(ray);
  Known known;
  if (by_end ? ray.end.x == o.x : ray.direction.x == 0) known[0] = o.x;
  if (by_end ? ray.end.y == o.y : ray.direction.y == 0) known[1] = o.y;
  if (by_end ? ray.end.z == o.z : ray.direction.z == 0) known[2] = o.z;
  return known;
}

/// The parameter as a pair of doubles; every other number is linear in it.
template <class Model>
class QuickNumbers {
 public:
  QuickNumbers(const AnyRay& ray, const Model& model, const Decided& decided)
      : line_(ray), model_(model), decided_(decided) {
    if (decided.when.at == When::At::root) {
      const Quadratic<Ball> q = quadratic_of<Ball>(line_, model, decided.when);
      t_ = quotient(Ball{0} - q.half - root(q.discriminant), q.square);
      return;
    }
    if constexpr (requires { model.template plane_meeting<Ball>(line_, decided); }) {
      if (auto meeting = model.template plane_meeting<Ball>(line_, decided)) {
        time_ = meeting->time, normal_ = meeting->normal;
        t_ = quotient(time_.numerator, time_.denominator);
        return;
      }
    }
    time_ = time_of<Ball>(line_, model, decided.when, ask_);
    t_ = quotient(time_.numerator, time_.denominator);
  }

  [[nodiscard]] std::optional<double> parameter() const { return sure(t_); }
  [[nodiscard]] std::optional<double> coordinate(double origin, const Ball& along) const {
    if (const auto x = sure(Ball{origin} + along * t_)) return x;
    // Zeros, which no pair of doubles near to them proves.
    const Ball weighted = Ball{origin} * time_.denominator + along * time_.numerator;
    if (decided_.when.at == When::At::root || weighted.radius != 0) return {};
    return sure(quotient(weighted, time_.denominator));
  }
  [[nodiscard]] std::array<std::optional<double>, 3> normal() const {
    if (!decided_.has_normal) return {0.0, 0.0, 0.0};
    if (normal_) return {sure(normal_->x), sure(normal_->y), sure(normal_->z)};
    RaySigns ask;
    const NormalForm<Ball> n = model_.template normal<Ball>(line_, decided_, ask);
    if (!ask.certain()) return {};
    const auto part = [&](const Ball& still, const Ball& moving) {
      return sure(n.moves ? quotient(still + moving * t_, n.divisor) : still);
    };
    return {part(n.still.x, n.moving.x), part(n.still.y, n.moving.y), part(n.still.z, n.moving.z)};
  }
  /// Around the parameter.
  [[nodiscard]] std::optional<Interval> range() const {
    const Interval around = Interval{t_.high} + Interval{t_.low} + Interval{-t_.radius, t_.radius};
    if (!ask_.certain() || !(t_.radius < Ball::infinity)) return {};
    return around;
  }
  [[nodiscard]] const Vec3<Ball>& direction() const { return line_.direction; }

 private:
  [[nodiscard]] std::optional<double> sure(const Ball& x) const {
    return ask_.certain() ? x.nearest() : std::optional<double>{};
  }

  ShotLine<Ball> line_;
  const Model& model_;
  const Decided& decided_;
  RaySigns ask_;
  Time<Ball> time_ = time_zero<Ball>();
  Ball t_{0};
  std::optional<Vec3<Ball>> normal_;  // where it was needed for the time
};

template <class Model>
Hit numbers_of(const AnyRay& ray, const Model& model, const Decided& decided) {
  Known known = known_of(ray, decided.when);
  if constexpr (requires { model.know(decided, known); }) model.know(decided, known);
  QuickHit pairs{};
  if constexpr (requires { model.quick(ray, decided); }) pairs = model.quick(ray, decided);
  std::optional<QuickNumbers<Model>> quick;  // where pairs leave a doubt
  const auto sharper = [&]() -> const QuickNumbers<Model>& {
    if (!quick) quick.emplace(ray, model, decided);
    return *quick;
  };
  std::optional<Forms<BigDyadic>> exact;
  const auto sure_or = [&](const std::optional<double>& x, std::size_t i) {
    if (x) return *x + 0.0;
    RaySigns ask;
    if (!exact) exact = forms_of<BigDyadic>(ray, model, decided, ask);
    return nearest((*exact)[i]);
  };
  const auto coordinate = [&](std::size_t i, double origin, Ball Vec3<Ball>::*along) {
    if (known[i]) return *known[i] + 0.0;
    if (pairs[1 + i]) return *pairs[1 + i];
    return sure_or(sharper().coordinate(origin, sharper().direction().*along), 1 + i);
  };
  const Point3& o = ray.origin;
  const double t = pairs[0] ? *pairs[0] : sure_or(sharper().parameter(), 0);
  const Point3 point{coordinate(0, o.x, &Vec3<Ball>::x), coordinate(1, o.y, &Vec3<Ball>::y),
                     coordinate(2, o.z, &Vec3<Ball>::z)};
  std::array<std::optional<double>, 3> normal{pairs[4], pairs[5], pairs[6]};
  if (!(normal[0] && normal[1] && normal[2])) normal = sharper().normal();
  return {t, point, decided.feature, {sure_or(normal[0], 4), sure_or(normal[1], 5), sure_or(normal[2], 6)}};
}

/// Over numbers that are exact.
template <class T, class Model>
RayParameter parameter_of(const ShotLine<T>& line, const Model& model, const Decided& decided) {
  if (decided.when.at == When::At::zero) return {};
  if (decided.when.at == When::At::root) {
    const Quadratic<T> q = quadratic_of<T>(line, model, decided.when);
    const Rational square = exact_number(q.square);
    return {-exact_number(q.half) / square, exact_number(q.discriminant) / (square * square),
            square.sign() == Sign::negative};
  }
  RaySigns ask;
  const Time<T> t = time_of<T>(line, model, decided.when, ask);
  return {exact_number(t.numerator) / exact_number(t.denominator)};
}
template <class Model>
RayParameter parameter_of(const AnyRay& ray, const Model& model, const Decided& decided) {
  if (decided.when.at == When::At::zero) return {};
  return parameter_of(ShotLine<BigDyadic>(ray), model, decided);
}

/// A Hit, a RayParameter, or what is decided as it is.
template <class Answer, class Model>
std::optional<Answer> answer(const AnyRay& ray, const Model& model, const std::optional<Decided>& decided) {
  if (!decided) return {};
  if constexpr (std::is_same_v<Answer, Decided>) {
    return decided;
  } else if constexpr (std::is_same_v<Answer, Hit>) {
    return numbers_of(ray, model, *decided);
  } else {
    return parameter_of(ray, model, *decided);
  }
}

/// Throws as query/body/figure_input.hpp says; the ray is a segment or a line where it was given as one.
void require_ray(std::string_view function, const AnyRay& ray, const FigureView& shape);
void require_ray(std::string_view function, const AnyRay& ray);
void require_ray(std::string_view function, const AnyRay& ray, const Ellipsoid3& ellipsoid);

inline bool is_sound(const AnyRay& ray) {
  return is_real(sum_of(ray.origin) + sum_of(ray.direction) + sum_of(ray.end));
}

template <Figure Shape>
void require_ray(std::string_view function, const AnyRay& ray, const Shape& s) {
  if (!is_sound(ray) || !is_sound(s)) [[unlikely]]
    require_ray(function, ray, view_of(s));
}
/// That gives such an answer.
template <class Answer>
inline constexpr std::string_view function_of = std::is_same_v<Answer, Hit>            ? "first_hit"
                                                : std::is_same_v<Answer, RayParameter> ? "first_hit_parameter"
                                                                                       : "hits";

}  // namespace plumb::query
