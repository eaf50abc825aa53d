// Balls, capsules and lozenges against k-DOPs and other intersections of halfspaces.
#include <cmath>

#include "query/body/figure_input.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/round_vertices.hpp"
#include "query/convex/search.hpp"
#include "query/overlap/pair_answer.hpp"

namespace plumb {
namespace query {
namespace {

using arith::Plain;

/// Guesses, of which what they are of is proved: how much of the size a search still moves when it ends, and by how much
/// of the radius a point is sought within the sides.
inline constexpr double settled_guess = 0x1p-45, inner_guess = 0x1p-24;

/// normal . x <= offset.
struct Side {
  Side(const Plain& n, double at_most) : normal(n), offset(at_most), length(std::sqrt(arith::dot(n, n))) {}
  Plain normal;
  double offset, length;
};

std::vector<Side> sides_of(const KDop3& k_dop) {
  std::vector<Side> sides;
  sides.reserve(2 * k_dop.directions.size());
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    const Vector3& d = k_dop.directions.all()[i];
    sides.emplace_back(Plain{d.x, d.y, d.z}, k_dop.max[i]);
    sides.emplace_back(Plain{-d.x, -d.y, -d.z}, -k_dop.min[i]);
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
/// along each side's normal it lies: what proves that p is outside.  Goes on from where it was.
struct Foot {
  Plain at;
  std::vector<double> back;

  void approach(std::span<const Side> sides, const Plain& p, double margin, int most_rounds) {
    at = p;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (back[i] > 0) at = at - sides[i].normal * back[i];
    }
    const double size = magnitude_of(p.x) + magnitude_of(p.y) + magnitude_of(p.z);
    for (int round = 0; round < most_rounds; ++round) {
      double change = 0;
      for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto& [n, offset, length] = sides[i];
        const double beyond = (arith::dot(n, at) - offset + margin * length) / (length * length);
        const double step = beyond > -back[i] ? beyond : -back[i];
        if (step == 0) continue;
        back[i] += step;
        at = at - n * step;
        change = std::fmax(change, magnitude_of(step) * length);
      }
      if (change <= settled_guess * (size + margin)) break;
    }
  }
};

/// The nearest point of a core, nearly: of a point, a segment, or a parallelogram by turns of its two edges.
Plain nearest_of_core(std::span<const Vertex> core, const Plain& q) {
  constexpr int most_rounds = 16;
  const Plain corner = plain(core[0]);
  if (core.size() == 1) return corner;
  Plain at = corner;
  std::array<double, 2> part{};
  for (int round = 0; round < (core.size() == 2 ? 1 : most_rounds); ++round) {
    for (std::size_t k = 0; k < core.size() / 2; ++k) {
      const Plain e = plain(core[k + 1]) - corner;
      const double square = arith::dot(e, e);
      const double t = square > 0 ? part[k] + arith::dot(q - at, e) / square : 0;
      const double next = !(t > 0) ? 0 : t < 1 ? t : 1;
      at = at + e * (next - part[k]);
      part[k] = next;
    }
  }
  return at;
}

class HalfspaceSearch {
 public:
  HalfspaceSearch(std::span<const Side> sides, const FigureView& round, std::span<const Vertex> core, double radius)
      : sides_(sides), round_(round), core_(core), radius_(radius) {}

  std::optional<Sign> run() const {
    constexpr int most_rounds = 48, most_at_once = 12;
    const double radius = radius_.value, margin = radius * inner_guess;
    for (const Side& side : sides_) {
      if (!(side.length > 0)) return {};
      if (proved_beyond([&](const Vertex& v) { return height(side, v); }, arith::vec<Running>(side.normal)))
        return Sign::positive;
    }
    for (const Vertex& v : core_) {
      if (radius > 0 && holds(v)) return Sign::negative;
    }
    Plain p{0, 0, 0};
    for (const Vertex& v : core_) p = p + plain(v) * (1 / static_cast<double>(core_.size()));
    Foot inner{p, std::vector<double>(sides_.size())}, outer = inner;
    for (int round = 0; round < most_rounds; ++round) {
      inner.approach(sides_, p, margin, most_at_once);
      const Plain way = inner.at - p;
      if (arith::dot(way, way) < radius * radius && proved_near(inner.at)) return Sign::negative;
      outer.approach(sides_, p, 0, most_at_once);
      if (proved_far(outer)) return Sign::positive;
      p = nearest_of_core(core_, inner.at);
    }
    return {};
  }

 private:
  static Running height(const Side& side, const Vertex& v) {
    return arith::dot(arith::vec<Running>(side.normal), v) - Running(side.offset);
  }
  [[nodiscard]] bool holds(const Vertex& v) const {
    for (const Side& side : sides_) {
      if (!(height(side, v).upper() <= 0)) return false;
    }
    return true;
  }
  [[nodiscard]] bool proved_near(const Plain& at) const {
    if (!holds(arith::vec<Running>(at))) return false;
    const Point3 place{at.x, at.y, at.z};
    return relate_by_search({view_of(place)}, {round_}) == Relation::overlapping;
  }
  /// Is every height, of vertices over a halfspace with this normal, more than the radius?
  template <class Height>
  [[nodiscard]] bool proved_beyond(Height height, const Vertex& normal) const {
    const Running reach = radius_ * radius_ * arith::dot(normal, normal);
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
      if (f.back[i] > 0) normal = normal + arith::vec<Running>(sides_[i].normal) * Running(f.back[i]);
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
  FigureView round_;
  std::span<const Vertex> core_;
  Running radius_;
};

template <class Round, class Set>
Relation relate_halfspaces(const Round& a, const Set& b, Question question) {
  require_figures(question, a, b);
  const std::vector<Side> sides = sides_of(b);
  const auto core = vertices(a);
  if (const auto gap = HalfspaceSearch(sides, view_of(a), core, a.radius).run()) return static_cast<Relation>(-*gap);
  return relate_swept(core_of(a), a.radius, flat_set(b));
}

}  // namespace

PLUMB_PAIR_ANSWERS_TO(KDop3, relate_halfspaces, Sphere3, Capsule3, Lozenge3)
PLUMB_PAIR_ANSWERS_TO(HalfspaceIntersection3, relate_halfspaces, Sphere3, Capsule3, Lozenge3)

}  // namespace query
}  // namespace plumb
