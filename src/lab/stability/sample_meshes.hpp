// Which meshes are the experiments on closed surfaces run on?  A ball and a machined part, and files where given.
//
// Laws: the generated meshes are closed and oriented; the same bits from every compiler (+ - * / and sqrt alone).
// Source: RTCD 12.1.
// Cost: milliseconds; files as read_mesh has it, when they are listed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::lab::stability {

/// An octahedron whose faces are cut in four `times` times, its vertices moved onto the unit sphere, as doubles can.
TriangleMesh ball_mesh(int times);

struct NamedMesh {
  std::string name, about;
  std::function<TriangleMesh()> make;
};

/// Those that are made when they are asked for.
std::vector<NamedMesh> generated_meshes(bool quick);

/// Of the folder, by name.  Throws MeshFileError for one that cannot be read, Error for one without faces and where
/// there are none.
std::vector<NamedMesh> real_meshes(const std::string& folder);

}  // namespace plumb::lab::stability
