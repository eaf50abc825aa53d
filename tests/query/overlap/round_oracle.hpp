// How far apart are two convex sets, by brute force over rationals, and what relation does that make of round shapes?
//
// The nearest point of a set to the origin is that of the affine hull of some independent generators of it
// (Caratheodory): of few of them, all sets of one, two and three are tried; a point that no generator is nearer along
// is the nearest of the whole set, otherwise one that is joins the few.  A set that holds the origin is found by a
// linear program.
// Laws: exact, and each distance proved by all generators.
// Cost: some 0.1 ms.
#pragma once

#include <cmath>
#include <optional>

#include "query/overlap/all_pairs.hpp"

namespace plumb::oracle {

inline RationalPoint sum(const RationalPoint& a, const mpq_class& times, const RationalPoint& b) {
  return {mpq_class(a[0] + times * b[0]), mpq_class(a[1] + times * b[1]), mpq_class(a[2] + times * b[2])};
}
inline RationalPoint times_rational(const RationalPoint& v, const mpq_class& times) {
  return {mpq_class(v[0] * times), mpq_class(v[1] * times), mpq_class(v[2] * times)};
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

/// The corners of an intersection and the directions that it goes on in: where three of the sides meet, and along two
/// of them, within all.  Where it holds lines, it is cut across them first.
inline Spanned spanned(const HalfspaceIntersection3& s) {
  using polygon_detail::cross, polygon_detail::is_zero;
  struct Side {
    RationalPoint normal;
    mpq_class offset;
  };
  std::vector<Side> sides;
  for (const Halfspace3& h : s.halfspaces) sides.push_back({rational(h.normal), h.offset});
  Spanned all;
  const std::array<RationalPoint, 3> units{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto along_all = [&](const RationalPoint& d) {
    return !is_zero(d) && std::ranges::all_of(sides, [&](const Side& h) { return dot(h.normal, d) == 0; });
  };
  const auto cut = [&](const RationalPoint& d) {
    if (!along_all(d)) return;
    all.directions.push_back(d), all.directions.push_back(opposite(d));
    sides.push_back({d, 0}), sides.push_back({opposite(d), 0});
  };
  for (const RationalPoint& u : units) cut(u);
  for (std::size_t i = 0; i < sides.size(); ++i) {  // with the new ones
    for (const RationalPoint& u : units) cut(cross(sides[i].normal, u));
    for (std::size_t j = 0; j < i; ++j) cut(cross(sides[i].normal, sides[j].normal));
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const RationalPoint edge = cross(sides[i].normal, sides[j].normal);
      for (const RationalPoint& d : {edge, opposite(edge)}) {
        const auto goes_on = [&](const Side& h) { return dot(h.normal, d) <= 0; };
        if (!is_zero(d) && std::ranges::all_of(sides, goes_on)) all.directions.push_back(d);
      }
      for (std::size_t k = j + 1; k < sides.size(); ++k) {
        const mpq_class whole = dot(edge, sides[k].normal);
        if (sgn(whole) == 0) continue;
        RationalPoint p = times_rational(edge, sides[k].offset / whole);
        p = sum(p, sides[i].offset / whole, cross(sides[j].normal, sides[k].normal));
        p = sum(p, sides[j].offset / whole, cross(sides[k].normal, sides[i].normal));
        const auto within = [&](const Side& h) { return dot(h.normal, p) <= h.offset; };
        if (std::ranges::all_of(sides, within)) all.points.push_back(p);
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
inline HalfspaceIntersection3 sides_of(const HalfspaceIntersection2& flat) {
  HalfspaceIntersection3 s{{{{0, 0, 1}, 0}, {{0, 0, -1}, 0}}};
  for (const auto& [n, offset] : flat.halfspaces) s.halfspaces.push_back({{n.x, n.y, 0}, offset});
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
      for (const RationalPoint& q : b.points) generators_.push_back({difference(p, q), true});
    }
    if (generators_.empty()) return;
    for (const RationalPoint& d : a.directions) generators_.push_back({d, false});
    for (const RationalPoint& d : b.directions) generators_.push_back({opposite(d), false});
    meet_ = relation(a, b) != Relation::disjoint;
  }

  std::optional<mpq_class> square() {
    if (generators_.empty()) return {};
    if (meet_) return mpq_class(0);
    std::vector<Generator> few{generators_[0]};
    while (true) {
      const Nearest nearest = nearest_of(few);
      const mpq_class square = dot(nearest.place, nearest.place);
      const auto nearer = std::ranges::find_if(generators_, [&](const Generator& g) {
        return dot(nearest.place, g.at) < (g.is_point ? square : mpq_class(0));
      });
      if (nearer == generators_.end()) return square;
      few = nearest.of;
      few.push_back(*nearer);
    }
  }

 private:
  struct Generator {
    RationalPoint at;
    bool is_point;
  };
  struct Nearest {
    RationalPoint place;
    std::vector<Generator> of;
  };

  /// Of all that few generators span, by trying all of one, two and three of them; not for what holds the origin.
  static Nearest nearest_of(const std::vector<Generator>& few) {
    std::optional<Nearest> best;
    const auto offer = [&best](const RationalPoint& x, std::vector<Generator> of) {
      if (!best || dot(x, x) < dot(best->place, best->place)) best = {x, std::move(of)};
    };
    for (const Generator& p : few) {
      if (!p.is_point) continue;
      offer(p.at, {p});
      for (std::size_t i = 0; i < few.size(); ++i) {
        const RationalPoint u = few[i].is_point ? difference(few[i].at, p.at) : few[i].at;
        const mpq_class uu = dot(u, u), pu = dot(p.at, u);
        if (sgn(uu) == 0) continue;
        if (const mpq_class t = -pu / uu; sgn(t) >= 0 && (t <= 1 || !few[i].is_point))
          offer(sum(p.at, t, u), {p, few[i]});
        for (std::size_t j = i + 1; j < few.size(); ++j) {
          const RationalPoint v = few[j].is_point ? difference(few[j].at, p.at) : few[j].at;
          const mpq_class uv = dot(u, v), vv = dot(v, v), pv = dot(p.at, v), whole = uu * vv - uv * uv;
          if (sgn(whole) == 0) continue;
          const mpq_class s = (uv * pv - vv * pu) / whole, t = (uv * pu - uu * pv) / whole;
          const mpq_class used = (few[i].is_point ? s : mpq_class(0)) + (few[j].is_point ? t : mpq_class(0));
          if (sgn(s) >= 0 && sgn(t) >= 0 && used <= 1) offer(sum(sum(p.at, s, u), t, v), {p, few[i], few[j]});
        }
      }
    }
    return *best;
  }

  std::vector<Generator> generators_;
  bool meet_ = false;
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

/// How often a figure just touches what is not a core.
struct RoundAnswers {
  pair_cases::AnswersByKind of_kind{};
  int just_touching = 0;
};

template <class A, class B>
void expect_relation(const A& a, const B& b, Relation expected, const std::string& about) {
  EXPECT_EQ(relate(a, b), expected) << about;
  EXPECT_EQ(relate(b, a), expected) << about;
  EXPECT_EQ(intersects(a, b), expected != Relation::disjoint) << about;
  EXPECT_EQ(intersects(b, a), expected != Relation::disjoint) << about;
}

}  // namespace plumb

namespace plumb::pair_cases {

using RoundKinds = Types<Circle2, Capsule2, Sphere3, Capsule3, Lozenge3>;

inline oracle::Spanned core_of(const AnyFigure& round) {
  return on_kind<oracle::Spanned>(RoundKinds{}, round, [](const auto& s) { return oracle::core(s); });
}
inline double radius_of(const AnyFigure& round) {
  return on_kind<double>(RoundKinds{}, round, [](const auto& s) { return s.radius; });
}
inline AnyFigure with_radius(const AnyFigure& round, double radius) {
  return on_kind<AnyFigure>(RoundKinds{}, round, [&]<class Shape>(const Shape& s) {
    auto* changed = new Shape(s);
    changed->radius = radius;
    return AnyFigure(round.row(), changed);
  });
}
template <class All>
oracle::Pieces pieces_of(All all, const AnyFigure& flat) {
  return on_kind<oracle::Pieces>(all, flat, []<class Shape>(const Shape& s) -> oracle::Pieces {
    if constexpr (query::FlatFigure<Shape>) {
      return oracle::pieces(s);
    } else {
      throw std::logic_error("brute force has no pieces of a round figure");
    }
  });
}

/// On random figures, the second of which is round; two times of three with the radius that makes them touch, where a
/// double is it.  The pair is asked as it stands in the table.
template <class All>
Answers expect_as_brute_force(All all, const PairRow& pair, std::uint64_t start, std::uint64_t cases,
                              int& just_touching) {
  Answers answers;
  const bool round_first = has_core(pair.a->kind);
  const FigureRow &of_flat = round_first ? *pair.b : *pair.a, &of_round = round_first ? *pair.a : *pair.b;
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const AnyFigure flat = near_figure(of_flat, m);
    AnyFigure round = figure(of_round, m);
    const oracle::RoundOracle expected(core_of(round), pieces_of(all, flat));
    if (expected.square() && m.below(3) != 0) {
      if (const auto root = oracle::exact_root(*expected.square())) round = with_radius(round, *root);
    }
    const Relation answer = expected.relation(mpq_class(radius_of(round)));
    answers.add(answer);
    if (radius_of(round) > 0 && answer == Relation::touching) ++just_touching;
    expect_relation(pair, round_first ? round : flat, round_first ? flat : round, answer, m);
  });
  return answers;
}

/// Two round figures, likewise.
inline Answers expect_round_as_brute_force(const PairRow& pair, std::uint64_t start, std::uint64_t cases) {
  Answers answers;
  shape_cases::on_shapes(start, cases, [&](Material& m) {
    const AnyFigure a = figure(*pair.a, m);
    AnyFigure b = figure(*pair.b, m);
    const oracle::RoundOracle expected(core_of(a), {{core_of(b)}, {}});
    if (const auto root = oracle::exact_root(*expected.square()); root && m.below(2) == 0) {
      const double rest = *root - radius_of(a);
      if (rest >= 0) b = with_radius(b, rest);
    }
    const Relation answer = expected.relation(mpq_class(radius_of(a)) + mpq_class(radius_of(b)));
    answers.add(answer);
    expect_relation(pair, a, b, answer, m);
  });
  return answers;
}

/// All pairs with a core.
template <class All>
void expect_all_round(All all, std::uint64_t start) {
  RoundAnswers answers;
  for (const PairRow& pair : pairs_of(all)) {
    const FigureKind a = pair.a->kind, b = pair.b->kind;
    if (oracle_of(a, b) != PairOracle::core) continue;
    const std::uint64_t some = cases_by_brute_force(a, b);
    add_to_kinds(answers.of_kind, a, b,
                 has_core(a) && has_core(b) ? expect_round_as_brute_force(pair, start, some)
                                            : expect_as_brute_force(all, pair, start, some, answers.just_touching));
    ++start;
  }
  std::printf("%d touch by a radius above zero\n", answers.just_touching);
  if (!battery::reaches_rare) return;
  expect_every_answer(answers.of_kind);
  EXPECT_GE(static_cast<std::uint64_t>(answers.just_touching), cases_of_pair * shape_cases::more);
}

}  // namespace plumb::pair_cases
