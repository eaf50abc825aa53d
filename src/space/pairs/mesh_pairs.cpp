#include "plumb/space/pairs/mesh_pairs.hpp"

#include <algorithm>

#include "plumb/query/section/intersection.hpp"
#include "query/section/posed_triangles.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_search.hpp"
#include "space/pairs/pair_slots.hpp"
#include "space/pairs/pair_sources.hpp"

namespace plumb {
namespace space {
namespace {

Intersection3 common(const Triangle3& a, const Triangle3& b) { return intersection(a, b); }
Intersection3 common(const PosedTriangle& a, const PosedTriangle& b) { return query::intersection(a, b); }

template <class Source>
std::vector<Intersection3> intersections_of(const Source& a, const Source& b, std::span<const TrianglePair> pairs,
                                            const PairOptions& options, std::vector<Intersection3> rows) {
  const std::vector<std::uint32_t> slots_a = slots_of(mesh_of(a)), slots_b = slots_of(mesh_of(b));
  require_pairs(pairs, slots_a.size(), slots_b.size());
  rows.clear(), rows.resize(pairs.size());
  constexpr std::size_t part_size = is_posed_source<Source> ? 16 : 256;
  const std::size_t parts = blocks_of(pairs.size(), part_size);
  for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i)
      rows[i] = common(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
  });
  return rows;
}

/// ask(a, b, whether they are one) of two sources, or of one twice.
template <class Ask>
auto asked_of_two(const char* function, const MeshView& a, const MeshView& b, const Ask& ask) {
  return with_sources(function, a, b, [&](const auto& s, const auto& t) { return ask(s, t, false); });
}
template <class Ask>
auto asked_of_one(const char* function, const MeshView& mesh, const Ask& ask) {
  return with_own_source(function, mesh, [&](const auto& s) { return ask(s, s, true); });
}

auto all_of(const char* function, const PairOptions& options, std::vector<TrianglePair>& rows) {
  return [=, &options, &rows](const auto& a, const auto& b, bool own) {
    return all_pairs(PairSearch(function, a, b, own, options), mesh_of(a).slots(), options.execution, std::move(rows));
  };
}
auto count_of(const char* function, const PairOptions& options) {
  return [=, &options](const auto& a, const auto& b, bool own) {
    return counted_pairs(PairSearch(function, a, b, own, options), is_split(mesh_of(a)) || is_split(mesh_of(b)),
                         options.execution);
  };
}
auto any_of(const char* function, const PairOptions& options) {
  return [=, &options](const auto& a, const auto& b, bool own) {
    return any_pair(PairSearch(function, a, b, own, options));
  };
}

constexpr const char* all_name = "intersecting_pairs";
constexpr const char* count_name = "count_intersecting_pairs";
constexpr const char* any_name = "any_intersecting_pair";

}  // namespace
}  // namespace space

std::vector<TrianglePair> intersecting_pairs(const MeshView& a, const MeshView& b, const PairOptions& options,
                                             std::vector<TrianglePair> rows) {
  return space::asked_of_two(space::all_name, a, b, space::all_of(space::all_name, options, rows));
}
PairCount count_intersecting_pairs(const MeshView& a, const MeshView& b, const PairOptions& options) {
  return space::asked_of_two(space::count_name, a, b, space::count_of(space::count_name, options));
}
std::optional<TrianglePair> any_intersecting_pair(const MeshView& a, const MeshView& b, const PairOptions& options) {
  return space::asked_of_two(space::any_name, a, b, space::any_of(space::any_name, options));
}

std::vector<TrianglePair> intersecting_pairs(const MeshView& mesh, const PairOptions& options,
                                             std::vector<TrianglePair> rows) {
  return space::asked_of_one(space::all_name, mesh, space::all_of(space::all_name, options, rows));
}
PairCount count_intersecting_pairs(const MeshView& mesh, const PairOptions& options) {
  return space::asked_of_one(space::count_name, mesh, space::count_of(space::count_name, options));
}
std::optional<TrianglePair> any_intersecting_pair(const MeshView& mesh, const PairOptions& options) {
  return space::asked_of_one(space::any_name, mesh, space::any_of(space::any_name, options));
}

std::vector<Intersection3> intersections(const MeshView& a, const MeshView& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options, std::vector<Intersection3> rows) {
  const auto ask = [&](const auto& s, const auto& t) {
    return space::intersections_of(s, t, pairs, options, std::move(rows));
  };
  return space::with_sources("intersections", a, b, ask, space::Asked::places);
}

}  // namespace plumb
