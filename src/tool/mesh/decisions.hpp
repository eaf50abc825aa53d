// Which geometric decisions does mesh software take on this mesh?
//
// Eleven kinds, each a question put to one predicate at points of the mesh.  The same decision is then taken by every
// method (tool/trial/contestant.hpp) and compared (tool/check/mesh.hpp).
// Laws: the decisions and their order depend on the mesh alone; which edges are flat is decided exactly.
// Source: RTCD 3.1.6, 12.3, 12.4.
// Cost: one exact orient3d an edge to begin with, then a few copies a decision.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "plumb/arith/lattice.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb::tool {

enum class Kind : std::uint8_t {
  edge_convex,         // orient3d(a, b, c, d): does the edge ab of faces abc and bad bend away, stay flat, or bend in?
  edge_coplanar,       // orient3d(c, d, a, b): do the opposite vertices lie in one plane with the edge?
  edge_delaunay_flat,  // insphere(a, b, c, off, d), off beside their plane: is d in the circle of abc within the plane?
  edge_delaunay,       // insphere(a, b, c, d, e): does the next neighbor e lie in the sphere of the edge's two faces?
  face_side,           // orient3d(a, b, c, q): on which side of the face is q, one of sixteen fixed points?
  orient_yz,           // orient2d of a face seen along x, y and z
  orient_zx,
  orient_xy,
  circle_yz,  // incircle(a, b, c, d) of an edge's two faces seen along x, y and z
  circle_zx,
  circle_xy,
};

struct KindInfo {
  std::string_view name, predicate, question;
};

inline constexpr std::array<KindInfo, 11> kinds{{
    {"edge-convex", "orient3d", "is the edge convex, flat or reflex?"},
    {"edge-coplanar", "orient3d", "are the vertices opposite the edge coplanar with it?"},
    {"edge-delaunay-flat", "insphere", "is the flat edge locally Delaunay in its plane?"},
    {"edge-delaunay", "insphere", "is the edge locally Delaunay?"},
    {"face-side", "orient3d", "on which side of the face is a fixed point?"},
    {"orient2d-yz", "orient2d", "how does the face turn, seen along x?"},
    {"orient2d-zx", "orient2d", "how does the face turn, seen along y?"},
    {"orient2d-xy", "orient2d", "how does the face turn, seen along z?"},
    {"incircle-yz", "incircle", "is the edge locally Delaunay, seen along x?"},
    {"incircle-zx", "incircle", "is the edge locally Delaunay, seen along y?"},
    {"incircle-xy", "incircle", "is the edge locally Delaunay, seen along z?"},
}};

/// What the exact answers say of the mesh's interior edges.
struct EdgeAnswers {
  std::uint64_t convex = 0, flat = 0, reflex = 0;
};

class MeshDecisions {
 public:
  explicit MeshDecisions(const TriangleMesh& mesh, const MeshEdges& edges);

  [[nodiscard]] std::uint64_t count(Kind kind) const;
  [[nodiscard]] const EdgeAnswers& edge_answers() const { return answers_; }
  /// Of all coordinates that the decisions take: the mesh's, and those of points put beside flat edges.
  [[nodiscard]] Lattice lattice() const;

  /// The coordinates of decision i of a kind whose predicate is F.
  template <Formula F>
  [[nodiscard]] Coordinates<F> coordinates(Kind kind, std::uint64_t i) const {
    const std::array<Point3, 5> p = points(kind, i);
    return coordinates_of<F>(p, dropped_axis(kind));
  }

 private:
  struct FlatEdge {
    std::uint32_t edge;
    Point3 off;
  };
  struct BentEdge {
    std::uint32_t edge, next;
  };

  [[nodiscard]] std::array<Point3, 5> points(Kind kind, std::uint64_t i) const;

  static int dropped_axis(Kind kind) {
    const int k = static_cast<int>(kind), first = static_cast<int>(Kind::orient_yz);
    return k < first ? -1 : (k - first) % 3;
  }

  template <Formula F>
  static Coordinates<F> coordinates_of(const std::array<Point3, 5>& p, int dropped) {
    Coordinates<F> c{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(F::points); ++i) {
      const std::array<double, 3> x{p[i].x, p[i].y, p[i].z};
      if constexpr (F::dimension == 3) {
        for (std::size_t axis = 0; axis < 3; ++axis) c[3 * i + axis] = x[axis];
      } else {  // the two axes that follow the dropped one, in cyclic order
        c[2 * i] = x[static_cast<std::size_t>(dropped + 1) % 3];
        c[2 * i + 1] = x[static_cast<std::size_t>(dropped + 2) % 3];
      }
    }
    return c;
  }

  const TriangleMesh& mesh_;
  std::vector<InteriorEdge> edges_;
  std::vector<FlatEdge> flat_;
  std::vector<BentEdge> bent_;
  std::vector<Point3> fixed_;
  EdgeAnswers answers_;
};

}  // namespace plumb::tool
