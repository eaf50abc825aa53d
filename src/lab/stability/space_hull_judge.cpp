#include "lab/stability/space_hull_judge.hpp"

#include <map>

#include "plumb/arith/error.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/hull/verify_hull.hpp"
#include "plumb/predicates.hpp"

namespace plumb::lab::stability {

using Index = std::uint32_t;

SpaceHullJudge::SpaceHullJudge(std::span<const Point3> points) : points_(points.begin(), points.end()) {
  const Hull3 hull = convex_hull(points);
  if (const HullVerdict verdict = verify_hull(hull, points); !verdict) throw Error("convex_hull: " + verdict.flaw);
  extreme_ = hull.vertices;
  flat_ = hull.dimension < 3;
  std::map<std::array<double, 3>, Index> known;  // in which -0 equals 0
  for (Index i = 0; i < points_.size(); ++i) {
    const Point3& p = points_[i];
    first_equal_.push_back(known.try_emplace({p.x, p.y, p.z}, i).first->second);
  }
}

SpaceHullFlaws SpaceHullJudge::flaws(const Faces& faces) const {
  SpaceHullFlaws flaws;
  flaws.wrong_dimension = faces.empty() != flat_;
  if (flaws.wrong_dimension || flat_) return flaws;
  std::vector<bool> named(points_.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::vector<Index>& face = faces[f];
    for (const Index i : face) named[first_equal_[i]] = true;
    bool seen = false, flat = false;
    for (std::size_t i = 2; i < face.size(); ++i) {
      bool any_below = false;
      for (const Index p : extreme_) {  // where any point is outside or off the plane, one of these is
        const Sign below = orient3d(points_[face[0]], points_[face[i - 1]], points_[face[i]], points_[p]);
        seen = seen || below == Sign::negative;
        any_below = any_below || below != Sign::zero;
      }
      flat = flat || !any_below;
    }
    if (seen) flaws.seen.push_back(f);
    if (flat) flaws.flat.push_back(f);
  }
  std::ranges::copy_if(extreme_, std::back_inserter(flaws.lost), [&](Index p) { return !named[p]; });
  flaws.torn = torn_edges(faces);
  return flaws;
}

std::vector<std::array<Index, 2>> SpaceHullJudge::torn_edges(const Faces& faces) const {
  std::map<std::array<Index, 2>, std::array<int, 2>> runs;  // from the lower to the higher index, and back
  for (const std::vector<Index>& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = first_equal_[face[i]], b = first_equal_[face[(i + 1) % face.size()]];
      ++runs[{std::min(a, b), std::max(a, b)}][a < b ? 0 : 1];
    }
  }
  std::vector<std::array<Index, 2>> torn;
  for (const auto& [edge, count] : runs) {
    if (count != std::array{1, 1}) torn.push_back(edge);
  }
  return torn;
}

}  // namespace plumb::lab::stability
