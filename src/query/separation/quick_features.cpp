// Features by corners: what the headers of figure/ and query/closest/ number, told by the corners' numbers.
#include <algorithm>
#include <bit>

#include "query/convex/features.hpp"
#include "query/separation/quick.hpp"

namespace plumb::query {
namespace {

constexpr Feature numbered(FeatureKind kind, std::size_t i) { return {kind, static_cast<std::uint32_t>(i)}; }

/// Of a box, rectangle, segment or point: `along` are the ways that lead along the feature.
Feature feature_along(std::size_t ways, std::uint32_t corner, std::uint64_t along) {
  if (along == 0) return numbered(FeatureKind::vertex, corner);
  if (ways == 1) return numbered(FeatureKind::edge, 0);
  if (ways == 2) {
    if (along == 3) return numbered(FeatureKind::face, 0);
    const std::uint32_t u = along == 1 ? 0 : 1;
    return numbered(FeatureKind::edge, 2 * u + (corner >> (1 - u) & 1));
  }
  if (std::popcount(along) == 1) {
    const auto u = static_cast<std::uint32_t>(std::countr_zero(along));
    const std::uint32_t v = u == 0 ? 1 : 0, w = 3 - u - v;
    return numbered(FeatureKind::edge, 4 * u + (corner >> v & 1) + 2 * (corner >> w & 1));
  }
  const auto w = static_cast<std::uint32_t>(std::countr_zero(~along));
  return numbered(FeatureKind::face, 2 * w + (corner >> w & 1));
}

/// A corner of a face.
struct FaceCorner {
  std::size_t face, corner;
};

/// Of triangles alone the number tells.
std::size_t face_of(const PolygonMesh& m, std::size_t corner) {
  const std::size_t f = corner / 3;
  if (f + 1 < m.first.size() && m.first[f] <= corner && corner < m.first[f + 1]) return f;
  return static_cast<std::size_t>(std::ranges::upper_bound(m.first, corner) - m.first.begin() - 1);
}

/// Takes every corner that a vertex is, from face to face around it; false where the faces do not close around it.
template <class Take>
bool around_vertex(const ConvexPolyhedron3& s, std::uint32_t vertex, const Take& take) {
  const PolygonMesh& m = s.mesh;
  const auto start = static_cast<std::size_t>(std::ranges::find(m.corners, vertex) - m.corners.begin());
  if (start == m.corners.size()) return false;
  FaceCorner at{face_of(m, start), start};
  for (std::size_t turns = 0; turns < m.corners.size(); ++turns) {
    take(at);
    const std::size_t beyond = s.across[at.corner];
    std::size_t c = m.first[beyond];
    while (c < m.first[beyond + 1] && m.corners[c] != vertex) ++c;
    if (c == m.first[beyond + 1]) return false;
    if (c == start) return true;
    at = {beyond, c};
  }
  return false;
}

/// Of two corners of a triangle or tetrahedron.
std::size_t edge_of(std::size_t corners, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t low = std::min(i, j), high = std::max(i, j);
  if (corners == 3) return low == 0 && high == 2 ? 2 : low;
  return low == 0 ? high - 1 : low + high;
}

std::optional<Feature> core_feature(const CoreCorners& c, std::span<const std::uint32_t> of, const Support& s) {
  if (c.polyhedron() != nullptr) {
    if (of.size() == 3 || s.level == s.known) return feature_of_mesh(*c.polyhedron(), of);
    return {};
  }
  if (s.level != s.known) return {};
  if (c.ways() > 0) return feature_along(c.ways(), of[0], s.level);
  if (of.size() == 1) return numbered(FeatureKind::vertex, of[0]);
  if (of.size() == 2) return numbered(FeatureKind::edge, c.size() == 2 ? 0 : edge_of(c.size(), of[0], of[1]));
  return numbered(FeatureKind::face, c.size() == 3 ? 0 : 6 - of[0] - of[1] - of[2]);
}

}  // namespace

/// An edge is the lower of the two corners that it leaves, a face that of three vertices.
std::optional<Feature> feature_of_mesh(const ConvexPolyhedron3& solid, std::span<const std::uint32_t> of) {
  if (of.size() == 1) return numbered(FeatureKind::vertex, of[0]);
  const PolygonMesh& m = solid.mesh;
  std::size_t found = m.corners.size();  // beyond all
  const auto see = [&](const FaceCorner& at) {
    const std::size_t first = m.first[at.face], last = m.first[at.face + 1] - 1;
    if (of.size() == 3) {
      const auto face = std::span(m.corners).subspan(first, last + 1 - first);
      const auto has = [&](std::uint32_t v) { return std::ranges::find(face, v) != face.end(); };
      if (has(of[1]) && has(of[2])) found = std::min(found, at.face);
      return;
    }
    const std::size_t c = at.corner, before = c == first ? last : c - 1, after = c == last ? first : c + 1;
    if (m.corners[after] == of[1]) found = std::min(found, c);
    if (m.corners[before] == of[1]) found = std::min(found, before);
  };
  if (!around_vertex(solid, of[0], see) || found == m.corners.size()) return {};
  return numbered(of.size() == 3 ? FeatureKind::face : FeatureKind::edge, found);
}

Feature feature_of_sum(const FigureView& figure, std::size_t edges, std::uint32_t corner, std::uint32_t along) {
  return on_surface(figure, feature_along(edges, corner, along));
}

std::optional<Feature> feature_of_corners(const FigureView& figure, const CoreCorners& c,
                                          std::span<const std::uint32_t> of, const Support& support) {
  const auto core = core_feature(c, of, support);
  if (!core) return {};
  return on_surface(figure, *core);
}

}  // namespace plumb::query
