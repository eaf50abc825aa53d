// CGAL's tree of boxes asked of meshes, by its kernels of exact predicates and of exact constructions.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/mesh_questions.hpp"

namespace plumb::bench {
namespace {

using namespace lab::trial;

template <class K>
struct TreeOf {
  using Triangles = std::vector<typename K::Triangle_3>;
  using Traits = CGAL::AABB_traits<K, CGAL::AABB_triangle_primitive<K, typename Triangles::const_iterator>>;

  explicit TreeOf(const TriangleMesh& mesh) {
    const auto at = [&mesh](std::uint32_t i) {
      const Point3& p = mesh.vertices[i];
      return typename K::Point_3(p.x, p.y, p.z);
    };
    for (const auto& [a, b, c] : mesh.triangles) triangles.emplace_back(at(a), at(b), at(c));
    tree.insert(triangles.cbegin(), triangles.cend());
    tree.build();
    tree.accelerate_distance_queries();
  }
  TreeOf(const TreeOf&) = delete;
  TreeOf& operator=(const TreeOf&) = delete;

  template <class Id>
  std::uint32_t number(const Id& id) const {
    return static_cast<std::uint32_t>(id - triangles.cbegin());
  }

  Triangles triangles;
  CGAL::AABB_tree<Traits> tree;
};

template <class K>
void add_tree(Rivals& all, const std::string& name, const std::string& about) {
  using Tree = TreeOf<K>;
  const auto make = [](const TriangleMesh& m) { return Tree(m); };
  all.push_back(
      {"closest-hit", without_flat_triangles(of_one_mesh<ray_numbers>(
                                                 name, "CGAL's AABB_tree::first_intersected_primitive, " + about, make,
                                                 [](std::span<const double> q) {
                                                   return typename K::Ray_3(typename K::Point_3(q[4], q[5], q[6]),
                                                                            typename K::Vector_3(q[7], q[8], q[9]));
                                                 },
                                                 [](const Tree& t, const typename K::Ray_3& ray) {
                                                   const auto first = t.tree.first_intersected_primitive(ray);
                                                   return first ? t.number(*first) : no_item;
                                                 }),
                                             1)});
  all.push_back(
      {"closest-point-on-mesh",
       without_flat_triangles(of_one_mesh<place_numbers>(
                                  name, "CGAL's AABB_tree::closest_point_and_primitive, " + about, make,
                                  [](std::span<const double> q) { return typename K::Point_3(q[4], q[5], q[6]); },
                                  [](const Tree& t, const typename K::Point_3& p) {
                                    return static_cast<double>(t.number(t.tree.closest_point_and_primitive(p).second));
                                  }),
                              1)});
}

}  // namespace

void add_cgal_meshes(Rivals& all) {
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  add_tree<Epick>(all, "epick", "exact predicates");
  add_tree<CGAL::Exact_predicates_exact_constructions_kernel>(all, "epeck", "exact constructions as well");
  all.push_back(
      {"mesh-pairs",
       without_flat_triangles(of_two_meshes(
                                  "epick", "CGAL's AABB_tree::all_intersected_primitives of each triangle of the other",
                                  [](const TriangleMesh& m) { return TreeOf<Epick>(m); },
                                  [](const TreeOf<Epick>& a, const TreeOf<Epick>& b) {
                                    Pairs pairs;
                                    std::vector<TreeOf<Epick>::Triangles::const_iterator> met;
                                    for (std::uint32_t i = 0; i < b.triangles.size(); ++i) {
                                      met.clear();
                                      a.tree.all_intersected_primitives(b.triangles[i], std::back_inserter(met));
                                      for (const auto& id : met) pairs.push_back({a.number(id), i});
                                    }
                                    return pairs;
                                  }),
                              2)});
}

}  // namespace plumb::bench
