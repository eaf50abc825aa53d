// What does the embedded part look like before it is turned?  A bolted flange, closed and clean, on a short lattice.
//
// A round plate with a chamfered foot and a filleted rim, a hub with a fillet at its base, a bore with a chamfer,
// eight counterbored holes on a bolt circle, four blind holes with drill points in the hub's face.
//
// Laws: (1) every coordinate is a multiple of 2^-10, at most 64 in magnitude (the one raised cap center apart), so what
// is drawn flat is exactly flat; (2) the surface is closed, oriented outward, every edge has two faces, its genus is 9
// (a bore and eight holes); (3) only + - * / and sqrt on doubles: the same bits from every compiler and library.
// Source: RTCD 12.1 (what a sound boundary is).
// Cost: below a millisecond.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::tool {

using Ring = std::vector<std::uint32_t>;  // vertices of a closed loop, counterclockwise seen against the surface normal

struct Flange {
  TriangleMesh mesh;
  Ring bore_edge;                               // where the hub's face meets the bore's chamfer
  std::uint32_t bore_first = 0, bore_last = 0;  // the triangles of the bore's surface, half open
  std::uint32_t rim_first = 0;   // first triangle of the rim's wall: its first side lies on the chamfer's upper edge
  std::uint32_t cap_center = 0;  // the nearly flat floor's middle, 2^-36 off its plane
  std::vector<std::uint32_t> cap_faces;  // the faces around it
};

Flange build_flange();

}  // namespace plumb::tool
