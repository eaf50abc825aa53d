// A guess in doubles, which holds no bound.
#include "query/gjk/quick_hull.hpp"

#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"

namespace plumb::query {

bool QuickHull::set(const BodyView& body) {
  if (!take_pose(body.pose)) return false;
  if (body.is_hull()) {
    at_ = body.vertices.data(), size_ = static_cast<std::uint32_t>(body.vertices.size());
    return size_ > 0 && body.radius == 0;
  }
  if (body.figure.kind != FigureKind::convex_polyhedron) return set_few(body.figure);
  solid_ = static_cast<const ConvexPolyhedron3*>(body.figure.shape);
  at_ = solid_->mesh.vertices.data(), size_ = static_cast<std::uint32_t>(solid_->mesh.vertices.size());
  return !solid_->mesh.corners.empty();
}

bool QuickHull::set(const CoreCorners& core) {
  if (const auto points = core.points(); !points.empty() && !core.has_scale()) {
    at_ = points.data(), size_ = static_cast<std::uint32_t>(points.size());
    solid_ = core.polyhedron();
    return take_pose(core.pose());
  }
  if (core.size() > few_.size()) return false;
  for (std::size_t i = 0; i < core.size(); ++i) {
    const arith::Plain p = core.at<double>(i);
    few_[size_++] = {p.x, p.y, p.z};
  }
  at_ = few_.data(), is_given_ = false;
  return true;
}

bool QuickHull::take_pose(const AnyPoseView& pose) {
  const auto* matrix = std::get_if<const Pose*>(&pose.by);
  if (matrix == nullptr && !pose.stands()) return false;
  pose_ = matrix == nullptr ? nullptr : *matrix, is_given_ = pose_ == nullptr;
  return true;
}

bool QuickHull::set_few(const FigureView& figure) {
  if (radius_of(figure) != 0) return false;
  const auto corners = CoreCorners::of(figure);  // of polygons none
  if (!corners) return false;
  for (std::size_t i = 0; i < corners->size(); ++i) {
    const arith::Plain p = corners->at<double>(i);
    few_[size_++] = {p.x, p.y, p.z};
  }
  at_ = few_.data();
  is_given_ = is_given_ && (corners->ways() == 0 || figure.kind == FigureKind::aabb);
  return true;
}

bool QuickHull::is_finite() const {
  double sum = 0;
  for (std::uint32_t i = 0; i < size_; ++i) sum += sum_of(at_[i]);
  return is_real(sum);
}

}  // namespace plumb::query
