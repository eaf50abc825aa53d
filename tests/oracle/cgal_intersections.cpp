#include <CGAL/intersections.h>
#include <gmpxx.h>

#include <algorithm>

#include "oracle/cgal_figures.hpp"
#include "oracle/intersections.hpp"

namespace plumb::oracle {
namespace {

/// CGAL orders the corners of a box itself; an empty one is none of its figures.
template <class Figure>
bool has_like(const Figure& figure) {
  if constexpr (requires { figure.min; }) {
    const auto smaller = [&](auto p) { return figure.min.*p < figure.max.*p; };
    bool all = smaller(&decltype(figure.min)::x) && smaller(&decltype(figure.min)::y);
    if constexpr (requires { figure.min.z; }) all = all && smaller(&decltype(figure.min)::z);
    return all;
  } else {
    return !of(figure).is_degenerate();
  }
}

std::string text(const Number& x) {
  mpq_class q(x.mpq());
  q.canonicalize();
  return q.get_str();
}

using Coordinates = std::vector<std::string>;

struct Vertices {
  using result_type = CommonVertices;
  std::vector<Coordinates> all;

  void add(const Kernel::Point_2& p) { all.push_back({text(p.x()), text(p.y())}); }
  void add(const Kernel::Point_3& p) { all.push_back({text(p.x()), text(p.y()), text(p.z())}); }
  CommonVertices sorted() {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  template <class Found>
  CommonVertices operator()(const Found& found) {
    if constexpr (requires { found.x(); }) {
      add(found);
    } else if constexpr (requires {
                           found.source();
                           found.target();
                         }) {
      add(found.source()), add(found.target());
    } else if constexpr (requires { found.begin(); }) {
      for (const auto& p : found) add(p);
    } else if constexpr (requires { found.vertex(2); }) {
      for (int i = 0; i < 3; ++i) add(found.vertex(i));
    } else {
      return {};  // a line or a plane
    }
    return sorted();
  }
};

template <class A, class B>
CommonVertices common(const A& a, const B& b) {
  if (!has_like(a) || !has_like(b)) return {};
  const auto found = CGAL::intersection(of(a), of(b));
  if (!found) return std::vector<Coordinates>{};
  Vertices vertices;
  return boost::apply_visitor(vertices, *found);
}

}  // namespace

CommonVertices common_vertices(const Segment2& a, const Segment2& b) { return common(a, b); }
CommonVertices common_vertices(const Line2& a, const Triangle2& b) { return common(a, b); }
CommonVertices common_vertices(const Segment2& a, const Triangle2& b) { return common(a, b); }
CommonVertices common_vertices(const Triangle2& a, const Triangle2& b) { return common(a, b); }
CommonVertices common_vertices(const Segment2& a, const Aabb2& b) { return common(a, b); }
CommonVertices common_vertices(const Segment3& a, const Segment3& b) { return common(a, b); }
CommonVertices common_vertices(const Line3& a, const Plane3& b) { return common(a, b); }
CommonVertices common_vertices(const Segment3& a, const Triangle3& b) { return common(a, b); }
CommonVertices common_vertices(const Line3& a, const Triangle3& b) { return common(a, b); }
CommonVertices common_vertices(const Segment3& a, const Aabb3& b) { return common(a, b); }
CommonVertices common_vertices(const Plane3& a, const Triangle3& b) { return common(a, b); }
CommonVertices common_vertices(const Plane3& a, const Tetrahedron3& b) { return common(a, b); }
CommonVertices common_vertices(const Plane3& a, const Aabb3& b) { return common(a, b); }
CommonVertices common_vertices(const Triangle3& a, const Triangle3& b) { return common(a, b); }
CommonVertices common_vertices(const Triangle3& a, const Aabb3& b) { return common(a, b); }
CommonVertices common_vertices(const Triangle3& a, const Tetrahedron3& b) { return common(a, b); }

CommonVertices common_vertices(const Plane3& a, const Plane3& b, const Plane3& c) {
  if (!has_like(a) || !has_like(b) || !has_like(c)) return {};
  const auto found = CGAL::intersection(of(a), of(b), of(c));
  if (!found) return std::vector<Coordinates>{};
  Vertices vertices;
  return boost::apply_visitor(vertices, *found);
}

}  // namespace plumb::oracle
