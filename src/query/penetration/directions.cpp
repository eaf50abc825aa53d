#include "query/penetration/directions.hpp"

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::query {

void require_directions(const std::string& function, std::span<const Vector3> all, bool is_list) {
  if (all.empty()) {
    throw InvalidShape(function + ": directions is empty, and nothing can move; give at least one");
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name = is_list ? "directions[" + std::to_string(i) + "]" : "direction";
    require_finite_parts(function, {name}, all[i]);
    if (all[i] == Vector3{}) {
      throw InvalidShape(function + ": " + name + " is zero, along which nothing moves; give one that has a length");
    }
  }
}

}  // namespace plumb::query
