#include "query/polytope_hierarchy/nearest.hpp"

#include "arith/proved_sign.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "query/polytope_hierarchy/descent.hpp"
#include "query/separation/convex_body.hpp"
#include "query/separation/corner_numbers.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb {
namespace query::hierarchy {
namespace {

constexpr std::size_t most_candidates = PolytopeHierarchy::most_neighbors + 1;

CoreCorners corners_of(std::span<const Point3> points) { return *CoreCorners::of(BodyView{.vertices = points}); }

/// From a polytope's nearest point toward p.
class NearestWay {
 public:
  NearestWay(const CoreCorners& p, const CoreCorners& polytope, const DifferenceCorners& corners)
      : p_(p), polytope_(polytope), corners_(corners), near_(way<Running>()) {}

  template <class Text>
  [[nodiscard]] Sign sign(const Text& text) const {
    if (near_) {
      if (const Unsure<Sign> s = text(*near_).sign(); s.certain()) return s.value();
    }
    if (const auto w = way<ShortDyadic>()) {
      if (const Unsure<Sign> s = text(*w).sign(); s.certain()) return s.value();
    }
    return text(*way<BigDyadic>()).sign();
  }
  [[nodiscard]] Sign beyond(const Point3& a, const Point3& b) const {
    return sign([&]<class T>(const Vec<T>& d) { return dot(d, arith::vec<T>(a) - arith::vec<T>(b)); });
  }

 private:
  template <class T>
  [[nodiscard]] std::optional<Vec<T>> way() const {
    CertainSigns ask;
    const NearestOfCorners<T> n = nearest_of<T>(p_, polytope_, corners_, ask);
    return ask.certain() ? std::optional(n.way) : std::nullopt;
  }

  const CoreCorners &p_, &polytope_;
  const DifferenceCorners& corners_;
  std::optional<Vec<Running>> near_;
};

}  // namespace

std::optional<NearestOfHierarchy> nearest(const PolytopeHierarchy& h, const CoreCorners& body) {
  const CoreCorners polytope = corners_of(h.points);
  const auto coarsest = proved_nearest(body, corners_of(std::span(h.points).first(h.levels.back().size)));
  if (!coarsest) return {};
  NearestOfHierarchy found{coarsest->corners, coarsest->meets, h.levels.size() - 1, {}};
  for (std::size_t i = h.levels.size() - 1; i-- > 0 && !found.meets;) {
    const HierarchyLevel& finer = h.levels[i];
    std::uint32_t at = found.corners.ends[0][1];
    for (std::size_t k = 1; k < found.corners.size; ++k) {
      if (finer.removed_at(found.corners.ends[k][1]).size() < finer.removed_at(at).size())
        at = found.corners.ends[k][1];
    }
    const auto beyond = beyond_plane(h, finer, at, NearestWay(body, polytope, found.corners));
    if (!beyond) continue;
    std::array<std::uint32_t, most_candidates> rank{*beyond};
    std::size_t size = 1;
    for (const std::uint32_t v : finer.neighbors_of_removed(*beyond - h.levels[i + 1].size)) rank[size++] = v;
    std::array<Point3, most_candidates> candidates;
    for (std::size_t k = 0; k < size; ++k) candidates[k] = h.points[rank[k]];
    const auto proved = proved_nearest(body, corners_of(std::span(candidates).first(size)));
    if (!proved) return {};
    found = {proved->corners, proved->meets, i, *beyond};
    for (std::size_t k = 0; k < found.corners.size; ++k) found.corners.ends[k][1] = rank[found.corners.ends[k][1]];
  }
  return found;
}

namespace {

std::optional<NearestOfHierarchy> nearest_to(const PolytopeHierarchy& h, const Point3& p) {
  return nearest(h, corners_of({&p, 1}));
}

void require_point(std::string_view function, const Point3& p) { require_finite_parts(function, {"p"}, p); }

}  // namespace
}  // namespace query::hierarchy

Closest closest_points(const Point3& p, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  require_point("closest_points", p);
  const auto found = nearest_to(h, p);
  if (!found || found->meets) return closest_points(p, h.polyhedron);
  const auto numbers = query::numbers_of(corners_of({&p, 1}), corners_of(h.points), found->corners);
  const Feature start{FeatureKind::edge, h.corners[found->corners.ends[0][1]]};
  return {numbers.on_a, numbers.on_b, numbers.distance, Feature{FeatureKind::vertex, 0},
          voronoi_region(h.polyhedron, p, start)};
}

double distance(const Point3& p, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  require_point("distance", p);
  const auto found = nearest_to(h, p);
  if (!found) return distance(p, h.polyhedron);
  return found->meets ? 0 : query::distance_of(corners_of({&p, 1}), corners_of(h.points), found->corners);
}

Rational squared_distance_exact(const Point3& p, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  require_point("squared_distance_exact", p);
  const auto found = nearest_to(h, p);
  if (!found) return squared_distance_exact(p, h.polyhedron);
  if (found->meets) return 0;
  return Rational(BigRational{query::square_of(corners_of({&p, 1}), corners_of(h.points), found->corners)});
}

bool contains(const PolytopeHierarchy& h, const Point3& p) {
  using namespace query::hierarchy;
  require_point("contains", p);
  const auto found = nearest_to(h, p);
  return found ? found->meets : contains(h.polyhedron, p);
}

}  // namespace plumb
