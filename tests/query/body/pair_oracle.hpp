// How do any two figures with straight edges lie to one another, by brute force in rationals?
//
// Each is a union of cells, relatively open convex sets, and of those that only belong to its boundary: a convex figure
// is one cell, a polygon is cut into trapezoids and walls at every vertex and crossing (query/overlap/polygon_cells.hpp).  Two
// cells are asked by one linear program for the largest slack that all weights and halfspaces can have at once.
// Laws: exact, and written from the structs' comments.
// Cost: some 50 us to many milliseconds.
#pragma once

#include <variant>

#include "query/overlap/polygon_cells.hpp"

namespace plumb::oracle {

/// normal . x <= offset for all; those that some point of the set has slack of.
struct Bounded {
  std::vector<RationalPoint> normals;
  std::vector<mpq_class> offsets;
  std::vector<bool> slack;

  void add(const RationalPoint& normal, const mpq_class& offset) {
    normals.push_back(normal);
    offsets.push_back(offset);
    slack.push_back(true);
  }
};
using Cell = std::variant<Spanned, Bounded>;

/// The largest common slack s <= 1: rows of equations over columns that are not negative, the last of them s.
class CommonSlack {
 public:
  std::size_t add_row(const mpq_class& right) {
    right_.push_back(right);
    return right_.size() - 1;
  }
  struct Entry {
    std::size_t row;
    mpq_class value;
  };
  void add_column(const std::vector<Entry>& entries, bool has_slack) {
    columns_.emplace_back(right_.size());
    for (const auto& [row, value] : entries) columns_.back()[row] = value;
    if (!has_slack) return;
    slack_.resize(right_.size());
    for (const auto& [row, value] : entries) slack_[row] += value;
  }
  void add_free(const std::vector<Entry>& entries) {
    std::vector<Entry> opposite = entries;
    for (Entry& e : opposite) e.value = -e.value;
    add_column(entries, false);
    add_column(opposite, false);
  }

  Relation relation() {
    const std::size_t last = add_row(1);  // s + rest = 1
    for (auto& c : columns_) c.resize(right_.size());
    add_column({{last, 1}}, false);
    slack_.resize(right_.size());
    slack_[last] = 1;
    columns_.push_back(slack_);
    s_ = columns_.size() - 1;
    for (std::size_t r = 0; r < right_.size(); ++r) {
      if (sgn(right_[r]) < 0) {
        right_[r] = -right_[r];
        for (auto& c : columns_) c[r] = -c[r];
      }
      basis_.push_back(s_ + 1 + r);  // artificial
    }
    while (step()) {
    }
    mpq_class s = 0;
    for (std::size_t r = 0; r < right_.size(); ++r) {
      if (basis_[r] > s_ && sgn(right_[r]) != 0) return Relation::disjoint;
      if (basis_[r] == s_) s = right_[r];
    }
    return sgn(s) > 0 ? Relation::overlapping : Relation::touching;
  }

 private:
  [[nodiscard]] bool improves(std::size_t j) const {
    mpq_class artificial = 0, slack = j == s_ ? 1 : 0;
    for (std::size_t r = 0; r < right_.size(); ++r) {
      if (basis_[r] > s_) artificial += columns_[j][r];
      if (basis_[r] == s_) slack -= columns_[j][r];
    }
    return sgn(artificial) > 0 || (sgn(artificial) == 0 && sgn(slack) > 0);
  }
  bool step() {
    std::size_t in = 0;
    while (in <= s_ && (std::ranges::find(basis_, in) != basis_.end() || !improves(in))) ++in;
    if (in > s_) return false;
    std::size_t out = right_.size();
    mpq_class least;
    for (std::size_t r = 0; r < right_.size(); ++r) {
      if (basis_[r] > s_ && sgn(right_[r]) == 0 && sgn(columns_[in][r]) != 0) {
        out = r;  // an artificial column at zero leaves before all others
        break;
      }
      if (sgn(columns_[in][r]) <= 0) continue;
      const mpq_class ratio = right_[r] / columns_[in][r];
      const int order = out == right_.size() ? -1 : cmp(ratio, least);
      if (order < 0 || (order == 0 && basis_[r] < basis_[out])) out = r, least = ratio;
    }
    if (out == right_.size()) return false;
    const std::vector<mpq_class> pivot = columns_[in];
    for (auto& c : columns_) eliminate(c, pivot, out);
    eliminate(right_, pivot, out);
    basis_[out] = in;
    return true;
  }
  static void eliminate(std::vector<mpq_class>& c, const std::vector<mpq_class>& pivot, std::size_t row) {
    if (sgn(c[row]) == 0) return;
    c[row] /= pivot[row];
    for (std::size_t r = 0; r < c.size(); ++r) {
      if (r != row && sgn(pivot[r]) != 0) c[r] -= pivot[r] * c[row];
    }
  }

