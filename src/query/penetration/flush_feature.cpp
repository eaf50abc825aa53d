#include "query/penetration/flush_feature.hpp"

#include "query/convex/features.hpp"
#include "query/penetration/basis.hpp"
#include "query/penetration/furthest.hpp"

namespace plumb::query::parting {
namespace {

using Index = std::uint32_t;

constexpr Feature vertex_number(Index i) { return {FeatureKind::vertex, i}; }
constexpr Feature edge_number(Index i) { return {FeatureKind::edge, i}; }
constexpr Feature face_number(Index i) { return {FeatureKind::face, i}; }

/// What is asked of features one after the other, by their corners: the first of a dimension wholly in the plane.
class Level {
 public:
  Level(const CoreCorners& c, std::span<const Index> all) : corners_(c), all_(all), dimension_(rank(all)) {}

  [[nodiscard]] std::size_t dimension() const { return dimension_; }
  [[nodiscard]] Index first() const { return all_[0]; }
  [[nodiscard]] bool is(std::initializer_list<Index> of) const { return is(std::span(of.begin(), of.size())); }
  [[nodiscard]] bool is(std::span<const Index> of) const {
    return std::ranges::all_of(of, [&](Index i) { return has(i); }) && rank(of) == dimension_;
  }
  [[nodiscard]] bool has(Index i) const {
    if (all_.size() <= 3) return i == all_[0] || i == all_[all_.size() / 2] || i == all_[all_.size() - 1];
    return std::ranges::binary_search(all_, i);
  }

 private:
  /// Of the hull of these corners.
  [[nodiscard]] std::size_t rank(std::span<const Index> of) const {
    if (of.size() == 1) return 0;
    if (of.size() == 2 && is_apart(of[0], of[1])) return 1;
    Basis basis;
    for (const Index i : of) extend(basis, {corners_, corners_}, {i, of[0]});
    return basis.size() - 1;
  }

  /// By one coordinate, as far as doubles tell.
  [[nodiscard]] bool is_apart(Index i, Index j) const {
    const Vec<Running> way = corners_.at<Running>(i) - corners_.at<Running>(j);
    return certain_sign(way.x) != 0 || certain_sign(way.y) != 0 || certain_sign(way.z) != 0;
  }

