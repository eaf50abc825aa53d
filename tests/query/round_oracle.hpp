// How far apart are two convex sets, by brute force over rationals, and what relation does that make of round shapes?
//
// The nearest point of a set to the origin is that of the affine hull of some independent generators of it
// (Caratheodory): all sets of one, two and three are tried, and a set that holds the origin is found by a linear
// program. Laws: exact.  Cost: cubic in the generators; some milliseconds for a segment and a box.
#pragma once

#include <optional>

#include "query/pair_oracle.hpp"
#include "query/pair_shapes.hpp"
#include "query/relation_counts.hpp"

namespace plumb::oracle {

inline RationalPoint sum(const RationalPoint& a, const mpq_class& times, const RationalPoint& b) {
  return {mpq_class(a[0] + times * b[0]), mpq_class(a[1] + times * b[1]), mpq_class(a[2] + times * b[2])};
}
inline mpq_class dot(const RationalPoint& a, const RationalPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline RationalPoint difference(const RationalPoint& a, const RationalPoint& b) { return sum(a, -1, b); }

inline Spanned spanned_by(const RationalPoint& corner, const std::vector<RationalPoint>& edges) {
  Spanned all{{corner}, {}};
  for (const RationalPoint& e : edges) {
    const std::size_t n = all.points.size();
    for (std::size_t i = 0; i < n; ++i) all.points.push_back(sum(all.points[i], 1, e));
  }
  return all;
}

/// The corners of a bounded intersection: where three of the sides meet, and within all.
inline Spanned spanned(const HalfspaceIntersection3& s) {
  Spanned all;
  const auto& h = s.halfspaces;
  const auto row = [&](std::size_t i) { return rational(h[i].normal); };
  const auto determinant = [](const RationalPoint& a, const RationalPoint& b, const RationalPoint& c) {
    return mpq_class(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]));
  };
  for (std::size_t i = 0; i < h.size(); ++i) {
    for (std::size_t j = i + 1; j < h.size(); ++j) {
      for (std::size_t k = j + 1; k < h.size(); ++k) {
        const std::array<RationalPoint, 3> rows{row(i), row(j), row(k)};
        const mpq_class whole = determinant(rows[0], rows[1], rows[2]);
        if (sgn(whole) == 0) continue;
        RationalPoint p;
        for (std::size_t c = 0; c < 3; ++c) {
          auto with = rows;
          with[0][c] = h[i].offset, with[1][c] = h[j].offset, with[2][c] = h[k].offset;
          p[c] = determinant(with[0], with[1], with[2]) / whole;
        }
        const auto within = [&](const Halfspace3& side) { return dot(rational(side.normal), p) <= side.offset; };
        if (std::ranges::all_of(h, within)) all.points.push_back(p);
      }
    }
  }
  return all;
}
inline HalfspaceIntersection3 sides_of(const KDop3& k_dop) {
  HalfspaceIntersection3 s;
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    const Vector3& d = k_dop.directions.all()[i];
    s.halfspaces.push_back({d, k_dop.max[i]});
    s.halfspaces.push_back({{-d.x, -d.y, -d.z}, -k_dop.min[i]});
  }
  return s;
}
inline HalfspaceIntersection3 sides_of(const KDop2& k_dop) {
  HalfspaceIntersection3 s{{{{0, 0, 1}, 0}, {{0, 0, -1}, 0}}};
  for (std::size_t i = 0; i < k_dop.directions.size(); ++i) {
    const auto [x, y] = k_dop.directions.all()[i];
    s.halfspaces.push_back({{x, y, 0}, k_dop.max[i]});
    s.halfspaces.push_back({{-x, -y, 0}, -k_dop.min[i]});
  }
  return s;
}

