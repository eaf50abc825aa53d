// Who reads which format?  One function a format; each fills a mesh and its share of the report, or throws.
//
// Law: they check indices and numbers as they go, so that errors have a line or byte; parse_mesh (read_mesh.cpp) does
// what is the same for all.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/file/decimal.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/mesh_failure.hpp"

namespace plumb::surface {

/// Where parts of a file begin, for readers that want them apart.
struct FileParts {
  enum class Kind : unsigned char {
    object,
    group,
    placed
  };  // what OBJ's `o` and `g` name, and what a node or item places
  struct Start {
    Kind kind;
    std::string name;
    std::size_t face;  // of the mesh: the first
  };
  struct Unread {
    std::string name, why;
  };
  std::vector<Start> starts;
  std::vector<Unread> unread;  // whose faces are left out
};

struct Parse {
  std::string_view bytes, file;
  std::uint64_t limit = 0;  // of what is unpacked, and of what parts multiply to, in bytes
  std::uint64_t read = 0;   // that are in files, this one and those beside it; the limit grows with them
  ReadOptions options{};
  std::filesystem::path folder{};  // where the files beside this one are; empty where it is no file
  PolygonMesh mesh{};
  LoadReport report{};
  DecimalReader decimals{};
  FileParts* parts = nullptr;  // where they are wanted

  [[nodiscard]] bool lenient() const { return options.strictness == Strictness::lenient; }

  /// Notes what is not read, `found` in a line, or where that is empty the file's end; a strict reading refuses it.
  /// `what` names the sort in the plural.
  void pass_over_in_line(std::string_view what, std::uint64_t line, std::string_view found);
  /// The same at a byte, of a lenient reading.
  void pass_over_at_byte(std::string_view what, std::uint64_t byte, const std::string& found);

  /// A part begins with the next face.
  void begin_part(FileParts::Kind kind, std::string_view name) {
    if (parts != nullptr) parts->starts.push_back({kind, std::string(name), mesh.first.size() - 1});
  }
  /// Calls put(), which puts a part of that name at the mesh's end.  Where parts are wanted and this one cannot be read,
  /// it is left out and noted.
  template <class Read>
  void read_part(const std::string& name, const Read& put) {
    if (parts == nullptr) return put();
    const std::size_t vertices = mesh.vertices.size(), corners = mesh.corners.size(), faces = mesh.first.size();
    begin_part(FileParts::Kind::placed, name);
    try {
      put();
    } catch (const MeshFileError& e) {
      if (e.problem == MeshFileProblem::too_large) throw;
      mesh.vertices.resize(vertices);
      mesh.corners.resize(corners);
      mesh.first.resize(faces);
      parts->starts.pop_back();
      parts->unread.push_back({name, e.what()});
    }
  }

  /// Ends the face whose corners were put at the end of mesh.corners; drops it when they are fewer than three.
  void end_face() {
    if (mesh.corners.size() - mesh.first.back() < 3) {
      mesh.corners.resize(mesh.first.back());
      ++report.dropped_faces;
    } else {
      if (mesh.corners.size() > std::numeric_limits<std::uint32_t>::max())
        fail_at_file(MeshFileProblem::unsupported, file,
                     "more than 4294967295 corners, expected fewer; cut the mesh up");
      mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
  }
};

void parse_obj(Parse& parse);
void parse_off(Parse& parse);
void parse_stl(Parse& parse);
void parse_ply(Parse& parse);
void parse_3mf(Parse& parse);
void parse_gltf(Parse& parse);

/// read_polygon_mesh, and where its parts begin.
PolygonMesh read_parts(const std::string& path, FileParts& parts, LoadReport* report, const ReadOptions& options);
PolygonMesh parse_parts(std::string_view bytes, const std::string& name, FileParts& parts, LoadReport* report,
                        const ReadOptions& options);

/// What a file of so many bytes may unpack to.
std::uint64_t unpacked_limit(std::uint64_t packed, const ReadOptions& options);

/// Is the length the one that an STL of so many triangles has, as told at its byte 80?
bool is_binary_stl(std::string_view bytes);

/// The first word of an OFF file: what stands before OFF, and the first count where it follows without a space.
struct OffHeader {
  std::string_view prefix, count;
};
std::optional<OffHeader> off_header(std::string_view word);

}  // namespace plumb::surface