  const CoreCorners& corners_;
  std::span<const Index> all_;
  std::size_t dimension_;
};

std::optional<Feature> of_box(const Level& level) {
  for (Index e = 0; e < 12 && level.dimension() == 1; ++e) {
    const Index u = e / 4, v = u == 0 ? 1 : 0, w = 3 - u - v, from = (e & 1) << v | (e >> 1 & 1) << w;
    if (level.is({from, from | 1U << u})) return edge_number(e);
  }
  for (Index f = 0; f < 6 && level.dimension() == 2; ++f) {
    const Index w = f / 2, u = w == 0 ? 1 : 0, v = 3 - u - w, from = (f & 1) << w, one = 1U << u, other = 1U << v;
    if (level.is({from, from | one, from | other, from | one | other})) return face_number(f);
  }
  return {};
}

std::optional<Feature> of_rectangle(const Level& level) {
  constexpr std::array<std::array<Index, 2>, 4> edges{{{0, 1}, {2, 3}, {0, 2}, {1, 3}}};
  if (level.dimension() == 2) return face_number(0);
  for (Index e = 0; e < 4; ++e) {
    if (level.is(edges[e])) return edge_number(e);
  }
  return {};
}

std::optional<Feature> of_tetrahedron(const Level& level) {
  Index e = 0;
  for (Index i = 0; i < 4 && level.dimension() == 1; ++i) {
    for (Index j = i + 1; j < 4; ++j, ++e) {
      if (level.is({i, j})) return edge_number(e);
    }
  }
  for (Index i = 0; i < 4 && level.dimension() == 2; ++i) {
    if (level.is({(i + 1) % 4, (i + 2) % 4, (i + 3) % 4})) return face_number(i);
  }
  return {};
}

/// Of segments, triangles and polygons.
std::optional<Feature> of_polygon(const Level& level, std::size_t corners) {
  if (level.dimension() == 2) return face_number(0);
  const auto n = static_cast<Index>(corners);
  for (Index i = 0; i < n; ++i) {
    if (level.is({i, i + 1 == n ? 0 : i + 1})) return edge_number(i);
  }
  return {};
}

std::optional<Feature> edge_of_mesh(const Level& level, const PolygonMesh& m) {
  const auto size = static_cast<Index>(m.corners.size());
  for (Index c = 0; c < size; ++c) {
    if (!level.has(m.corners[c])) continue;
    const auto end = std::ranges::upper_bound(m.first, c);  // of the face
    const Index next = c + 1 == *end ? *std::prev(end) : c + 1;
    if (level.is({m.corners[c], m.corners[next]})) return edge_number(c);
  }
  return {};
}

std::optional<Feature> of_mesh(const Level& level, const PolygonMesh& m) {
  if (level.dimension() == 1) return edge_of_mesh(level, m);
  for (Index f = 0; f + 1 < m.first.size() && level.dimension() == 2; ++f) {
    const auto face = std::span(m.corners).subspan(m.first[f], m.first[f + 1] - m.first[f]);
    if (level.has(face[0]) && level.is(face)) return face_number(f);
  }
  return {};
}

/// Of independent edges: the level ones are those that are free, from the corner that has none of them.
Feature of_plain_sum(std::size_t edges, const SumLevel& level) {
  const Index first = level.first, free = level.free;
  const auto has = [&](Index k) { return first >> k & 1; };
  if (free == 0) return vertex_number(first);
  if (edges == 1 || (edges == 2 && free == 3)) return edges == 1 ? edge_number(0) : face_number(0);
  if (edges == 2) return edge_number(free == 1 ? has(1) : 2 + has(0));
  if (std::has_single_bit(free)) {
    const auto u = static_cast<Index>(std::countr_zero(free)), v = u == 0 ? 1U : 0U, w = 3 - u - v;
    return edge_number(4 * u + has(v) + 2 * has(w));
  }
  const auto w = static_cast<Index>(std::countr_zero(~free));
  return face_number(2 * w + has(w));
}

}  // namespace

Feature flush_feature(const BodyView& body, const CoreCorners& c, const SumLevel& level, bool is_plain) {
  if (is_plain) return on_surface(body.figure, of_plain_sum(c.edges(), level));
  std::array<Index, 8> corners{};
  std::size_t size = 0;
  for (Index i = 0; i < c.size(); ++i) {
    if ((i & ~level.free) == level.first) corners[size++] = i;
  }
  return flush_feature(body, c, std::span(corners).first(size));
}

Feature flush_feature(const BodyView& body, const CoreCorners& c, std::span<const std::uint32_t> corners) {
  const Level level(c, corners);
  std::optional<Feature> found;
  if (level.dimension() == 0) {
    found = vertex_number(level.first());
  } else if (body.is_hull()) {
    return level.dimension() == 1 ? edge_number(level.first()) : face_number(level.first());
  } else if (c.polyhedron() != nullptr) {
    found = of_mesh(level, c.polyhedron()->mesh);
  } else if (c.ways() > 0) {
    found = c.ways() == 3 ? of_box(level) : of_rectangle(level);
  } else {
    const bool is_solid = body.figure.kind == FigureKind::tetrahedron;
    found = is_solid ? of_tetrahedron(level) : of_polygon(level, c.size());
  }
  return body.is_hull() ? *found : on_surface(body.figure, found.value_or(vertex_number(level.first())));
}

FlushPair flush_pair(const BodyView& a, const BodyView& b, const Difference& d, const Way& along) {
  Normal way([&]<class T>() { return along.along<T>(d); });
  const KnownPlane known = along.known(d);
  const bool is_plane = along.is_through_plane();
  const auto on_a = all_furthest(d.a, way, Sign::negative, along.from()[0], known.a, is_plane),
             on_b = all_furthest(d.b, way, Sign::positive, along.from()[1], known.b, is_plane);
  return flush_pair(a, b, d, std::array{std::span<const Index>(on_a), std::span<const Index>(on_b)});
}

FlushPair flush_pair(const BodyView& a, const BodyView& b, const Difference& d,
                     const std::array<std::span<const Index>, 2>& level) {
  return {flush_feature(a, d.a, level[0]), flush_feature(b, d.b, level[1]), {level[0][0], level[1][0]}};
}

}  // namespace plumb::query::parting
