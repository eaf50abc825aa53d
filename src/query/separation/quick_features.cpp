// Features by corners: what the headers of figure/ and query/closest/ number, told by the corners' numbers.
#include <algorithm>
#include <bit>

#include "query/convex/features.hpp"
#include "query/separation/quick.hpp"

namespace plumb::query {
namespace {

constexpr Feature numbered(FeatureKind kind, std::size_t i) { return {kind, static_cast<std::uint32_t>(i)}; }

/// Of a box or rectangle: `along` are the ways that lead along the feature.
std::optional<Feature> feature_along(std::size_t ways, std::uint32_t corner, std::uint64_t along) {
  if (along == 0) return numbered(FeatureKind::vertex, corner);
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

/// The first place from this one on where a vertex is a corner.
std::size_t corner_at(const PolygonMesh& m, std::uint32_t vertex, std::size_t from) {
  return static_cast<std::size_t>(
      std::find(m.corners.begin() + static_cast<std::ptrdiff_t>(from), m.corners.end(), vertex) - m.corners.begin());
}

/// An edge is the lower of the two corners that it leaves, a face that of three vertices.
std::optional<Feature> feature_of_mesh(const PolygonMesh& m, std::span<const std::uint32_t> of) {
  if (of.size() == 1) return numbered(FeatureKind::vertex, of[0]);
  std::size_t edge = m.corners.size();
  for (std::size_t c = corner_at(m, of[0], 0); c < m.corners.size(); c = corner_at(m, of[0], c + 1)) {
    const auto f = static_cast<std::size_t>(std::ranges::upper_bound(m.first, c) - m.first.begin() - 1);
    const std::size_t first = m.first[f], last = m.first[f + 1] - 1;
    if (of.size() == 3) {
      const auto face = std::span(m.corners).subspan(first, last + 1 - first);
      const auto has = [&](std::uint32_t v) { return std::ranges::find(face, v) != face.end(); };
      if (has(of[1]) && has(of[2])) return numbered(FeatureKind::face, f);
      continue;
    }
    const std::size_t before = c == first ? last : c - 1, after = c == last ? first : c + 1;
    if (m.corners[after] == of[1]) edge = std::min(edge, c);
    if (m.corners[before] == of[1]) edge = std::min(edge, before);
  }
  if (edge == m.corners.size()) return {};
  return numbered(FeatureKind::edge, edge);
}

/// Of two corners of a triangle or tetrahedron.
std::size_t edge_of(std::size_t corners, std::uint32_t i, std::uint32_t j) {
  const std::uint32_t low = std::min(i, j), high = std::max(i, j);
  if (corners == 3) return low == 0 && high == 2 ? 2 : low;
  return low == 0 ? high - 1 : low + high;
}

std::optional<Feature> core_feature(const CoreCorners& c, std::span<const std::uint32_t> of, const Support& s) {
  if (c.polyhedron() != nullptr) {
    if (of.size() == 3 || s.level == s.known) return feature_of_mesh(c.polyhedron()->mesh, of);
    return {};
  }
  if (s.level != s.known) return {};
  if (c.ways() > 0) return feature_along(c.ways(), of[0], s.level);
  if (of.size() == 1) return numbered(FeatureKind::vertex, of[0]);
  if (of.size() == 2) return numbered(FeatureKind::edge, c.size() == 2 ? 0 : edge_of(c.size(), of[0], of[1]));
  return numbered(FeatureKind::face, c.size() == 3 ? 0 : 6 - of[0] - of[1] - of[2]);
}

}  // namespace

std::optional<Feature> feature_of_corners(const FigureView& figure, const CoreCorners& c,
                                          std::span<const std::uint32_t> of, const Support& support) {
  const auto core = core_feature(c, of, support);
  if (!core) return {};
  return on_surface(figure, *core);
}

}  // namespace plumb::query
