// Which meshes does a command line mean?  Files, every mesh in a folder, and standard input.
//
// Laws: (1) a folder means the files in it and in its folders, in the order of their paths, whose names end like those
// of meshes; what else lies there is passed over, and said so.  (2) Links to folders are not followed, so a walk ends.
// (3) "-" is standard input, once.
// Source: none.
// Cost: a look at each name in the folders.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "plumb/surface/read_mesh.hpp"

namespace plumb::tool {

/// What one argument means.
struct MeshInputs {
  std::vector<std::string> files;
  std::vector<std::string> passed_over;  // in a folder: no meshes by their names, and folders that cannot be read
};

/// Of one argument; throws MeshFileError for a folder that holds no mesh or cannot be read.
MeshInputs mesh_inputs(const std::string& argument);

/// The mesh of a file, or of standard input for "-".  Throws MeshFileError, and Error where that cannot be read.
PolygonMesh read_input(const std::string& file, LoadReport* report, const ReadOptions& options);

/// How an input is called: "standard input" for "-".
std::string name_of_input(const std::string& file);

}  // namespace plumb::tool
