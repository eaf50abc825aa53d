#include "plumb/surface/solid/intersection_curves.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "plumb/space/bvh/build.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/solid/arrangement.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;
using FaceOfEach = std::array<std::uint32_t, 2>;

constexpr std::uint32_t no_source = std::numeric_limits<std::uint32_t>::max();

TriangleMesh these_triangles(const TriangleMesh& mesh, Numbers& triangles) {
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  TriangleMesh made{mesh.vertices, {}};
  for (const std::uint32_t t : triangles) made.triangles.push_back(mesh.triangles[t]);
  return made;
}

FaceOfEach lesser(const FaceOfEach& l, const FaceOfEach& r) { return {std::min(l[0], r[0]), std::min(l[1], r[1])}; }
bool is_of_both(const FaceOfEach& faces) { return faces[0] != no_source && faces[1] != no_source; }

/// The least triangle of each mesh that a facet is a piece of.
FaceOfEach faces_of_facet(const Arrangement& all, std::size_t facet) {
  FaceOfEach least{no_source, no_source};
  for (const FacetSource& s : all.sources_of(facet)) least[s.face.mesh] = std::min(least[s.face.mesh], s.face.triangle);
  return least;
}

struct CurveEdge {
  std::array<std::uint32_t, 2> ends;  // ascending
  FaceOfEach faces;
};

/// Edges that both have, in order, but those in the midst of what they have in common.
std::vector<CurveEdge> curve_edges(const Arrangement& all) {
  struct Row {
    CurveEdge edge;
    bool is_common;
  };
  std::vector<Row> rows;
  for (std::size_t f = 0; f < all.facets.size(); ++f) {
    const FaceOfEach faces = faces_of_facet(all, f);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = all.facets[f][k], b = all.facets[f][(k + 1) % 3];
      rows.push_back({{{std::min(a, b), std::max(a, b)}, faces}, is_of_both(faces)});
    }
  }
  std::ranges::sort(rows, {}, [](const Row& r) { return r.edge.ends; });
  std::vector<CurveEdge> found;
  for (std::size_t i = 0, next = 0; i < rows.size(); i = next) {
    CurveEdge edge = rows[i].edge;
    std::size_t common = 0;
    for (next = i; next < rows.size() && rows[next].edge.ends == edge.ends; ++next) {
      edge.faces = lesser(edge.faces, rows[next].edge.faces);
      common += rows[next].is_common ? 1 : 0;
    }
    if (is_of_both(edge.faces) && common != 2) found.push_back(edge);
  }
  return found;
}

class CurveTracer {
 public:
  explicit CurveTracer(const Arrangement& all)
      : all_(all), edges_(curve_edges(all)), first_(all.vertices.size() + 1), used_(edges_.size()) {
    for (const CurveEdge& e : edges_)
      for (const std::uint32_t v : e.ends) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    at_.resize(2 * edges_.size());
    Numbers next = first_;
    // Edges ascend, so that each vertex has those to its lesser neighbors first.
    for (const std::size_t end : {1U, 0U})
      for (std::uint32_t e = 0; e < edges_.size(); ++e) at_[next[edges_[e].ends[end]]++] = e;
  }

  std::vector<IntersectionCurve> run() {
    for (std::uint32_t v = 0; v + 1 < first_.size(); ++v)
      if (degree(v) != 2) trace_from(v);
    for (std::uint32_t v = 0; v + 1 < first_.size(); ++v) trace_from(v);
    add_points();
    std::ranges::sort(traced_, {}, &Traced::points);
    std::vector<IntersectionCurve> made;
    for (Traced& t : traced_) {
      IntersectionCurve curve{{}, t.closed, std::move(t.faces)};
      for (const std::uint32_t v : t.points) curve.points.push_back(all_.vertices[v]);
      made.push_back(std::move(curve));
    }
    return made;
  }

 private:
  struct Traced {
    Numbers points;
    bool closed;
    std::vector<FaceOfEach> faces;
  };

  [[nodiscard]] std::uint32_t degree(std::uint32_t v) const { return first_[v + 1] - first_[v]; }

  void trace_from(std::uint32_t start) {
    for (std::uint32_t i = first_[start]; i < first_[start + 1]; ++i) {
      if (used_[at_[i]]) continue;
      Traced curve{{start}, false, {}};
      std::uint32_t v = start, e = at_[i];
      while (true) {
        used_[e] = true;
        curve.faces.push_back(edges_[e].faces);
        v = edges_[e].ends[edges_[e].ends[0] == v ? 1 : 0];
        if (v == start) break;
        curve.points.push_back(v);
        if (degree(v) != 2) break;
        e = at_[first_[v]] == e ? at_[first_[v] + 1] : at_[first_[v]];
      }
      curve.closed = v == start;
      traced_.push_back(std::move(curve));
    }
  }

  /// Vertices of both that no edge or facet of both ends at.
  void add_points() {
    std::vector<FaceOfEach> faces(all_.vertices.size(), {no_source, no_source});
    std::vector<bool> is_covered(all_.vertices.size());
    for (std::size_t f = 0; f < all_.facets.size(); ++f) {
      const FaceOfEach of = faces_of_facet(all_, f);
      for (const std::uint32_t v : all_.facets[f]) {
        faces[v] = lesser(faces[v], of);
        if (is_of_both(of)) is_covered[v] = true;
      }
    }
    for (std::uint32_t v = 0; v < faces.size(); ++v)
      if (is_of_both(faces[v]) && !is_covered[v] && degree(v) == 0) traced_.push_back({{v}, false, {faces[v]}});
  }

  const Arrangement& all_;
  std::vector<CurveEdge> edges_;
  Numbers first_, at_;  // edges at each vertex
  std::vector<bool> used_;
  std::vector<Traced> traced_;
};

}  // namespace

std::vector<IntersectionCurve> intersection_curves(const TriangleMesh& a, const TriangleMesh& b) {
  const Bvh of_a = build_bvh(a), of_b = build_bvh(b);
  std::array<Numbers, 2> met;
  for (const TrianglePair& p : intersecting_pairs(of_a, of_b)) met[0].push_back(p.a), met[1].push_back(p.b);
  const std::array meeting{these_triangles(a, met[0]), these_triangles(b, met[1])};
  std::vector<IntersectionCurve> curves = CurveTracer(arrange({}, meeting)).run();
  for (IntersectionCurve& curve : curves)
    for (FaceOfEach& faces : curve.faces) faces = {met[0][faces[0]], met[1][faces[1]]};
  return curves;
}

}  // namespace plumb
