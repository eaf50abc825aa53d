// `plumb convert`: this mesh, as a file of another format.
//
// Laws: (1) faces and coordinates are those of the file read, bit for bit, with the exceptions of STL
// (plumb/surface/file/write_mesh.hpp); nothing is welded or repaired.  (2) No file that is there is replaced, unless that is
// asked for.  (3) The load report is said: what was left out, merged, or no double.
// Source: plumb/surface/file/read_mesh.hpp, write_mesh.hpp.
// Cost: theirs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/file/write_mesh.hpp"
#include "tool/mesh/inputs.hpp"

namespace plumb::tool {

struct ConvertOptions {
  MeshArguments files;                          // from, to; "-" is standard input, and standard output
  std::optional<std::string> format, encoding;  // of these names; otherwise what write_mesh does
  bool overwrite = false;
};

inline constexpr std::string_view format_names[] = {"obj", "off", "stl", "ply"};
inline constexpr std::string_view encoding_names[] = {"ascii", "binary", "binary-big-endian"};

int run_convert(const ConvertOptions& options);

}  // namespace plumb::tool
