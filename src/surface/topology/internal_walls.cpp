#include "surface/topology/internal_walls.hpp"

#include <algorithm>
#include <vector>

#include "plumb/predicates.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/signed_volume.hpp"
#include "surface/topology/triangle_lists.hpp"

namespace plumb::surface {
namespace {

/// The sides of triangle t: 2 t is the one that its normal points to, 2 t + 1 the other.
std::uint32_t side(const EdgeUse& use, bool forward_faces_front) {
  return 2 * use.face + (use.forward == forward_faces_front ? 0 : 1);
}
/// The side that looks counterclockwise around the edge, seen from its larger vertex; and that which looks clockwise.
std::uint32_t side_after(const EdgeUse& use) { return side(use, true); }
std::uint32_t side_before(const EdgeUse& use) { return side(use, false); }

Sign turn(const Point3& a, const Point3& b, const Point3& c, int axis) {
  const auto seen = [axis](const Point3& p) {
    return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
  };
  return orient2d(seen(a), seen(b), seen(c));
}

/// The order of points around the line from a to b, beginning with that of p: by quadrants, and within them by signs.
class AroundEdge {
 public:
  AroundEdge(const Point3& a, const Point3& b, const Point3& p) : a_(a), b_(b), p_(p) {}

  /// Positive where q lies less than half a turn counterclockwise from p, seen from b.
  [[nodiscard]] Sign ahead(const Point3& p, const Point3& q) const { return -orient3d(a_, b_, p, q); }
  /// 0 for p's own half plane, 1 and 3 for what is before and behind the opposite one, which is 2.
  [[nodiscard]] int quarter(const Point3& q) const {
    const Sign s = ahead(p_, q);
    if (s != Sign::zero) return s == Sign::positive ? 1 : 3;
    for (const int axis : {0, 1, 2}) {
      const Sign of_p = turn(a_, b_, p_, axis), of_q = turn(a_, b_, q, axis);
      if (of_p != Sign::zero && of_q != Sign::zero) return of_p == of_q ? 0 : 2;
    }
    return 0;  // on the line itself
  }

 private:
  const Point3 &a_, &b_, &p_;
};

/// The triangles at an edge in their order around it; empty where two lie on one another there.
std::vector<EdgeUse> in_order(const TriangleMesh& mesh, const std::array<std::uint32_t, 2>& edge,
                              std::span<const EdgeUse> uses) {
  const auto at = [&](std::uint32_t v) -> const Point3& { return mesh.vertices[v]; };
  const AroundEdge around(at(edge[0]), at(edge[1]), at(uses[0].opposite));
  struct Placed {
    int quarter;
    EdgeUse use;
  };
  std::vector<Placed> placed;
  for (const EdgeUse& use : uses) placed.push_back({around.quarter(at(use.opposite)), use});
  const auto before = [&](const Placed& l, const Placed& r) {
    if (l.quarter != r.quarter) return l.quarter < r.quarter;
    return l.quarter % 2 == 1 && around.ahead(at(l.use.opposite), at(r.use.opposite)) == Sign::positive;
  };
  std::ranges::sort(placed, before);
  std::vector<EdgeUse> order;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (i > 0 && !before(placed[i - 1], placed[i])) return {};
    order.push_back(placed[i].use);
  }
  return order;
}

bool may_hold_walls(const MeshEdges& edges, const Shells& found) {
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() > 2 &&
        std::ranges::any_of(uses, [&](const EdgeUse& use) { return !found.shells[found.shell_of[use.face]].closed; }))
      return true;
  }
  return false;
}

}  // namespace

void find_dividing_walls(const TriangleMesh& mesh, const MeshEdges& edges, Shells& found) {
  if (!may_hold_walls(edges, found)) return;
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  DisjointSets sides(2 * std::size_t{n}), surfaces(n);
  std::vector<bool> unclear(n);  // by the representatives of surfaces, in the end
  std::vector<std::uint32_t> unclear_at;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    for (const EdgeUse& use : uses) surfaces.unite(uses[0].face, use.face);
    const std::vector<EdgeUse> sorted = uses.size() > 2 ? in_order(mesh, edges.edges[e], uses) : std::vector<EdgeUse>{};
    if (uses.size() > 2 && sorted.empty()) unclear_at.push_back(uses[0].face);
    const std::span<const EdgeUse> order = uses.size() > 2 ? std::span<const EdgeUse>(sorted) : uses;
    for (std::size_t i = 0; i < order.size(); ++i)
      sides.unite(side_after(order[i]), side_before(order[(i + 1) % order.size()]));
  }
  for (const std::uint32_t t : unclear_at) unclear[surfaces.find(t)] = true;

  std::vector<std::uint32_t> cell_of(2 * std::size_t{n});
  for (std::uint32_t s = 0; s < 2 * n; ++s) cell_of[s] = sides.find(s);
  const TriangleLists cells(cell_of, 2 * std::size_t{n});  // of sides
  std::vector<std::uint32_t> outer(n, no_shell);           // of each surface
  std::vector<bool> is_outer(2 * std::size_t{n});
  for (std::uint32_t c = 0; c < 2 * n; ++c) {
    if (cells[c].empty() || found.shell_of[c / 2] == no_shell) continue;
    const std::uint32_t surface = surfaces.find(c / 2);
    // What bounds a cell turns outward, seen from the cell, where a side looks into it.
    const Sign volume = sign_of_volume(mesh, cells[c], [](std::uint32_t s) {
      return SidedTriangle{s / 2, s % 2 == 0};
    });
    if (volume == Sign::positive) continue;
    is_outer[c] = true;
    if (outer[surface] != no_shell) unclear[surface] = true;
    outer[surface] = c;
  }
  for (Shell& s : found.shells) s.wall = !s.closed && !unclear[surfaces.find(s.first_triangle)];
  for (std::uint32_t t = 0; t < n; ++t) {
    const std::uint32_t s = found.shell_of[t];
    if (s != no_shell && (is_outer[cell_of[2 * t]] || is_outer[cell_of[2 * t + 1]])) found.shells[s].wall = false;
  }
}

}  // namespace plumb::surface
