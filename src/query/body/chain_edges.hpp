// Polygon boundary: which edges has a polygon, as segments of space, and how are their features called?
//
// Laws: all edges that query/body/boundary.hpp tells, also those that bound no inside; a polygon of the plane lies in
// z = 0.
// Cost: two copies of the corners.
#pragma once

#include <vector>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/body/boundary.hpp"

namespace plumb::query {

/// An edge, its ends by the numbers that the polygon has for them.
struct ChainEdge {
  Segment3 shape;
  std::uint32_t from, to;
  Feature whole;

  /// What the polygon calls a feature of the segment.
  [[nodiscard]] Feature feature(const Feature& of_edge) const {
    if (of_edge.kind != FeatureKind::vertex) return whole;
    return {FeatureKind::vertex, of_edge.index == 0 ? from : to};
  }
};

template <class Polygon>
requires(is_one_of(figure_kind<Polygon>, polygon_kinds)) std::vector<ChainEdge> chain_edges(const Polygon& polygon) {
  struct Heard {
    std::vector<Point3> corners;
    std::vector<ChainEdge> edges;

    void corner(const arith::Vec<double>& p) { corners.push_back({p.x, p.y, p.z}); }
    void edge(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
      edges.push_back({{corners[from], corners[to]}, from, to, {FeatureKind::edge, number}});
    }
    void face(std::span<const std::uint32_t>, std::uint32_t) {}
  } heard;
  tell_boundary<double>(polygon, heard);
  return std::move(heard.edges);
}

}  // namespace plumb::query