/// The relatively open pieces of a figure whose union is its inside, and those of its boundary, given as closed sets.
struct Pieces {
  std::vector<Spanned> inner, boundary;
};
template <class Shape>
Pieces pieces(const Shape& s) {
  if constexpr (std::is_same_v<Shape, HalfspaceIntersection3>) {
    return {{spanned(s)}, {}};
  } else if constexpr (requires { sides_of(s); }) {
    return {{spanned(sides_of(s))}, {}};
  } else if constexpr (std::is_same_v<Shape, Halfspace2>) {
    return {{spanned(Halfspace3{{s.normal.x, s.normal.y, 0}, s.offset})}, {}};
  } else {
    Pieces all;
    const Cells of = cells(s);
    for (const Cell& c : of.inner) all.inner.push_back(std::get<Spanned>(c));
    for (const Cell& c : of.boundary) all.boundary.push_back(std::get<Spanned>(c));
    return all;
  }
}

inline Spanned core(const Sphere3& s) { return {{rational(s.center)}, {}}; }
inline Spanned core(const Capsule3& c) { return {{rational(c.a), rational(c.b)}, {}}; }
inline Spanned core(const Circle2& s) { return {{rational(s.center)}, {}}; }
inline Spanned core(const Capsule2& c) { return {{rational(c.a), rational(c.b)}, {}}; }
inline Spanned core(const Lozenge3& l) {
  return spanned_by(rational(l.corner), {rational(l.edges[0]), rational(l.edges[1])});
}

/// The square of the distance; nothing for an empty set.
class BruteDistance {
 public:
  BruteDistance(const Spanned& a, const Spanned& b) {
    for (const RationalPoint& p : a.points) {
      for (const RationalPoint& q : b.points) add_once(points_, difference(p, q));
    }
    for (const RationalPoint& d : a.directions) add_once(directions_, d);
    for (const RationalPoint& d : b.directions) add_once(directions_, opposite(d));
    meet_ = !a.points.empty() && !b.points.empty() && relation(a, b) != Relation::disjoint;
  }

  std::optional<mpq_class> square() {
    if (points_.empty()) return {};
    if (meet_) return mpq_class(0);
    for (const RationalPoint& p : points_) {
      offer(p);
      for (std::size_t i = 0; i < points_.size() + directions_.size(); ++i) {
        const RationalPoint u = toward(i, p);
        try_line(p, u);
        for (std::size_t j = i + 1; j < points_.size() + directions_.size(); ++j)
          try_plane(p, u, toward(j, p), i < points_.size(), j < points_.size());
      }
    }
    return least_;
  }

 private:
  static void add_once(std::vector<RationalPoint>& all, const RationalPoint& p) {
    if (std::ranges::find(all, p) == all.end()) all.push_back(p);
  }
  [[nodiscard]] RationalPoint toward(std::size_t i, const RationalPoint& p) const {
    return i < points_.size() ? difference(points_[i], p) : directions_[i - points_.size()];
  }
  void offer(const RationalPoint& x) {
    const mpq_class square = dot(x, x);
    if (!least_ || square < *least_) least_ = square;
  }
  // Weights of points add up to one at most: a foot beyond the end of a segment is not of it, but of a ray it is.
  void try_line(const RationalPoint& p, const RationalPoint& u) {
    const mpq_class uu = dot(u, u);
    if (sgn(uu) == 0) return;
    const mpq_class t = -dot(p, u) / uu;
    const bool is_point = std::ranges::find(points_, sum(p, 1, u)) != points_.end();
    if (sgn(t) >= 0 && (t <= 1 || !is_point)) offer(sum(p, t, u));
  }
  void try_plane(const RationalPoint& p, const RationalPoint& u, const RationalPoint& v, bool u_is_point,
                 bool v_is_point) {
    const mpq_class uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), pu = dot(p, u), pv = dot(p, v);
    const mpq_class whole = uu * vv - uv * uv;
    if (sgn(whole) == 0) return;
    const mpq_class s = (uv * pv - vv * pu) / whole, t = (uv * pu - uu * pv) / whole;
    const mpq_class used = (u_is_point ? s : mpq_class(0)) + (v_is_point ? t : mpq_class(0));
    if (sgn(s) >= 0 && sgn(t) >= 0 && used <= 1) offer(sum(sum(p, s, u), t, v));
  }

  std::vector<RationalPoint> points_, directions_;
  bool meet_ = false;
  std::optional<mpq_class> least_;
};

inline std::optional<mpq_class> squared_distance(const Spanned& a, const Spanned& b) {
  return BruteDistance(a, b).square();
}

