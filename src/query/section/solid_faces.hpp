// Of corners and the bounds that each lies on: what is their hull, and which faces has it?
//
// Laws: those of query/section/solid.hpp, where every vertex of the hull is among the corners, every other corner is in
// the hull, and a hull without volume lies on one bound whole.  Nothing where the numbers T cannot tell.
// Source: Andrew 1979.
// Cost: n log n of the corners on each bound.
#pragma once

#include <algorithm>
#include <optional>

#include "plumb/query/section/solid.hpp"
#include "query/section/corner.hpp"

namespace plumb::query::meeting {

using Ids = std::vector<std::uint32_t>;  // of bounds, or of corners

/// A plane as an axis sees it: which one, and how corners turn there that are counterclockwise from outside.
struct FaceLook {
  std::size_t axis;
  Sign turn;
};
/// By the sign that the outward normal has along x, y and z.
template <class SignOf>
FaceLook face_look(const SignOf& outward) {
  for (const std::size_t axis : {2u, 0u, 1u}) {  // looks[1] is seen from behind
    if (const Sign up = outward(axis); up != Sign::zero) return {axis, axis == 1 ? -up : up};
  }
  return {2, Sign::zero};
}

template <class T>
struct SolidCorners {
  std::vector<Corner<T, 3>> corners;  // ascending, no two equal
  std::vector<Ids> on;                // the bounds that each lies on
};

/// The cycles of the bounds' faces, each from its least corner, counterclockwise from outside.
template <class T, class LookOf>
std::vector<Ids> face_cycles(const SolidCorners<T>& of, const std::vector<Ids>& on_bound, const LookOf& look_of,
                             CertainSigns& ask) {
  std::vector<Ids> faces, seen;
  for (std::size_t i = 0; i < on_bound.size(); ++i) {
    const Ids& ids = on_bound[i];
    if (ids.size() < 3 || std::ranges::find(seen, ids) != seen.end()) continue;  // of one plane with another
    const FaceLook look = look_of(i);
    if (look.turn == Sign::zero) continue;  // all of space
    seen.push_back(ids);
    const auto at = [&](std::size_t k) -> const Corner<T, 3>& { return of.corners[ids[k]]; };
    const auto chain = extreme_chain(ids.size(), at, looks[look.axis], ask);
    if (!ask.certain()) return {};
    if (chain.size() < 3) continue;  // an edge
    Ids face;
    for (const std::size_t k : chain) face.push_back(ids[k]);
    if (look.turn == Sign::negative) std::reverse(face.begin() + 1, face.end());
    faces.push_back(std::move(face));
  }
  return faces;
}

/// A corner inside of a face or an edge is none of the set's.
template <class T>
void keep_corners_of(std::vector<Ids>& faces, std::vector<Corner<T, 3>>& corners) {
  Ids number(corners.size(), 0);
  for (const Ids& face : faces) {
    for (const std::uint32_t c : face) number[c] = 1;
  }
  std::uint32_t kept = 0;
  for (std::size_t c = 0; c < number.size(); ++c) {
    if (number[c] == 0) continue;
    if (kept != c) corners[kept] = std::move(corners[c]);
    number[c] = kept++;
  }
  corners.erase(corners.begin() + kept, corners.end());
  for (Ids& face : faces) {
    for (std::uint32_t& c : face) c = number[c];
  }
}

/// look_of(i) is bound i's FaceLook, name(corner) the corner's ExactPoint3, if it can be named.
template <class T, class LookOf, class Name>
std::optional<SolidIntersection3> solid_of(SolidCorners<T> of, std::size_t bounds, const LookOf& look_of,
                                           const Name& name, CertainSigns& ask) {
  auto& corners = of.corners;
  const auto told = [&](IntersectionKind kind) -> std::optional<SolidIntersection3> {
    SolidIntersection3 common;
    common.kind = kind;
    common.vertices.reserve(corners.size());
    for (const Corner<T, 3>& c : corners) {
      auto point = name(c);
      if (!point) return {};
      common.vertices.push_back(std::move(*point));
    }
    return common;
  };
  if (corners.size() < 3) {
    return told(
        std::array{IntersectionKind::nothing, IntersectionKind::point, IntersectionKind::segment}[corners.size()]);
  }
  std::vector<Ids> on_bound(bounds);
  for (std::uint32_t c = 0; c < corners.size(); ++c) {
    for (const std::uint32_t i : of.on[c]) on_bound[i].push_back(c);
  }
  for (std::size_t i = 0; i < bounds; ++i) {
    if (on_bound[i].size() != corners.size()) continue;
    const FaceLook look = look_of(i);
    if (look.turn == Sign::zero) continue;  // all of space
    corners = extreme(corners, looks[look.axis], ask);
    if (!ask.certain()) return {};
    return told(corners.size() == 2 ? IntersectionKind::segment : IntersectionKind::polygon);
  }
  std::vector<Ids> faces = face_cycles(of, on_bound, look_of, ask);
  if (!ask.certain()) return {};
  keep_corners_of(faces, corners);
  std::ranges::sort(faces);
  auto common = told(IntersectionKind::solid);
  if (!common) return {};
  common->first.push_back(0);
  for (const Ids& face : faces) {
    common->corners.insert(common->corners.end(), face.begin(), face.end());
    common->first.push_back(static_cast<std::uint32_t>(common->corners.size()));
  }
  return common;
}

}  // namespace plumb::query::meeting
