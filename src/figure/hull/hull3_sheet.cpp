// Faces that are counterclockwise in one look, whose edges are matched, and whose rim goes around a convex region once,
// cover that region exactly once: how often a point is covered only changes where one crosses the rim.
#include <algorithm>

#include "figure/hull/hull3_proof.hpp"

namespace plumb::figure::hull3 {
namespace {

constexpr auto place_of = [](const auto& rim_point) { return std::pair(rim_point.p.x, rim_point.p.y); };

}  // namespace

Sheet::Sheet(const Checked& checked, Look look, Sign orientation)
    : checked_(checked), look_(look), orientation_(orientation), member_(checked.hull.face_count(), 0) {
  for (std::size_t f = 0; f < member_.size(); ++f) {
    const auto& s = checked.spanned[f];
    const auto seen = [&](std::size_t k) { return projected(look, checked.points[s[k]]); };
    if (sign_of(predicates::Orient2d{}, seen(0), seen(1), seen(2)) != orientation) continue;
    member_[f] = 1;
    ++faces_;
  }
  require(!empty(), "no face is seen from one side");

  const Index no_edge = ~Index{0};
  std::vector<Index> leaving(checked.points.size(), no_edge);  // the rim's edge that leaves a point
  std::size_t count = 0;
  Index any = no_edge;
  for (Index c = 0; c < checked.twin.size(); ++c) {
    if (!holds(checked.face_of[c]) || (checked.twin[c] != no_edge && holds(checked.face_of[checked.twin[c]]))) continue;
    Index& here = leaving[checked.hull.corners[c]];
    require(here == no_edge, "the faces seen from one side touch at point ", checked.hull.corners[c]);
    here = any = c;
    ++count;
  }
  require(any != no_edge, "the faces seen from one side have no rim");
  std::vector<Point2> loop;
  for (Index c = any; rim_.size() < count;) {
    rim_.push_back(c);
    loop.push_back(projected(look, checked.at(c)));
    c = leaving[checked.hull.corners[checked.next(c)]];
    require(c != no_edge && (c != any || rim_.size() == count),
            "the rim of the faces seen from one side is not one loop");
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t before = i == 0 ? loop.size() - 1 : i - 1, after = i + 1 == loop.size() ? 0 : i + 1;
    const Sign s = sign_of(predicates::Orient2d{}, loop[before], loop[i], loop[after]);
    rim_points_.push_back({loop[i], s != Sign::zero});
  }
  std::ranges::sort(rim_points_, {}, place_of);
  if (orientation == Sign::negative) std::ranges::reverse(loop);
  require(goes_around_once(loop, true), "the rim of the faces seen from one side is not convex");

  // Where a walk begins only matters to its length.
  Point2 high = low_ = loop.front();
  for (const Point2& p : loop) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  while (cells_ * cells_ < faces_) ++cells_;
  scale_ = {static_cast<double>(cells_) / (high.x - low_.x), static_cast<double>(cells_) / (high.y - low_.y)};
  start_.assign(cells_ * cells_, checked.face_of[any]);
  for (Index c = 0; c < checked.twin.size(); ++c) {
    if (holds(checked.face_of[c])) start_for(projected(look, checked.at(c))) = checked.face_of[c];
  }
}

Sign Sheet::turn(Index corner, const Point2& p) const {
  const Sign s = sign_of(predicates::Orient2d{}, projected(look_, checked_.at(corner)),
                         projected(look_, checked_.at(checked_.next(corner))), p);
  return orientation_ == Sign::negative ? -s : s;
}

bool Sheet::is_rim(Index corner) const {
  const Index twin = checked_.twin[corner];
  return twin == ~Index{0} || !holds(checked_.face_of[twin]);
}

std::optional<Index> Sheet::beyond(Index face, const Point2& p, Place& place) const {
  place = {face, false, false, false};
  // Where a face does not turn, p could be on the line of two edges and on neither: the bends alone are looked at.
  const std::span<const Index> bends(checked_.bend.begin() + checked_.first_bend[face],
                                     checked_.bend.begin() + checked_.first_bend[face + 1]);
  const auto passes = [&](Index edge) {
    const Sign s = turn(edge, p);
    if (s == Sign::zero) {
      place.on_edge = true;
      place.on_rim = place.on_rim || is_rim(edge);
    }
    return s != Sign::negative;
  };
  for (const Index edge : {bends.front(), bends.back()}) {
    if (!passes(edge)) return edge;
  }
  // In the angle at the first bend: between which two of the others?
  std::size_t low = 1, high = bends.size() - 1;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    const Sign s = sign_of(predicates::Orient2d{}, projected(look_, checked_.at(bends.front())),
                           projected(look_, checked_.at(bends[middle])), p);
    (s == -orientation_ ? high : low) = middle;
  }
  if (!passes(bends[low])) return bends[low];
  if (!place.on_edge) return std::nullopt;
  const auto found = std::ranges::lower_bound(rim_points_, std::pair(p.x, p.y), {}, place_of);
  if (found != rim_points_.end() && found->p == p) {
    place.on_rim = true;
    place.at_turn = found->turns;
  }
  return std::nullopt;
}

Index& Sheet::start_for(const Point2& p) {
  const auto cell = [&](double t) {
    return t > 0 ? static_cast<std::size_t>(std::min(t, static_cast<double>(cells_ - 1))) : std::size_t{0};
  };
  return start_[cell((p.x - low_.x) * scale_.x) * cells_ + cell((p.y - low_.y) * scale_.y)];
}

Sheet::Place Sheet::place(const Point3& point, std::size_t name) {
  const Point2 p = projected(look_, point);
  Index& start = start_for(p);
  Place found{};
  Index f = start;
  for (std::size_t steps = 0; steps < 16 * cells_; ++steps) {
    const auto edge = beyond(f, p, found);
    if (!edge) {
      start = f;
      return found;
    }
    require(!is_rim(*edge), "point ", name, " lies outside");
    f = checked_.face_of[checked_.twin[*edge]];
  }
  // Among coplanar triangles a walk may go around in a circle.
  for (f = 0; f < member_.size(); ++f) {
    if (holds(f) && !beyond(f, p, found)) return found;
  }
  throw Flaw{text_of("point ", name, " lies outside")};
}

}  // namespace plumb::figure::hull3
