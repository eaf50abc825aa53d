// What is the mesh of a case?  Points, and triangles that name them, to be judged and changed as a whole.
//
// A surface closes by places, not by indices: equal points are one place, whatever their numbers, so that a mesh whose
// triangles share no index can be closed as well.  0.0 and -0.0 are the same.
// Laws: (1) a triangle with two corners in one place closes by itself; (2) whatever moves all points of a place
// together keeps a closed mesh closed.
// Source: a surface without boundary is a cycle of chains of triangles.
// Cost: n log n.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "degenerate/fields.hpp"

namespace plumb::degenerate {

struct MeshCase {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// Of a field of points, and of one that names them.
MeshCase mesh_of(const Field& points, const Field& triangles, std::span<const double> numbers);
/// The case with another mesh in their place.
Numbers with_mesh(std::span<const double> numbers, const Field& points, const Field& triangles, const MeshCase& mesh);

/// Of each point the least number of those in its place.
std::vector<std::size_t> places_of(const MeshCase& mesh);

/// An edge that is passed oftener from `from` to `to` than back, by `times`.
struct OpenEdge {
  std::size_t from, to;
  int times;
};
/// By places; none of a mesh that closes.
std::vector<OpenEdge> open_edges(const MeshCase& mesh);

bool is_closed(const MeshCase& mesh);

/// The triangles that come an odd number of times, by places, and have three of them: those that bound something.
std::vector<std::array<std::size_t, 3>> odd_triangles(const MeshCase& mesh);

}  // namespace plumb::degenerate
