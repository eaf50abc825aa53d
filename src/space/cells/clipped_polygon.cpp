#include "space/cells/clipped_polygon.hpp"

namespace plumb::space {

ClippedPolygon::ClippedPolygon(const Polygon3& polygon)
    : plane_(plane_of_chain(polygon.vertices.size(), [&](std::size_t k) { return polygon.vertices[k]; })) {
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) corners_.push_back({v[i], {true, v[i], v[(i + 1) % v.size()], {}}});
}

ExactPoint3 ClippedPolygon::crossing(const Edge& edge, const ThreePoints& plane) const {
  if (edge.is_given) return LinePlanePoint3{edge.a, edge.b, plane[0], plane[1], plane[2]};
  return ThreePlanePoint3{plane_, edge.plane, plane};
}

void ClippedPolygon::keep(const ThreePoints& plane) {
  std::vector<Sign> signs;
  bool cuts = false;
  for (const Corner& c : corners_) {
    signs.push_back(orient3d(plane[0], plane[1], plane[2], c.at));
    cuts |= signs.back() == Sign::negative;
  }
  if (!cuts) return;
  std::vector<Corner> kept;
  const Edge along{false, {}, {}, plane};
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Corner& here = corners_[i];
    const Sign now = signs[i], next = signs[(i + 1) % signs.size()];
    if (now == Sign::negative) {
      if (next == Sign::positive) kept.push_back({crossing(here.edge, plane), here.edge});
    } else if (next != Sign::negative) {
      kept.push_back(here);
    } else if (now == Sign::zero) {
      kept.push_back({here.at, along});
    } else {
      kept.push_back(here);
      kept.push_back({crossing(here.edge, plane), along});
    }
  }
  corners_ = std::move(kept);
}

std::vector<ExactPoint3> ClippedPolygon::corners() const {
  std::vector<ExactPoint3> told;
  for (const Corner& c : corners_) {
    if (told.empty() || (told.back() != c.at && told.front() != c.at)) told.push_back(c.at);
  }
  return told;
}

}  // namespace plumb::space
