// CGAL's functions on figures, by its kernels of exact predicates and of exact constructions.
#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Min_sphere_annulus_d_traits_3.h>
#include <CGAL/Min_sphere_d.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/location_tests.hpp"

namespace plumb::bench {
namespace {

template <class K>
struct Made {
  using P2 = typename K::Point_2;
  using P3 = typename K::Point_3;
  using Triangle = typename K::Triangle_3;
  using Segment = typename K::Segment_3;
  using Ray = typename K::Ray_3;
  using Box = typename K::Iso_cuboid_3;
  using Mesh = CGAL::Surface_mesh<P3>;
  using Side = CGAL::Side_of_triangle_mesh<Mesh, K>;

  static P3 point(const double* x) { return P3(x[0], x[1], x[2]); }
  static Triangle triangle(const double* x) { return Triangle(point(x), point(x + 3), point(x + 6)); }
  static Segment segment(const double* x) { return Segment(point(x), point(x + 3)); }
  static Box box(const double* x) { return Box(point(x), point(x + 3), 0); }
  template <std::size_t N>
  static std::vector<P2> points2(const std::array<double, N>& q, std::size_t first) {
    std::vector<P2> all;
    for (std::size_t i = 2 * first; i < N; i += 2) all.emplace_back(q[i], q[i + 1]);
    return all;
  }
  template <std::size_t N>
  static std::vector<P3> points3(const std::array<double, N>& q) {
    std::vector<P3> all;
    for (std::size_t i = 0; i < N; i += 3) all.push_back(point(&q[i]));
    return all;
  }

