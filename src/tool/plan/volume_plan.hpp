// Which bounding volume does a mesh's tree deserve where meshes are asked for the triangles that meet?  Measured on the
// mesh itself, against a copy of it that has been turned.
//
// Laws: (1) every kind answers the same question, and its pairs are compared with those of the mesh's own tree of boxes.
// (2) Taken is the kind of the least time a query.  (3) The counts depend on the mesh alone; times are the least of some
// runs, by one thread.  (4) A kind whose volumes no doubles hold is named as left out.
// Source: RTCD 6.1.1, 6.1.2; 13.1 (measure first).
// Cost: a tree of each kind for both meshes, of oriented boxes some microseconds a triangle; three queries of each.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/space/pairs/volume_pairs.hpp"

namespace plumb::tool {

struct VolumeTimes {
  std::string_view kind;
  double build_ms;  // of one tree, beyond the mesh's own
  double query_ms;
  PairWork work;  // of the mesh's own tree only the pairs that meet
  bool contradicts;
};

struct VolumePlan {
  std::vector<VolumeTimes> kinds;          // first the mesh's own tree
  std::vector<std::string_view> left_out;  // kinds beyond the doubles
  [[nodiscard]] const VolumeTimes& chosen() const;
};

/// Of a mesh without triangles: no kinds.
VolumePlan plan_volumes(const TriangleMesh& mesh);

}  // namespace plumb::tool
