// Ray cast: what do first_hit, first_hit_parameter and hits answer of a shape?  One answer for all that say how a line sees
// them.
//
// A shape says with_model(shape, asked, f), which calls f with its model: constraints (query/ray/clip.hpp), facets
// (query/ray/facets.hpp), or what decides by itself, decide<T>(line, ask).  with_model is found by its arguments, so that
// it stands in plumb::query, not in a namespace without a name.
// Laws: those of query/ray/ray.hpp.
// Source: RTCD 5.3.
// Cost: that of the model.
#pragma once

#include "query/ray/facets.hpp"
#include "query/ray/seen_line.hpp"

namespace plumb::query {

struct RayQuestion {
  std::string_view function;
  const AnyRay& ray;
};

template <class T, class Model>
std::optional<Decided> decided_of(const ShotLine<T>& line, const Model& model, RaySigns& ask) {
  if constexpr (requires { model.template decide<T>(line, ask); }) {
    return model.template decide<T>(line, ask);
  } else if constexpr (requires { model.facets(); }) {
    return meet_facets<T>(line, model, ask);
  } else {
    return clip<T>(line, model, ask);
  }
}

template <class Answer, class List = RayWorlds, class Model>
std::optional<Answer> answer_of_model(const AnyRay& ray, const Model& model) {
  return answer<Answer>(ray, model, certainly<List>([&]<class T>(RayWorld<T>& ask) {
                          return decided_of<T>(ShotLine<T>(ray), model, ask);
                        }));
}

template <class Answer, class Shape>
std::optional<Answer> answer_of(const AnyRay& ray, const Shape& s) {
  const RayQuestion asked{function_of<Answer>, ray};
  require_ray(asked.function, ray, s);
  return with_model(s, asked, [&](const auto& model) { return answer_of_model<Answer>(ray, model); });
}

template <class Shape>
std::optional<Hit> RayAnswers<Shape>::first_hit(const AnyRay& ray, const Shape& s) {
  return answer_of<Hit>(ray, s);
}
template <class Shape>
std::optional<RayParameter> RayAnswers<Shape>::first_hit_parameter(const AnyRay& ray, const Shape& s) {
  return answer_of<RayParameter>(ray, s);
}
template <class Shape>
bool RayAnswers<Shape>::hits(const AnyRay& ray, const Shape& s) {
  return answer_of<Decided>(ray, s).has_value();
}

template <SeenRound Shape>
std::optional<SeenHit> seen_hit(const SeenLine& line, const Shape& s) {
  return with_model(s, RayQuestion{"first_hit", line.ray}, [&](const auto& model) {
    RaySigns ask;
    return seen_hit_of(line, model, decided_of(line, model, ask));
  });
}

// Each stands where its model does.
extern template struct RayAnswers<Plane3>;
extern template struct RayAnswers<ThreePointPlane3>;
extern template struct RayAnswers<Halfspace3>;
extern template struct RayAnswers<Quadrilateral3>;
extern template struct RayAnswers<Polygon3>;
extern template struct RayAnswers<HoledPolygon3>;
extern template struct RayAnswers<Rectangle3>;
extern template struct RayAnswers<Tetrahedron3>;
extern template struct RayAnswers<Sphere3>;
extern template struct RayAnswers<Capsule3>;
extern template struct RayAnswers<Cylinder3>;
extern template struct RayAnswers<Cone3>;
extern template struct RayAnswers<Lozenge3>;
extern template struct RayAnswers<Ellipsoid3>;
extern template struct RayAnswers<Aabb3>;
extern template struct RayAnswers<Obb3>;
extern template struct RayAnswers<KDop3>;
extern template struct RayAnswers<ConvexPolyhedron3>;
extern template std::optional<SeenHit> seen_hit(const SeenLine&, const Sphere3&);
extern template std::optional<SeenHit> seen_hit(const SeenLine&, const Capsule3&);
extern template std::optional<SeenHit> seen_hit(const SeenLine&, const Cylinder3&);
extern template std::optional<SeenHit> seen_hit(const SeenLine&, const Cone3&);
extern template std::optional<SeenHit> seen_hit(const SeenLine&, const Lozenge3&);

}  // namespace plumb::query
