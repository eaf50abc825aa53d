#include "plumb/space/bsp/build_bsp.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "figure/basic/mesh_input.hpp"
#include "space/bsp/checked_polygons.hpp"
#include "space/bsp/leaf_labels.hpp"
#include "space/bsp/plane_choice.hpp"
#include "space/cells/three_points.hpp"

namespace plumb {
namespace {

using space::DividedPieces;
using space::ListedPiece;
using space::PieceList;

/// What is to become the child of a node.
struct BspTask {
  PieceList pieces;
  std::uint32_t parent;
  bool in_front;
  std::size_t depth, chain;
};

class BspBuilder {
 public:
  BspBuilder(BspTree& tree, const BspOptions& options) : tree_(tree), options_(options) {}

  void build(PieceList all) {
    tree_.pieces.clear();
    tree_.first_piece.clear();
    todo_.push_back({std::move(all), none, true, 0, 0});
    while (!todo_.empty()) {
      BspTask task = std::move(todo_.back());
      todo_.pop_back();
      place(std::move(task));
    }
    tree_.first_piece.push_back(static_cast<std::uint32_t>(tree_.pieces.size()));
    tree_.report.pieces = tree_.pieces.size();
    tree_.pieces.push_back({0, static_cast<std::uint32_t>(tree_.corners.size())});
    tree_.report.nodes = tree_.nodes.size();
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  static constexpr std::size_t most = BspChild::solid_bit;

  void hang(const BspTask& task, BspChild child) {
    if (task.parent == none) {
      tree_.root = child;
    } else {
      (task.in_front ? tree_.nodes[task.parent].front : tree_.nodes[task.parent].back) = child;
    }
  }

  void keep_pieces(const PieceList& list) {
    tree_.first_piece.push_back(static_cast<std::uint32_t>(tree_.pieces.size()));
    for (const ListedPiece& p : list.pieces) {
      tree_.pieces.push_back({p.face, static_cast<std::uint32_t>(tree_.corners.size())});
      for (const space::GuessedCorner& c : list.corners_of(p)) tree_.corners.push_back(c.corner);
    }
    if (tree_.corners.size() >= most)
      throw InvalidShape("build_bsp: the pieces have more than 2^30 corners; divide fewer polygons at once");
  }

  void place(BspTask task) {
    const bool stores_leaves = options_.kind == BspKind::leaf_storing;
    std::optional<DividedPieces> parts;
    std::uint32_t plane = 0;
    if (task.pieces.pieces.size() > (stores_leaves ? options_.leaf_size : 0)) {
      const space::PlaneChoice choice = choose_plane(tree_, task.pieces, options_);
      if (choice.across) parts = across(task.pieces, *choice.across, plane);
      if (!parts && choice.face) {
        plane = BspCorner::face_plane | *choice.face;
        parts = divided(tree_, task.pieces, plane);
      }
    }
    if (!parts) return make_leaf(task);
    task.pieces = {};
    make_node(task, std::move(*parts), plane);
  }

  /// Nothing where that would not leave fewer pieces on both sides.
  std::optional<DividedPieces> across(const PieceList& list, const BspAxisPlane& across, std::uint32_t& plane) {
    tree_.axis_planes.push_back(across);
    plane = BspCorner::axis_plane | static_cast<std::uint32_t>(tree_.axis_planes.size() - 1);
    DividedPieces parts = divided(tree_, list, plane);
    const std::size_t n = list.pieces.size(), front = parts.front.pieces.size(), back = parts.back.pieces.size();
    if (front > 0 && back > 0 && front < n && back < n) return parts;
    tree_.axis_planes.pop_back();
    return {};
  }

  void make_leaf(const BspTask& task) {
    const auto number = static_cast<std::uint32_t>(tree_.report.leaves++);
    tree_.report.depth = std::max(tree_.report.depth, task.depth);
    if (options_.kind == BspKind::leaf_storing) keep_pieces(task.pieces);
    hang(task, {BspChild::leaf_bit | number});
  }

  void make_node(const BspTask& task, DividedPieces parts, std::uint32_t plane) {
    const auto number = static_cast<std::uint32_t>(tree_.nodes.size());
    BspNode node{0, 3, space::number_of_plane(plane), {}, {}};
    if (space::is_axis_plane(plane)) {
      node.axis = tree_.axis_planes.back().axis;
      node.at = tree_.axis_planes.back().at;
      ++tree_.report.axis_nodes;
    }
    tree_.nodes.push_back(node);
    hang(task, {number});
    tree_.report.splits += parts.splits;
    if (options_.kind == BspKind::leaf_storing) {
      for (const ListedPiece& p : parts.coplanar.pieces)
        parts.front.add(p.face, parts.coplanar.corners_of(p), !space::is_axis_plane(plane));
    } else {
      keep_pieces(parts.coplanar);
    }
    const bool is_chain = parts.front.pieces.empty() || parts.back.pieces.empty();
    const std::size_t chain = is_chain ? task.chain + 1 : 0;
    tree_.report.longest_chain = std::max(tree_.report.longest_chain, chain);
    todo_.push_back({std::move(parts.back), number, false, task.depth + 1, chain});
    todo_.push_back({std::move(parts.front), number, true, task.depth + 1, chain});
  }

  BspTree& tree_;
  const BspOptions& options_;
  std::vector<BspTask> todo_;
};

double largest_coordinate(const std::vector<Point3>& vertices) {
  double most = 0;
  for (const Point3& p : vertices) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most > 0 ? most : 1;
}

template <class T>
std::size_t bytes_of(const std::vector<T>& all) {
  return all.size() * sizeof(T);
}

}  // namespace

BspTree build_bsp(const PolygonMesh& mesh, const BspOptions& options) {
  space::require_convex_faces(mesh);
  const bool is_solid = options.kind == BspKind::solid_leaf;
  const TriangleMesh fans = is_solid ? space::fans_of(mesh) : TriangleMesh{};
  if (is_solid) space::require_closed(fans);
  BspTree tree;
  tree.kind = options.kind;
  tree.mesh = mesh;
  tree.reach = largest_coordinate(mesh.vertices);
  const PolygonFaces faces{tree.mesh};
  PieceList all;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const auto named = faces[f];
    const auto plane = space::plane_of_chain(named.size(), [&](std::size_t k) { return faces.at(named[k]); });
    tree.planes.push_back(plane);
    if (space::on_one_line(plane[0], plane[1], plane[2])) {
      ++tree.report.faces_left_out;
    } else {
      space::add_polygon(tree, f, all);
    }
  }
  BspBuilder(tree, options).build(std::move(all));
  if (is_solid) space::label_leaves(tree, fans);
  tree.report.bytes = sizeof(BspTree) + bytes_of(tree.nodes) + bytes_of(tree.first_piece) + bytes_of(tree.pieces) +
                      bytes_of(tree.corners) + bytes_of(tree.axis_planes) + bytes_of(tree.planes) +
                      bytes_of(tree.mesh.vertices) + bytes_of(tree.mesh.corners) + bytes_of(tree.mesh.first);
  return tree;
}

BspTree build_bsp(const TriangleMesh& mesh, const BspOptions& options) {
  require_mesh("build_bsp", mesh);
  return build_bsp(polygon_mesh(mesh), options);
}

}  // namespace plumb
