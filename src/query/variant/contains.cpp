#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/convex/containment.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

bool view_contains(const PosedView& outer, const PosedView& inner) {
  if (!is_posed_view(outer) && !is_posed_view(inner)) {
    return asked_by_types<PairsOf<contains_pairs>, bool>(
        "contains", outer.figure, inner.figure,
        [](const auto& x, const auto& y) requires requires { contains(x, y); } { return contains(x, y); });
  }
  if (inner.figure.kind == FigureKind::point) {  // as relate takes it, which is asked of two points as well
    require_related("contains", outer.figure, inner.figure);
    return relate_posed("contains", outer, inner) != Relation::disjoint;
  }
  require_answer(contains_pairs, "contains", outer.figure, inner.figure);
  return posed_contains(outer, inner);
}

template <class Point>
Location located(const AnyFigure& figure, const Point& p) {
  const FigureView point = view_of(p), v = figure.figure();
  if (v.dimension != point.dimension) refuse_pair("locate", v, point);
  return visit(
      [&]<class Shape>(const Shape& s) -> Location {
        if constexpr (requires { locate(s, p); })
          return figure.is_posed() ? posed_locate(figure.view(), point) : locate(s, p);
        refuse_pair("locate", v, point);
      },
      figure);
}

}  // namespace

bool any_contains(const PosedView& outer, const PosedView& inner) {
  return recorded("contains", {outer, inner}, {}, [&] { return view_contains(outer, inner); });
}
Location any_locate(const AnyFigure& figure, const Point2& p) {
  return recorded("locate", {figure.view(), {view_of(p)}}, {}, [&] { return located(figure, p); });
}
Location any_locate(const AnyFigure& figure, const Point3& p) {
  return recorded("locate", {figure.view(), {view_of(p)}}, {}, [&] { return located(figure, p); });
}

}  // namespace plumb::query
