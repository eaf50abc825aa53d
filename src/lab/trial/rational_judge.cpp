#include "lab/trial/rational_judge.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "arith/exact_number.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb::lab::trial {
namespace {

constexpr std::size_t rows = 5;
using Column = std::array<mpq_class, rows>;

/// Has the system of these columns and this right side, which is not negative, a solution that is not negative?  The
/// first phase of the simplex method, of which the artificial columns need not be kept: none comes back.
bool solvable(std::vector<Column> columns, Column right) {
  std::array<bool, rows> artificial{true, true, true, true, true};
  std::array<std::size_t, rows> basis{};
  for (;;) {
    std::size_t enter = columns.size();
    for (std::size_t j = 0; j < columns.size() && enter == columns.size(); ++j) {
      mpq_class gain = 0;
      for (std::size_t r = 0; r < rows; ++r) {
        if (artificial[r]) gain += columns[j][r];
      }
      if (gain > 0) enter = j;
    }
    mpq_class left = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      if (artificial[r]) left += right[r];
    }
    if (left == 0) return true;
    if (enter == columns.size()) return false;
    // Bland's rule: of equal ratios the row of the smallest variable leaves; artificial ones come first.
    std::size_t leave = rows;
    mpq_class least;
    for (std::size_t r = 0; r < rows; ++r) {
      if (columns[enter][r] <= 0) continue;
      const mpq_class ratio = right[r] / columns[enter][r];
      const auto place = [&](std::size_t row) {
        return artificial[row] ? std::pair(0, row) : std::pair(1, basis[row]);
      };
      if (leave == rows || ratio < least || (ratio == least && place(r) < place(leave))) {
        leave = r;
        least = ratio;
      }
    }
    const mpq_class pivot = columns[enter][leave];
    const Column by = columns[enter];
    const auto eliminate = [&](Column& column) {
      column[leave] /= pivot;
      for (std::size_t r = 0; r < rows; ++r) {
        if (r != leave) column[r] -= by[r] * column[leave];
      }
    };
    for (Column& column : columns) eliminate(column);
    eliminate(right);
    artificial[leave] = false;
    basis[leave] = enter;
  }
}

mpq_class square(const RationalVec& v) { return dot(v, v); }

mpq_class within_unit(const mpq_class& x) { return x < 0 ? mpq_class(0) : x > 1 ? mpq_class(1) : x; }

}  // namespace

RationalVec rational_vec(std::span<const double> q, std::size_t i) {
  return {mpq_class(q[3 * i]), mpq_class(q[3 * i + 1]), mpq_class(q[3 * i + 2])};
}

bool meet(const Generated& a, const Generated& b) {
  std::vector<Column> columns;
  for (const RationalVec& p : a.points) columns.push_back({p.x, p.y, p.z, 1, 0});
  for (const RationalVec& d : a.directions) columns.push_back({d.x, d.y, d.z, 0, 0});
  for (const RationalVec& p : b.points) columns.push_back({-p.x, -p.y, -p.z, 0, 1});
  for (const RationalVec& d : b.directions) columns.push_back({-d.x, -d.y, -d.z, 0, 0});
  return solvable(std::move(columns), {0, 0, 0, 1, 1});
}

mpq_class square_distance(const RationalVec& p, const RationalVec& a, const RationalVec& b) {
  const RationalVec d = b - a;
  const mpq_class whole = square(d);
  if (whole == 0) return square(p - a);
  return square(p - (a + d * within_unit(dot(p - a, d) / whole)));
}

mpq_class square_distance(const RationalVec& p, const RationalVec& a, const RationalVec& b, const RationalVec& c) {
  const RationalVec u = b - a, v = c - a, w = p - a, n = cross(u, v);
  const mpq_class whole = square(n);
  if (whole != 0) {
    const mpq_class s = dot(cross(w, v), n), t = dot(cross(u, w), n), height = dot(w, n);
    if (s >= 0 && t >= 0 && s + t <= whole) return height * height / whole;
  }
  return std::min({square_distance(p, a, b), square_distance(p, b, c), square_distance(p, c, a)});
}

mpq_class square_distance_of_segments(const RationalVec& a, const RationalVec& b, const RationalVec& c,
                                      const RationalVec& d) {
  const RationalVec u = b - a, v = d - c, w = c - a, n = cross(u, v);
  const mpq_class whole = square(n);
  if (whole != 0) {
    const mpq_class s = dot(cross(w, v), n), t = dot(cross(w, u), n), height = dot(w, n);
    if (s >= 0 && s <= whole && t >= 0 && t <= whole) return height * height / whole;
  }
  return std::min(
      {square_distance(a, c, d), square_distance(b, c, d), square_distance(c, a, b), square_distance(d, a, b)});
}

