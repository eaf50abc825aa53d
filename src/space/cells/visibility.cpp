#include "plumb/space/cells/visibility.hpp"

#include <algorithm>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "space/cells/clipped_polygon.hpp"

namespace plumb {
namespace {

using space::side, space::ThreePoints, space::turned_round;
using Cutters = std::vector<ThreePoints>;

/// Planes through the eye and an edge, positive where the polygon is.  The eye is not in its plane.
void add_cone(const Point3& eye, const Polygon3& polygon, Cutters& cutters) {
  const auto& v = polygon.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const ThreePoints plane{eye, v[i], v[(i + 1) % v.size()]};
    if (space::on_one_line(plane[0], plane[1], plane[2])) continue;  // no edge: a point that is named twice
    const auto off = std::find_if(v.begin(), v.end(), [&](const Point3& p) { return side(plane, p) != Sign::zero; });
    cutters.push_back(side(plane, *off) == Sign::positive ? plane : turned_round(plane));
  }
}

/// Has the polygon nothing on one side of the plane, and something on the other?
struct Sides {
  bool below = false, above = false;
  Sides(const ThreePoints& plane, const Polygon3& polygon) {
    for (const Point3& p : polygon.vertices) {
      const Sign s = side(plane, p);
      below |= s == Sign::negative, above |= s == Sign::positive;
    }
  }
};

/// Planes through an edge of one and a vertex of the other that separate them, positive on the side of b: behind b,
/// what is on a line from a through b is on that side.
void add_separators(const Polygon3& a, const Polygon3& b, Cutters& cutters) {
  const auto with_edges_of = [&](const Polygon3& edges, const Polygon3& vertices) {
    const auto& v = edges.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
      for (const Point3& p : vertices.vertices) {
        const ThreePoints plane{v[i], v[(i + 1) % v.size()], p};
        if (space::on_one_line(plane[0], plane[1], plane[2])) continue;
        const Sides of_a(plane, a), of_b(plane, b);
        if (!of_a.above && !of_b.below && (of_a.below || of_b.above)) cutters.push_back(plane);
        if (!of_a.below && !of_b.above && (of_a.above || of_b.below)) cutters.push_back(turned_round(plane));
      }
    }
  };
  with_edges_of(a, b);
  with_edges_of(b, a);
}

/// A walk through all chains, depth first, of portals that something is seen of.
class ChainSearch {
 public:
  ChainSearch(const PortalCells& rooms, std::uint32_t cell) : rooms_(rooms), first_(cell) {}

  /// admits(portal, cell): may the portal be gone through from the cell, behind those so far?  enter(portal, cell) adds
  /// what cuts those behind it to `cutters`.
  template <class Admits, class Enter>
  Sight all(const Admits& admits, const Enter& enter) {
    struct Step {
      std::uint32_t cell;
      std::size_t next, cutters;  // of its portals; how many there were before it was entered
    };
    Sight sight;
    std::vector<bool> on_way(rooms_.cells().size()), seen(rooms_.cells().size());
    std::vector<Step> steps{{first_, 0, cutters.size()}};
    on_way[first_] = seen[first_] = true;
    while (!steps.empty()) {
      Step& step = steps.back();
      const auto portals = rooms_.portals_of(step.cell);
      if (step.next == portals.size()) {
        on_way[step.cell] = false;
        cutters.resize(step.cutters);
        steps.pop_back();
        if (!chain.empty()) chain.pop_back();
        continue;
      }
      const std::uint32_t portal = portals[step.next++], here = step.cell, there = rooms_.beyond(portal, here);
      if (on_way[there] || !admits(portal, here)) continue;
      space::ClippedPolygon window(rooms_.portals()[portal].polygon);
      for (const ThreePoints& plane : cutters) {
        if (!window.empty()) window.keep(plane);
      }
      if (window.empty()) continue;
      const std::size_t before = cutters.size();
      enter(portal, here);
      chain.push_back({portal, here});
      SeenChain& told = sight.chains.emplace_back();
      for (const Link& link : chain) told.portals.push_back(link.portal);
      told.cell = there;
      told.window = window.corners();
      on_way[there] = seen[there] = true;
      steps.push_back({there, 0, before});
    }
    for (std::uint32_t c = 0; c < seen.size(); ++c) {
      if (seen[c]) sight.cells.push_back(c);
    }
    return sight;
  }

