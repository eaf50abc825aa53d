// How do the parts that a file places become one mesh?  Vertices moved once per placement, faces after them.
//
// Laws: (1) the parts stand in the order of being placed; a map that mirrors turns its faces round, so that outside
// stays outside.  (2) What parts multiply to meets the limit before memory does.
// Source: RTCD 2.2.1.
// Cost: that of the placements.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "surface/file/mesh_parsers.hpp"
#include "surface/file/placement.hpp"

namespace plumb::surface {

/// How deep parts may lie in parts: what real files need many times over, and short enough for exact maps.
inline constexpr std::size_t deepest_part = 256;

class Assembly {
 public:
  explicit Assembly(Parse& parse) : parse_(parse), left_(parse.limit) {}

  /// What is about to be taken: fails where it is more than the limit leaves.
  void charge(std::uint64_t count, std::uint64_t bytes_each);

  /// A file of this size is read as well: the limit grows as if it were in the one that names it.
  void also_read(std::uint64_t bytes);

  /// The vertices, moved; the number of the first of them in the mesh.  `part` is named in errors.
  std::uint32_t place(std::span<const Point3> vertices, const Placement& placement, const std::string& part);
  /// Triangles of vertices so numbered from `first` on.
  void add(std::span<const TriangleMesh::Triangle> triangles, std::uint32_t first, const Placement& placement);

 private:
  Parse& parse_;
  std::uint64_t left_;
};

}  // namespace plumb::surface
