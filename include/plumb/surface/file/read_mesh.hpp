// What mesh does a file hold?  OBJ, OFF, STL (ASCII and binary), PLY (ASCII, both binary byte orders), 3MF, glTF and
// GLB, each of them also packed by gzip.
//
// Laws: decimals become their nearest doubles, float32 widens exactly; polygons, repeated vertices and zero area stay
// as they are in the file (STL, which has no indices, gets one vertex per distinct point, -0 and +0 being one point, in
// the order of first use).  Indices are in range, coordinates finite, or the file is refused.  Memory is bounded by a
// small multiple of the file's size, never by a number that the file claims; and of what packing and parts make of it
// by the limits given.
// - 3MF: the items of the build with their components, also in parts of their own (production extension); other
//   extensions are passed over.  Decimals become doubles, in the file's unit, which the report tells.
// - glTF, GLB: the triangles, strips and fans of the default scene's nodes (of all, where it has no scenes), buffers in
//   the file, as data URIs and in files beside it; sparse accessors.  Points, lines, skins and morph targets are passed
//   over; Draco, meshopt, quantized positions and GPU instancing are refused by name.
//   In both a part is where its transforms put it: read as it is where they are the identity, otherwise each coordinate
//   the double nearest to the exact product of all of them, and counted.  A transform that mirrors turns the faces.
// - Packed by gzip (part.stl.gz, known by its content): unpacked first, each member held to its checksum.
// - OBJ: v, f (any corner form, negative indices, forward references), continued lines; other statements of the format
//   are not read.  A line that is none, or says more than its statement, is passed over and told in the report.
// - OFF: the prefixes ST, C, N; a line for each vertex and face, behind which colors and the like may stand, or numbers
//   on any lines.
// - STL: words on any lines.  The name of a solid ends with its line, or where a facet begins.
// - PLY: any scalar types, faces and triangle strips; other elements and properties are passed over; numbers of ASCII on
//   any lines; a coordinate in it is read as the decimal that it is, also where the header calls it `float`.
// Faces of one or two corners, which OBJ, OFF and PLY allow, and the turns of strips, which name a vertex twice, are no
// surface: left out, and counted in the report.
// Source: RTCD 2.2.1.
// Cost: linear in the file (STL: n log n), some 50 to 100 MB/s for text.  Bounded by n log n operations for n bytes,
// and by most_bytes and most_ratio.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/file/mesh_file.hpp"

namespace plumb {

/// What a file has of one sort to which its format gives no meaning, and which was not read.
struct PassedOver {
  std::string what;  // "lines that are no statement of OBJ"
  std::uint64_t count = 0;
  std::optional<std::uint64_t> line, byte;  // where the first is
  std::string first;                        // what it says, in quotes where it is text
};

struct LoadReport {
  MeshFormat format = MeshFormat::obj;
  MeshEncoding encoding = MeshEncoding::ascii;
  std::uint64_t bytes = 0;         // unpacked
  std::uint64_t packed_bytes = 0;  // of the file that was packed by gzip, otherwise 0
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;             // as in the file, before triangulation
  std::uint64_t polygons = 0;          // those of more than three corners
  std::uint64_t fans = 0;              // polygons that project to no simple polygon (triangulate.hpp); by read_mesh
  std::uint64_t dropped_faces = 0;     // faces of fewer than three corners
  std::uint64_t merged_vertices = 0;   // STL corners that repeat a point already seen
  std::uint64_t decimals = 0;          // coordinates that were decimals
  std::uint64_t inexact_decimals = 0;  // those that are not exactly doubles
  double largest_move = 0;             // how far a decimal moved to its double, at most
  std::string_view unit{};             // "millimeter", where the file says; glTF's is always the meter
  std::uint64_t parts = 0;             // meshes placed by a 3MF's build or a glTF's nodes
  std::uint64_t transformed = 0;       // coordinates that a transform other than the identity has made
  std::uint64_t rounded = 0;           // those of them whose exact value is no double
  std::vector<std::string> files_beside{};  // that were read as well: a glTF's buffers
  std::vector<PassedOver> passed_over{};    // each sort once, in the order of their first
};

/// What becomes of a file that is not as its format has it.  Whatever a stricter reading takes, a laxer one reads alike.
enum class Strictness {
  strict,  // refused
  usual,   // refused, unless it is text for which the format has a place but no meaning: that is passed over
  lenient,  // read as far as its triangles can be told: bytes behind the last facet, counts that are wrong, an STL without
            // normals or `endsolid`, lines among its facets
};

/// How much a small file may become.  What is packed unpacks to no more than `most_bytes`, nor to more than
/// `most_ratio` times its own size, of which the first 16 MiB are free.  `points_too`: a file of vertices without a face,
/// a cloud of points, is no error.  What was passed over, the report lists.
struct ReadOptions {
  std::uint64_t most_bytes = std::uint64_t{4} << 30;
  std::uint64_t most_ratio = 250;
  bool points_too = false;
  Strictness strictness = Strictness::usual;
};

/// The mesh of a file, its polygons triangulated.  Throws MeshFileError.
TriangleMesh read_mesh(const std::string& path, LoadReport* report = nullptr, const ReadOptions& options = {});

/// The mesh of a file, its polygons kept.  Throws MeshFileError.
PolygonMesh read_polygon_mesh(const std::string& path, LoadReport* report = nullptr, const ReadOptions& options = {});

/// The mesh that these bytes are the file of; `name` stands for the file in errors.
PolygonMesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name, LoadReport* report = nullptr,
                       const ReadOptions& options = {});

/// The same of a file in any format, packed or not: the content tells, or the name's extension.
PolygonMesh parse_mesh(std::string_view bytes, const std::string& name, LoadReport* report = nullptr,
                       const ReadOptions& options = {});

}  // namespace plumb
