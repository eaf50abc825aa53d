#include "plumb/world/clash.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "plumb/predicates.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/ray/inside.hpp"
#include "world/clash_contact.hpp"
#include "world/clash_found.hpp"
#include "world/clash_solids.hpp"

namespace plumb {
namespace world {
namespace {

bool boxes_meet(const Aabb3& a, const Aabb3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

std::array<Point3, 3> corners_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}
std::array<Point3, 3> corners_of(const ClashPart& part, std::uint32_t triangle) {
  return corners_of(part.mesh(), triangle);
}
Triangle3 triangle_of(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = corners_of(mesh, triangle);
  return {a, b, c};
}

bool has_corner_beside(const std::array<Point3, 3>& of, const std::array<Point3, 3>& plane) {
  return std::ranges::any_of(of,
                             [&](const Point3& p) { return orient3d(plane[0], plane[1], plane[2], p) != Sign::zero; });
}

/// Do insides of triangles meet that are not of one plane?
bool is_crossing(const ClashPart& a, const ClashPart& b, const TrianglePair& pair) {
  if (pair.relation != Relation::overlapping) return false;
  const auto of_a = corners_of(a, pair.a), of_b = corners_of(b, pair.b);
  return has_corner_beside(of_a, of_b) || has_corner_beside(of_b, of_a);
}
bool any_crosses(const ClashPart& a, const ClashPart& b, const std::vector<TrianglePair>& pairs) {
  return std::ranges::any_of(pairs, [&](const TrianglePair& p) { return is_crossing(a, b, p); });
}

/// Shells of a part that do not meet the other: are any inside of it, any outside?  `met` are triangles of the part.
struct ShellsSeen {
  bool inside = false, outside = false;
  std::uint32_t vertex_inside = 0;
};
ShellsSeen free_shells(const ClashPart& part, const ClashPart& solid, const std::vector<std::uint32_t>& met) {
  std::vector<std::uint8_t> meets(part.shells().vertices.size());
  for (const std::uint32_t t : met)
    if (const std::uint32_t of = part.shells().of[t]; of != ClashPart::no_shell) meets[of] = 1;
  ShellsSeen seen;
  for (std::size_t s = 0; s < meets.size(); ++s) {
    if (meets[s] != 0) continue;
    const std::uint32_t vertex = part.shells().vertices[s];
    if (winding_number(solid.bvh(), part.mesh().vertices[vertex]).value_or(0) == 0) {
      seen.outside = true;
    } else if (!seen.inside) {
      seen.inside = true;
      seen.vertex_inside = vertex;
    }
  }
  return seen;
}

/// Where a surface meets the other's, and for shells that meet none.
struct Seen {
  Lying at;
  std::optional<ClashPlace> inside;  // a vertex of one part inside of the other
};

Seen look(const ClashPart& a, const ClashPart& b, const std::vector<TrianglePair>& pairs) {
  Seen seen;
  if (!pairs.empty()) seen.at = lying_at_contact(a, b, pairs);
  std::vector<std::uint32_t> met_a, met_b;
  for (const TrianglePair& p : pairs) met_a.push_back(p.a), met_b.push_back(p.b);
  if (b.is_solid()) {
    const ShellsSeen of_a = free_shells(a, b, met_a);
    seen.at.a_in_b |= of_a.inside;
    seen.at.a_off_b |= of_a.outside;
    if (of_a.inside) seen.inside = {PlaceKind::vertex_of_a, of_a.vertex_inside, 0};
  }
  if (a.is_solid()) {
    const ShellsSeen of_b = free_shells(b, a, met_b);
    seen.at.b_in_a |= of_b.inside;
    seen.at.b_off_a |= of_b.outside;
    if (of_b.inside && !seen.inside) seen.inside = {PlaceKind::vertex_of_b, of_b.vertex_inside, 0};
  }
  return seen;
}

/// Points of triangles, each triangle's and all in order.
std::vector<std::array<Point3, 3>> sorted_triangles(const ClashPart& part) {
  const auto key = [](const Point3& p) { return std::tie(p.x, p.y, p.z); };
  const auto before = [&](const Point3& l, const Point3& r) { return key(l) < key(r); };
  std::vector<std::array<Point3, 3>> all;
  for (std::uint32_t t = 0; t < part.mesh().triangles.size(); ++t) {
    all.push_back(corners_of(part, t));
    std::ranges::sort(all.back(), before);
  }
  std::ranges::sort(all,
                    [&](const auto& l, const auto& r) { return std::ranges::lexicographical_compare(l, r, before); });
  return all;
}

bool are_same_sheets(const ClashPart& a, const ClashPart& b) {
  if (a.mesh().triangles.size() != b.mesh().triangles.size() || a.box() != b.box()) return false;
  return sorted_triangles(a) == sorted_triangles(b);
}

ClashPlace first_meeting(const std::vector<TrianglePair>& pairs) {
  const auto overlapping = std::ranges::find(pairs, Relation::overlapping, &TrianglePair::relation);
  const TrianglePair& pair = overlapping != pairs.end() ? *overlapping : pairs.front();
  return {PlaceKind::meeting, pair.a, pair.b};
}

void find_distance(const ClashPart& a, const ClashPart& b, double clearance, FoundClash& found) {
  const auto near = closest_triangles(a.bvh(), b.bvh(), {.first = true, .within = clearance});
  if (!near) return;
  found.clash.kind = ClashKind::within_clearance;
  found.clash.distance = near->closest.distance;
  found.at = {PlaceKind::nearest, near->a, near->b};
}

void tell_solids(const ClashPart& a, const ClashPart& b, bool measure, FoundClash& found) {
  Clash& clash = found.clash;
  Seen seen;
  // Whatever crosses will need the arrangement; that it does is no more than a guess that insides meet.
  const bool crosses = any_crosses(a, b, clash.meeting);
  if (crosses && a.is_simple() && b.is_simple()) {
    if (const auto common = common_of_one_piece_each(a, b, clash.meeting, measure)) {
      clash.kind = ClashKind::overlapping;
      if (measure) measure_in_common(a, b, *common, {true, true}, clash);
      return;
    }
  }
  if (!crosses) {
    seen = look(a, b, clash.meeting);
    if (!seen.at.a_in_b && !seen.at.b_in_a && !seen.at.same_side) {
      if (!clash.meeting.empty()) clash.kind = ClashKind::touching;
      return;
    }
  }
  const std::array<TriangleMesh, 2> meshes{a.mesh(), b.mesh()};
  const Arrangement of_both = arrange(meshes);
  world::tell_solids_apart(of_both, clash);
  if (clash.kind == ClashKind::touching) return;
  if (clash.meeting.empty() && seen.inside) found.at = *seen.inside;
  if (measure) world::measure_solids(a, b, of_both, clash);
}

void tell_solid_and_sheet(const ClashPart& a, const ClashPart& b, FoundClash& found) {
  Clash& clash = found.clash;
  const Seen seen = look(a, b, clash.meeting);
  const bool in = a.is_solid() ? seen.at.b_in_a : seen.at.a_in_b,
             off = a.is_solid() ? seen.at.b_off_a : seen.at.a_off_b;
  if (in && off) {
    clash.kind = ClashKind::overlapping;
  } else if (in) {
    clash.kind = ClashKind::enclosed;
    clash.inner = a.is_solid() ? 1U : 0U;
  } else if (!clash.meeting.empty()) {
    clash.kind = ClashKind::touching;
  }
  if (clash.meeting.empty() && seen.inside) found.at = *seen.inside;
}

void tell_sheets(const ClashPart& a, const ClashPart& b, Clash& clash) {
  if (clash.meeting.empty()) return;
  clash.kind = are_same_sheets(a, b)              ? ClashKind::duplicate
               : any_crosses(a, b, clash.meeting) ? ClashKind::overlapping
                                                  : ClashKind::touching;
}

}  // namespace
}  // namespace world

std::string_view name_of(ClashKind kind) {
  constexpr std::array<std::string_view, clash_kinds> names{
      "apart", "within clearance", "touching", "overlapping", "piercing through", "enclosed", "duplicate"};
  return names[static_cast<std::size_t>(kind)];
}

namespace world {

FoundClash find_clash_and_place(const ClashPart& a, const ClashPart& b, const ClashOptions& options) {
  FoundClash found;
  Clash& clash = found.clash;
  if (a.empty() || b.empty()) return found;
  if (boxes_meet(a.box(), b.box())) {
    clash.meeting = intersecting_pairs(a.bvh(), b.bvh(), {.execution = Execution::serial});
    if (!clash.meeting.empty()) found.at = first_meeting(clash.meeting);
    if (a.is_solid() && b.is_solid()) {
      tell_solids(a, b, options.measure, found);
    } else if (a.is_solid() || b.is_solid()) {
      tell_solid_and_sheet(a, b, found);
    } else {
      tell_sheets(a, b, clash);
    }
  }
  if (clash.kind == ClashKind::apart && options.clearance) find_distance(a, b, *options.clearance, found);
  return found;
}

Point3 place_of(const TriangleMesh& a, const TriangleMesh& b, const ClashPlace& at) {
  switch (at.kind) {
    case PlaceKind::meeting:
      return approximate(intersection(triangle_of(a, at.a), triangle_of(b, at.b)).vertices.front());
    case PlaceKind::nearest:
      return closest_points(triangle_of(a, at.a), triangle_of(b, at.b)).on_a;
    case PlaceKind::vertex_of_a:
      return a.vertices[at.a];
    case PlaceKind::vertex_of_b:
      return b.vertices[at.a];
    case PlaceKind::none:
      break;
  }
  return {};
}

}  // namespace world

Clash find_clash(const ClashPart& a, const ClashPart& b, const ClashOptions& options) {
  world::FoundClash found = world::find_clash_and_place(a, b, options);
  found.clash.place = world::place_of(a.mesh(), b.mesh(), found.at);
  return std::move(found.clash);
}

}  // namespace plumb
