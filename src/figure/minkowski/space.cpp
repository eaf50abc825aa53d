// From vertex to vertex of the sum along its edges: at a vertex a + b the sum looks like the cone of all edges that
// leave a and b, of which the extreme ones are its edges.
#include <algorithm>
#include <unordered_map>

#include "figure/basic/finite_parts.hpp"
#include "figure/minkowski/cone.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/minkowski/minkowski.hpp"

namespace plumb {
namespace {

using figure::minkowski::Cone;
using figure::minkowski::Edge;

/// The vertices of a hull, and for each the ends of its edges.
struct Body {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> index;
  std::vector<std::vector<std::uint32_t>> near;
};

Body body_of(std::vector<Point3> points, const char* function, const char* part, bool negated) {
  figure::require_finite_points(function, part, std::span<const Point3>(points));
  if (negated) {
    for (Point3& p : points) p = {-p.x, -p.y, -p.z};
  }
  const Hull3 hull = convex_hull(points);
  Body body;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (const std::uint32_t v : hull.vertices) {
    number.emplace(v, static_cast<std::uint32_t>(body.vertices.size()));
    body.vertices.push_back(points[v]);
    body.index.push_back(v);
  }
  body.near.resize(body.vertices.size());
  for (std::size_t f = 0; f < hull.face_count(); ++f) {
    const auto face = hull.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = number.at(face[i]), b = number.at(face[(i + 1) % face.size()]);
      body.near[a].push_back(b);
      if (hull.dimension == 2) body.near[b].push_back(a);
    }
  }
  if (hull.dimension == 1) body.near = {{1}, {0}};
  return body;
}

std::uint32_t smallest(const Body& body) {
  std::uint32_t least = 0;
  for (std::uint32_t i = 1; i < body.vertices.size(); ++i) {
    if (compare_lexicographically(body.vertices[i], body.vertices[least]) == Sign::negative) least = i;
  }
  return least;
}

/// A vertex of the sum, by the vertices of the bodies, and those at the far ends of its edges, in turn.
struct Node {
  std::uint32_t a, b;
  std::vector<std::uint32_t> ends;
};

class EdgeWalk {
 public:
  EdgeWalk(const Body& a, const Body& b) : a_(a), b_(b) {
    const std::uint32_t start = found(smallest(a), smallest(b));
    settle(start, figure::minkowski::cone(edges(start)));
    // Ends, for each pair of vertices is a node once.
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      // What was found from here is settled at once: the edge back is where its cone begins.
      for (const std::uint32_t end : std::vector(nodes_[n].ends)) {
        if (settled_[end]) continue;
        settle(end, figure::minkowski::cone(edges(end), edge_back(end, n)));
      }
    }
  }

  [[nodiscard]] MinkowskiSum3 sum() const {
    MinkowskiSum3 made;
    for (const Node& n : nodes_)
      made.vertices.push_back({a_.vertices[n.a], b_.vertices[n.b], a_.index[n.a], b_.index[n.b]});
    made.dimension = static_cast<int>(std::min<std::size_t>(nodes_[0].ends.size(), 3));
    if (made.dimension == 3) add_faces(made);
    if (made.dimension == 2) add_polygon(made);
    return made;
  }

 private:
  std::uint32_t found(std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(nodes_.size());
    const auto [at, is_new] = number_.emplace(std::uint64_t{a} << 32 | b, next);
    if (is_new) {
      nodes_.push_back({a, b, {}});
      settled_.push_back(false);
    }
    return at->second;
  }

  [[nodiscard]] std::vector<Edge> edges(std::uint32_t node) const {
    const Node& n = nodes_[node];
    std::vector<Edge> all;
    for (const std::uint32_t to : a_.near[n.a]) all.push_back({a_.vertices[n.a], a_.vertices[to], to, {}});
    for (const std::uint32_t to : b_.near[n.b]) all.push_back({b_.vertices[n.b], b_.vertices[to], {}, to});
    return all;
  }

  /// Which of the edges of `node` leads toward `from`.
  [[nodiscard]] std::size_t edge_back(std::uint32_t node, std::uint32_t from) const {
    const std::vector<Edge> all = edges(node);
    const Node &n = nodes_[node], &f = nodes_[from];
    std::size_t i = 0;
    while (n.a != f.a ? all[i].to_a != f.a : all[i].to_b != f.b) ++i;
    return i;
  }

  void settle(std::uint32_t node, const Cone& cone) {
    settled_[node] = true;
    for (const Edge& e : cone) {
      const std::uint32_t end = found(e.to_a.value_or(nodes_[node].a), e.to_b.value_or(nodes_[node].b));
      nodes_[node].ends.push_back(end);
    }
  }

  /// Around a face, with the face on the left: at each vertex the edge that follows the one it was reached by.  Ends,
  /// for each edge is gone along once.
  void add_faces(MinkowskiSum3& made) const {
    std::vector<std::vector<bool>> done;
    for (const Node& n : nodes_) done.emplace_back(n.ends.size(), false);
    for (std::uint32_t v = 0; v < nodes_.size(); ++v) {
      for (std::size_t e = 0; e < nodes_[v].ends.size(); ++e) {
        if (done[v][e]) continue;
        std::uint32_t at = v;
        std::size_t edge = e;
        while (!done[at][edge]) {
          done[at][edge] = true;
          made.corners.push_back(at);
          const std::uint32_t to = nodes_[at].ends[edge];
          const auto& ends = nodes_[to].ends;
          const auto back = std::ranges::find(ends, at) - ends.begin();
          edge = (static_cast<std::size_t>(back) + 1) % ends.size();
          at = to;
        }
        made.first.push_back(static_cast<std::uint32_t>(made.corners.size()));
      }
    }
  }

  void add_polygon(MinkowskiSum3& made) const {
    const Cone cone = figure::minkowski::cone(edges(0));
    // Every node has two ends, so that the walk comes back to where it began.
    std::uint32_t from = 0, at = nodes_[0].ends[figure::minkowski::turns_left(cone[0], cone[1]) ? 0 : 1];
    made.corners.push_back(0);
    while (at != 0) {
      made.corners.push_back(at);
      const std::uint32_t next = nodes_[at].ends[nodes_[at].ends[0] == from ? 1 : 0];
      from = at;
      at = next;
    }
    made.first.push_back(static_cast<std::uint32_t>(made.corners.size()));
  }

  const Body &a_, &b_;
  std::vector<Node> nodes_;
  std::vector<bool> settled_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
};

MinkowskiSum3 sum(const Body& a, const Body& b) {
  return a.vertices.empty() || b.vertices.empty() ? MinkowskiSum3{} : EdgeWalk(a, b).sum();
}

MinkowskiSum3 sum(std::span<const Point3> a, std::span<const Point3> b, const char* function, bool negated) {
  return sum(body_of({a.begin(), a.end()}, function, "a", false),
             body_of({b.begin(), b.end()}, function, "b", negated));
}

}  // namespace

MinkowskiSum3 minkowski_sum(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  return sum(a.mesh.vertices, b.mesh.vertices, "minkowski_sum", false);
}
MinkowskiSum3 minkowski_sum(std::span<const Point3> a, std::span<const Point3> b) {
  return sum(a, b, "minkowski_sum", false);
}
MinkowskiSum3 minkowski_difference(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b) {
  return sum(a.mesh.vertices, b.mesh.vertices, "minkowski_difference", true);
}
MinkowskiSum3 minkowski_difference(std::span<const Point3> a, std::span<const Point3> b) {
  return sum(a, b, "minkowski_difference", true);
}

}  // namespace plumb
