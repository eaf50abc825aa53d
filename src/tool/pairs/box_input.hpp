// Which boxes does a file hold?  Those of its rows, or those of a mesh's triangles.
//
//   0,0,1,1                      min x, min y, max x, max y: a box in the plane
//   0,0,0,1,1,1                  min x, min y, min z, max x, max y, max z: one in space
//
// Laws: (1) boxes have the numbers of the rows, or of the mesh's triangles, from 0.  (2) A box whose min is above its
// max throws Error, which names its row.
// Source: tool/rows/number_table.hpp.
// Cost: that of reading.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "tool/rows/number_table.hpp"

namespace plumb::tool {

struct BoxInput {
  std::string name;
  std::optional<AskedMesh> mesh;  // of whose triangles they are
  bool is_planar = false;
  std::vector<Aabb2> plane;  // either these
  std::vector<Aabb3> space;  // or these
  std::size_t inexact = 0;   // boxes with decimals that are no doubles

  [[nodiscard]] std::size_t size() const { return is_planar ? plane.size() : space.size(); }
};

/// Of a file, or of standard input for "-"; no output may replace what is read.
BoxInput read_boxes(const std::string& file, const ReadOptions& reading, const OutputFiles& outputs);

}  // namespace plumb::tool
