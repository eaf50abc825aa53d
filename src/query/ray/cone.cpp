// Cones: the half of a double cone on one side of its apex, cut by the plane of its base.
//
// With w from the apex to the origin, e the axis from the apex to the base, and P = |e|^2, the double cone is
//   P |w x e|^2 <= r^2 (w . e)^2,
// a quadratic along the line, of any sign of its square: negative where the line runs steeper than the cone, so that it
// is in it before the one root and after the other.  Where it is not in it when it comes to the half that counts, the
// first root from there on is the lesser one of a positive square, the greater one of a negative, and both are
// (-half - sqrt(discriminant)) / square;
//   discriminant = P^2 (r^2 |e x (d x w)|^2 - P (w . (d x e))^2).
#include "query/ray/answers.hpp"
#include "query/ray/round_parts.hpp"

namespace plumb::query {
namespace {

/// Constraint 0: not before the apex; 1: not beyond the base; 2: the side, where its quadratic is linear.
struct ConeModel {
  static constexpr std::uint32_t apex = 0, base = 1, side = 2;
  const Cone3& cone;

  template <class T>
  [[nodiscard]] Vec3<T> axis() const {
    return between<T>(cone.apex, cone.base);
  }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const Vec3<T> w = line.origin_from(i == base ? cone.base : cone.apex), e = axis<T>();
    if (i == base) return {dot(w, e), dot(line.direction, e)};
    if (i == apex) return {T(0.0) - dot(w, e), T(0.0) - dot(line.direction, e)};
    const Quadratic<T> q = quadratic(line);
    return {q.constant, q.half + q.half};
  }
  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line) const {
    const Vec3<T> w = line.origin_from(cone.apex), e = axis<T>(), &d = line.direction;
    const Vec3<T> across = cross(w, e), turn = cross(d, e);
    const T r(cone.radius), rr = r * r, p = length2(e), along = dot(w, e), speed = dot(d, e), gap = dot(w, turn);
    return {p * length2(turn) - rr * speed * speed, p * dot(across, turn) - rr * along * speed,
            p * length2(across) - rr * along * along, p * p * (rr * length2(cross(e, cross(d, w))) - p * gap * gap)};
  }
  /// The way from the axis to the point, less r^2 / P of the way along the axis.
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns&) const {
    const Vec3<T> w = line.origin_from(cone.apex), e = axis<T>(), &d = line.direction;
    if (decided.normal == base) return still_normal(e);
    const T r(cone.radius), p = length2(e), lean = p + r * r;
    return {times(w, p * p) - times(e, lean * dot(w, e)), times(d, p * p) - times(e, lean * dot(d, e)), p * p, true};
  }
  void know(const Decided& decided, Known& known) const {
    if (decided.feature.kind == FeatureKind::vertex) known = {cone.apex.x, cone.apex.y, cone.apex.z};
  }
  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const;
};

/// When the line enters the cone among what is left between apex and base.
template <class T>
std::optional<When> enter_cone(const AnyRay& ray, const Quadratic<T>& q, const Remaining<T>& left, RaySigns& ask) {
  if (left.is_empty(ask)) return {};
  if (has_no_direction(ray)) return ask(q.constant) == Sign::positive ? std::nullopt : std::optional(left.first(ask));
  const Sign bend = ask(q.square);
  if (bend == Sign::positive) return enter(q, left, ConeModel::side, ask);
  // The line is not perpendicular to the axis, so that both planes cut it.
  const auto& [from, to] = left;
  if (ask(from.when.at == When::At::zero ? q.constant : value_at(q, from.time)) != Sign::positive) return from.when;
  if (ask(value_at(q, to.time)) == Sign::positive) return {};
  return When{bend == Sign::zero ? When::At::quotient : When::At::root, ConeModel::side, 0};
}

template <class T>
std::optional<Decided> ConeModel::decide(const ShotLine<T>& line, RaySigns& ask) const {
  const Linear<T> before = linear(line, apex, ask), beyond = linear(line, base, ask);
  Remaining<T> left(line.ray);
  if (!left.cut(before, apex, ask) || !left.cut(beyond, base, ask)) return {};
  const Quadratic<T> q = quadratic(line);
  const std::optional<When> when = enter_cone(line.ray, q, left, ask);
  if (!when) return {};
  const bool root = when->at == When::At::root, on_line = when->at == When::At::quotient && when->index == side;
  Time<T> time = time_zero<T>();
  if (when->at == When::At::quotient) {
    const Linear<T> c = when->index == side ? linear(line, side, ask) : when->index == base ? beyond : before;
    time = with_positive_denominator(c.constant, T(0.0) - c.slope, -ask(c.slope));
  }
  const auto holds = [&](std::uint32_t plane, const Linear<T>& c) {
    return (when->at == When::At::quotient && when->index == plane) || sign_at(c, *when, time, &q, ask) == Sign::zero;
  };
  if (holds(apex, before)) return Decided{*when, {FeatureKind::vertex, 0}, true, side};
  const bool on_base = holds(base, beyond), on_side = root || on_line || ask(value_at(q, time)) == Sign::zero;
  if (!on_base && !on_side) return Decided{*when, {FeatureKind::interior, 0}, false, 0};
  const Feature feature{on_base && on_side ? FeatureKind::edge : FeatureKind::face, on_base && !on_side ? 1u : 0u};
  if (!on_base) return Decided{*when, feature, true, side};
  const bool by_base = ask(beyond.slope) == Sign::negative || !on_side;
  const bool by_side =
      !by_base && (on_line || (root ? ask(q.discriminant) == Sign::positive
                                    : ask(q.square * time.numerator + q.half * time.denominator) == Sign::negative));
  return Decided{*when, feature, true, by_side ? side : base};
}

}  // namespace

template <class F>
auto with_model(const Cone3& cone, const RayQuestion&, const F& f) {
  // A ball, of which no direction is known to cut.
  return cone.apex == cone.base ? f(BallModel{cone.apex, cone.radius}) : f(ConeModel{cone});
}

template struct RayAnswers<Cone3>;

template std::optional<SeenHit> seen_hit(const SeenLine&, const Cone3&);

}  // namespace plumb::query
