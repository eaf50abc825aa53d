// Planes as equations, reduced by Gauss and Jordan over rationals.
#include "plumb/query/section/planes.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "arith/exact_number.hpp"
#include "certify/exact_coordinates.hpp"
#include "plumb/query/section/posed.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/posed_set.hpp"
#include "query/convex/round_parts.hpp"

namespace plumb::query {
namespace {

using Row = std::array<mpq_class, 4>;  // coefficients, and the right side
using Equations = std::vector<Row>;

void require_plane(std::string_view name, const AnyPlane3& plane) {
  std::visit([&](const auto& s) { require_figure("intersection", name, s); }, plane);
}

Row through(const Exact3& normal, const Exact3& p) { return {normal[0], normal[1], normal[2], dot(normal, p)}; }
Exact3 unit(std::size_t axis) {
  Exact3 e;
  e[axis] = 1;
  return e;
}

/// The equations of p and all that the lines span there: one of a plane, more of less, none of all.
Equations equations(const Exact3& p, std::span<const Exact3> lines) {
  Exact3 along{}, normal{};
  for (const Exact3& line : lines) {
    if (is_zero(along)) {
      along = line;
    } else if (is_zero(normal)) {
      normal = cross(along, line);
    } else if (sgn(through(normal, line)[3]) != 0) {
      return {};
    }
  }
  if (!is_zero(normal)) return {through(normal, p)};
  Equations rows;
  for (std::size_t axis = 0; axis < 3; ++axis)
    rows.push_back(through(is_zero(along) ? unit(axis) : cross(along, unit(axis)), p));
  return rows;
}
Equations equations(const AnyPlane3& plane) {
  if (const auto* p = std::get_if<Plane3>(&plane)) {
    return {{p->normal.x, p->normal.y, p->normal.z, p->offset}};
  }
  const auto& t = std::get<ThreePointPlane3>(plane);
  const Exact3 a = exact3(t.a);
  return equations(a, std::array{exact3(t.b) - a, exact3(t.c) - a});
}

struct Reduced {
  std::vector<std::size_t> pivots;  // the column of each row's leading one
  Equations rows;
  bool consistent = true;
};

Reduced reduced(Equations rows) {
  Reduced r;
  for (std::size_t column = 0; column < 3; ++column) {
    const std::size_t rank = r.pivots.size();
    std::size_t from = rank;
    while (from < rows.size() && sgn(rows[from][column]) == 0) ++from;
    if (from == rows.size()) continue;
    std::swap(rows[from], rows[rank]);
    const mpq_class lead = rows[rank][column];
    for (mpq_class& x : rows[rank]) x /= lead;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == rank || sgn(rows[i][column]) == 0) continue;
      const mpq_class factor = rows[i][column];
      for (std::size_t k = 0; k < 4; ++k) rows[i][k] -= factor * rows[rank][k];
    }
    r.pivots.push_back(column);
  }
  for (std::size_t i = r.pivots.size(); i < rows.size(); ++i) r.consistent = r.consistent && sgn(rows[i][3]) == 0;
  rows.resize(r.pivots.size());
  r.rows = std::move(rows);
  return r;
}

FlatIntersection solution(const Reduced& r) {
  FlatIntersection flat;
  if (!r.consistent) return flat;
  flat.kind = static_cast<FlatKind>(3 - static_cast<int>(r.pivots.size()));
  Exact3 at;
  for (std::size_t i = 0; i < r.pivots.size(); ++i) at[r.pivots[i]] = r.rows[i][3];
  flat.point = RationalPoint3{exact_number(at[0]), exact_number(at[1]), exact_number(at[2])};
  for (std::size_t free = 0; free < 3; ++free) {
    if (std::find(r.pivots.begin(), r.pivots.end(), free) != r.pivots.end()) continue;
    Exact3 d = unit(free);
    for (std::size_t i = 0; i < r.pivots.size(); ++i) d[r.pivots[i]] = -r.rows[i][free];
    flat.directions.push_back({exact_number(d[0]), exact_number(d[1]), exact_number(d[2])});
  }
  return flat;
}

std::size_t rank_of(Equations rows) { return reduced(std::move(rows)).pivots.size(); }
Row normal_of(Row row) {
  row[3] = 0;
  return row;
}
bool parallel(const Row& a, const Row& b) { return rank_of({normal_of(a), normal_of(b)}) < 2; }
bool same(const Row& a, const Row& b) {
  const Reduced r = reduced({a, b});
  return r.consistent && r.pivots.size() < 2;
}

/// One row: a plane, unless it has no normal.
bool is_plane(const Equations& rows) {
  return rows.size() == 1 && (sgn(rows[0][0]) != 0 || sgn(rows[0][1]) != 0 || sgn(rows[0][2]) != 0);
}

std::array<Point3, 3> corners(const AnyPlane3& plane) {
  const auto& t = std::get<ThreePointPlane3>(plane);
  return {t.a, t.b, t.c};
}

Equations equations_of_image(const PosedView& plane) {
  const FlatSet s = image(posed_set(plane));
  if (s.points.empty()) return {{0, 0, 0, 1}};
  return equations(s.points[0], s.lines);
}

}  // namespace

FlatIntersection posed_planes(const PosedView& a, const PosedView& b) {
  require_posed("intersection", a, b);
  Equations rows = equations_of_image(a);
  for (Row& row : equations_of_image(b)) rows.push_back(std::move(row));
  return solution(reduced(std::move(rows)));
}

}  // namespace plumb::query

namespace plumb {

Vector3 approximate(const ExactVector3& a) {
  const Point3 p = approximate(ExactPoint3(RationalPoint3{a.x, a.y, a.z}));
  return {p.x, p.y, p.z};
}

FlatIntersection intersection(const AnyPlane3& a, const AnyPlane3& b) {
  using namespace query;
  std::visit([](const auto& p, const auto& q) { require_figures("intersection", p, q); }, a, b);
  Equations rows = equations(a);
  for (Row& row : equations(b)) rows.push_back(std::move(row));
  return solution(reduced(std::move(rows)));
}

ThreePlanes intersection(const AnyPlane3& a, const AnyPlane3& b, const AnyPlane3& c) {
  using namespace query;
  require_plane("a", a);
  require_plane("b", b);
  require_plane("c", c);
  const std::array<Equations, 3> each{equations(a), equations(b), equations(c)};
  Equations all;
  for (const Equations& rows : each) all.insert(all.end(), rows.begin(), rows.end());
  const Reduced r = reduced(all);
  ThreePlanes result{PlaneArrangement::degenerate, 3, solution(r)};
  if (!is_plane(each[0]) || !is_plane(each[1]) || !is_plane(each[2])) return result;
  const Row &p = all[0], &q = all[1], &s = all[2];
  const bool pq = same(p, q), ps = same(p, s), qs = same(q, s);
  result.distinct = pq && ps ? 1 : pq || ps || qs ? 2 : 3;
  switch (r.pivots.size()) {
    case 3:
      result.arrangement = PlaneArrangement::point;
      if (a.index() == 1 && b.index() == 1 && c.index() == 1)
        result.common.point = ThreePlanePoint3{corners(a), corners(b), corners(c)};
      break;
    case 2:
      result.arrangement = r.consistent                                         ? PlaneArrangement::line
                           : parallel(p, q) || parallel(p, s) || parallel(q, s) ? PlaneArrangement::two_parallel
                                                                                : PlaneArrangement::prism;
      break;
    default:
      result.arrangement = PlaneArrangement::parallel;
  }
  return result;
}

}  // namespace plumb
