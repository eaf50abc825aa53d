// Which faults can a mesh have, and what becomes of each in a repair?  A table, by which each is planted at a triangle.
//
// Planting guesses places in doubles; what is there then is judged exactly.
// Laws: (1) each name of surface_defects, each step and each change that mends has a row: a test asks.  (2) A row touches
// vertices of its triangle and new ones alone, and tells them; those for which `where` is not `triangle` stand beside
// the mesh, or are everywhere.  (3) What is left after the repair has its reason in the row.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/predicates.hpp"
#include "plumb/surface/repair/repair.hpp"

namespace plumb::planted {

/// What a fault is planted in, and what it touched.
struct Ground {
  TriangleMesh& mesh;
  std::uint32_t triangle;
  double step;         // some units in the last place of the largest coordinate; the tolerance is twice that
  bool closed = true;  // the mesh, before anything was planted
  std::vector<Point3> touched{};
  std::vector<std::uint32_t> gone{};  // triangles to be left out at last, so that numbers stay

  [[nodiscard]] Point3 at(std::size_t corner) const { return mesh.vertices[mesh.triangles[triangle][corner]]; }
  std::uint32_t add(const Point3& p) {
    mesh.vertices.push_back(p);
    touched.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }
  [[nodiscard]] Point3 near(const Point3& p) const { return {p.x + step, p.y, p.z}; }
  /// Divides the triangle's first edge at a point, not the neighbor's; the number of the new vertex.
  std::uint32_t divide(const Point3& p) {
    const auto [a, b, c] = mesh.triangles[triangle];
    const std::uint32_t m = add(p);
    mesh.triangles[triangle] = {a, m, c};
    mesh.triangles.push_back({m, b, c});
    return m;
  }
  [[nodiscard]] bool on_edge(const Point3& p) const { return collinear(at(0), p, at(1)); }
  void touch(const TriangleMesh::Triangle& t) {
    for (const std::uint32_t v : t) touched.push_back(mesh.vertices[v]);
  }
  /// Outward whatever the order of its corners.
  void add_tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto& v = mesh.vertices;
    if (orient3d(v[a], v[b], v[c], v[d]) != Sign::positive) std::swap(b, c);
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}});
  }
};

inline Point3 middle(const Point3& p, const Point3& q) {
  return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
}

/// A frame at a triangle, in doubles: its middle, its unit normal, its least height.
struct Frame {
  Point3 middle;
  std::array<double, 3> normal;
  double height;

  explicit Frame(const Ground& g) {
    const Point3 a = g.at(0), b = g.at(1), c = g.at(2);
    middle = {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double area = std::hypot(normal[0], normal[1], normal[2]);
    for (double& x : normal) x /= area;
    const auto length = [](const Point3& p, const Point3& q) { return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z); };
    height = area / std::max({length(a, b), length(b, c), length(c, a)});
  }
  /// So many heights out of the triangle.
  [[nodiscard]] Point3 out(double heights) const {
    const double by = heights * height;
    return {middle.x + by * normal[0], middle.y + by * normal[1], middle.z + by * normal[2]};
  }
};

/// Beside the mesh, a place with free space about it that is as wide as the mesh's greatest coordinate.
inline Point3 beside(const TriangleMesh& mesh) {
  double greatest = 1;
  for (const Point3& p : mesh.vertices) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return {std::ldexp(4.0, std::ilogb(greatest)), 0, 0};
}

enum class Where : unsigned char { triangle, beside, everywhere };
enum class Plan : unsigned char { printable, with_tolerance, slivers, small_components, merge_coplanar };
/// The triangles as they were; others in their place, as sound; or a fault stays that `left` and `why` tell.
enum class Ending : unsigned char { as_before, as_sound, some_left };

struct Fault {
  std::string_view name;
  std::vector<std::string_view> defects;  // by which the judge tells it
  RepairKind step;                        // what mends it, and
  std::optional<ChangeKind> change;       // how that is told; or what tells that it stays, beside the judge
  Where where;
  Plan plan;
  Ending ending;
  bool (*plant)(Ground&);  // false where the triangle is no place for it
  std::vector<std::string_view> left = {};
  std::string_view why = {};
};

