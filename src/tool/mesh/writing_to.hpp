// In which format is a mesh written under this name?  That of its extension; standard output has none: it is OBJ.
//
// Source: plumb/surface/file/write_mesh.hpp.
// Cost: none.
#pragma once

#include <string>

#include "plumb/surface/file/write_mesh.hpp"

namespace plumb::tool {

/// "-" is standard output.
inline WriteOptions writing_to(const std::string& path) {
  return path == "-" ? WriteOptions{.format = MeshFormat::obj} : WriteOptions{};
}

}  // namespace plumb::tool
