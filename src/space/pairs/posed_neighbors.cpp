#include "space/pairs/posed_neighbors.hpp"

#include <algorithm>

#include "query/overlap/posed_triangles.hpp"

namespace plumb::space {
namespace {

using Number = BigDyadic;
using Way = query::Vec3<Number>;

Sign along(const Way& v, const Way& w) { return query::dot(v, w).sign(); }
bool is_none(const Way& v) { return v.x.sign() == Sign::zero && v.y.sign() == Sign::zero && v.z.sign() == Sign::zero; }
bool is_same_way(const Way& v, const Way& w) { return is_none(query::cross(v, w)) && along(v, w) == Sign::positive; }

/// Is the way, which is one, a sum of these with factors that are not negative?
bool is_in_cone(const Way& way, const std::array<Way, 2>& cone) {
  const auto& [v, w] = cone;
  const Way normal = query::cross(v, w);
  if (is_none(normal)) return is_same_way(way, v) || is_same_way(way, w);
  return along(query::cross(way, w), normal) != Sign::negative && along(query::cross(v, way), normal) != Sign::negative;
}

bool have_way_in_common(const std::array<Way, 2>& a, const std::array<Way, 2>& b) {
  const auto any_in = [](const std::array<Way, 2>& ways, const std::array<Way, 2>& cone) {
    return std::ranges::any_of(ways, [&](const Way& way) { return !is_none(way) && is_in_cone(way, cone); });
  };
  return any_in(a, b) || any_in(b, a);
}

/// Of (v, w, a) and (v, w, b), from v: in common is more than the edge where both go on beyond it.
bool more_than_posed_edge(const Way& edge, const Way& a, const Way& b) {
  const Way turn_a = query::cross(edge, a), turn_b = query::cross(edge, b);
  if (!is_none(turn_a) || !is_none(turn_b)) return along(turn_a, turn_b) == Sign::positive;
  const auto before = [&](const Way& way) { return along(way, edge) == Sign::negative; };
  const auto behind = [&](const Way& way) { return along(way - edge, edge) == Sign::positive; };
  return (before(a) && before(b)) || (behind(a) && behind(b));
}

bool names(const Bvh::Corners& t, std::uint32_t i) { return std::ranges::find(t, i) != t.end(); }

}  // namespace

Relation relate_flattened(std::span<const Point3> vertices, const Bvh::Corners& a, const Bvh::Corners& b,
                          const Pose& pose) {
  std::vector<std::uint32_t> shared, only_a, only_b;
  const auto add = [](std::vector<std::uint32_t>& to, std::uint32_t i) {
    if (std::ranges::find(to, i) == to.end()) to.push_back(i);
  };
  for (const std::uint32_t i : a) add(names(b, i) ? shared : only_a, i);
  for (const std::uint32_t i : b) {
    if (!names(a, i)) add(only_b, i);
  }
  const auto whole = [&] {
    const auto triangle = [&](const Bvh::Corners& c) {
      return Posed<Triangle3>{{vertices[c[0]], vertices[c[1]], vertices[c[2]]}, pose};
    };
    return query::relate(triangle(a), triangle(b));
  };
  if (shared.empty() || (only_a.empty() && only_b.empty())) return whole();
  const auto at = [&](std::uint32_t i) { return query::posed<Number>(vertices[i], pose); };
  const Way from = at(shared[0]), none = from - from;
  const auto way = [&](const std::vector<std::uint32_t>& to, std::size_t i) {
    return i < to.size() ? at(to[i]) - from : none;
  };
  const Way edge = way(shared, 1);
  const bool more = is_none(edge)
                        ? have_way_in_common({way(only_a, 0), way(only_a, 1)}, {way(only_b, 0), way(only_b, 1)})
                        : more_than_posed_edge(edge, way(only_a, 0), way(only_b, 0));
  return more ? whole() : Relation::disjoint;
}

}  // namespace plumb::space
