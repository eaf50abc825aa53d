// What is said of a hull: faces merged into polygons, or cut into triangles, in the order that the laws fix.
#pragma once

#include "figure/hull/hull2_steps.hpp"
#include "figure/hull/hull3_surface.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb::figure::hull3 {

/// Faces, one after the other, starting anywhere.
class FaceList {
 public:
  void corner(std::uint32_t index) { corners_.push_back(index); }
  void close() { first_.push_back(static_cast<std::uint32_t>(corners_.size())); }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    corners_.insert(corners_.end(), {a, b, c});
    close();
  }
  /// A polygon that is strictly convex, as a fan from its smallest index.
  void fan(std::span<const std::uint32_t> polygon);
  void polygon(std::span<const std::uint32_t> polygon) {
    corners_.insert(corners_.end(), polygon.begin(), polygon.end());
    close();
  }

  /// Each face from its smallest index, and the faces by their first two corners (law 4); empties the list.
  void move_to(Hull3& hull);

 private:
  std::vector<std::uint32_t> corners_, first_{0};
};

/// All points as corners: swept from the lexicographically first to the last.  The points are sorted, distinct, and not
/// on one line; triangles are counterclockwise, or clockwise if `flipped`.
void sweep(std::span<const figure::hull2::Indexed> points, bool flipped, FaceList& faces);

/// The faces of a surface that has grown to the hull.
Hull3 faces_of(const Surface& surface, std::size_t input_size, const HullOptions& options);

/// With every point of the boundary, which the surface has kept in its lists.
Hull3 faces_with_all_points(const Surface& surface, std::size_t input_size, bool triangulate);

/// The hull of points whose affine hull is no more than a plane, given as that and as points that span it.
Hull3 flat_hull(std::span<const Point3> points, int dimension, const std::array<Point3, 3>& span,
                const HullOptions& options);

/// Marks of the input in ascending order.
class IndexSet {
 public:
  explicit IndexSet(std::size_t size) : marked_(size, 0) {}
  void insert(std::uint32_t index) {
    count_ += marked_[index] == 0 ? 1 : 0;
    marked_[index] = 1;
  }
  [[nodiscard]] std::vector<std::uint32_t> ascending() const {
    std::vector<std::uint32_t> all;
    all.reserve(count_);
    for (std::size_t i = 0; i < marked_.size(); ++i) {
      if (marked_[i] != 0) all.push_back(static_cast<std::uint32_t>(i));
    }
    return all;
  }

 private:
  std::vector<unsigned char> marked_;
  std::size_t count_ = 0;
};

/// Which half-edges lie within a polygon, between triangles of one plane; and the polygons' boundaries.
class Outlines {
 public:
  explicit Outlines(const Surface& surface);
  [[nodiscard]] bool inner(Id half_edge) const { return inner_[half_edge] != 0; }
  [[nodiscard]] bool any_inner() const { return any_inner_; }
  /// On the boundaries of how many polygons the node is: 0 within one, 2 within an edge, 3 and more at a vertex.
  [[nodiscard]] Id degree(Id node) const { return degree_[node]; }
  /// The next half-edge of the polygon's boundary.  Found around the node, where there is at least this polygon's other
  /// boundary half-edge.
  [[nodiscard]] Id next(Id half_edge) const {
    Id h = next_in_face(half_edge);
    while (inner(h)) h = next_in_face(surface_.twin(h));
    return h;
  }
  /// Calls visit(half-edges of one boundary) for each polygon.
  template <class Visit>
  void each(Visit visit) const {
    std::vector<unsigned char> done(inner_.size(), 0);
    std::vector<Id> loop;
    for (Id h = 0; h < inner_.size(); ++h) {
      if (done[h] != 0 || inner(h) || !surface_.faces()[h / 3].alive()) continue;
      loop.clear();
      for (Id at = h; done[at] == 0; at = next(at)) {
        done[at] = 1;
        loop.push_back(at);
      }
      visit(std::span<const Id>(loop));
    }
  }

 private:
  const Surface& surface_;
  std::vector<unsigned char> inner_;
  std::vector<Id> degree_;
  bool any_inner_ = false;
};

}  // namespace plumb::figure::hull3
