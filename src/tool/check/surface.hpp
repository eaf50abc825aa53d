// The surface of a mesh in a report: what is wrong with it (plumb/surface/topology/faults.hpp), in words.
//
// Source: RTCD 12.3, 12.4.
// Cost: that of find_faults.
#pragma once

#include <optional>
#include <string>

#include "surface/topology/fault_words.hpp"

namespace plumb::tool {

/// The name stands at a bar of progress.
SurfaceFaults check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                            const std::string& name, std::optional<double> nearer_than = {});

using surface::surface_verdict, surface::shown_shells;

/// "turn shell 1": what the shells that are inside out ask for.
std::string turning_advice(const SurfaceFaults& check);

}  // namespace plumb::tool
