// How does a mesh become a file?
//
// Laws: reading the file gives back the same faces and every coordinate bit for bit (decimals are the shortest that
// name the double), with two exceptions of STL: it knows no indices, so vertices come in the order of use and equal
// ones merge, and polygons are triangulated.  The file appears whole or not at all: it is written beside its place and
// renamed; a device or pipe is written in place. STL is written as text, for binary STL holds float32 only; when asked
// for it, a coordinate that is no float32 is refused, not rounded.  STL normals are written as 0 0 0 (the corners'
// order tells): a normal is rarely a double.
// Source: RTCD 2.2.1.
// Cost: linear; the file's bytes are held in memory once.  Bounded by n operations for n faces.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "plumb/arith/no_answer.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/file/mesh_file.hpp"

namespace plumb {

struct WriteOptions {
  std::optional<MeshFormat> format{};      // otherwise by the extension
  std::optional<MeshEncoding> encoding{};  // otherwise ASCII, for PLY binary little endian (coordinates in float64)
};

/// Throws MeshFileError; NonFinite for a NaN or infinity, Error for an index out of range, in the mesh.
void write_mesh(const std::string& path, const PolygonMesh& mesh, const WriteOptions& options = {});
void write_mesh(const std::string& path, const TriangleMesh& mesh, const WriteOptions& options = {});

PLUMB_NO_ANSWER(bool,
                "plumb: write_mesh takes a path and then a TriangleMesh or PolygonMesh, and WriteOptions: "
                "write_mesh(\"part.stl\", mesh)")
write_mesh(PLUMB_ANYTHING) PLUMB_DELETED;

/// The bytes of the file that write_mesh would write.  `name` stands for the file in errors.
std::string format_mesh(const PolygonMesh& mesh, MeshFormat format, std::optional<MeshEncoding> encoding = {},
                        std::string_view name = "mesh");
/// The same for a file of that name, whose extension tells the format unless the options do.
std::string format_mesh(const PolygonMesh& mesh, const std::string& path, const WriteOptions& options);

/// The same faces, as polygons of three corners.
PolygonMesh to_polygons(const TriangleMesh& mesh);

}  // namespace plumb
