#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/variant/questions.hpp"
#include "query/variant/asked.hpp"
#include "query/variant/recorded.hpp"

namespace plumb::query {
namespace {

Relation relate_views(const PosedView& a, const PosedView& b) {
  require_related("relate", a.figure, b.figure);
  if (is_posed_view(a) || is_posed_view(b)) return relate_posed("relate", a, b);
  if (b.figure.kind < a.figure.kind) return relate_views(b, a);
  return asked_in_order<RelatedPairs, Relation>(
      "relate", a.figure, b.figure,
      [](const auto& x, const auto& y) requires requires { relate(x, y); } { return relate(x, y); });
}

}  // namespace

Relation any_relate(const PosedView& a, const PosedView& b) {
  return recorded("relate", {a, b}, {}, [&] { return relate_views(a, b); });
}

}  // namespace plumb::query
