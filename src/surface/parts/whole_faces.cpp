#include "surface/parts/whole_faces.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "plumb/arith/error.hpp"

namespace plumb::surface {
namespace {

struct WholeFace {
  std::map<std::uint32_t, std::vector<std::uint32_t>> next;  // of each vertex on its outline
  std::vector<std::uint32_t> sources;
};

/// By plane and side; edges within a face, which it has in both directions, are left out.
using WholeFaces = std::map<std::pair<std::uint32_t, bool>, WholeFace>;

WholeFaces faces_by_plane(const CutCell& cell) {
  std::map<std::pair<std::uint32_t, bool>, std::vector<const CutFacet*>> facets;
  for (const CutFacet& f : cell) facets[{f.plane, f.turned}].push_back(&f);
  WholeFaces faces;
  for (const auto& [at, of_plane] : facets) {
    WholeFace& face = faces[at];
    std::map<std::array<std::uint32_t, 2>, int> times;
    for (const CutFacet* f : of_plane) {
      if (f->triangle != no_triangle) face.sources.push_back(f->triangle);
      for (const CutEdge& e : f->edges) {
        if (const auto back = times.find({e.to, e.from}); back != times.end() && back->second > 0) {
          --back->second;
        } else {
          ++times[{e.from, e.to}];
        }
      }
    }
    for (const auto& [edge, n] : times)
      for (int i = 0; i < n; ++i) face.next[edge[0]].push_back(edge[1]);
    std::ranges::sort(face.sources);
    face.sources.erase(std::unique(face.sources.begin(), face.sources.end()), face.sources.end());
  }
  return faces;
}

struct Outline {
  std::vector<std::uint32_t> corners;
  std::uint32_t plane;
  const std::vector<std::uint32_t>* sources;
};

/// Around the face, from its first corner.  Throws nothing: a face of several outlines is no face of a convex solid.
bool follow(const CutSpace& space, const WholeFace& face, const std::set<std::uint32_t>& corners, Outline& outline) {
  std::uint32_t first = no_triangle;
  for (const auto& [v, next] : face.next) {
    if (next.size() != 1) return false;
    if (corners.contains(v) && (first == no_triangle || space.before(v, first))) first = v;
  }
  if (first == no_triangle) return false;
  std::size_t steps = 0;
  std::uint32_t v = first;
  do {
    if (corners.contains(v)) outline.corners.push_back(v);
    v = face.next.at(v).front();
  } while (v != first && ++steps < face.next.size());
  return steps + 1 == face.next.size() && outline.corners.size() > 2;
}

bool is_double(const ExactPoint3& p) { return ExactPoint3(approximate(p)) == p; }

}  // namespace

std::variant<ConvexPart, DividingPlane> whole_faces(CutSpace& space, const CutCell& cell) {
  const WholeFaces faces = faces_by_plane(cell);
  std::map<std::uint32_t, std::uint32_t> planes_at;
  for (const auto& [at, face] : faces)
    for (const auto& [v, next] : face.next) ++planes_at[v];
  std::set<std::uint32_t> corners;
  for (const auto& [v, planes] : planes_at)
    if (planes > 2) corners.insert(v);
  std::vector<Outline> outlines;
  for (const auto& [at, face] : faces) {
    const Sign out = at.second ? Sign::negative : Sign::positive;
    for (const auto& [v, planes] : planes_at)
      if (space.side(v, at.first) == out) return DividingPlane{at.first};
  }
  for (const auto& [at, face] : faces) {
    Outline outline{{}, at.first, &face.sources};
    if (!follow(space, face, corners, outline))
      throw InvalidShape("convex_parts: the mesh crosses itself where its edges meet, or lies on itself");
    outlines.push_back(std::move(outline));
  }
  std::vector<std::uint32_t> order(corners.begin(), corners.end());
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return space.before(a, b); });
  std::map<std::uint32_t, std::uint32_t> number_of;
  ConvexPart part;
  part.solid.kind = IntersectionKind::solid;
  part.is_exact = true;
  for (const std::uint32_t v : order) {
    number_of[v] = static_cast<std::uint32_t>(part.solid.vertices.size());
    part.solid.vertices.push_back(space.point(v));
    part.is_exact = part.is_exact && is_double(space.point(v));
  }
  for (Outline& o : outlines)
    for (std::uint32_t& v : o.corners) v = number_of[v];
  std::ranges::sort(outlines, {}, &Outline::corners);
  part.solid.first.push_back(0);
  for (const Outline& o : outlines) {
    part.solid.corners.insert(part.solid.corners.end(), o.corners.begin(), o.corners.end());
    part.solid.first.push_back(static_cast<std::uint32_t>(part.solid.corners.size()));
    part.plane.push_back(o.plane);  // a number of the space, until the mesh's is known
    part.sources.insert(part.sources.end(), o.sources->begin(), o.sources->end());
    part.first_source.push_back(static_cast<std::uint32_t>(part.sources.size()));
  }
  return part;
}

}  // namespace plumb::surface
