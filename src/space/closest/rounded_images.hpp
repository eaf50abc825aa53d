// How far do moved surfaces deviate?  By meshes of doubles near to their exact images, and how far off these are.
//
// Law: the interval of the rounded images, widened by how far any vertex of either was moved, holds the distance of the
// exact ones.
// Source: RTCD 3.2; that the distance moves by no more than the farthest point does is the triangle inequality.
// Cost: a copy of each tree, fitted to the images.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "plumb/space/bvh/refit.hpp"
#include "plumb/space/closest/hausdorff.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/closest/hausdorff_tolerance.hpp"
#include "space/closest/nearby_corner.hpp"
#include "space/closest/numbered_triangles.hpp"

namespace plumb::space {

/// What makes every image a double, which is below 2^2050 in size, and the root of its inverse; powers of two, exact.
inline constexpr double smaller = 0x1p-1030, larger_by_half = 0x1p515;

inline MeshPose::Rows rows_of(const MeshPose& pose) {
  if (pose.matrix() == nullptr) return pose.rows();
  const auto& [c, t] = *pose.matrix();
  const auto row = [](double u, double v, double w, double shift) {
    return std::array{Interval(u), Interval(v), Interval(w), Interval(shift)};
  };
  return {row(c[0].x, c[1].x, c[2].x, t.x), row(c[0].y, c[1].y, c[2].y, t.y), row(c[0].z, c[1].z, c[2].z, t.z)};
}

/// A mesh of doubles near to the images of its vertices, all of them moved by -origin and times a scale.
struct RoundedImage {
  Bvh bvh;
  double off;  // no vertex is farther from the exact one

  RoundedImage(const PosedMesh& mesh, const Point3& origin, double scale) : bvh(mesh.bvh), off(0) {
    if (mesh.pose == identity_pose && origin == Point3{0, 0, 0} && scale == 1) return;
    query::NearbyPlaces near;
    const MeshPose::Rows rows = rows_of(mesh.pose);
    const Interval by(scale);
    const auto part = [&](const std::array<Interval, 4>& row, double from, const Point3& p) {
      const auto& [u, v, w, shift] = row;
      return by * u * Interval(p.x) + by * v * Interval(p.y) + by * w * Interval(p.z) +
             (by * shift - by * Interval(from));
    };
    std::vector<Point3> places;
    places.reserve(bvh.vertices.size());
    for (const Point3& p : bvh.vertices.view()) {
      places.push_back(near(part(rows[0], origin.x, p), part(rows[1], origin.y, p), part(rows[2], origin.z, p)));
    }
    off = near.off();
    refit(bvh, places);
  }
};

struct RoundedImages {
  Point3 origin;
  double scale;
  RoundedImage a, b;

  RoundedImages(const PosedMesh& x, const PosedMesh& y, const Point3& from, double by)
      : origin(from), scale(by), a(x, from, by), b(y, from, by) {}
  /// Far from the origin what both are moved by is left out; beyond the doubles all is made smaller.
  static RoundedImages of(const PosedMesh& a, const PosedMesh& b) {
    RoundedImages images(a, b, {0, 0, 0}, 1);
    if (images.off() == 0) return images;
    const MeshPose::Rows rows = rows_of(a.pose);
    const Point3 t{rows[0][3].lower, rows[1][3].lower, rows[2][3].lower};
    if (RoundedImages moved(a, b, t, 1); moved.off() < images.off()) images = std::move(moved);
    if (images.off() < Interval::infinity) return images;
    return {a, b, {0, 0, 0}, smaller};
  }
  /// No distance is farther off: that of two surfaces changes by no more than their farthest vertices move.
  [[nodiscard]] double off() const { return sum_above(a.off, b.off); }
  [[nodiscard]] double extent() const {
    return std::fmax(NumberedTriangles(a.bvh).extent(), NumberedTriangles(b.bvh).extent());
  }
};

/// ask(the image of a, that of b, the options for them).
template <class Ask>
HausdorffDistance of_images(const PosedMesh& a, const PosedMesh& b, HausdorffOptions options, const Ask& ask) {
  const RoundedImages images = RoundedImages::of(a, b);
  options.absolute *= images.scale;
  HausdorffDistance h = ask(images.a.bvh, images.b.bvh, options);
  h.least = std::fmax(0, difference_below(h.least, images.off()));
  h.most = sum_above(h.most, images.off());
  if (&a.bvh == &b.bvh && a.pose == b.pose) h.least = h.most = 0;
  h.is_within = is_near_enough(options, images.extent(), {h.least, h.most});
  if (images.scale != 1) {  // back, which is exact or overflows
    for (double* x : {&h.least, &h.most, &h.point.x, &h.point.y, &h.point.z})
      *x *= larger_by_half, *x *= larger_by_half;
    h.least = std::fmin(h.least, std::numeric_limits<double>::max());
  }
  h.point = {h.point.x + images.origin.x, h.point.y + images.origin.y, h.point.z + images.origin.z};
  return h;
}

}  // namespace plumb::space
