#include "convex_search.hpp"

#include <algorithm>
#include <vector>

#include "arith/running_error.hpp"
#include "axis_body.hpp"

namespace plumb::query {
namespace {

using namespace axes;
using Vertex = core::Vec<Running>;
using Triple = core::Vec<double>;
using Vertices = std::vector<Vertex>;

constexpr int most_steps = 48;

Triple value(const Vertex& v) { return {v.x.value, v.y.value, v.z.value}; }

/// Of a line or ray, a part that goes beyond all others along an axis: it meets their hull where the whole does.
/// Nothing where doubles do not tell.
std::optional<Vertices> cut_to(const Vertices& others, const AxisBody<Running>& straight) {
  const Vertex &from = straight.points[0], &along = straight.edges[0];
  const std::array parts{&Vertex::x, &Vertex::y, &Vertex::z};
  const auto axis =
      *std::ranges::max_element(parts, {}, [&](Running Vertex::*part) { return magnitude_of((along.*part).value); });
  const double least = Running::size((along.*axis).value);
  double reach = 0;
  for (const Vertex& v : others) reach = std::max(reach, Running::size(((v - from).*axis).upper()) * 2);
  for (const Vertex& v : others) reach = std::max(reach, Running::size(((v - from).*axis).lower()) * 2);
  const double t = (reach + least) / least;
  const Vertex step = along * Running(t);
  Vertices ends{straight.ends[0] == EdgeEnd::both ? from - step : from, from + step};
  const bool forward = (along.*axis).value > 0;
  for (const Vertex& v : others) {
    const Running above = (ends[1] - v).*axis, below = (v - ends[0]).*axis;
    const auto beyond = [forward](const Running& x) { return forward ? x.lower() > 0 : x.upper() < 0; };
    if (!beyond(above) || (straight.ends[0] == EdgeEnd::both && !beyond(below))) return {};
  }
  return ends;
}

/// Nothing for figures that go on in two directions.
std::optional<Vertices> vertices_of(const FlatView& v, const Vertices* others) {
  return with_shape(v, [&](const auto& s) -> std::optional<Vertices> {
    using Shape = std::remove_cvref_t<decltype(s)>;
    Vertices all;
    if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
      std::vector<bool> used(s.mesh.vertices.size());
      for (const std::uint32_t c : s.mesh.corners) used[c] = true;
      for (std::size_t i = 0; i < used.size(); ++i) {
        if (used[i]) all.push_back(core::vec<Running>(s.mesh.vertices[i]));
      }
      return all;
    } else if constexpr (has_body<Shape>) {
      const auto body = axis_body_of<Running>(s, {0, 0, 0});
      if (body.edge_count > 0 && body.ends[0] != EdgeEnd::none)
        return body.edge_count == 1 && others != nullptr ? cut_to(*others, body) : std::nullopt;
      all.assign(body.points.begin(), body.points.begin() + static_cast<std::ptrdiff_t>(body.point_count));
      return all;
    } else {
      return {};
    }
  });
}

const Vertex& farthest(const Vertices& vertices, const Triple& along, double way) {
  const Vertex* best = &vertices[0];
  double most = -std::numeric_limits<double>::infinity();
  for (const Vertex& v : vertices) {
    const double reach = way * core::dot(value(v), along);
    if (reach > most) most = reach, best = &v;
  }
  return *best;
}

/// Are all of a strictly farther along than all of b?
bool proves_apart(const Vertices& a, const Vertices& b, const Triple& along) {
  const Vertex n{Running(along.x), Running(along.y), Running(along.z)};
  double least = std::numeric_limits<double>::infinity(), most = -least, widths = 0;
  for (const Vertex& v : a) {
    const Running at = core::dot(v, n);
    widths += at.upper() - at.lower();
    least = std::min(least, at.lower());
  }
  for (const Vertex& v : b) {
    const Running at = core::dot(v, n);
    widths += at.upper() - at.lower();
    most = std::max(most, at.upper());
  }
  return widths - widths == 0 && least > most;
}

/// Is the origin strictly inside of the tetrahedron?
bool proves_overlap(const std::vector<Vertex>& s) {
  if (s.size() != 4) return false;
  Sign all{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto sign = core::dot(s[(i + 1) % 4], core::cross(s[(i + 2) % 4], s[(i + 3) % 4])).sign();
    if (!sign.certain() || sign.value() == Sign::zero) return false;
    const Sign outward = i % 2 == 0 ? sign.value() : -sign.value();
    if (i > 0 && outward != all) return false;
    all = outward;
  }
  return true;
}

/// The part of the simplex that is nearest to the origin, and its nearest point: of all its parts.
struct Nearest {
  std::vector<Vertex> part;
  Triple at{0, 0, 0};
};
Nearest nearest(const std::vector<Vertex>& simplex) {
  Nearest best;
  double distance = std::numeric_limits<double>::infinity();
  for (unsigned chosen = 1; chosen < 1u << simplex.size(); ++chosen) {
    std::vector<Vertex> part;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((chosen >> i & 1u) != 0) part.push_back(simplex[i]);
    }
    // Weights of the edges from the first corner, by elimination of their normal equations.
    const Triple base = value(part[0]);
    const std::size_t n = part.size() - 1;
    std::array<Triple, 3> edge{};
    std::array<std::array<double, 4>, 3> row{};
    for (std::size_t i = 0; i < n; ++i) edge[i] = value(part[i + 1]) - base;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) row[i][j] = core::dot(edge[i], edge[j]);
      row[i][3] = -core::dot(edge[i], base);
    }
    bool inside = true;
    for (std::size_t k = 0; k < n && inside; ++k) {
      inside = row[k][k] > 0;
      for (std::size_t i = 0; i < n && inside; ++i) {
        if (i == k) continue;
        const double by = row[i][k] / row[k][k];
        for (std::size_t j = 0; j < 4; ++j) row[i][j] -= by * row[k][j];
      }
    }
    double rest = 1;
    Triple at = base;
    for (std::size_t i = 0; i < n && inside; ++i) {
      const double weight = row[i][3] / row[i][i];
      inside = weight > 0;
      rest -= weight;
      at = at + edge[i] * weight;
    }
    if (inside && rest > 0 && core::dot(at, at) < distance) {
      distance = core::dot(at, at);
      best = {std::move(part), at};
    }
  }
  return best;
}

bool same(const Triple& a, const Triple& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

std::optional<Relation> relate_hulls(const Vertices& a, const Vertices& b) {
  std::vector<Vertex> simplex{a[0] - b[0]};
  Triple at = value(simplex[0]);
  for (int step = 0; step < most_steps; ++step) {
    const Vertex next = farthest(a, at, -1) - farthest(b, at, 1);
    if (core::dot(value(next), at) > 0 && proves_apart(a, b, at)) return Relation::disjoint;
    if (std::ranges::any_of(simplex, [&](const Vertex& v) { return same(value(v), value(next)); })) return {};
    simplex.push_back(next);
    if (proves_overlap(simplex)) return Relation::overlapping;
    Nearest found = nearest(simplex);
    if (found.part.empty() || found.part.size() == 4) return {};
    simplex = std::move(found.part);
    at = found.at;
  }
  return {};
}

}  // namespace

std::optional<Relation> relate_by_search(const FlatView& a, const FlatView& b) {
  const bool a_first = a.kind == FigureKind::convex_polyhedron;
  const auto solid = vertices_of(a_first ? a : b, nullptr);
  const auto other = vertices_of(a_first ? b : a, &*solid);
  if (!other) return {};
  return relate_hulls(*solid, *other);
}

}  // namespace plumb::query
