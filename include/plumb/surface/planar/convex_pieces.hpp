// Which convex polygons make up a polygon, without new points?
//
//   for (const std::vector<std::uint32_t>& piece : convex_pieces(holed)) use(piece);   // indices, counterclockwise
//
// Laws: each piece is convex and has area; pieces overlap nowhere and cover what triangulate covers by the same rule;
// every corner of a piece is a vertex of the polygon, and vertices on straight edges stay.  No two neighbors could be
// one convex piece along their common edge.  Of a polygon without holes there are at most four times as many pieces as
// the fewest: no more than two edges at a reflex corner keep it convex, so that with r of them at most 2 r + 1 pieces
// are left, and one edge can end at two of them only, so that there are at least r / 2 + 1.  fewest_convex_pieces has
// the fewest.
// Errors are those of triangulate_polygon.hpp; fewest_convex_pieces throws InvalidShape for what is not simple.
// Source: RTCD 12.5.2; Hertel and Mehlhorn 1983; Keil and Snoeyink 2002.
// Cost: that of the triangulation, then a sort of its edges.  Bounded by n^2 signs, fewest_convex_pieces by n^3 signs.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/surface/planar/triangulate_polygon.hpp"

namespace plumb {

std::vector<std::vector<std::uint32_t>> convex_pieces(const Polygon2& polygon, WindingRule rule = WindingRule::odd);
std::vector<std::vector<std::uint32_t>> convex_pieces(const HoledPolygon2& polygon,
                                                      WindingRule rule = WindingRule::odd);

/// The polygon's edges must meet in their common corners alone.
std::vector<std::vector<std::uint32_t>> fewest_convex_pieces(const Polygon2& polygon);

/// The triangles, which must overlap nowhere, are joined over the edges that two of them have in common.
std::vector<std::vector<std::uint32_t>> convex_pieces(std::span<const Point2> points, const CornerTriangles& triangles);

}  // namespace plumb
