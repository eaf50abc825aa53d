// Ray cast at moved figures: what does a round figure say of a line as it sees it, before its pose?
//
// A pose that is not singular takes the line before it to the line, at the same parameters, so that what the figure as it
// stands decides of the one is decided of the other.
// Laws: exact; the statements and the models are those that answer without poses, over rational numbers.
// Source: RTCD 3.2, 5.3.2, 5.3.7.
// Cost: GMP; some 20 us.
#pragma once

#include "figure/basic/in_space.hpp"
#include "query/ray/numbers.hpp"

namespace plumb::query {

using SeenLine = ShotLine<Rational>;

/// The normal is still + t moving, before the pose; zero where there is none.
struct SeenHit {
  RayParameter t;
  Feature feature;
  Vec3<Rational> still, moving;
};

/// `decided` is of the model, in rational numbers.
template <class Model>
std::optional<SeenHit> seen_hit_of(const SeenLine& line, const Model& model, const std::optional<Decided>& decided) {
  if (!decided) return {};
  const Vec3<Rational> none = vector_of<Rational>(Vector3{0, 0, 0});
  SeenHit hit{parameter_of(line, model, *decided), decided->feature, none, none};
  if (!decided->has_normal) return hit;
  RaySigns ask;
  const NormalForm<Rational> n = model.template normal<Rational>(line, *decided, ask);
  const Rational share = Rational(1.0) / n.divisor;
  hit.still = times(n.still, share);
  if (n.moves) hit.moving = times(n.moving, share);
  return hit;
}

template <class Shape>
concept SeenRound = SeenByRays<Shape, 3> && !FlatFigure<Shape>;

/// Of figures that have been looked at, in space; query/ray/answers.hpp.
template <SeenRound Shape>
std::optional<SeenHit> seen_hit(const SeenLine& line, const Shape& s);

/// In the plane: what has faces in space has edges there.
template <class Shape>
requires(std::is_same_v<Shape, Circle2> || std::is_same_v<Shape, Capsule2>)  //
    std::optional<SeenHit> seen_hit(const SeenLine& line, const Shape& s) {
  auto hit = seen_hit(line, in_space(s));
  if (hit) hit->feature.kind = hit->feature.kind == FeatureKind::interior ? FeatureKind::face : FeatureKind::edge;
  return hit;
}

}  // namespace plumb::query
