// Neighbors by a vertex or an edge, by signs; those without area by what they have in common, constructed.
#include "plumb/space/pairs/neighbors.hpp"

#include <algorithm>
#include <bit>

#include "plumb/predicates.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb {
namespace space {
namespace {

using Corners = std::array<std::uint32_t, 3>;

// The indices of a triangle: those that the other has too, once each, before those that it has not.
struct Told {
  std::array<std::uint32_t, 3> corner;
  std::size_t shared = 0;  // of the distinct ones
  bool repeats = false;    // has an index twice
};

Told told_of_repeated(const Corners& t, const Corners& other) {
  Told r{{}, 0, true};
  const auto is_shared = [&](std::uint32_t i) { return i == other[0] || i == other[1] || i == other[2]; };
  for (const std::uint32_t i : t) {
    const auto end = r.corner.begin() + static_cast<std::ptrdiff_t>(r.shared);
    if (is_shared(i) && std::find(r.corner.begin(), end, i) == end) r.corner[r.shared++] = i;
  }
  std::size_t next = r.shared;
  for (const std::uint32_t i : t) {
    if (!is_shared(i) && next < 3) r.corner[next++] = i;
  }
  return r;
}

// Most pairs that a search asks about are neighbors, so that this has no branch but one.
Told told(const Corners& t, const Corners& other) {
  if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) [[unlikely]]
    return told_of_repeated(t, other);
  const auto bit = [&](std::size_t k) {
    return static_cast<unsigned>(t[k] == other[0]) | static_cast<unsigned>(t[k] == other[1]) |
           static_cast<unsigned>(t[k] == other[2]);
  };
  const unsigned shared = bit(0) | bit(1) << 1 | bit(2) << 2;
  static constexpr std::uint8_t shared_first[8][3] = {{0, 1, 2}, {0, 1, 2}, {1, 0, 2}, {0, 1, 2},
                                                      {2, 0, 1}, {0, 2, 1}, {1, 2, 0}, {0, 1, 2}};
  const auto& order = shared_first[shared];
  return {{t[order[0]], t[order[1]], t[order[2]]}, static_cast<std::size_t>(std::popcount(shared)), false};
}

Triangle3 triangle_of(std::span<const Point3> v, const Corners& t) { return {v[t[0]], v[t[1]], v[t[2]]}; }

Sign seen_turn(const Point3& a, const Point3& b, const Point3& c, int axis) {
  const auto seen = [axis](const Point3& p) {
    return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  };
  return orient2d(seen(a), seen(b), seen(c));
}

bool has_area(const Triangle3& t) {
  return seen_turn(t.a, t.b, t.c, 0) != Sign::zero || seen_turn(t.a, t.b, t.c, 1) != Sign::zero ||
         seen_turn(t.a, t.b, t.c, 2) != Sign::zero;
}

bool is_one_side(Sign s, Sign t) { return s == t && s != Sign::zero; }

/// Is anything in common beyond v0 = shared, or v0 v1?  For any triangles, by construction.
bool more_by_construction(const Triangle3& s, const Triangle3& t, std::span<const std::uint32_t> shared,
                          std::span<const Point3> v) {
  Intersection3 feature{IntersectionKind::point, {v[shared[0]]}};
  if (shared.size() == 2 && v[shared[0]] != v[shared[1]]) {
    feature = {IntersectionKind::segment, {v[shared[0]], v[shared[1]]}};
    if (feature.vertices[1] < feature.vertices[0]) std::swap(feature.vertices[0], feature.vertices[1]);
  }
  return intersection(s, t) != feature;
}

/// Of (v, a, b) and (v, c, d).  What is in common but v is so along a ray from v, up to the edge opposite to v of one.
bool more_than_vertex(const Triangle3& s, const Triangle3& t, std::span<const std::uint32_t> shared,
                      std::span<const Point3> v) {
  const Sign over_s[] = {orient3d(s.a, s.b, s.c, t.b), orient3d(s.a, s.b, s.c, t.c)};
  if (is_one_side(over_s[0], over_s[1])) return false;
  const Sign over_t[] = {orient3d(t.a, t.b, t.c, s.b), orient3d(t.a, t.b, t.c, s.c)};
  if (is_one_side(over_t[0], over_t[1])) return false;
  const bool s_coplanar = over_s[0] == Sign::zero && over_s[1] == Sign::zero;
  const bool t_coplanar = over_t[0] == Sign::zero && over_t[1] == Sign::zero;
  const bool have_area = s_coplanar && t_coplanar ? has_area(s) && has_area(t) : !s_coplanar && !t_coplanar;
  if (!have_area) return more_by_construction(s, t, shared, v);
  return relate(Segment3{s.b, s.c}, t) != Relation::disjoint || relate(Segment3{t.b, t.c}, s) != Relation::disjoint;
}

/// Of (v, w, a) and (v, w, b).
bool more_than_edge(const Triangle3& s, const Triangle3& t, std::span<const std::uint32_t> shared,
                    std::span<const Point3> v) {
  if (orient3d(s.a, s.b, s.c, t.c) != Sign::zero) return false;
  for (const int axis : {0, 1, 2}) {
    const Sign of_s = seen_turn(s.a, s.b, s.c, axis), of_t = seen_turn(t.a, t.b, t.c, axis);
    if (of_s != Sign::zero && of_t != Sign::zero) return of_s == of_t;
  }
  return more_by_construction(s, t, shared, v);
}

}  // namespace
}  // namespace space

Relation relate_in_mesh(std::span<const Point3> vertices, const std::array<std::uint32_t, 3>& a,
                        const std::array<std::uint32_t, 3>& b) {
  using namespace space;
  const Told s = told(a, b);
  const auto whole = [&] { return relate(triangle_of(vertices, a), triangle_of(vertices, b)); };
  if (s.shared == 0 || s.shared == 3) return whole();
  const Told t = told(b, a);
  const std::span<const std::uint32_t> shared(s.corner.data(), s.shared);
  bool more = false;
  if (s.repeats || t.repeats) {
    const auto all_in = [](const Corners& of, const Corners& other) {
      return std::ranges::all_of(of, [&](std::uint32_t i) { return std::ranges::find(other, i) != other.end(); });
    };
    more = (all_in(a, b) && all_in(b, a)) ||
           more_by_construction(triangle_of(vertices, a), triangle_of(vertices, b), shared, vertices);
  } else {
    // The shared corners in one order on both sides.
    const Corners like_s = {s.corner[0], s.shared == 2 ? s.corner[1] : t.corner[1], t.corner[2]};
    const auto ask = s.shared == 1 ? more_than_vertex : more_than_edge;
    more = ask(triangle_of(vertices, s.corner), triangle_of(vertices, like_s), shared, vertices);
  }
  return more ? whole() : Relation::disjoint;
}

}  // namespace plumb
