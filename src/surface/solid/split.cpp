#include "plumb/surface/solid/split.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "surface/solid/mesh_in_order.hpp"
#include "surface/solid/plane_view.hpp"
#include "surface/solid/point_table.hpp"
#include "surface/solid/wound_triangles.hpp"

namespace plumb {
namespace {

/// normal . x - offset, of which the sign tells the side.
struct ExactPlane {
  std::array<Rational, 3> normal;
  Rational offset;

  [[nodiscard]] Rational height(const RationalPoint3& p) const {
    return normal[0] * p.x + normal[1] * p.y + normal[2] * p.z - offset;
  }
  /// An axis along which the plane is seen; none where there is no normal.
  [[nodiscard]] std::optional<int> axis() const {
    for (int k = 2; k >= 0; --k)
      if (normal[static_cast<std::size_t>(k)].sign() != Sign::zero) return k;
    return {};
  }
};

ExactPlane exact_plane(const Plane3& p) {
  return {{Rational(p.normal.x), Rational(p.normal.y), Rational(p.normal.z)}, Rational(p.offset)};
}
ExactPlane exact_plane(const ThreePointPlane3& p) {
  const RationalPoint3 a = rational_point(p.a), b = rational_point(p.b), c = rational_point(p.c);
  const Rational ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z, vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  ExactPlane made{{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx}, Rational()};
  made.offset = made.height(a);
  return made;
}

class PlaneSplitter {
 public:
  PlaneSplitter(const ExactMesh& mesh, const ExactPlane& plane, int axis)
      : mesh_(mesh), axis_(axis), vertices_(mesh.vertices) {
    for (const ExactPoint3& p : vertices_) {
      exact_.push_back(rational_point(p));
      heights_.push_back(plane.height(exact_.back()));
      sides_.push_back(heights_.back().sign());
    }
  }

  ExactMesh half(Sign side) {
    made_.clear();
    in_plane_.clear();
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) keep(t, side);
    close();
    return in_order();
  }

 private:
  using Numbers = std::vector<std::uint32_t>;

  /// What lies on the side, of a triangle that reaches there.
  void keep(std::size_t triangle, Sign side) {
    const TriangleMesh::Triangle& corners = mesh_.triangles[triangle];
    if (std::ranges::none_of(corners, [&](std::uint32_t v) { return sides_[v] == side; })) return;
    Numbers kept;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
      if (sides_[from] == side || sides_[from] == Sign::zero) kept.push_back(from);
      if (sides_[from] != Sign::zero && sides_[to] == -sides_[from]) kept.push_back(crossing(from, to));
    }
    for (std::size_t i = 2; i < kept.size(); ++i)
      made_.emplace_back(TriangleMesh::Triangle{kept[0], kept[i - 1], kept[i]}, mesh_.sources[triangle]);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const std::uint32_t from = kept[i], to = kept[(i + 1) % kept.size()];
      if (sides_[from] != Sign::zero || sides_[to] != Sign::zero) continue;
      in_plane_[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [at, is_new] = crossings_.try_emplace({a, b}, static_cast<std::uint32_t>(vertices_.size()));
    if (is_new) {
      const Rational t = heights_[a] / (heights_[a] - heights_[b]);
      const RationalPoint3 &p = exact_[a], &q = exact_[b];
      vertices_.push_back(
          surface::in_plain_form(RationalPoint3{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), p.z + t * (q.z - p.z)}));
      sides_.push_back(Sign::zero);
    }
    return at->second;
  }

  /// The ends of what is open in the plane, run through backward, turn around the faces that close it.
  void close() {
    Numbers used;
    for (const auto& [ends, times] : in_plane_)
      if (times != 0) used.insert(used.end(), {ends.first, ends.second});
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    const auto place = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::ranges::lower_bound(used, v) - used.begin());
    };
    std::vector<ExactPoint2> seen;
    for (const std::uint32_t v : used) seen.push_back(surface::shadow(vertices_[v], axis_));
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::int32_t> open(used.size());
    for (const auto& [ends, times] : in_plane_)
      for (std::int32_t i = 0; i != times; i += times > 0 ? 1 : -1) {
        const std::uint32_t from = place(times > 0 ? ends.second : ends.first);
        const std::uint32_t to = place(times > 0 ? ends.first : ends.second);
        edges.push_back({from, to});
        ++open[from];
        --open[to];
      }
    if (std::ranges::any_of(open, [](std::int32_t n) { return n != 0; }))
      throw InvalidShape("split: the mesh is not closed where the plane cuts it; give one that an operation made");
    const auto wound = surface::wound_triangles(std::span<const ExactPoint2>(seen), edges);
    const auto once = [](const surface::WoundTriangle& t) { return t.winding == 1 || t.winding == -1; };
    if (!wound || !std::ranges::all_of(*wound, once))
      throw InvalidShape("split: the mesh crosses itself in the plane; resolve it first");
    for (const auto& [corners, winding] : *wound) {
      TriangleMesh::Triangle t{used[corners[0]], used[corners[1]], used[corners[2]]};
      if (winding < 0) std::swap(t[1], t[2]);
      made_.emplace_back(t, cut_face);
    }
  }

  [[nodiscard]] ExactMesh in_order() {
    Numbers order(vertices_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
      return compare_xyz(vertices_[a], vertices_[b]) == Sign::negative;
    });
    std::vector<ExactPoint3> sorted;
    Numbers number(order.size());
    for (const std::uint32_t v : order) {
      number[v] = static_cast<std::uint32_t>(sorted.size());
      sorted.push_back(vertices_[v]);
    }
    for (auto& [corners, source] : made_)
      for (std::uint32_t& v : corners) v = number[v];
    return surface::mesh_in_order(sorted, std::move(made_));
  }

  const ExactMesh& mesh_;
  int axis_;
  std::vector<ExactPoint3> vertices_;  // those of the mesh, then crossings
  std::vector<RationalPoint3> exact_;
  std::vector<Rational> heights_;
  std::vector<Sign> sides_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> made_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::int32_t> in_plane_;  // how often from less to greater
};

}  // namespace

SplitSolid split(const ExactMesh& mesh, const AnyPlane3& plane) {
  if (mesh.sources.size() != mesh.triangles.size())
    throw UnequalLengths("split: there are " + std::to_string(mesh.sources.size()) + " sources of " +
                         std::to_string(mesh.triangles.size()) + " triangles; give one for each");
  const ExactPlane exact = std::visit([](const auto& p) { return exact_plane(p); }, plane);
  const auto axis = exact.axis();
  if (!axis)
    throw InvalidShape("split: the plane has no normal; give one of a direction, or three points not on a line");
  PlaneSplitter splitter(mesh, exact, *axis);
  SplitSolid halves;
  halves.above = splitter.half(Sign::positive);
  halves.below = splitter.half(Sign::negative);
  return halves;
}

}  // namespace plumb
