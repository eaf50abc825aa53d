// Which meshes are the experiments on closed surfaces run on?  A ball and a machined part, and files where given.
//
// Laws: the generated meshes are closed and oriented; the same bits from every compiler (+ - * / and sqrt alone).
// Source: RTCD 12.1; cost: milliseconds; files as read_mesh has it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plumb/figure/mesh.hpp"
#include "tool/stability/experiment.hpp"

namespace plumb::tool::stability {

/// An octahedron whose faces are cut in four `times` times, its vertices moved onto the unit sphere, as doubles can.
TriangleMesh ball_mesh(int times);

/// A mesh by its name, made or read when it is asked for.
struct NamedMesh {
  std::string name, about;
  std::function<TriangleMesh()> make;
};

/// The generated ones, and those of the folder of real meshes, by name.
std::vector<NamedMesh> sample_meshes(const Settings& settings);

}  // namespace plumb::tool::stability