  struct Link {
    std::uint32_t portal, from;
  };
  Cutters cutters;
  std::vector<Link> chain;

 private:
  const PortalCells& rooms_;
  std::uint32_t first_;
};

Sight seen_through(const PortalCells& rooms, std::uint32_t cell, const Point3& eye, const Polygon3* window) {
  rooms.require_cell("seen_from", cell);
  figure::require_finite_parts<Point3>("seen_from", {"eye"}, eye);
  if (!contains(rooms.cells()[cell], eye)) {
    throw InvalidShape("seen_from: the eye is outside cell " + std::to_string(cell));
  }
  ChainSearch search(rooms, cell);
  if (window != nullptr) {
    figure::require_finite_points("seen_from", "window.vertices", std::span(window->vertices));
    if (window->vertices.size() < 3 || !convexity(*window).is_convex()) {
      throw InvalidShape("seen_from: the window is no convex polygon in a plane");
    }
    const auto& v = window->vertices;
    if (side(space::plane_of_chain(v.size(), [&](std::size_t k) { return v[k]; }), eye) == Sign::zero) {
      throw InvalidShape("seen_from: the eye is in the window's plane");
    }
    add_cone(eye, *window, search.cutters);
  }
  const auto eye_side = [&](std::uint32_t portal, std::uint32_t from) {
    return side(rooms.plane_before(portal, from), eye);
  };
  const auto admits = [&](std::uint32_t portal, std::uint32_t from) {
    const Sign s = eye_side(portal, from);
    return s == Sign::positive ||
           (s == Sign::zero && search.chain.empty() && contains(rooms.portals()[portal].polygon, eye));
  };
  const auto enter = [&](std::uint32_t portal, std::uint32_t from) {
    search.cutters.push_back(turned_round(rooms.plane_before(portal, from)));
    if (eye_side(portal, from) == Sign::positive) add_cone(eye, rooms.portals()[portal].polygon, search.cutters);
  };
  return search.all(admits, enter);
}

}  // namespace

Sight seen_from(const PortalCells& rooms, std::uint32_t cell, const Point3& eye) {
  return seen_through(rooms, cell, eye, nullptr);
}
Sight seen_from(const PortalCells& rooms, std::uint32_t cell, const Point3& eye, const Polygon3& window) {
  return seen_through(rooms, cell, eye, &window);
}

Sight potentially_visible(const PortalCells& rooms, std::uint32_t cell) {
  rooms.require_cell("potentially_visible", cell);
  ChainSearch search(rooms, cell);
  const auto polygon = [&](std::uint32_t portal) -> const Polygon3& { return rooms.portals()[portal].polygon; };
  // Each portal before it has something on the near side; the one before it, in a face of the same cell, strictly.
  const auto admits = [&](std::uint32_t portal, std::uint32_t from) {
    const ThreePoints plane = rooms.plane_before(portal, from);
    for (std::size_t i = 0; i < search.chain.size(); ++i) {
      const auto& v = polygon(search.chain[i].portal).vertices;
      const Sign least = i + 1 == search.chain.size() ? Sign::positive : Sign::zero;
      if (std::none_of(v.begin(), v.end(), [&](const Point3& p) { return side(plane, p) >= least; })) return false;
    }
    return true;
  };
  const auto enter = [&](std::uint32_t portal, std::uint32_t from) {
    search.cutters.push_back(turned_round(rooms.plane_before(portal, from)));
    for (const auto& link : search.chain) add_separators(polygon(link.portal), polygon(portal), search.cutters);
  };
  return search.all(admits, enter);
}

}  // namespace plumb
