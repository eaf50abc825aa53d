// What find_clash finds before its place is made a point: for pairs that are each other's images, which have it elsewhere.
//
// Source: none.
// Cost: that of find_clash.
#pragma once

#include "plumb/world/clash.hpp"

namespace plumb::world {

enum class PlaceKind : unsigned char { none, meeting, nearest, vertex_of_a, vertex_of_b };

/// Two triangles that meet or are nearest, or a vertex, whose number is `a`.
struct ClashPlace {
  PlaceKind kind = PlaceKind::none;
  std::uint32_t a = 0, b = 0;
};

struct FoundClash {
  Clash clash;  // without its place
  ClashPlace at;
};

FoundClash find_clash_and_place(const ClashPart& a, const ClashPart& b, const ClashOptions& options);

Point3 place_of(const TriangleMesh& a, const TriangleMesh& b, const ClashPlace& at);

}  // namespace plumb::world
