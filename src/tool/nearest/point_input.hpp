// Which points does a file hold?  Those of its rows, or the vertices of a mesh.
//
//   0.5,1                        x, y: a point in the plane
//   0.5,1,2                      x, y, z: one in space
//
// Law: points have the numbers of the rows, or of the mesh's vertices, from 0.
// Source: tool/rows/number_table.hpp.
// Cost: that of reading.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "plumb/arith/point.hpp"
#include "tool/rows/number_table.hpp"

namespace plumb::tool {

struct PointInput {
  std::string name;
  std::optional<AskedMesh> mesh;  // whose vertices they are
  bool is_planar = false;
  std::vector<Point2> plane;  // either these
  std::vector<Point3> space;  // or these
  std::size_t inexact = 0;    // points with decimals that are no doubles

  [[nodiscard]] std::size_t size() const { return is_planar ? plane.size() : space.size(); }
};

/// Of a file, or of standard input for "-"; no output may replace what is read.
PointInput read_point_file(const std::string& file, const ReadOptions& reading, const OutputFiles& outputs);

}  // namespace plumb::tool
