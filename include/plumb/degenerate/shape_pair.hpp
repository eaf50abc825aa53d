// How can two shapes lie to one another?  Pairs of shapes in special positions, exactly so and nearly so.
//
// Each shape is made in integers on its side of a plane (a line, in the plane), with one of its features in it; both
// are then carried into space by one integer map.  So nothing is rounded, whatever the kinds.
// Laws: (1) The shapes keep the laws of shape.hpp.
// (2) Of those that lie `exactly` so, in the positions up to shared_face both shapes hold the point `contact`, and the
// plane through it with this normal has a on the side where normal . x is no more, b on the other: they meet, and only
// touch where one of them leaves the plane.  Of parallel ones the plane has b strictly on its side; of coplanar ones
// both on the same side.  Concentric shapes hold `contact` in their (relative) interiors; of contained ones
// the first holds the second, and equal and reversed ones are one set.
// (3) Those that lie `nearly` so are moved from there by a few units in the last place, of one coordinate or two or of
// the whole shape.
// (4) The same choices give the same pair, bit for bit, everywhere.
// A position that the kinds cannot have throws InvalidShape.
// Source: RTCD 11; the exact maps are the rotations of integer quaternions, and any others where nothing is round or
// rectangular.
// Cost: some us.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/degenerate/shape.hpp"

namespace plumb::degenerate {

enum class Position : unsigned char {
  vertex_on_vertex,
  vertex_on_edge,
  vertex_on_face,
  edge_across_edge,
  edge_along_edge,
  edge_on_face,
  face_on_face,
  shared_edge,
  shared_face,
  parallel,
  coplanar,
  perpendicular,
  concentric,
  contained,
  equal,
  reversed,
};

struct PositionInfo {
  Position position;
  std::string_view name;
  std::string_view about;
};

inline constexpr std::array positions = {
    PositionInfo{Position::vertex_on_vertex, "vertex_on_vertex", "one vertex, or point of a round surface, is common"},
    PositionInfo{Position::vertex_on_edge, "vertex_on_edge", "a vertex of one lies on an edge of the other"},
    PositionInfo{Position::vertex_on_face, "vertex_on_face", "a vertex of one lies on a face of the other"},
    PositionInfo{Position::edge_across_edge, "edge_across_edge", "an edge crosses an edge, from outside"},
    PositionInfo{Position::edge_along_edge, "edge_along_edge", "two edges lie on one line and overlap"},
    PositionInfo{Position::edge_on_face, "edge_on_face", "an edge of one lies on a face of the other"},
    PositionInfo{Position::face_on_face, "face_on_face", "two faces lie in one plane and overlap"},
    PositionInfo{Position::shared_edge, "shared_edge", "an edge is common, with both of its ends"},
    PositionInfo{Position::shared_face, "shared_face", "a face is common, with all of its vertices"},
    PositionInfo{Position::parallel, "parallel", "two faces or edges are parallel, some way apart"},
    PositionInfo{Position::coplanar, "coplanar", "a face of each lies in one plane, the shapes on the same side of it"},
    PositionInfo{Position::perpendicular, "perpendicular", "one stands upright on a face of the other"},
    PositionInfo{Position::concentric, "concentric", "the middles are common"},
    PositionInfo{Position::contained, "contained", "the first contains the second, and may touch it from within"},
    PositionInfo{Position::equal, "equal", "both are the same numbers"},
    PositionInfo{Position::reversed, "reversed", "the same, with its vertices or axes named the other way round"},
};

constexpr std::string_view name_of(Position position) { return positions[static_cast<std::size_t>(position)].name; }

constexpr std::optional<Position> position_named(std::string_view name) {
  for (const PositionInfo& info : positions) {
    if (info.name == name) return info.position;
  }
  return std::nullopt;
}

enum class Nearness : unsigned char { exactly, nearly };

struct ShapePair {
  std::vector<double> a, b;
  std::array<double, 3> contact{}, normal{};  // of the plane two numbers each
};

/// Whether shapes of these kinds can lie so.
bool has_position(ShapeKind a, ShapeKind b, int dimension, Position position);

ShapePair shape_pair(ShapeKind a, ShapeKind b, int dimension, Position position, Nearness nearness, Entropy& entropy);

/// Any position that these kinds can have, exactly or nearly so.
ShapePair any_shape_pair(ShapeKind a, ShapeKind b, int dimension, Entropy& entropy);

}  // namespace plumb::degenerate
