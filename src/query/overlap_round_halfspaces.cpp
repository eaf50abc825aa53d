// Balls, capsules and lozenges against k-DOPs and other intersections of halfspaces.
#include <cmath>

#include "exact_gap.hpp"
#include "plumb/query/overlap_round.hpp"
#include "round_input.hpp"
#include "round_vertices.hpp"

namespace plumb {
namespace query {
namespace {

using Plain = core::Vec<double>;

Plain plain(const Vertex& v) { return {v.x.value, v.y.value, v.z.value}; }

/// normal . x <= offset.
struct Side {
  Plain normal;
  double offset;
};

std::vector<Side> sides_of(const KDop3& k_dop) {
  std::vector<Side> sides;
  sides.reserve(2 * k_dop.directions.size());
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    const Vector3& d = k_dop.directions.all()[i];
    sides.push_back({{d.x, d.y, d.z}, k_dop.max[i]});
    sides.push_back({{-d.x, -d.y, -d.z}, -k_dop.min[i]});
  }
  return sides;
}
std::vector<Side> sides_of(const HalfspaceIntersection3& intersection) {
  std::vector<Side> sides;
  sides.reserve(intersection.halfspaces.size());
  for (const Halfspace3& h : intersection.halfspaces) sides.push_back({{h.normal.x, h.normal.y, h.normal.z}, h.offset});
  return sides;
}

/// The nearest point of the sides to p, nearly, by corrections for each side in turn (Hildreth 1957), and how far back
/// along each side's normal it lies: what proves that p is outside.
struct Foot {
  Plain at;
  std::vector<double> back;
};
Foot foot(std::span<const Side> sides, const Plain& p, double margin) {
  constexpr int most_rounds = 64;
  Foot f{p, std::vector<double>(sides.size())};
  const double size = std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
  for (int round = 0; round < most_rounds; ++round) {
    double change = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto& [n, offset] = sides[i];
      const double square = core::dot(n, n), length = std::sqrt(square);
      if (!(square > 0)) continue;
      const double beyond = (core::dot(n, f.at) - offset + margin * length) / square;
      const double step = beyond > -f.back[i] ? beyond : -f.back[i];
      f.back[i] += step;
      f.at = f.at - n * step;
      change = std::fmax(change, std::fabs(step) * length);
    }
    if (change <= 0x1p-45 * (size + margin)) break;  // a guess for what is proved after it
  }
  return f;
}

Vertex exactly(const Plain& v) { return {Running(v.x), Running(v.y), Running(v.z)}; }

class Search {
 public:
  Search(std::span<const Side> sides, std::span<const Vertex> core, double radius)
      : sides_(sides), core_(core), radius_(radius) {}

  std::optional<Sign> run() const {
    constexpr int most_rounds = 6;
    const double margin = radius_.value * 0x1p-24;
    for (const Side& side : sides_) {
      if (!(core::dot(side.normal, side.normal) > 0)) return {};
      if (proved_beyond([&](const Vertex& v) { return height(side, v); }, exactly(side.normal))) return Sign::positive;
    }
    for (const Vertex& v : core_) {
      if (radius_.value > 0 && holds(v)) return Sign::negative;
    }
    Plain p = plain(core_[0]);
    for (std::size_t i = 1; i < core_.size(); ++i) p = p + plain(core_[i]);
    p = p * (1 / static_cast<double>(core_.size()));
    for (int round = 0; round < most_rounds; ++round) {
      const Foot inner = foot(sides_, p, margin);
      if (proved_near(inner.at)) return Sign::negative;
      const Foot outer = foot(sides_, p, 0);
      if (proved_far(outer)) return Sign::positive;
      if (core_.size() != 2) break;
      const Plain a = plain(core_[0]), e = plain(core_[1]) - a;
      const double square = core::dot(e, e), s = core::dot(inner.at - a, e) / square;
      p = a + e * (!(s > 0) ? 0 : s < 1 ? s : 1);
    }
    return {};
  }

 private:
  static Running height(const Side& side, const Vertex& v) {
    return core::dot(exactly(side.normal), v) - Running(side.offset);
  }
  [[nodiscard]] bool holds(const Vertex& v) const {
    for (const Side& side : sides_) {
      if (!(height(side, v).upper() <= 0)) return false;
    }
    return true;
  }
  [[nodiscard]] bool proved_near(const Plain& at) const {
    const Vertex q = exactly(at);
    if (!holds(q)) return false;
    const std::array<Vertex, 1> point{q};
    return quick_gap(core_, point, radius_.value, 0) == Sign::negative;
  }
  /// Is every height, of vertices over a halfspace with this normal, more than the radius?
  template <class Height>
  [[nodiscard]] bool proved_beyond(Height height, const Vertex& normal) const {
    const Running reach = radius_ * radius_ * core::dot(normal, normal);
    for (const Vertex& v : core_) {
      const Running h = height(v);
      if (!(h.lower() > 0)) return false;
      const Unsure<Sign> s = (h * h - reach).sign();
      if (!s.certain() || s.value() != Sign::positive) return false;
    }
    return true;
  }
  /// The halfspace that the sides imply with these weights.
  [[nodiscard]] bool proved_far(const Foot& f) const {
    Vertex normal;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (f.back[i] > 0) normal = normal + exactly(sides_[i].normal) * Running(f.back[i]);
    }
    return proved_beyond(
        [&](const Vertex& v) {
          Running h;
          for (std::size_t i = 0; i < sides_.size(); ++i) {
            if (f.back[i] > 0) h = h + height(sides_[i], v) * Running(f.back[i]);
          }
          return h;
        },
        normal);
  }

  std::span<const Side> sides_;
  std::span<const Vertex> core_;
  Running radius_;
};

template <class Round, class Set>
Relation relate_halfspaces(const Round& a, const Set& b) {
  require_shapes_of("relate", a, b);
  const std::vector<Side> sides = sides_of(b);
  const auto core = vertices(a);
  if (const auto gap = Search(sides, core, a.radius).run()) return static_cast<Relation>(-*gap);
  return relate_swept(core_set(a), a.radius, flat_set(b));
}

}  // namespace
}  // namespace query

using query::relate_halfspaces;

Relation relate(const Sphere3& a, const KDop3& b) { return relate_halfspaces(a, b); }
Relation relate(const Sphere3& a, const HalfspaceIntersection3& b) { return relate_halfspaces(a, b); }
Relation relate(const Capsule3& a, const KDop3& b) { return relate_halfspaces(a, b); }
Relation relate(const Capsule3& a, const HalfspaceIntersection3& b) { return relate_halfspaces(a, b); }
Relation relate(const Lozenge3& a, const KDop3& b) { return relate_halfspaces(a, b); }
Relation relate(const Lozenge3& a, const HalfspaceIntersection3& b) { return relate_halfspaces(a, b); }

}  // namespace plumb
