// How are solids of solids asked for and told in C?
//
// Source: none.
// Cost: none beside that of the operations.
#pragma once

#include <string>

#include "c/handles.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"

namespace plumb::c {

inline Pieces pieces_of(int merges) { return merges != 0 ? Pieces::of_polygons : Pieces::of_triangles; }

/// A plumb_operation without PLUMB_MERGE_PIECES, of meshes or of exact ones.
template <class Mesh>
ExactMesh combined(int operation, const std::vector<Mesh>& meshes, Pieces pieces) {
  constexpr auto rule = WindingRule::positive;
  const std::span<const Mesh> all(meshes);
  switch (operation) {
    case PLUMB_UNITE:
      return unite(all, rule, pieces);
    case PLUMB_INTERSECT:
      return intersect(all, rule, pieces);
    case PLUMB_SUBTRACT:
      return subtract(all, rule, pieces);
    case PLUMB_SYMMETRIC_DIFFERENCE:
      return symmetric_difference(all, rule, pieces);
    default:
      break;
  }
  throw InvalidArgument("operation " + std::to_string(operation) + " is none");
}

/// The report may be NULL.
inline plumb_mesh* told_solid(RoundedMesh made, plumb_solid_report* report) {
  if (report != nullptr) write(report, plumb_solid_report{0, made.sound, made.moved});
  return new plumb_mesh{std::move(made.mesh)};
}

}  // namespace plumb::c
