// How does Python see a solid that operations made?  As exact as it is, or rounded once.
//
// Source: none.
// Cost: that of rounding, or a copy of none.
#pragma once

#include <memory>

#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"
#include "python/mesh.hpp"

namespace plumb::python {

inline Pieces pieces_of(bool merge) { return merge ? Pieces::of_polygons : Pieces::of_triangles; }

/// Numbers of meshes and of their triangles; -1 for those that a plane made.
py::array_t<std::int32_t> told_sources(const std::vector<SourceFace>& sources);
/// plumb.Combined
py::object shown(RoundedMesh rounded);

}  // namespace plumb::python