  std::vector<std::vector<mpq_class>> columns_;
  std::vector<mpq_class> right_, slack_;
  std::vector<std::size_t> basis_;
  std::size_t s_ = 0;
};

/// Equations that x = (row 0, 1, 2 of `x`) is in the cell; `x` is left out where nothing else speaks of it.
inline void add_cell(CommonSlack& program, const std::array<std::vector<CommonSlack::Entry>*, 3>& x, const Cell& cell,
                     std::vector<std::pair<std::vector<CommonSlack::Entry>, bool>>& columns) {
  if (const auto* set = std::get_if<Spanned>(&cell)) {
    std::array<std::size_t, 3> row{};
    for (std::size_t k = 0; k < 3; ++k) {
      row[k] = program.add_row(0);
      x[k]->push_back({row[k], -1});
    }
    const std::size_t one = program.add_row(1);
    for (const auto& p : set->points)
      columns.push_back({{{row[0], p[0]}, {row[1], p[1]}, {row[2], p[2]}, {one, 1}}, true});
    for (const auto& d : set->directions) columns.push_back({{{row[0], d[0]}, {row[1], d[1]}, {row[2], d[2]}}, true});
    return;
  }
  const auto& [normals, offsets, slack] = std::get<Bounded>(cell);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const std::size_t row = program.add_row(offsets[i]);
    for (std::size_t k = 0; k < 3; ++k) x[k]->push_back({row, normals[i][k]});
    columns.push_back({{{row, 1}}, slack[i]});
  }
}

inline Relation relation(const Cell& a, const Cell& b) {
  if (std::holds_alternative<Spanned>(a) && std::holds_alternative<Spanned>(b))
    return relation(std::get<Spanned>(a), std::get<Spanned>(b));
  CommonSlack program;
  std::array<std::vector<CommonSlack::Entry>, 3> x;
  std::vector<std::pair<std::vector<CommonSlack::Entry>, bool>> columns;
  add_cell(program, {&x[0], &x[1], &x[2]}, a, columns);
  add_cell(program, {&x[0], &x[1], &x[2]}, b, columns);
  for (const auto& entries : x) program.add_free(entries);
  for (const auto& [entries, has_slack] : columns) program.add_column(entries, has_slack);
  return program.relation();
}

struct Cells {
  std::vector<Cell> inner, boundary;
};

inline Relation relation(const Cells& a, const Cells& b) {
  Relation most = Relation::disjoint;
  const auto ask = [&](const std::vector<Cell>& as, const std::vector<Cell>& bs, Relation at_most) {
    for (const Cell& p : as) {
      for (const Cell& q : bs) {
        if (most < at_most) most = std::max(most, std::min(relation(p, q), at_most));
      }
    }
  };
  ask(a.inner, b.inner, Relation::overlapping);
  ask(a.inner, b.boundary, Relation::touching);
  ask(a.boundary, b.inner, Relation::touching);
  ask(a.boundary, b.boundary, Relation::touching);
  return most;
}

/// Which halfspaces have slack, each asked alone.
inline Cells bounded(Bounded all) {
  const Cell everywhere = Spanned{{{0, 0, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, -1}}};
  std::vector<bool> slack;
  for (std::size_t i = 0; i < all.normals.size(); ++i) {
    all.slack.assign(all.normals.size(), false);
    all.slack[i] = true;
    slack.push_back(relation(Cell(all), everywhere) == Relation::overlapping);
  }
  all.slack = slack;
  return {{all}, {}};
}

inline Spanned corners(const std::vector<RationalPoint>& axes, const RationalPoint& center) {
  Spanned all;
  for (unsigned corner = 0; corner < 1u << axes.size(); ++corner) {
    RationalPoint p = center;
    for (std::size_t i = 0; i < axes.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) p[k] += (corner >> i & 1u) != 0 ? axes[i][k] : mpq_class(-axes[i][k]);
    }
    all.points.push_back(p);
  }
  return all;
}
inline RationalPoint times(double t, RationalPoint v) {
  for (mpq_class& x : v) x *= mpq_class(t);
  return v;
}

template <class Shape>
Cells cells(const Shape& s) {
  if constexpr (requires { s.outer; }) {
    const auto [inner, boundary] = polygon_cells(chains_of(s));
    return {{inner.begin(), inner.end()}, {boundary.begin(), boundary.end()}};
  } else if constexpr (requires { s.vertices; } || std::is_same_v<Shape, Quadrilateral2> ||
                       std::is_same_v<Shape, Quadrilateral3>) {
    const auto [inner, boundary] = polygon_cells(chains_of(s));
    return {{inner.begin(), inner.end()}, {boundary.begin(), boundary.end()}};
  } else if constexpr (requires { s.mesh; }) {
    Spanned all;
    for (const Point3& p : s.mesh.vertices) all.points.push_back(rational(p));
    return {{all}, {}};
  } else if constexpr (
      requires { s.halfspaces; } || requires { s.directions; } || std::is_same_v<Shape, Halfspace2>) {
    Bounded all;
    const auto add = [&all](const auto& normal, double offset) { all.add(rational(normal), mpq_class(offset)); };
    if constexpr (requires { s.halfspaces; }) {
      for (const auto& h : s.halfspaces) add(h.normal, h.offset);
    } else if constexpr (requires { s.directions; }) {
      for (std::size_t i = 0; i < s.min.size(); ++i) {
        add(s.directions.all()[i], s.max[i]);
        all.add(opposite(rational(s.directions.all()[i])), mpq_class(-s.min[i]));
      }
    } else {
      add(s.normal, s.offset);
    }
    if constexpr (std::is_same_v<Shape, Halfspace2> || std::is_same_v<Shape, HalfspaceIntersection2> ||
                  std::is_same_v<Shape, KDop2>) {
      all.add({0, 0, 1}, 0);
      all.add({0, 0, -1}, 0);
    }
    return bounded(all);
  } else if constexpr (std::is_same_v<Shape, Obb2> || std::is_same_v<Shape, Rectangle3>) {
    return {{corners({times(s.half.x, rational(s.axes[0])), times(s.half.y, rational(s.axes[1]))}, rational(s.center))},
            {}};
  } else {
    return {{spanned(s)}, {}};
  }
}

}  // namespace plumb::oracle
