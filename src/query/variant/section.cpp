#include "plumb/query/body/intersection_pairs.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/query/section/posed.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

AnyIntersection common_of_views(const PosedView& a, const PosedView& b) {
  require_answer(intersection_pairs, "intersection", a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) {
    if (a.figure.dimension == 2) return posed_intersection2(a, b);
    if (is_solid_kind(a.figure.kind) && is_solid_kind(b.figure.kind)) return posed_solid(a, b);
    if (is_plane_kind(a.figure.kind) && is_plane_kind(b.figure.kind)) return posed_planes(a, b);
    return posed_intersection3(a, b);
  }
  if (b.figure.kind < a.figure.kind) return common_of_views(b, a);
  return asked_in_order<PairsOf<intersection_pairs>, AnyIntersection>(
      "intersection", a.figure, b.figure, [](const auto& x, const auto& y) requires requires { intersection(x, y); } {
        return AnyIntersection(intersection(x, y));
      });
}

}  // namespace

AnyIntersection any_intersection(const PosedView& a, const PosedView& b) {
  return recorded("intersection", {a, b}, {}, [&] { return common_of_views(a, b); });
}

}  // namespace plumb::query