inline std::vector<RepairStep> steps_of(Plan plan, double step) {
  switch (plan) {
    case Plan::with_tolerance:
      return printable_solid(2 * step);
    case Plan::slivers:
      return {{RepairKind::slivers, 2 * step}};
    case Plan::small_components:
      return {{RepairKind::small_components, 0, 5}, {RepairKind::unused}};
    case Plan::merge_coplanar:
      return {{RepairKind::merge_coplanar}, {RepairKind::unused}};
    default:
      return printable_solid();
  }
}

inline const std::vector<Fault> faults{
    {"repeated vertex",
     {"open"},
     RepairKind::weld,
     ChangeKind::merged_vertex,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       const Point3 a = g.at(0);
       g.mesh.triangles[g.triangle][0] = g.add(a);
       return true;
     }},
    {"triangles with vertices of their own",
     {"open"},
     RepairKind::weld,
     ChangeKind::merged_vertex,
     Where::everywhere,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       for (auto& t : g.mesh.triangles)
         for (std::uint32_t& v : t) v = g.add(Point3{g.mesh.vertices[v]});
       return true;
     }},
    {"close vertex",
     {"open", "close-vertices"},
     RepairKind::weld,
     ChangeKind::merged_vertex,
     Where::triangle,
     Plan::with_tolerance,
     Ending::as_before,
     [](Ground& g) {
       g.mesh.triangles[g.triangle][0] = g.add(g.near(g.at(0)));
       return true;
     }},
    {"gap about a triangle",
     {"open", "close-vertices"},
     RepairKind::weld,
     ChangeKind::merged_vertex,
     Where::triangle,
     Plan::with_tolerance,
     Ending::as_before,
     [](Ground& g) {
       for (std::size_t k = 0; k < 3; ++k) g.mesh.triangles[g.triangle][k] = g.add(g.near(g.at(k)));
       return true;
     }},
    {"edge of next to no length",
     {"close-vertices"},
     RepairKind::weld,
     ChangeKind::collapsed_triangle,
     Where::triangle,
     Plan::with_tolerance,
     Ending::as_before,
     [](Ground& g) {
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       const std::uint32_t m = g.add(g.near(g.at(0)));
       g.mesh.triangles[g.triangle] = {m, b, c};
       g.mesh.triangles.insert(g.mesh.triangles.end(), {{m, a, b}, {m, c, a}});
       return true;
     }},
    {"crack along an edge",
     {"open"},
     RepairKind::zip,
     ChangeKind::divided_edge,
     Where::triangle,
     Plan::with_tolerance,
     Ending::as_sound,
     [](Ground& g) {
       const Point3 p = g.near(middle(g.at(0), g.at(1)));
       if (g.on_edge(p)) return false;
       g.divide(p);
       return true;
     }},
    {"T-junction",
     {"open", "vertex-on-edge"},
     RepairKind::t_junctions,
     ChangeKind::divided_edge,
     Where::triangle,
     Plan::printable,
     Ending::as_sound,
     [](Ground& g) {
       const Point3 p = middle(g.at(0), g.at(1));
       if (!g.on_edge(p)) return false;
       g.divide(p);
       return true;
     }},
    {"triangle that names a vertex twice",
     {"degenerate"},
     RepairKind::degenerate,
     ChangeKind::flat_triangle,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       g.mesh.triangles.push_back({a, b, a});
       return true;
     }},
    {"triangle on one line",
     {"degenerate"},
     RepairKind::degenerate,
     ChangeKind::flat_triangle,
     Where::triangle,
     Plan::printable,
     Ending::as_sound,
     [](Ground& g) {
       const Point3 p = middle(g.at(0), g.at(1));
       if (!g.on_edge(p)) return false;
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       g.mesh.triangles.push_back({a, b, g.divide(p)});
       return true;
     }},
    {"sliver",
     {},
     RepairKind::slivers,
     ChangeKind::flat_triangle,
     Where::triangle,
     Plan::slivers,
     Ending::as_sound,
     [](Ground& g) {
       const Point3 p = g.near(middle(g.at(0), g.at(1)));
       if (g.on_edge(p)) return false;
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       g.mesh.triangles.push_back({a, b, g.divide(p)});
       return true;
     }},
    {"duplicate triangle",
     {"duplicate"},
     RepairKind::duplicates,
     ChangeKind::duplicate_triangle,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       g.mesh.triangles.push_back({b, c, a});
       return true;
     }},
    {"opposite triangle",
     {"opposite"},
     RepairKind::duplicates,
     ChangeKind::opposite_triangle,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       g.mesh.triangles.push_back({b, a, c});
       return true;
     }},
    {"fin of two opposite triangles",
     {"opposite", "non-manifold-edge"},
     RepairKind::duplicates,
     ChangeKind::opposite_triangle,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       const std::uint32_t tip = g.add(Frame(g).out(1));
       g.mesh.triangles.insert(g.mesh.triangles.end(), {{a, b, tip}, {b, a, tip}});
       return true;
     }},
    {"wall within",
     {"internal-wall"},
     RepairKind::walls,
     ChangeKind::removed_wall,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       const Frame frame(g);
       const Point3 p = frame.out(-0.01);
       const double s = 0.003 * frame.height;
       if (!g.closed || !(s > 16 * g.step)) return false;
       const std::uint32_t a = g.add(p), b = g.add({p.x + s, p.y, p.z}), c = g.add({p.x, p.y + s, p.z});
       g.mesh.triangles.push_back({a, b, c});
       return true;
     }},
    {"small component",
     {},
     RepairKind::small_components,
     ChangeKind::removed_component,
     Where::beside,
     Plan::small_components,
     Ending::as_before,
     [](Ground& g) {
       const Point3 p = beside(g.mesh);
       const std::uint32_t a = g.add(p), b = g.add({p.x + 1, p.y, p.z}), c = g.add({p.x, p.y + 1, p.z});
       g.add_tetrahedron(a, b, c, g.add({p.x, p.y, p.z + 1}));
       return true;
     }},
    {"turned triangle",
     {"unoriented"},
     RepairKind::orientation,
     ChangeKind::turned_triangles,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       std::swap(g.mesh.triangles[g.triangle][1], g.mesh.triangles[g.triangle][2]);
       return true;
     }},
    {"hole of a triangle",
     {"open"},
     RepairKind::holes,
     ChangeKind::filled_hole,
     Where::triangle,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       g.gone = {g.triangle};
       return true;
     }},
    {"hole of all triangles at a vertex",
     {"open"},
     RepairKind::holes,
     ChangeKind::filled_hole,
     Where::triangle,
     Plan::printable,
     Ending::as_sound,
     [](Ground& g) {
       const std::uint32_t v = g.mesh.triangles[g.triangle][0];
       for (std::uint32_t t = 0; t < g.mesh.triangles.size(); ++t) {
         if (std::ranges::count(g.mesh.triangles[t], v) == 0) continue;
         g.touch(g.mesh.triangles[t]);
         g.gone.push_back(t);
       }
       return true;
     }},
    {"inside out",
     {"inside-out"},
     RepairKind::outward,
     ChangeKind::turned_shell,
     Where::everywhere,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       for (auto& t : g.mesh.triangles) {
         g.touch(t);
         std::swap(t[1], t[2]);
       }
       return g.closed;
     }},
    {"solids with one vertex",
     {"non-manifold-vertex"},
     RepairKind::split,
     ChangeKind::split_vertex,
     Where::beside,
     Plan::printable,
     Ending::some_left,
     [](Ground& g) {
       const Point3 p = beside(g.mesh);
       const std::uint32_t o = g.add(p);
       for (const double s : {1.0, -1.0}) {
         const std::uint32_t a = g.add({p.x + s, p.y, p.z}), b = g.add({p.x, p.y + s, p.z});
         g.add_tetrahedron(o, a, b, g.add({p.x, p.y, p.z + s}));
       }
       return true;
     },
     {"self-intersecting"},
     "parted in their numbers, they still touch: no vertex gets a new coordinate"},
    {"solids with one edge",
     {"non-manifold-edge"},
     RepairKind::split,
     ChangeKind::split_vertex,
     Where::beside,
     Plan::printable,
     Ending::some_left,
     [](Ground& g) {
       const Point3 p = beside(g.mesh);
       const std::uint32_t o = g.add(p), e = g.add({p.x, p.y, p.z + 1});
       for (const double s : {1.0, -1.0}) {
         const std::uint32_t a = g.add({p.x + 1, p.y + s, p.z});
         g.add_tetrahedron(o, e, a, g.add({p.x - 1, p.y + s, p.z}));
       }
       return true;
     },
     {"self-intersecting"},
     "parted in their numbers, they still touch: no vertex gets a new coordinate"},
    {"face of more triangles than it takes",
     {},
     RepairKind::merge_coplanar,
     ChangeKind::merged_coplanar,
     Where::triangle,
     Plan::merge_coplanar,
     Ending::as_sound,
     [](Ground& g) {
       const Point3 p = middle(middle(g.at(0), g.at(1)), g.at(2));
       if (g.on_edge(p) || orient3d(g.at(0), g.at(1), g.at(2), p) != Sign::zero) return false;
       const TriangleMesh::Triangle corners = g.mesh.triangles[g.triangle];
       for (const auto& t : g.mesh.triangles)  // its neighbors may be in its plane
         if (std::ranges::any_of(t, [&](std::uint32_t v) { return std::ranges::count(corners, v) != 0; })) g.touch(t);
       const auto [a, b, c] = corners;
       const std::uint32_t m = g.add(p);
       g.mesh.triangles[g.triangle] = {a, b, m};
       g.mesh.triangles.insert(g.mesh.triangles.end(), {{b, c, m}, {c, a, m}});
       return true;
     }},
    {"unused vertex",
     {},
     RepairKind::unused,
     ChangeKind::unused_vertex,
     Where::beside,
     Plan::printable,
     Ending::as_before,
     [](Ground& g) {
       g.add(beside(g.mesh));
       return true;
     }},
    {"third triangle at an edge",
     {"open", "non-manifold-edge"},
     RepairKind::split,
     ChangeKind::kept_edge,
     Where::triangle,
     Plan::printable,
     Ending::some_left,
     [](Ground& g) {
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       g.mesh.triangles.push_back({a, b, g.add(Frame(g).out(0.5))});
       return true;
     },
     {"open", "non-manifold-edge"},
     "the mesh does not say which of the three is one too many"},
    {"solid across the surface",
     {"self-intersecting", "crossing-shells"},
     RepairKind::split,
     std::nullopt,
     Where::triangle,
     Plan::printable,
     Ending::some_left,
     [](Ground& g) {
       const Frame frame(g);
       const Point3 p = frame.middle;
       const double s = 0.05 * frame.height;
       if (!(s > 16 * g.step)) return false;
       const std::uint32_t a = g.add({p.x + s, p.y + s, p.z + s}), b = g.add({p.x + s, p.y - s, p.z - s}),
                           c = g.add({p.x - s, p.y + s, p.z - s});
       g.add_tetrahedron(a, b, c, g.add({p.x - s, p.y - s, p.z + s}));
       return true;
     },
     {"self-intersecting", "crossing-shells"},
     "surfaces that cross are not parted: that is a union, or a difference"},
    {"one-sided component",
     {"open", "unoriented"},
     RepairKind::orientation,
     ChangeKind::one_sided,
     Where::beside,
     Plan::printable,
     Ending::some_left,
     [](Ground& g) {
       const Point3 p = beside(g.mesh);
       std::array<std::uint32_t, 7> v;
       for (std::uint32_t i = 0; i < 7; ++i)
         v[i] = g.add({p.x + std::cos(i * 0.9), p.y + std::sin(i * 0.9), p.z + (i % 2 == 0 ? 0.5 : -0.5)});
       for (std::uint32_t i = 0; i < 7; ++i)
         g.mesh.triangles.push_back({v[i], v[(i + 1 + i % 2) % 7], v[(i + 2 - i % 2) % 7]});
       return true;
     },
     {"open", "unoriented"},
     "no turning of triangles makes a Moebius strip agree"}};

}  // namespace plumb::planted
