// Which boxes of two wide nodes meet, and which triangles of two leaves may? Eight at once.
//
// Laws: boxes of one frame, exactly.  Triangles are left out only where their boxes are apart, or one lies on one side
// of the other's plane, surely: by the bound of a volume whose differences are within what both leaves extend.  No
// answer depends on the instruction set.
// Source: RTCD 6.6, 13.7; Moller 1997 for the planes.
// Cost: 64 boxes some 60 operations of eight lanes; a triangle against eight 70, of which 54 after the boxes.
#pragma once

#include <array>
#include <cstdint>

#include "plumb/space/bvh/wide_tree.hpp"

namespace plumb::space {

inline constexpr std::size_t most_in_lanes = 8;

/// Bit k of number i: the boxes of child i of a and child k of b meet.
using ChildrenMet = std::array<std::uint8_t, 8>;
ChildrenMet children_met(const WideNode<8>& a, const WideNode<8>& b);
/// The same for one child of a.
std::uint8_t children_met(const WideNode<8>& a, std::size_t child, const WideNode<8>& b);

/// Triangles number by number.
struct alignas(64) TriangleLanes {
  std::array<std::array<double, most_in_lanes>, 9> corners;  // a.x, a.y, a.z, b.x, ...; all lanes hold a triangle
  std::uint32_t n = 0;                                       // of them the first are asked for

  // By `complete`: from the least to the most, and normals; all triangles in a box.
  std::array<std::array<double, most_in_lanes>, 6> boxes;
  std::array<std::array<double, most_in_lanes>, 3> normals;
  std::array<double, 6> around;
};
void complete(TriangleLanes& lanes);

/// Bit k of number i: triangle i of a and triangle k of b may meet.
using MayMeet = std::array<std::uint8_t, most_in_lanes>;
void find_near(const TriangleLanes& a, const TriangleLanes& b, MayMeet& may);

}  // namespace plumb::space
