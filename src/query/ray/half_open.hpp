// Ray cast: where does a ray that is moved a little hit a triangle?  The half-open rule, of any model of one facet.
//
// By the half-open rule the whole ray is moved by a vector (x, y, z) with 1 >> x >> y >> z > 0, the same one for all
// triangles.  The moved ray misses every edge that is not parallel to it, and has neither end in a plane that is not:
// the side of the edge from p to q changes by (q - p) x d, that of the plane by -n, and neither is zero there.  So for
// finitely many triangles there is one true ray, as near as one likes, that answers as the rule does.
// Source: simulation of simplicity with one vector for the whole scene.
// Cost: that of meet_facets.
#pragma once

#include "query/ray/answers.hpp"

namespace plumb::query {

template <class T, class Model>
std::optional<Decided> half_open(const ShotLine<T>& line, const Model& model, RaySigns& ask) {
  const AnyRay& ray = line.ray;
  const Facet<T> f = model.template facet<T>(line, 0);
  const Vec3<T>& d = line.direction;
  const Vec3<T> n = facet_normal(f), shift = Vec3<T>{T(0.0), T(0.0), T(0.0)} - n;
  const T slope = dot(d, n), above = dot(f.corners[0], n);
  const Sign way = ask(slope);
  if (way == Sign::zero || !passes_perturbed(f, d, ask)) return {};
  if (begins(ray) && perturbed(above, shift, ask) != way) return {};
  if (ends(ray) && perturbed(above - slope, shift, ask) == way) return {};
  const Time<T> time = with_positive_denominator(above, slope, way);
  const std::optional<Feature> feature = corner_or_edge(f, times(d, time.numerator), time.denominator, ask);
  const bool at_zero = ask(above) == Sign::zero;
  return Decided{{at_zero ? When::At::zero : When::At::quotient, 0, part_of(Meeting::plane, 0)},
                 feature.value_or(Feature{FeatureKind::face, 0}),
                 true,
                 0};
}

template <class Answer, class List = RayWorlds, class Model>
std::optional<Answer> answer_by(HitRule rule, const AnyRay& ray, const Model& model) {
  if (rule == HitRule::closed) return answer_of_model<Answer, List>(ray, model);
  return answer<Answer>(ray, model, certainly<List>([&]<class T>(RayWorld<T>& ask) {
                          return half_open<T>(ShotLine<T>(ray), model, ask);
                        }));
}

}  // namespace plumb::query
