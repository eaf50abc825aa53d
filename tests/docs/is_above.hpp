// The worked example of docs/add_a_question.md: does a figure lie wholly above a plane?
#pragma once

#include <array>
#include <plumb/figure.hpp>
#include <plumb/query.hpp>

namespace mine {

using plumb::FigureKind;
using plumb::query::PairOrder;

/// The plane is named first, so that one row says all; a column for each kind, in the order of FigureKind.
inline constexpr plumb::query::QuestionTable above_pairs{
    "is_above",
    PairOrder::as_named,
    "-vr",
    {"-", "vertices", "radius"},
    plumb::query::rows_named({{FigureKind::plane, "v--v---v----vr---------"}}),
    plumb::query::rows_named({})};

inline bool is_point_above(const plumb::Plane3& plane, const plumb::Point3& p) {
  return locate(plumb::Halfspace3{plane.normal, plane.offset}, p) == plumb::Location::outside;
}

/// What is convex lies above where its corners do.
inline std::array<plumb::Point3, 1> corners(const plumb::Point3& p) { return {p}; }
inline std::array<plumb::Point3, 2> corners(const plumb::Segment3& s) { return {s.a, s.b}; }
inline std::array<plumb::Point3, 3> corners(const plumb::Triangle3& t) { return {t.a, t.b, t.c}; }
inline std::array<plumb::Point3, 4> corners(const plumb::Tetrahedron3& t) { return {t.a, t.b, t.c, t.d}; }

template <class Plane, class Shape>
concept AboveOrNot = plumb::Figure<Plane> && plumb::Figure<Shape> &&
                     (plumb::figure_dimension<Plane> == 3 && plumb::figure_dimension<Shape> == 3) &&
                     above_pairs.answers(plumb::figure_kind<Plane>, plumb::figure_kind<Shape>, 3);

template <class Plane, class Shape>
requires AboveOrNot<Plane, Shape>
bool is_above(const Plane& plane, const Shape& shape) {
  if constexpr (std::is_same_v<Shape, plumb::Sphere3>) {
    return is_point_above(plane, shape.center) && relate(plane, shape) == plumb::Relation::disjoint;
  } else {
    for (const plumb::Point3& p : corners(shape)) {
      if (!is_point_above(plane, p)) return false;
    }
    return true;
  }
}

}  // namespace mine