/// The double whose square this is, where there is one.
inline std::optional<double> exact_root(const mpq_class& square) {
  const double r = std::sqrt(square.get_d());
  if (std::isfinite(r) && mpq_class(r) * mpq_class(r) == square) return r;
  return {};
}

/// A core against the pieces of a figure, for any radius around it.
class RoundOracle {
 public:
  RoundOracle(const Spanned& core, Pieces other) : core_(core), other_(std::move(other)) {
    for (const Spanned& piece : other_.inner) lower(inner_, squared_distance(core_, piece));
    least_ = inner_;
    for (const Spanned& piece : other_.boundary) lower(least_, squared_distance(core_, piece));
  }

  /// Of the least distance.
  [[nodiscard]] const std::optional<mpq_class>& square() const { return least_; }

  [[nodiscard]] Relation relation(const mpq_class& reach) const {
    if (sgn(reach) == 0) {
      const Cells core{{core_}, {}},
          other{{other_.inner.begin(), other_.inner.end()}, {other_.boundary.begin(), other_.boundary.end()}};
      return oracle::relation(core, other);
    }
    const mpq_class limit = reach * reach;
    if (inner_ && *inner_ < limit) return Relation::overlapping;
    return least_ && *least_ <= limit ? Relation::touching : Relation::disjoint;
  }

 private:
  static void lower(std::optional<mpq_class>& least, const std::optional<mpq_class>& square) {
    if (square && (!least || *square < *least)) least = square;
  }

  Spanned core_;
  Pieces other_;
  std::optional<mpq_class> inner_, least_;
};

}  // namespace plumb::oracle

namespace plumb {

/// relate and intersects, both ways round, on random figures; two times of three with the radius that makes them touch,
/// where a double is it.
template <class Flat, class Round>
void expect_as_brute_force(std::uint64_t start, std::uint64_t cases) {
  Counts counts;
  int just_touching = 0;
  shape_cases::on_shapes(start, cases, [&](shape_cases::Material& m) {
    const Flat flat = pair_cases::near_figure<Flat>(m);
    auto round = m.shape<Round>();
    const oracle::RoundOracle expected(oracle::core(round), oracle::pieces(flat));
    if (expected.square() && m.below(3) != 0) {
      if (const auto root = oracle::exact_root(*expected.square())) round.radius = *root;
    }
    const Relation answer = expected.relation(mpq_class(round.radius));
    counts.add(answer);
    if (round.radius > 0 && answer == Relation::touching) ++just_touching;
    const std::string about = m.about(flat, round);
    ASSERT_EQ(relate(flat, round), answer) << about;
    ASSERT_EQ(relate(round, flat), answer) << about;
    ASSERT_EQ(intersects(flat, round), answer != Relation::disjoint) << about;
    ASSERT_EQ(intersects(round, flat), answer != Relation::disjoint) << about;
  });
  std::printf("disjoint %d, touching %d (%d round), overlapping %d\n", counts.of[0], counts.of[1], just_touching,
              counts.of[2]);
  if (cases >= 50) expect_all_answers(counts, cases * shape_cases::more);
}

/// Two round figures, likewise.
template <class A, class B>
void expect_round_as_brute_force(std::uint64_t start, std::uint64_t cases) {
  Counts counts;
  shape_cases::on_shapes(start, cases, [&](shape_cases::Material& m) {
    const auto a = m.shape<A>();
    auto b = m.shape<B>();
    const oracle::RoundOracle expected(oracle::core(a), {{oracle::core(b)}, {}});
    if (const auto root = oracle::exact_root(*expected.square()); root && m.below(2) == 0) {
      const double rest = *root - a.radius;
      if (rest >= 0) b.radius = rest;
    }
    const Relation answer = expected.relation(mpq_class(a.radius) + mpq_class(b.radius));
    counts.add(answer);
    ASSERT_EQ(relate(a, b), answer) << m.about(a, b);
    ASSERT_EQ(relate(b, a), answer) << m.about(a, b);
  });
  std::printf("disjoint %d, touching %d, overlapping %d\n", counts.of[0], counts.of[1], counts.of[2]);
  expect_all_answers(counts, cases * shape_cases::more);
}

}  // namespace plumb
