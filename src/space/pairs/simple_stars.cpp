#include "space/pairs/simple_stars.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "plumb/predicates.hpp"
#include "space/bvh/parts.hpp"

namespace plumb::space {
namespace {

/// Which sides of a triangle are seen along the three axes of space: two bits for each, of which none is set where it is
/// seen from its edge.
using Shown = std::uint8_t;
constexpr Shown opposite_of(Shown s) { return static_cast<Shown>((s & 0x15) << 1 | (s & 0x2a) >> 1); }

Shown shown_by(const Triangle3& t) {
  const auto bits = [](Sign s) { return s == Sign::positive ? 1U : s == Sign::negative ? 2U : 0U; };
  const Point3 &a = t.a, &b = t.b, &c = t.c;
  return static_cast<Shown>(bits(orient2d({a.y, a.z}, {b.y, b.z}, {c.y, c.z})) |
                            bits(orient2d({a.z, a.x}, {b.z, b.x}, {c.z, c.x})) << 2 |
                            bits(orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y})) << 4);
}

/// Holds a triangle's other corners, as they follow the vertex, and what it shows so.
struct LinkEdge {
  std::uint32_t from, to;
  Shown shown;
};
constexpr LinkEdge turned(const LinkEdge& e) { return {e.to, e.from, opposite_of(e.shown)}; }

/// Holds the slots of each vertex, one after another.
struct SlotsAround {
  std::vector<std::uint32_t> first, slot;

  template <class Mesh>
  SlotsAround(const SlotMesh<Mesh>& mesh, std::size_t slots) : first(mesh.vertices.size() + 1), slot(3 * slots) {
    for (std::size_t s = 0; s < slots; ++s) {
      for (const std::uint32_t v : Bvh::Corners(mesh.triangles[s])) ++first[v];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    for (std::size_t s = slots; s-- > 0;) {
      for (const std::uint32_t v : Bvh::Corners(mesh.triangles[s])) slot[--first[v]] = static_cast<std::uint32_t>(s);
    }
  }
};

/// What is around one vertex at a time; its lists are kept for the next.
class Star {
 public:
  explicit Star(std::span<const Point3> vertices) : vertices_(vertices) {}

  template <class Mesh>
  [[nodiscard]] bool is_simple(const SlotMesh<Mesh>& mesh, std::uint32_t v, std::span<const std::uint32_t> slots,
                               std::span<const Shown> shown) {
    if (slots.empty() || slots.size() > most_triangles) return false;
    path_.clear();
    for (const std::uint32_t s : slots) {
      const Bvh::Corners& c = mesh.triangles[s];
      const std::size_t k = c[0] == v ? 0 : c[1] == v ? 1 : 2;
      path_.push_back({c[(k + 1) % 3], c[(k + 2) % 3], shown[s]});
    }
    return follow_one_another() && (goes_round_along_an_axis(v) || goes_round(v));
  }

 private:
  /// Beyond it the order is not looked for: it takes the square of their number.
  static constexpr std::size_t most_triangles = 256;

  /// Puts the links in the order in which one goes around, and turns them to lead on; false where they are no path and no
  /// ring.
  bool follow_one_another() {
    std::size_t n = lead_on(1);
    is_closed_ = n == path_.size() && path_.back().to == path_.front().from;
    if (is_closed_ || n == path_.size()) return true;
    std::reverse(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(n));  // and on from its other end
    for (std::size_t i = 0; i < n; ++i) path_[i] = turned(path_[i]);
    n = lead_on(n);
    is_closed_ = false;
    return n == path_.size();
  }
  /// So many lead on from one another already; how many can?
  std::size_t lead_on(std::size_t n) {
    for (; n < path_.size(); ++n) {
      const std::uint32_t at = path_[n - 1].to;
      const auto next = std::find_if(path_.begin() + static_cast<std::ptrdiff_t>(n), path_.end(),
                                     [at](const LinkEdge& e) { return e.from == at || e.to == at; });
      if (next == path_.end()) break;
      if (next->from != at) *next = turned(*next);
      std::swap(*next, path_[n]);
    }
    return n;
  }

