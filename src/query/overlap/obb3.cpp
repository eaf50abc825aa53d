// An oriented box against what is straight, triangles and axis-aligned boxes.
//
// The matrix of the box's cofactors (rows N_i, its face normals) maps it to an axis-aligned box, |t_i| <= H_i, and the
// other shape to one of its kind; a linear map that is one to one keeps the relation.  There the axes that can separate
// are those of the box, the normal of a triangle, and cross products of an edge with an axis, of two terms each.
// Over doubles with bounds of their errors first, then over pairs of doubles and integers: one statement of each question
// (query/overlap/box_quick.hpp, figure/obb/quick.hpp).  What is flat there is asked as all figures with
// straight edges are.
// Source: RTCD 5.2.1, 5.2.9, 5.3.3, 4.4.1.
#include "figure/obb/quick.hpp"
#include "query/body/figure_input.hpp"
#include "query/overlap/box_quick.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

template <class Shape>
Relation relate_obb(const Shape& a, const Obb3& b, Question question) {
  assert_sound_thread();
  if (const auto r = quick_relation(a, b)) [[likely]]
    return *r;
  require_figures(question, a, b);
  if constexpr (std::is_same_v<Shape, Triangle3>) {
    if (a.a == a.b || a.c == a.a) return relate_obb(Segment3{a.b, a.c}, b, question);
    if (a.b == a.c) return relate_obb(Segment3{a.a, a.b}, b, question);
  }
  if (const auto r = near_relation(a, b)) return *r;
  return relate_flat(view_of(a), view_of(b));
}

}  // namespace
PLUMB_PAIR_ANSWERS_TO(Obb3, relate_obb, Line3, Ray3, Segment3, Triangle3)

Relation relate_pair(PairFunction<Aabb3, Obb3>, const Aabb3& a, const Obb3& b, Question question) {
  assert_sound_thread();
  if (const auto r = quick_relation(a, b); r && !is_empty(a)) [[likely]]
    return *r;
  require_figures(question, a, b);
  if (is_empty(a)) return Relation::disjoint;
  if (const auto r = near_relation(a, b)) return *r;
  return relate_flat(view_of(a), view_of(b));
}

}  // namespace query
}  // namespace plumb
