// Extreme vertex: from the farthest one of the coarsest polytope to that of the finest.
#include "certify/carried_errors.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/certify/direction.hpp"
#include "query/polytope_hierarchy/descent.hpp"

namespace plumb {
namespace query::hierarchy {
namespace {

struct GivenDirection {
  const Vector3& given;
  template <class Text>
  [[nodiscard]] Sign sign(const Text& text) const {
    return proved_sign([&]<class T>() { return text(arith::vec<T>(given)); });
  }
  [[nodiscard]] Sign beyond(const Point3& a, const Point3& b) const { return compare_along_direction(a, b, given); }
};

/// Does every other vertex of the finest polytope lie less far than this one, which none exceeds?
bool is_alone(const PolytopeHierarchy& h, std::uint32_t at, const GivenDirection& direction) {
  const auto is_level = [&](std::uint32_t v) { return direction.beyond(h.points[v], h.points[at]) == Sign::zero; };
  const auto rim = std::ranges::lower_bound(h.rims, at, {}, [](const auto& r) { return r.fan.vertex; });
  if (rim != h.rims.end() && rim->fan.vertex == at)
    return !is_level(farthest_of_fan(h.points, rim->fan, rim->neighbors, direction));
  return std::ranges::none_of(h.neighbors_of(at), is_level);
}

}  // namespace
}  // namespace query::hierarchy

Support3 support_point(const PolytopeHierarchy& h, const Vector3& direction) {
  using namespace query::hierarchy;
  require_finite_parts("support_point", {"direction"}, direction);
  const GivenDirection along{direction};
  std::uint32_t at = 0;
  for (std::uint32_t v = 1; v < h.levels.back().size; ++v) {
    if (along.beyond(h.points[v], h.points[at]) == Sign::positive) at = v;
  }
  for (std::size_t i = h.levels.size() - 1; i-- > 0;) at = beyond_plane(h, h.levels[i], at, along).value_or(at);
  if (is_alone(h, at, along)) return {h.points[at], h.vertices[at], true};
  return support_point(h.polyhedron, direction, h.vertices[at]);
}

}  // namespace plumb
