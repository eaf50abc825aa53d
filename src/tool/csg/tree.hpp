// Which tree of solids does a text mean? Its leaves as meshes, placed, and its operations.
//
// Laws: (1) matrices are composed exactly, and each coordinate of a leaf is rounded once, to the nearest double; how many
// were is counted.  A matrix that mirrors turns faces, one that flattens makes an empty solid.  (2) What is read from a
// file is named from the folder of the text.  (3) A hull is that of leaves which are united, placed and in hulls alone.
// (4) What is not known, has no flat sides or bounds nothing throws Error, which names the text, the line and the call.
// Source: OpenSCAD's manual.
// Cost: linear in the leaves' triangles; n log n for a hull.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plumb/surface/solid/evaluate.hpp"
#include "surface/file/placement.hpp"
#include "tool/csg/syntax.hpp"
#include "tool/mesh/asked_mesh.hpp"

namespace plumb::tool {

struct CsgScene {
  std::optional<Csg3> tree;  // none of an empty text
  std::vector<AskedMesh> imported;
  surface::Placed placed;  // coordinates of leaves under matrices
};

/// `text` is a name; no output may replace a file that is read.
CsgScene scene_of(const std::vector<CsgCall>& calls, const std::string& text, const ReadOptions& reading,
                  OutputFiles& outputs);

}  // namespace plumb::tool
