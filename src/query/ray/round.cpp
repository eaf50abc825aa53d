// Balls, cylinders and capsules.
//
// A capsule is a ball before the first end of its axis, a cylinder between the ends, a ball beyond the second: the
// parameters at which the ray passes from one zone to the next are quotients, and both quadratics agree there.
#include <span>

#include "query/ray/answers.hpp"
#include "query/ray/round_parts.hpp"

namespace plumb::query {
namespace {

/// Positive before a (zone 1) or beyond b (zone 2) along the axis.
template <class T>
Linear<T> beyond_end(const ShotLine<T>& line, const Point3& a, const Point3& b, std::uint32_t zone) {
  const Vec3<T> out = zone == 1 ? between<T>(b, a) : between<T>(a, b);
  return {dot(line.origin_from(zone == 1 ? a : b), out), dot(line.direction, out)};
}

/// Constraint 0: before a; 1: beyond b; 2: the side.
struct CylinderModel {
  const Cylinder3& cylinder;

  static std::size_t size() { return 2; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    return beyond_end(line, cylinder.a, cylinder.b, i + 1);
  }
  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line) const {
    return tube_quadratic(line.origin_from(cylinder.a), line.direction, between<T>(cylinder.a, cylinder.b),
                          cylinder.radius);
  }
  static Feature feature(std::span<const std::uint32_t> tight) {
    if (tight.size() > 1) return {FeatureKind::edge, tight[0]};  // one end and the side
    return {FeatureKind::face, tight[0] == 2 ? 0 : tight[0] + 1};
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns&) const {
    const Vec3<T> e = between<T>(cylinder.a, cylinder.b);
    if (decided.normal == 2) return from_axis(line.origin_from(cylinder.a), line.direction, e);
    return still_normal(decided.normal == 1 ? e : between<T>(cylinder.b, cylinder.a));
  }
};

/// Zones are numbered as the faces: 0 the side, 1 about a, 2 about b.
struct CapsuleModel {
  const Capsule3& capsule;

  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line, const When& when) const {
    const Vec3<T> w = line.origin_from(when.index == 2 ? capsule.b : capsule.a);
    if (when.index != 0) return ball_quadratic(w, line.direction, capsule.radius);
    return tube_quadratic(w, line.direction, between<T>(capsule.a, capsule.b), capsule.radius);
  }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns&) const {
    const Vec3<T> w = line.origin_from(decided.normal == 2 ? capsule.b : capsule.a);
    if (decided.normal != 0) return from_center(w, line.direction);
    return from_axis(w, line.direction, between<T>(capsule.a, capsule.b));
  }
  template <class T>
  std::optional<Decided> decide(const ShotLine<T>& line, RaySigns& ask) const;
};

template <class T>
std::optional<Decided> CapsuleModel::decide(const ShotLine<T>& line, RaySigns& ask) const {
  const auto& [a, b, radius] = capsule;
  const std::array<Linear<T>, 3> beyond{Linear<T>{T(0.0), T(0.0)}, beyond_end(line, a, b, 1),
                                        beyond_end(line, a, b, 2)};
  const auto within = [&](std::uint32_t zone) {
    return Linear<T>{T(0.0) - beyond[zone].constant, T(0.0) - beyond[zone].slope};
  };
  const Sign way = ask(beyond[2].slope);
  const std::array<std::uint32_t, 3> order = way == Sign::positive   ? std::array<std::uint32_t, 3>{1, 0, 2}
                                             : way == Sign::negative ? std::array<std::uint32_t, 3>{2, 0, 1}
                                                                     : std::array<std::uint32_t, 3>{0, 1, 2};
  for (const std::uint32_t zone : order) {
    Remaining<T> left(line.ray);
    const bool some =
        zone == 0 ? left.cut(beyond[1], 1, ask) && left.cut(beyond[2], 2, ask) : left.cut(within(zone), zone, ask);
    if (!some) continue;
    const Quadratic<T> q = quadratic(line, When{When::At::root, zone, 0});
    const std::optional<When> when = enter(q, left, zone, ask);
    if (!when) continue;
    if (when->at != When::At::root && ask(q.constant) == Sign::negative)
      return Decided{{}, {FeatureKind::interior, 0}, false, 0};
    const bool seam = zone != 0 && sign_at(beyond[zone], *when, time_zero<T>(), &q, ask) == Sign::zero;
    const std::uint32_t face = seam ? 0 : zone;
    return Decided{*when, {FeatureKind::face, face}, true, face};
  }
  return {};
}

}  // namespace

template <class F>
auto with_model(const Sphere3& s, const RayQuestion&, const F& f) {
  return f(BallModel{s.center, s.radius});
}
template <class F>
auto with_model(const Cylinder3& s, const RayQuestion&, const F& f) {
  return s.a == s.b ? f(BallModel{s.a, s.radius}) : f(CylinderModel{s});
}
template <class F>
auto with_model(const Capsule3& s, const RayQuestion&, const F& f) {
  return s.a == s.b ? f(BallModel{s.a, s.radius}) : f(CapsuleModel{s});
}

template struct RayAnswers<Sphere3>;
template struct RayAnswers<Cylinder3>;
template struct RayAnswers<Capsule3>;

template std::optional<SeenHit> seen_hit(const SeenLine&, const Sphere3&);
template std::optional<SeenHit> seen_hit(const SeenLine&, const Cylinder3&);
template std::optional<SeenHit> seen_hit(const SeenLine&, const Capsule3&);

}  // namespace plumb::query
