// How are the faults of a surface told to readers?  In the words of every report, of the program and of Python.
//
// Source: RTCD 12.3, 12.4.
// Cost: none that counts.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plumb/surface/topology/faults.hpp"

namespace plumb::surface {

/// In the order in which reports name them.
enum class FaultKind : unsigned char {
  zero_area,
  repeated_vertex,
  close_vertices,
  duplicate,
  opposite,
  wall,
  vertex_on_edge,
  open_edge,
  non_manifold_edge,
  non_manifold_vertex,
  wound_edge,
  inside_out,
  crossing,
  overlapping,
  touching,
  unused_vertex
};
inline constexpr std::size_t fault_kinds = 16;

/// How many of a kind there are, and what one and several are called.
struct CountedFault {
  std::uint64_t count;
  std::string one, many;
};
std::array<CountedFault, fault_kinds> counted_faults(const SurfaceFaults& faults, const MeshStatistics& statistics);

/// "2 shells, closed, oriented, free of self-intersections, free of degenerate triangles"
std::string surface_verdict(const SurfaceFaults& faults);

/// Of the shells first those with something wrong, at most so many, in their order.
std::vector<std::size_t> shown_shells(const SurfaceFaults& faults, std::size_t most);
/// A line a shell, from the second on indented by so much; empty where there are none.  `rest`: where those are that
/// are too many to be shown.
std::string shell_lines(const SurfaceFaults& faults, const std::string& indent, const std::string& rest);

/// "1 open edge; 2 repeated vertices", "nothing"
std::string wrong_words(const SurfaceFaults& faults, const MeshStatistics& statistics);

}  // namespace plumb::surface