mpq_class square_between_hulls(std::span<const RationalVec> a, std::span<const RationalVec> b) {
  if (meet({{a.begin(), a.end()}, {}}, {{b.begin(), b.end()}, {}})) return 0;
  mpq_class least = square_distance_of_segments(a[0], a[0], b[0], b[0]);
  const auto edges = [](std::span<const RationalVec> of, auto f) {  // and points
    for (std::size_t i = 0; i < of.size(); ++i) {
      for (std::size_t j = i; j < of.size(); ++j) f(of[i], of[j]);
    }
  };
  edges(a, [&](const RationalVec& p, const RationalVec& q) {
    edges(b, [&](const RationalVec& r, const RationalVec& s) {
      least = std::min(least, square_distance_of_segments(p, q, r, s));
    });
  });
  const auto to_triangles = [&](std::span<const RationalVec> of, std::span<const RationalVec> from) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      for (std::size_t j = i + 1; j < of.size(); ++j) {
        for (std::size_t k = j + 1; k < of.size(); ++k) {
          for (const RationalVec& p : from) least = std::min(least, square_distance(p, of[i], of[j], of[k]));
        }
      }
    }
  };
  to_triangles(a, b);
  to_triangles(b, a);
  return least;
}

bool in_polygon(std::span<const double> q) {
  const auto at = [q](std::size_t i) { return std::array{mpq_class(q[2 * i]), mpq_class(q[2 * i + 1])}; };
  const auto p = at(0);
  const std::size_t corners = q.size() / 2 - 1;
  bool inside = false;
  for (std::size_t i = 1; i <= corners; ++i) {
    const auto a = at(i), b = at(i % corners + 1);
    const mpq_class side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    const auto within = [&](std::size_t k) { return std::min(a[k], b[k]) <= p[k] && p[k] <= std::max(a[k], b[k]); };
    if (side == 0 && within(0) && within(1)) return true;
    if ((a[1] > p[1]) != (b[1] > p[1]) && (side > 0) == (b[1] > a[1])) inside = !inside;
  }
  return inside;
}

bool in_solid(const RationalVec& p, std::span<const std::array<RationalVec, 3>> faces) {
  for (const auto& [a, b, c] : faces) {
    if (meet({{p}, {}}, {{a, b, c}, {}})) return true;
  }
  for (long attempt = 1;; ++attempt) {
    const RationalVec d{mpq_class(1000), mpq_class(17 * attempt), mpq_class(attempt * attempt + 1)};
    bool inside = false, lucky = true;
    for (std::size_t face = 0; face < faces.size() && lucky; ++face) {
      const RationalVec a = faces[face][0] - p, b = faces[face][1] - p, c = faces[face][2] - p;
      const RationalVec n = cross(b - a, c - a);
      const mpq_class height = dot(a, n), rise = dot(d, n);
      if (height == 0) continue;  // beside the face, in its plane: a ray that leaves the plane misses it
      const std::array side{dot(d, cross(a, b)), dot(d, cross(b, c)), dot(d, cross(c, a))};
      lucky = rise != 0 && std::ranges::none_of(side, [](const mpq_class& s) { return s == 0; });
      const bool through = (side[0] > 0) == (side[1] > 0) && (side[1] > 0) == (side[2] > 0);
      if (lucky && through && height / rise > 0) inside = !inside;
    }
    if (lucky) return inside;
  }
}

std::uint32_t corners_of_hull(std::span<const RationalVec> points) {
  const auto same = [](const RationalVec& p, const RationalVec& q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  std::uint32_t corners = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Generated others;
    bool is_first = true;
    for (std::size_t j = 0; j < points.size(); ++j) {
      if (!same(points[i], points[j])) others.points.push_back(points[j]);
      if (j < i && same(points[i], points[j])) is_first = false;
    }
    const bool inner = !others.points.empty() && meet({{points[i]}, {}}, others);
    if (is_first && !inner) corners |= std::uint32_t{1} << i;
  }
  return corners;
}

double nearest_root(const mpq_class& square) { return rounded_root(Rounding::nearest, exact_number(square)); }

}  // namespace plumb::lab::trial
