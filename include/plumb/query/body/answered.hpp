// What is said to a question of query/ that has no answer for these figures?  One sentence each.
//
// Laws: those of figure/basic/answered.hpp.
// Cost: compile time only.
#pragma once

#include <optional>

#include "plumb/figure/basic/answered.hpp"

namespace plumb {

struct Intersection3;
struct Closest;
struct Contact;
struct Hit;

template <class T = Intersection3>
figure::NoAnswer<T> intersection(const figure::Anything&, const figure::Anything&, const figure::Anything& = {}) {
  static_assert(figure::never<T>,
                "plumb: intersection takes lines, rays, segments, planes, triangles, boxes and convex polyhedra of one "
                "space, the pairs of docs/intersection.md; relate takes more");
  __builtin_unreachable();
}
template <class A, class B>
concept Intersectable = requires(const A& a, const B& b) {
  { intersection(a, b) } -> figure::Answer;
};

template <class T = Hit>
figure::NoAnswer<std::optional<T>> first_hit(const figure::Anything&, const figure::Anything&,
                                             const figure::Anything& = {}) {
  static_assert(figure::never<T>,
                "plumb: first_hit takes a line, ray or segment and then a figure of its space, a TriangleMesh or a "
                "TriangleBatch: query/ray/ray.hpp and query/ray/ray2.hpp list them");
  __builtin_unreachable();
}
template <class Straight, class Shape>
concept Hittable = requires(const Straight& straight, const Shape& shape) {
  { first_hit(straight, shape) } -> figure::Answer;
};

template <class T = Closest>
figure::NoAnswer<T> closest_points(const figure::Anything&, const figure::Anything&) {
  static_assert(figure::never<T>,
                "plumb: closest_points takes two figures of one space, neither of which is a cylinder or a cone "
                "(include <plumb/query.hpp>): docs/closest.md lists the pairs; of a mesh ask its triangles");
  __builtin_unreachable();
}

template <class T = double>
figure::NoAnswer<T> distance(const figure::Anything&, const figure::Anything&, const figure::Anything& = {}) {
  static_assert(figure::never<T>,
                "plumb: distance takes two figures of one space, neither of which is a cylinder or a cone (include "
                "<plumb/query.hpp>): docs/closest.md lists the pairs; of a mesh ask its triangles");
  __builtin_unreachable();
}
template <class A, class B>
concept Measurable = requires(const A& a, const B& b) {
  { distance(a, b) } -> figure::Answer;
  { closest_points(a, b) } -> figure::Answer;
};

template <class T = Contact>
figure::NoAnswer<std::optional<T>> first_contact(const figure::Anything&, const figure::Anything&,
                                                 const figure::Anything& = {}) {
  static_assert(
      figure::never<T>,
      "plumb: first_contact takes Translating figures of one space, one of which may stand still, or Moving points, "
      "segments and triangles: docs/motion.md lists the pairs");
  __builtin_unreachable();
}
template <class A, class B>
concept Collidable = requires(const A& a, const B& b) {
  { first_contact(a, b) } -> figure::Answer;
};

}  // namespace plumb
