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

#include "plumb/predicates.hpp"
#include "plumb/surface/repair/repair.hpp"
#include "surface/repair/planted_ground.hpp"

namespace plumb::planted {

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
    {"vertex by an edge that a double triangle closes",
     {"open", "opposite"},
     RepairKind::t_junctions,
     ChangeKind::divided_edge,
     Where::triangle,
     Plan::with_tolerance,
     Ending::as_sound,
     [](Ground& g) {
       const Point3 p = g.near(middle(g.at(0), g.at(1)));
       const auto [a, b, c] = g.mesh.triangles[g.triangle];
       const auto beyond = std::ranges::find_if(g.mesh.triangles, [&, from = a, to = b](const auto& t) {
         return std::ranges::count(t, from) == 1 && std::ranges::count(t, to) == 1 && t != g.mesh.triangles[g.triangle];
       });
       if (g.on_edge(p) || beyond == g.mesh.triangles.end()) return false;
       const TriangleMesh::Triangle twice{(*beyond)[0], (*beyond)[2], (*beyond)[1]};
       g.touch(twice);
       g.divide(p);
       g.mesh.triangles.push_back(twice);
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
