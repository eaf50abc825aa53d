// How are the faults of a surface told in C?
//
// Source: none.
// Cost: none.
#pragma once

#include "plumb/plumb.h"
#include "plumb/surface/topology/faults.hpp"

namespace plumb::c {

inline plumb_faults told_faults(const SurfaceFaults& found) {
  plumb_faults out{};
  out.is_sound = !found.any();
  out.closed = found.closed;
  out.oriented = found.oriented;
  out.touching_pairs = found.met.touching;
  out.overlapping_pairs = found.met.overlapping;
  out.degenerate_triangles = found.degenerate;
  out.repeated_vertices = found.repeated_vertices;
  out.shells = found.shells.size();
  out.inside_out_shells = found.inside_out_shells;
  out.open_edges = found.open_edges;
  out.non_manifold_edges = found.non_manifold_edges;
  out.non_manifold_vertices = found.non_manifold_vertices;
  out.vertices_on_edges = found.vertices_on_edges;
  out.duplicate_triangles = found.duplicate_triangles;
  return out;
}

}  // namespace plumb::c
