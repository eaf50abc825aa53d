// Which triangles are meant?  Those of an answer as an OBJ file, for people to look at beside the mesh.
//
// Laws: (1) coordinates are the mesh's, every bit of them; faces turn as they do there.  (2) Each group is an object of
// its name, without the vertices that it does not use; one without triangles is left out.  (3) Before a face stands its
// number in the mesh, as a comment.  (4) No file that is there is replaced, unless that is asked for.
// Source: the format as Wavefront published it.
// Cost: linear; the file's text is held in memory.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {

struct ObjOutput {
  std::optional<std::string> path;  // "-" is standard output
  bool overwrite = false;
};

/// Some triangles of a mesh, by their numbers.
struct TriangleGroup {
  std::string_view name;
  const TriangleMesh* mesh;
  std::vector<std::uint32_t> triangles;
};

/// Ascending, each once.
std::vector<std::uint32_t> distinct(std::vector<std::uint32_t> triangles);

/// `about` becomes the first line.
std::string triangles_obj(std::string_view about, std::span<const TriangleGroup> groups);

/// Promises --obj; throws Error also for a name that ends like another format's.
void promise_obj(OutputFiles& outputs, const ObjOutput& obj);

}  // namespace plumb::tool
