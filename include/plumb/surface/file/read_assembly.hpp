// Which parts does a file hold, each by its name?  The nodes of a glTF, the items of a 3MF's build, the objects or groups
// of an OBJ; of any other file the one mesh.
//
// Laws: (1) the parts together are the mesh that read_mesh reads, cut where parts begin: its coordinates, faces and
// limits.  (2) A part is a node with a mesh; an object that a build's item places, itself or by components; of an OBJ all
// faces behind an `o` of one name, or of one `g` where there is no `o`.  What stands before the first is a part of the
// file's name.  (3) A part without a name is called by its number in the file; names need not differ.  (4) A part of a glTF or
// 3MF that cannot be read is left out, and is in `unread` by its name with what is wrong; what is wrong with the file
// as a whole (a node that is reached twice, XML or JSON that is none) throws, as read_mesh does.  (5) Parts without a
// triangle are left out.
// Source: RTCD 2.2.1.
// Cost: that of read_mesh, and a search for each vertex among those of its part.  Bounded by n log n operations.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {

struct AssemblyPart {
  std::string name;
  TriangleMesh mesh;
};

struct UnreadPart {
  std::string name, why;
};

struct AssemblyParts {
  std::vector<AssemblyPart> parts;
  std::vector<UnreadPart> unread;
};

/// Throws MeshFileError.
AssemblyParts read_assembly(const std::string& path, LoadReport* report = nullptr, const ReadOptions& options = {});
/// The bytes are those of a file of that name.
AssemblyParts parse_assembly(std::string_view bytes, const std::string& name, LoadReport* report = nullptr,
                             const ReadOptions& options = {});

}  // namespace plumb
