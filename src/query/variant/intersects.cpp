#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

bool views_meet(const PosedView& a, const PosedView& b) {
  require_related("intersects", a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) return relate_posed("intersects", a, b) != Relation::disjoint;
  if (b.figure.kind < a.figure.kind) return views_meet(b, a);
  return asked_in_order<RelatedPairs, bool>(
      "intersects", a.figure, b.figure,
      [](const auto& x, const auto& y) requires requires { intersects(x, y); } { return intersects(x, y); });
}

}  // namespace

bool any_intersects(const PosedView& a, const PosedView& b) {
  return recorded("intersects", {a, b}, {}, [&] { return views_meet(a, b); });
}

}  // namespace plumb::query
