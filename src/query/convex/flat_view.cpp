#include "query/convex/flat_view.hpp"

namespace plumb::query {

FlatSet flat_set(const FlatView& v) {
  return with_shape(v, [](const auto& s) {
    if constexpr (requires { query::flat_set(s); }) {
      return query::flat_set(s);
    } else {
      return FlatSet{};
    }
  });
}

}  // namespace plumb::query
