// A guess in doubles, which holds no bound.
#include "query/gjk/quick_hull.hpp"

#include "query/convex/core.hpp"

namespace plumb::query {
namespace {

bool is_flat_polygon(FigureKind kind) { return is_one_of(kind, {FigureKind::quadrilateral, FigureKind::polygon}); }

}  // namespace

std::optional<QuickHull> QuickHull::of(const BodyView& body) {
  if (!body.is_hull() && is_flat_polygon(body.figure.kind)) return {};
  return of_sound(body);
}

std::optional<QuickHull> QuickHull::of_sound(const BodyView& body) {
  QuickHull h;
  h.pose_ = body.pose, h.is_given_ = body.pose == nullptr;
  const auto take = [&h](std::span<const Point3> list) {
    h.at_ = list.data(), h.size_ = static_cast<std::uint32_t>(list.size());
  };
  if (body.is_hull()) {
    take(body.vertices);
  } else if (body.figure.kind == FigureKind::convex_polyhedron) {
    h.solid_ = static_cast<const ConvexPolyhedron3*>(body.figure.shape);
    take(h.solid_->mesh.vertices);
    if (h.solid_->mesh.corners.empty()) return {};
  } else if (body.figure.kind == FigureKind::polygon) {
    take(static_cast<const Polygon3*>(body.figure.shape)->vertices);
  } else {
    if (radius_of(body.figure) != 0) return {};
    const auto corners = CoreCorners::of(BodyView{body.figure, {}, nullptr});
    if (!corners) return {};
    for (std::size_t i = 0; i < corners->size(); ++i) {
      const arith::Plain p = corners->at<double>(i);
      h.few_[h.size_++] = {p.x, p.y, p.z};
    }
    h.at_ = h.few_.data();
    h.is_given_ = h.is_given_ && (corners->ways() == 0 || body.figure.kind == FigureKind::aabb);
  }
  if (h.size_ == 0) return {};
  return h;
}

}  // namespace plumb::query
