// The surface of a mesh in a report: what is wrong with it (plumb/surface/topology/faults.hpp), in words.
//
// Source: RTCD 12.3, 12.4.
// Cost: that of find_faults.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumb/surface/topology/faults.hpp"

namespace plumb::tool {

/// The name stands at a bar of progress.
SurfaceFaults check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                            const std::string& name, std::optional<double> nearer_than = {});

/// "2 shells, closed, oriented, free of self-intersections, free of degenerate triangles"
std::string surface_verdict(const SurfaceFaults& check);

/// "turn shell 1": what the shells that are inside out ask for.
std::string turning_advice(const SurfaceFaults& check);

/// The numbers of the shells that a report of at most so many shows: what is wrong first, in their order.
std::vector<std::size_t> shown_shells(const SurfaceFaults& check, std::size_t most);

}  // namespace plumb::tool
