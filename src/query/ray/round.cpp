// Balls, cylinders and capsules.
//
// A capsule is a ball before the first end of its axis, a cylinder between the ends, a ball beyond the second: the
// parameters at which the ray passes from one zone to the next are quotients, and both quadratics agree there.
#include <span>

#include "plumb/query/ray/hits.hpp"
#include "query/ray/round_parts.hpp"
#include "query/ray/seen_line.hpp"

namespace plumb {
namespace query {
namespace {

/// Positive before a (zone 1) or beyond b (zone 2) along the axis.
template <class T>
Linear<T> beyond_end(const ShotLine<T>& line, const Point3& a, const Point3& b, std::uint32_t zone) {
  const Vec3<T> out = zone == 1 ? between<T>(b, a) : between<T>(a, b);
  return {dot(line.origin_from(zone == 1 ? a : b), out), dot(line.direction, out)};
}

struct BallModel {
  Point3 center;
  double radius;

  static std::size_t size() { return 0; }
  template <class T>
  Linear<T> linear(const ShotLine<T>&, std::uint32_t, RaySigns&) const {
    return {T(0.0), T(0.0)};
  }
  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line) const {
    return ball_quadratic(line.origin_from(center), line.direction, radius);
  }
  static Feature feature(std::span<const std::uint32_t>) { return {FeatureKind::face, 0}; }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided&, RaySigns&) const {
    return from_center(line.origin_from(center), line.direction);
  }
};

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
};

template <class T>
std::optional<Decided> decide_capsule(const ShotLine<T>& line, const CapsuleModel& model, RaySigns& ask) {
  const auto& [a, b, radius] = model.capsule;
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
    const Quadratic<T> q = model.quadratic<T>(line, When{When::At::root, zone, 0});
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

template <class Answer>
std::optional<Answer> of_ball(const AnyRay& ray, const Point3& center, double radius) {
  const BallModel model{center, radius};
  return answer<Answer>(ray, model, clip(ray, model));
}

template <class Answer>
std::optional<Answer> of(const AnyRay& ray, const Sphere3& sphere) {
  require<Answer>(ray, sphere);
  return of_ball<Answer>(ray, sphere.center, sphere.radius);
}

template <class Answer>
std::optional<Answer> of(const AnyRay& ray, const Cylinder3& cylinder) {
  require<Answer>(ray, cylinder);
  if (cylinder.a == cylinder.b) return of_ball<Answer>(ray, cylinder.a, cylinder.radius);
  const CylinderModel model{cylinder};
  return answer<Answer>(ray, model, clip(ray, model));
}

template <class Answer>
std::optional<Answer> of(const AnyRay& ray, const Capsule3& capsule) {
  require<Answer>(ray, capsule);
  if (capsule.a == capsule.b) return of_ball<Answer>(ray, capsule.a, capsule.radius);
  const CapsuleModel model{capsule};
  return answer<Answer>(ray, model, certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) {
                          return decide_capsule<T>(ShotLine<T>(ray), model, ask);
                        }));
}

std::optional<SeenHit> seen_ball(const SeenLine& line, const Point3& center, double radius) {
  const BallModel model{center, radius};
  RaySigns ask;
  return seen_hit(line, model, clip(line, model, ask));
}

}  // namespace

std::optional<SeenHit> seen_hit(const SeenLine& line, const Sphere3& sphere) {
  return seen_ball(line, sphere.center, sphere.radius);
}
std::optional<SeenHit> seen_hit(const SeenLine& line, const Cylinder3& cylinder) {
  if (cylinder.a == cylinder.b) return seen_ball(line, cylinder.a, cylinder.radius);
  const CylinderModel model{cylinder};
  RaySigns ask;
  return seen_hit(line, model, clip(line, model, ask));
}
std::optional<SeenHit> seen_hit(const SeenLine& line, const Capsule3& capsule) {
  if (capsule.a == capsule.b) return seen_ball(line, capsule.a, capsule.radius);
  const CapsuleModel model{capsule};
  RaySigns ask;
  return seen_hit(line, model, decide_capsule(line, model, ask));
}

}  // namespace query

std::optional<Hit> first_hit(const AnyRay& ray, const Sphere3& sphere) { return query::of<Hit>(ray, sphere); }
std::optional<Hit> first_hit(const AnyRay& ray, const Capsule3& capsule) { return query::of<Hit>(ray, capsule); }
std::optional<Hit> first_hit(const AnyRay& ray, const Cylinder3& cylinder) { return query::of<Hit>(ray, cylinder); }

std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Sphere3& sphere) {
  return query::of<RayParameter>(ray, sphere);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Capsule3& capsule) {
  return query::of<RayParameter>(ray, capsule);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Cylinder3& cylinder) {
  return query::of<RayParameter>(ray, cylinder);
}

bool hits(const AnyRay& ray, const Capsule3& capsule) { return query::of<query::Decided>(ray, capsule).has_value(); }
bool hits(const AnyRay& ray, const Cylinder3& cylinder) { return query::of<query::Decided>(ray, cylinder).has_value(); }

}  // namespace plumb