  /// Along an axis of space signs are known, and who goes round passes once from below the vertex to above it.
  [[nodiscard]] bool goes_round_along_an_axis(std::uint32_t v) const {
    if (!is_closed_) return false;
    unsigned all = 0x3f;
    for (const LinkEdge& e : path_) all &= e.shown;
    if (all == 0) return false;
    const auto height = (all & 3) != 0 ? &Point3::z : (all & 12) != 0 ? &Point3::x : &Point3::y;
    const double o = vertices_[v].*height;
    std::size_t rises = 0;
    for (const LinkEdge& e : path_) rises += vertices_[e.from].*height < o && !(vertices_[e.to].*height < o) ? 1U : 0U;
    return rises == 1;
  }

  /// Guesses a point on the side that the triangles may all show.
  [[nodiscard]] Point3 seen_from(std::uint32_t v) const {
    const Point3& o = vertices_[v];
    double x = 0, y = 0, z = 0, reach = 0;
    for (const LinkEdge& e : path_) {
      const Point3 &p = vertices_[e.from], &q = vertices_[e.to];
      const double px = p.x - o.x, py = p.y - o.y, pz = p.z - o.z, qx = q.x - o.x, qy = q.y - o.y, qz = q.z - o.z;
      const double nx = py * qz - pz * qy, ny = pz * qx - px * qz, nz = px * qy - py * qx;
      const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
      if (!(length > 0)) continue;
      x += nx / length, y += ny / length, z += nz / length;
      reach = std::max({reach, std::abs(px), std::abs(py), std::abs(pz)});
    }
    return {o.x + x * reach, o.y + y * reach, o.z + z * reach};
  }

  /// Directions from 0 on to the half of a turn are high, others low: who goes round passes once from low to high.
  [[nodiscard]] bool goes_round(std::uint32_t v) const {
    const Point3 &o = vertices_[v], &start = vertices_[path_.front().from], w = seen_from(v);
    if (!(w.x - w.x == 0) || !(w.y - w.y == 0) || !(w.z - w.z == 0)) return false;
    bool was_high = true;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const Point3 &p = vertices_[path_[i].from], &q = vertices_[path_[i].to];
      if (orient3d(o, p, q, w) != left) return false;
      if (is_closed_ && i + 1 == path_.size()) break;  // which leads to the start
      const bool is_high = i == 0 || orient3d(o, start, q, w) != right;
      if (is_high && !was_high) return false;
      was_high = is_high;
    }
    return !is_closed_ || !was_high;
  }

  static constexpr Sign left = Sign::negative, right = Sign::positive;  // as orient3d says of a turn that w sees
  std::span<const Point3> vertices_;
  std::vector<LinkEdge> path_;
  bool is_closed_ = false;
};

/// Tells of each vertex whether its star is simple.
template <class Mesh>
std::vector<std::uint8_t> find_simple(const SlotMesh<Mesh>& mesh, std::size_t slots, Execution execution) {
  std::vector<std::uint8_t> is_simple(mesh.vertices.size());
  const SlotsAround around(mesh, slots);
  std::vector<Shown> shown(slots);
  for_blocks(execution, slots, 4096, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t s = from; s < to; ++s) shown[s] = shown_by(mesh.triangle(s));
  });
  for_blocks(execution, mesh.vertices.size(), 4096, [&](std::size_t, std::size_t from, std::size_t to) {
    Star star(mesh.vertices);
    for (std::size_t v = from; v < to; ++v) {
      const std::span<const std::uint32_t> here(around.slot.data() + around.first[v],
                                                around.first[v + 1] - around.first[v]);
      is_simple[v] = star.is_simple(mesh, static_cast<std::uint32_t>(v), here, shown) ? 1 : 0;
    }
  });
  return is_simple;
}

}  // namespace

template <class Mesh>
SimpleStars::SimpleStars(const SlotMesh<Mesh>& mesh, std::size_t slots, Execution execution)
    : is_simple_(find_simple(mesh, slots, execution)) {}
template SimpleStars::SimpleStars(const SlotMesh<Bvh>&, std::size_t, Execution);
template SimpleStars::SimpleStars(const SlotMesh<CompactBvh>&, std::size_t, Execution);

}  // namespace plumb::space
