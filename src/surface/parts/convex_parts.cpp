// Convex decomposition: notches are cut one plane after another.
#include "plumb/surface/parts/convex_parts.hpp"

#include <algorithm>

#include "surface/parts/sound_solid.hpp"
#include "surface/parts/whole_faces.hpp"

namespace plumb {
namespace {

using surface::CellEdges, surface::CutCell, surface::CutReach, surface::CutSpace;

struct NotchPlane {
  std::uint32_t plane;
  std::int64_t beside = 0;  // facets of notches in it
};

/// A guess of which plane leaves few parts: it has many notches in it, and crosses few.
std::uint32_t choose_plane(CutSpace& space, const CellEdges& edges) {
  constexpr std::size_t looked_at = 8;
  std::vector<std::uint32_t> planes;
  for (const surface::EdgeWedge& w : edges.wedges) {
    if (!w.is_notch) continue;
    planes.push_back(w.from.plane);
    planes.push_back(w.to.plane);
  }
  std::ranges::sort(planes);
  std::vector<NotchPlane> found;
  for (const std::uint32_t p : planes) {
    if (found.empty() || found.back().plane != p) found.push_back({p});
    ++found.back().beside;
  }
  const std::size_t n = std::min(found.size(), looked_at);
  std::ranges::stable_sort(found, std::ranges::greater(), &NotchPlane::beside);
  std::int64_t most = 0;
  std::uint32_t best = found.front().plane;
  for (std::size_t i = 0; i < n; ++i) {
    std::int64_t gain = 0;
    for (const surface::WedgedEdge& e : edges.edges) {
      std::int64_t notches = 0;
      for (const surface::EdgeWedge& w : edges.wedges_of(e)) notches += w.is_notch ? 1 : 0;
      if (notches == 0) continue;
      const Sign of_a = space.side(e.a, found[i].plane), of_b = space.side(e.b, found[i].plane);
      if (of_a == Sign::zero && of_b == Sign::zero) gain += 2 * notches;
      if (of_a * of_b == Sign::negative) gain -= notches;
    }
    if (i == 0 || gain > most) most = gain, best = found[i].plane;
  }
  return best;
}

/// The parts as far as they are known, and the cells that are not parts yet.
class PartFinder {
 public:
  PartFinder(CutSpace& space, ConvexParts& found) : space_(space), found_(found) {}

  void divide(std::vector<CutCell> solids) {
    for (const CutCell& cell : solids) found_.notches += surface::edges_of(space_, cell).notches;
    open_ = std::move(solids);
    while (!open_.empty()) {
      CutCell cell = std::move(open_.back());
      open_.pop_back();
      take(std::move(cell));
    }
  }

 private:
  void take(CutCell cell) {
    const CellEdges edges = surface::edges_of(space_, cell);
    if (edges.flaw) throw InvalidShape("convex_parts: the mesh crosses itself where its edges meet");
    if (edges.notches != 0) {
      const std::uint32_t plane = choose_plane(space_, edges);
      cut(std::move(cell), edges, plane, CutReach::notches);
      return;
    }
    auto faces = surface::whole_faces(space_, cell);
    if (auto* part = std::get_if<ConvexPart>(&faces); part != nullptr) {
      found_.parts.push_back(std::move(*part));
    } else {
      // Solids that only touch were held for one.
      cut(std::move(cell), edges, std::get<surface::DividingPlane>(faces).plane, CutReach::everywhere);
    }
  }
  void cut(CutCell cell, const CellEdges& edges, std::uint32_t plane, CutReach reach) {
    ++found_.cuts;
    std::vector<CutCell> cells = surface::cut_cell(space_, std::move(cell), edges, plane, reach);
    if (cells.size() == 1) throw InvalidShape("convex_parts: the mesh lies on itself");
    std::ranges::move(cells, std::back_inserter(open_));
  }

  CutSpace& space_;
  ConvexParts& found_;
  std::vector<CutCell> open_;
};

/// Numbers of the mesh as it was given instead of those of the space.
void name_triangles(const surface::SoundSolid& solid, const CutSpace& space, ConvexPart& part,
                    std::vector<std::uint32_t>& first_of_plane) {
  if (first_of_plane.empty()) {
    for (std::uint32_t t = 0; t < solid.given.size(); ++t) {
      const std::uint32_t p = space.plane_of(t);
      if (first_of_plane.size() <= p) first_of_plane.resize(p + 1, surface::no_triangle);
      first_of_plane[p] = std::min(first_of_plane[p], solid.given[t]);
    }
  }
  for (std::uint32_t& p : part.plane) p = first_of_plane[p];
  for (std::uint32_t& t : part.sources) t = solid.given[t];
  for (std::size_t f = 0; f + 1 < part.first_source.size(); ++f)
    std::sort(part.sources.begin() + part.first_source[f], part.sources.begin() + part.first_source[f + 1]);
}

}  // namespace

ConvexParts convex_parts(const TriangleMesh& mesh) {
  constexpr const char* question = "convex_parts";
  const surface::SoundSolid solid = surface::in_canonical_order(question, mesh);
  CutSpace space(solid.mesh);
  ConvexParts found;
  PartFinder(space, found).divide(surface::solids_of(question, solid, space));
  std::ranges::sort(found.parts, [](const ConvexPart& a, const ConvexPart& b) {
    return std::ranges::lexicographical_compare(a.solid.vertices, b.solid.vertices);
  });
  std::vector<std::uint32_t> first_of_plane;
  for (ConvexPart& part : found.parts) name_triangles(solid, space, part, first_of_plane);
  return found;
}

PolygonMesh rounded(const ConvexPart& part) { return {approximate(part.solid), part.solid.corners, part.solid.first}; }

}  // namespace plumb