  struct Located {
    P3 point;
    std::unique_ptr<Mesh> mesh;
    std::unique_ptr<Side> side;
  };
  static Located located(const std::array<double, 21>& q) {
    auto mesh = std::make_unique<Mesh>();
    std::array<typename Mesh::Vertex_index, 6> vertices;
    for (std::size_t i = 0; i < 6; ++i) vertices[i] = mesh->add_vertex(point(&q[3 + 3 * i]));
    for (const auto& f : lab::trial::octahedron_faces) mesh->add_face(vertices[f[0]], vertices[f[1]], vertices[f[2]]);
    auto side = std::make_unique<Side>(*mesh);
    return {point(&q[0]), std::move(mesh), std::move(side)};
  }
};

/// Points that CGAL found to be corners, as a set of bits.
template <std::size_t Dimension, std::size_t N, class Point>
double bits_of(const std::array<double, N>& q, const std::vector<Point>& found) {
  std::uint32_t bits = 0;
  for (const Point& p : found) {
    std::array<double, Dimension> x;
    for (std::size_t k = 0; k < Dimension; ++k) x[k] = CGAL::to_double(p[static_cast<int>(k)]);
    bits |= bit_of<Dimension>(q, x.data());
  }
  return bits;
}

/// A question and its points.
template <std::size_t N, class Point>
struct Cloud {
  std::array<double, N> q;
  std::vector<Point> points;
};

/// Two shapes, and whether they are such as CGAL asks for: no triangle that is flat, no segment or ray that is a point.
template <class A, class B>
struct Question {
  A first;
  B second;
  bool sound = !first.is_degenerate() && !second.is_degenerate();
};

/// Epeck's numbers are evaluated exactly before they are rounded, which to_double alone does not ask for.
template <class Number>
double root(const Number& square) {
  return std::sqrt(CGAL::to_double(CGAL::exact(square)));
}

template <class K>
void add_kernel(Rivals& all, const std::string& name, const std::string& about) {
  using M = Made<K>;
  using P3 = typename K::Point_3;
  const auto call = [&](const std::string& function) { return function + ", " + about; };
  const auto meet = [](const auto& q) { return CGAL::do_intersect(q.first, q.second); };
  const auto meet_if_sound = [](const auto& q) {
    return q.sound ? lab::trial::as_answer(CGAL::do_intersect(q.first, q.second)) : lab::trial::unsure;
  };
  const auto far = [](const auto& q) { return root(CGAL::squared_distance(q.first, q.second)); };
  join<15>(
      all, "ray-triangle", name, call("CGAL's do_intersect"),
      [](const std::array<double, 15>& q) {
        return Question<typename M::Ray, typename M::Triangle>{
            typename M::Ray(M::point(&q[0]), typename K::Vector_3(q[3], q[4], q[5])), M::triangle(&q[6])};
      },
      meet_if_sound);
  join<8>(
      all, "segment-segment", name, call("CGAL's do_intersect"),
      [](const std::array<double, 8>& q) {
        const auto p = M::points2(q, 0);
        return std::pair{typename K::Segment_2(p[0], p[1]), typename K::Segment_2(p[2], p[3])};
      },
      meet);
  join<15>(
      all, "segment-triangle", name, call("CGAL's do_intersect"),
      [](const std::array<double, 15>& q) {
        return Question<typename M::Segment, typename M::Triangle>{M::segment(&q[0]), M::triangle(&q[6])};
      },
      meet_if_sound);
  join<18>(
      all, "triangle-triangle", name, call("CGAL's do_intersect"),
      [](const std::array<double, 18>& q) {
        return Question<typename M::Triangle, typename M::Triangle>{M::triangle(&q[0]), M::triangle(&q[9])};
      },
      meet_if_sound);
  join<12>(
      all, "box-box", name, call("CGAL's do_intersect of Iso_cuboids"),
      [](const std::array<double, 12>& q) {
        return std::pair{M::box(&q[0]), M::box(&q[6])};
      },
      meet);
  join<9>(
      all, "point-segment-distance", name, call("the root of CGAL's squared_distance"),
      [](const std::array<double, 9>& q) {
        return std::pair{M::point(&q[0]), M::segment(&q[3])};
      },
      far);
  join<12>(
      all, "point-triangle-distance", name, call("the root of CGAL's squared_distance"),
      [](const std::array<double, 12>& q) {
        return std::pair{M::point(&q[0]), M::triangle(&q[3])};
      },
      far);
  join<12>(
      all, "segment-segment-distance", name, call("the root of CGAL's squared_distance"),
      [](const std::array<double, 12>& q) {
        return std::pair{M::segment(&q[0]), M::segment(&q[6])};
      },
      far);
  using P2s = std::vector<typename K::Point_2>;
  join<std::tuple_size_v<lab::trial::PolygonNumbers>>(
      all, "point-in-polygon", name, call("CGAL's bounded_side_2"),
      [](const lab::trial::PolygonNumbers& q) {
        return std::pair{typename K::Point_2(q[0], q[1]), M::points2(q, 1)};
      },
      [](const std::pair<typename K::Point_2, P2s>& q) {
        return CGAL::bounded_side_2(q.second.begin(), q.second.end(), q.first, K()) != CGAL::ON_UNBOUNDED_SIDE;
      });
  join<21>(all, "point-in-polyhedron", name, call("CGAL's Side_of_triangle_mesh"), M::located,
           [](const typename M::Located& q) { return (*q.side)(q.point) != CGAL::ON_UNBOUNDED_SIDE; });
  using Flat = Cloud<32, typename K::Point_2>;
  join<32>(
      all, "hull-2d", name, call("CGAL's convex_hull_2"),
      [](const std::array<double, 32>& q) {
        return Flat{q, M::points2(q, 0)};
      },
      [](const Flat& cloud) {
        std::vector<typename K::Point_2> hull;
        CGAL::convex_hull_2(cloud.points.begin(), cloud.points.end(), std::back_inserter(hull));
        return bits_of<2>(cloud.q, hull);
      });
  using Solid = Cloud<36, P3>;
  join<36>(
      all, "hull-3d", name, call("CGAL's extreme_points_3"),
      [](const std::array<double, 36>& q) {
        return Solid{q, M::points3(q)};
      },
      [](const Solid& cloud) {
        std::vector<P3> hull;
        CGAL::extreme_points_3(cloud.points, std::back_inserter(hull));
        return bits_of<3>(cloud.q, hull);
      });
  join<15>(all, "smallest-ball", name, call("the root of CGAL's Min_sphere_d"), M::template points3<15>,
           [](const std::vector<P3>& points) {
             using Ball = CGAL::Min_sphere_d<CGAL::Min_sphere_annulus_d_traits_3<K>>;
             return root(Ball(points.begin(), points.end()).squared_radius());
           });
}

}  // namespace

void add_cgal_figures(Rivals& all) {
  add_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(all, "epick", "exact predicates");
  add_kernel<CGAL::Exact_predicates_exact_constructions_kernel>(all, "epeck", "exact constructions as well");
}

}  // namespace plumb::bench
