// Two convex sets are disjoint where a plane leaves a gap between them, and their relative interiors are where a plane
// has one on either side without holding both: linear programs in the plane's normal and offset.
#include "arith/rational_lp.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {
namespace {

using arith::Constraints, arith::RationalVector;

/// normal . x <= offset on a, >= on b.
class Separation {
 public:
  Separation(const FlatSet& a, const FlatSet& b) : slack_(4) {
    add(a, 1);
    add(b, -1);
  }

  /// All points on their sides with a gap; directions and lines need none.
  [[nodiscard]] bool has_gap() const { return arith::feasible(rows_, is_point_).slack > 0; }

  /// Not everything lies in the plane.
  [[nodiscard]] bool is_proper() const {
    arith::Constraints all = rows_;
    all.add(slack_, -1);
    return arith::feasible(all, std::vector<bool>(all.rows.size(), false)).slack >= 0;
  }

 private:
  void add(const FlatSet& s, int side) {
    for (const Exact3& p : s.points) add_row(p, -side, side, true);
    for (const Exact3& d : s.directions) add_row(d, 0, side, false);
    for (const Exact3& l : s.lines) {
      add_row(l, 0, 1, false);
      add_row(l, 0, -1, false);
    }
  }
  void add_row(const Exact3& v, int weight, int side, bool is_point) {
    arith::RationalVector row{mpq_class(side * v[0]), mpq_class(side * v[1]), mpq_class(side * v[2]),
                              mpq_class(weight)};
    for (std::size_t k = 0; k < 4; ++k) slack_[k] += row[k];
    rows_.add(std::move(row), 0);
    is_point_.push_back(is_point);
  }

  arith::Constraints rows_;
  std::vector<bool> is_point_;
  arith::RationalVector slack_;  // the sum of all rows: lines cancel
};

}  // namespace

Relation relate(const FlatSet& a, const FlatSet& b) {
  if (a.points.empty() || b.points.empty()) return Relation::disjoint;
  const Separation s(a, b);
  if (s.has_gap()) return Relation::disjoint;
  return s.is_proper() ? Relation::touching : Relation::overlapping;
}

bool intersects(const FlatSet& a, const FlatSet& b) {
  return !a.points.empty() && !b.points.empty() && !Separation(a, b).has_gap();
}

}  // namespace plumb::query
