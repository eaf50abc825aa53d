#include "figure/containment/generated_set.hpp"

#include <algorithm>

#include "figure/containment/contains_input.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/predicates/cross_products.hpp"

namespace plumb::figure::containment {
namespace {

template <class Vector>
std::optional<std::pair<Vector, Vector>> pair_of(const std::array<Vector, 3>& axes) {
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {2, 0}}) {
    if (!parallel(axes[i], axes[j])) return std::pair{axes[i], axes[j]};
  }
  return {};
}

template <class Vector>
std::optional<Vector> first_of(const std::array<Vector, 3>& axes) {
  const auto found = std::ranges::find_if_not(axes, [](const Vector& v) { return is_zero(v); });
  return found == axes.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

std::optional<std::pair<Vector2, Vector2>> independent(const Axes2& axes) { return pair_of(axes); }
std::optional<std::pair<Vector3, Vector3>> independent(const Axes3& axes) { return pair_of(axes); }
std::optional<Vector2> any_of(const Axes2& axes) { return first_of(axes); }
std::optional<Vector3> any_of(const Axes3& axes) { return first_of(axes); }

bool in_plane(const Point3& center, const std::pair<Vector3, Vector3>& span, const Point3& p) {
  return sign_of(predicates::OrderAlongCross{}, span.first, span.second, center, p) == Sign::zero;
}

std::size_t telling_coordinates(const std::pair<Vector3, Vector3>& span) {
  const Numbers u = numbers(span.first), v = numbers(span.second);
  std::size_t first = 0;
  while (first < 2 && parallel(kept<Vector2>(u, first), kept<Vector2>(v, first))) ++first;
  return first;
}

std::size_t telling_coordinate(const Numbers& v) { return v[0] != 0 ? 0 : v[1] != 0 ? 1 : 2; }

}  // namespace plumb::figure::containment
