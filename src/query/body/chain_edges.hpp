// Polygon boundary: which edges has a polygon, as segments of space, and how are their features called?  Which corners,
// and who follows whom?
//
// Laws: all edges that query/body/boundary.hpp tells, also those that bound no inside; a figure of the plane lies in
// z = 0.  Corners are doubles, so that of oriented boxes they are rounded.
// Cost: two copies of the corners.
#pragma once

#include <vector>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "query/body/boundary.hpp"

namespace plumb::query {

/// An edge, its ends by the numbers that the figure has for them.
struct ChainEdge {
  Segment3 shape;
  std::uint32_t from, to;
  Feature whole;

  /// What the figure calls a feature of the segment.
  [[nodiscard]] Feature feature(const Feature& of_edge) const {
    if (of_edge.kind != FeatureKind::vertex) return whole;
    return {FeatureKind::vertex, of_edge.index == 0 ? from : to};
  }
};

template <class Shape>
requires has_boundary<Shape> std::vector<ChainEdge> chain_edges(const Shape& shape) {
  struct Heard {
    std::vector<Point3> corners;
    std::vector<ChainEdge> edges;

    void corner(const arith::Vec<double>& p) { corners.push_back({p.x, p.y, p.z}); }
    void edge(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
      edges.push_back({{corners[from], corners[to]}, from, to, {FeatureKind::edge, number}});
    }
    void face(std::span<const std::uint32_t>, std::uint32_t) {}
  } heard;
  tell_boundary<double>(shape, heard);
  return std::move(heard.edges);
}

/// The corners of all chains in turn, and where each chain begins.
template <class Point>
struct ChainCorners {
  std::vector<Point> corners;
  std::vector<std::uint32_t> first{0};

  /// The edge that leaves corner i of chain number c ends at this corner.
  [[nodiscard]] std::uint32_t next(std::size_t c, std::uint32_t i) const {
    return i + 1 == first[c + 1] ? first[c] : i + 1;
  }
  [[nodiscard]] std::uint32_t next(std::uint32_t i) const {
    std::size_t c = 0;
    while (first[c + 1] <= i) ++c;
    return next(c, i);
  }
};

template <class Polygon>
requires(is_one_of(figure_kind<Polygon>, polygon_kinds)) auto chain_corners(const Polygon& polygon) {
  using Point = std::conditional_t<figure_dimension<Polygon> == 2, Point2, Point3>;
  ChainCorners<Point> chains;
  chains.corners.reserve(4), chains.first.reserve(2);
  boundary::for_each_chain(polygon, [&](const auto& chain) {
    boundary::for_each_place(chain, [&](const Point& p) { chains.corners.push_back(p); });
    chains.first.push_back(static_cast<std::uint32_t>(chains.corners.size()));
  });
  return chains;
}

}  // namespace plumb::query
