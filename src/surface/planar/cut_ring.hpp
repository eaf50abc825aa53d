// How is one closed path cut into triangles on its own corners, also where it touches itself?
//
// Laws: with success there are two triangles fewer than corners, every edge of the path is an edge of just one of them
// in the same direction, and they cover every point as often as the path winds around it: not at all or once, always
// with the same sign.  A path that does not touch itself has triangles with area only, which are its constrained
// Delaunay triangulation.  Where it touches itself, between parts that it joins without width, triangles have no area.
// False where edges cross, where the path winds in another way, and where it joins parts by an edge that has the
// outside on both sides, or goes along one edge twice in one direction.
// Source: RTCD 12.5.1.1 (bridges to holes); Toussaint and Avis 1982 for what is cut anew.
// Cost: that of the triangulation, then linear in the degrees of the corners.
//
// A station is a corner of the path, or a place where an edge passes one.  The half-edge that leaves a station has the
// inside on its left, up to the first one that comes in to a station at the same vertex.  If that is not the same
// station, the path is pinched there: it is divided into the rings of its faces, which triangles without area join.
// Stations that are no corners are taken out in the end: what lies about one is seen from the edge that passes it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::surface {

/// Triangles of indices of the ring's points, put at the end of `out`; nothing without success.
bool cut_ring(std::span<const Point2> ring, std::vector<std::array<std::uint32_t, 3>>& out);

/// The way in which a ring turns whose edges meet in their common corners alone; of any other nothing.
std::optional<Sign> turn_of_simple_ring(std::span<const Point2> ring);

}  // namespace plumb::surface
