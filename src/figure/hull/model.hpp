// A hull in doubles, for searches: unit normals, edges with their faces, and climbing from vertex to vertex.
//
// Laws: none that decisions may rest on: the numbers are rounded.  What is found here is made certain afterwards
// (figure/obb/enclose.hpp).
// Source: RTCD 4.2.5 for climbing.
// Cost: a sort of the edges; a climb a few steps from where it starts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "figure/basic/frame.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::figure::frame {

struct HullModel {
  struct Edge {
    std::uint32_t from, to;     // counterclockwise around `left`
    std::uint32_t left, right;  // faces
  };

  std::vector<Vector3> vertices;  // localized
  std::vector<Vector3> normals;   // of faces, outward, unit
  std::vector<Edge> edges;
  std::vector<std::uint32_t> corners, first;  // of faces
  std::vector<std::uint32_t> neighbors, first_neighbor;

  /// Of a hull of dimension 3.
  HullModel(const Hull3& hull, std::span<const Point3> points);

  /// A vertex farthest along d, climbing from v.
  [[nodiscard]] std::uint32_t climb(std::uint32_t v, const Vector3& d) const {
    double most = dot(vertices[v], d);
    for (;;) {  // ends, for `most` grows with each vertex and there are finitely many
      std::uint32_t next = v;
      bool is_level = false;
      for (std::uint32_t i = first_neighbor[v]; i < first_neighbor[v + 1]; ++i) {
        const double far = dot(vertices[neighbors[i]], d);
        is_level |= far > most - level;
        if (far > most) {
          most = far;
          next = neighbors[i];
        }
      }
      if (next == v) {
        next = is_level ? beyond_plateau(v, d) : v;
        if (next == v) return v;
        most = dot(vertices[next], d);
      }
      v = next;
    }
  }

 private:
  // What roundings do not tell apart, of vertices of magnitude one: a guess.
  static constexpr double level = 0x1p-48;
  // A vertex that is farther than v and beside those that are as far: of vertices that lie very close together, roundings
  // hide which of them leads on.  v where there is none.
  [[nodiscard]] std::uint32_t beyond_plateau(std::uint32_t v, const Vector3& d) const;
};

/// Near which vertex does a climb along d end?  A table over directions.
class ClimbStarts {
 public:
  explicit ClimbStarts(const HullModel& model);
  [[nodiscard]] std::uint32_t farthest(const Vector3& d) const { return model_.climb(start_[cell(d)], d); }

 private:
  static std::size_t cell(const Vector3& d);
  const HullModel& model_;
  std::vector<std::uint32_t> start_;
};

}  // namespace plumb::figure::frame
