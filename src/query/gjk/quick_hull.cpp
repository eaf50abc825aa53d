// A guess in doubles, which holds no bound.
#include "query/gjk/quick_hull.hpp"

#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/weighted_pose.hpp"

namespace plumb::query {

bool QuickHull::set(const BodyView& body) {
  take_pose(body.pose);
  if (body.is_hull()) {
    at_ = body.vertices.data(), size_ = static_cast<std::uint32_t>(body.vertices.size());
    return size_ > 0;
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
    take_pose(core.pose());
    return true;
  }
  if (core.size() > few_.size()) return false;
  for (std::size_t i = 0; i < core.size(); ++i) {
    const arith::Plain p = core.at<double>(i);
    few_[size_++] = {p.x, p.y, p.z};
  }
  at_ = few_.data(), is_given_ = has_errors_ = false;
  return true;
}

void QuickHull::take_pose(const AnyPoseView& pose) {
  is_posed_ = !pose.stands(), is_given_ = pose.stands();
  if (pose.stands()) return;
  const auto by = weighted_pose<double>(pose);
  const double over = 1 / by.weight;
  for (std::size_t k = 0; k < 3; ++k) columns_[k] = by.columns[k] * over;
  translation_ = by.translation * over;
}

bool QuickHull::set_few(const FigureView& figure) {
  return with_figure(figure, [this]<class Shape>(const Shape& s) {
    constexpr FigureKind kind = figure_kind<Shape>;
    if constexpr (has_boundary<Shape> && !is_one_of(kind, {FigureKind::quadrilateral, FigureKind::polygon,
                                                           FigureKind::holed_polygon, FigureKind::convex_polyhedron})) {
      if (is_nothing(s)) return false;
      constexpr bool are_sums = is_one_of(kind, {FigureKind::obb, FigureKind::rectangle, FigureKind::lozenge});
      using Number = std::conditional_t<are_sums, Running, double>;
      for_each_corner<Number>(s, [this](const arith::Vec<Number>& p) {
        if constexpr (are_sums) {
          few_[size_] = {p.x.value, p.y.value, p.z.value}, off_[size_] = {p.x.error, p.y.error, p.z.error};
        } else {
          few_[size_] = {p.x, p.y, p.z};
        }
        ++size_;
      });
      at_ = few_.data(), is_given_ = is_given_ && !are_sums;
      return true;
    } else {
      return false;
    }
  });
}

bool QuickHull::is_finite() const {
  double sum = 0;
  for (std::uint32_t i = 0; i < size_; ++i) sum += sum_of(at_[i]);
  return is_real(sum);
}

}  // namespace plumb::query
