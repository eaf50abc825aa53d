#include "space/bsp/plane_side.hpp"

#include <algorithm>

#include "plumb/certify/implicit.hpp"

namespace plumb {
namespace space {
namespace {

bool face_names(const BspTree& tree, std::uint32_t face, std::uint32_t vertex) {
  const auto first = tree.mesh.corners.begin() + tree.mesh.first[face];
  const auto last = tree.mesh.corners.begin() + tree.mesh.first[face + 1];
  return std::find(first, last, vertex) != last;
}

std::uint32_t vertex_number(const BspTree& tree, std::uint32_t face, std::uint32_t corner) {
  const std::uint32_t first = tree.mesh.first[face], count = tree.mesh.first[face + 1] - first;
  return tree.mesh.corners[first + (corner < count ? corner : corner - count)];
}

Sign vertex_side(const BspTree& tree, std::uint32_t plane, std::uint32_t vertex) {
  if (!is_axis_plane(plane) && face_names(tree, number_of_plane(plane), vertex)) return Sign::zero;
  return plane_side(tree, plane, tree.mesh.vertices[vertex]);
}

template <class Point>
Sign implicit_side(const BspTree& tree, std::uint32_t plane, const Point& p) {
  if (!is_axis_plane(plane)) {
    const auto& [a, b, c] = tree.planes[number_of_plane(plane)];
    return -orient3d(a, b, c, p);
  }
  const auto [axis, at] = tree.axis_planes[number_of_plane(plane)];
  const Point3 on{at, at, at};
  using predicates::HomogeneousOrder;
  if (axis == 0) return certify::mixed::first_sign<HomogeneousOrder<0>>(p, on);
  if (axis == 1) return certify::mixed::first_sign<HomogeneousOrder<1>>(p, on);
  return certify::mixed::first_sign<HomogeneousOrder<2>>(p, on);
}

LinePlanePoint3 point_on_edge(const BspTree& tree, std::uint32_t face, const BspCorner& c) {
  const auto cut = tree.points_of_plane(c.second);
  return {tree.vertex(face, c.first), tree.vertex(face, c.first + 1), cut[0], cut[1], cut[2]};
}

ThreePlanePoint3 point_in_face(const BspTree& tree, std::uint32_t face, const BspCorner& c) {
  return {tree.planes[face], tree.points_of_plane(c.first), tree.points_of_plane(c.second)};
}

}  // namespace

Sign plane_side(const BspTree& tree, std::uint32_t plane, const Point3& p) {
  if (is_axis_plane(plane)) {
    const auto [axis, at] = tree.axis_planes[number_of_plane(plane)];
    return beyond(along_axis(p, axis), at);
  }
  const auto& [a, b, c] = tree.planes[number_of_plane(plane)];
  return -orient3d(a, b, c, p);
}

Sign corner_side(const BspTree& tree, std::uint32_t plane, std::uint32_t face, const BspCorner& corner) {
  if (corner.second == BspCorner::no_plane) return vertex_side(tree, plane, vertex_number(tree, face, corner.first));
  if (corner.first == plane || corner.second == plane) return Sign::zero;
  if (is_plane(corner.first)) return implicit_side(tree, plane, point_in_face(tree, face, corner));
  const Sign from = vertex_side(tree, plane, vertex_number(tree, face, corner.first));
  const Sign to = vertex_side(tree, plane, vertex_number(tree, face, corner.first + 1));
  if (from * to != Sign::negative) return from != Sign::zero ? from : to;
  return implicit_side(tree, plane, point_on_edge(tree, face, corner));
}

}  // namespace space

std::array<Point3, 3> BspTree::points_of_plane(std::uint32_t plane) const {
  if (!space::is_axis_plane(plane)) return planes[space::number_of_plane(plane)];
  const auto [axis, at] = axis_planes[space::number_of_plane(plane)];
  if (axis == 0) return {Point3{at, 0, 0}, {at, reach, 0}, {at, 0, reach}};
  if (axis == 1) return {Point3{0, at, 0}, {0, at, reach}, {reach, at, 0}};
  return {Point3{0, 0, at}, {reach, 0, at}, {0, reach, at}};
}

std::vector<ExactPoint3> BspTree::corners_of(std::size_t piece, std::vector<ExactPoint3> rows) const {
  rows.clear();
  const std::uint32_t face = pieces[piece].face;
  for (const BspCorner& c : piece_corners(piece)) {
    if (c.second == BspCorner::no_plane) {
      rows.emplace_back(vertex(face, c.first));
    } else if (space::is_plane(c.first)) {
      rows.emplace_back(space::point_in_face(*this, face, c));
    } else {
      rows.emplace_back(space::point_on_edge(*this, face, c));
    }
  }
  return rows;
}

}  // namespace plumb
