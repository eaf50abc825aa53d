// Who answers for two figures with straight edges: quick proofs first, what is exact of all sets for the rest.
#include "flat_set.hpp"
#include "flat_view.hpp"
#include "polygon_relation.hpp"

namespace plumb::query {
namespace {

FlatSet set_of(const FlatView& v) {
  return with_shape(v, [](const auto& s) {
    if constexpr (requires { flat_set(s); }) {
      return flat_set(s);
    } else {
      return FlatSet{};  // polygons are asked otherwise
    }
  });
}

}  // namespace

Relation relate_flat(const FlatView& a, const FlatView& b) {
  require("relate", a, b);
  if (is_polygon(a) || is_polygon(b)) return relate_polygon("relate", a, b);
  return relate(set_of(a), set_of(b));
}

bool flat_intersects(const FlatView& a, const FlatView& b) {
  require("intersects", a, b);
  if (is_polygon(a) || is_polygon(b)) return relate_polygon("intersects", a, b) != Relation::disjoint;
  return intersects(set_of(a), set_of(b));
}

}  // namespace plumb::query
