#include "hull_overlap.hpp"

#include <array>
#include <vector>

#include "plumb/figure/support.hpp"
#include "plumb/predicates.hpp"
#include "rational_lp.hpp"

namespace plumb::figure {
namespace {

namespace f = predicates;
using Triple = std::array<double, 3>;

double dot(const Triple& u, const Triple& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/// A point of each hull, and their difference in doubles.
struct Difference {
  Point3 a, b;
  [[nodiscard]] Triple value() const { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend bool operator==(const Difference&, const Difference&) = default;
};
using Simplex = std::vector<Difference>;

Point3 farthest(std::span<const Point3> points, const Triple& along, double sign) {
  const Point3* best = points.data();
  double most = -std::numeric_limits<double>::infinity();
  for (const Point3& p : points) {
    const double reach = sign * dot({p.x, p.y, p.z}, along);
    if (reach > most) {
      most = reach;
      best = &p;
    }
  }
  return *best;
}

/// The part of the simplex that is nearest to the origin, and its nearest point: of all its parts.
struct Nearest {
  Simplex part;
  Triple at;
};
Nearest nearest(const Simplex& simplex) {
  Nearest best{{}, {}};
  double distance = std::numeric_limits<double>::infinity();
  for (unsigned chosen = 1; chosen < 1u << simplex.size(); ++chosen) {
    Simplex part;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      if ((chosen >> i & 1) != 0) part.push_back(simplex[i]);
    }
    // Weights of the edges from the first corner, by elimination of their normal equations.
    const Triple base = part[0].value();
    const std::size_t n = part.size() - 1;
    std::array<Triple, 3> edge{};
    std::array<std::array<double, 4>, 3> row{};
    for (std::size_t i = 0; i < n; ++i) {
      const Triple to = part[i + 1].value();
      edge[i] = {to[0] - base[0], to[1] - base[1], to[2] - base[2]};
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) row[i][j] = dot(edge[i], edge[j]);
      row[i][3] = -dot(edge[i], base);
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
      for (std::size_t j = 0; j < 3; ++j) at[j] += weight * edge[i][j];
    }
    if (inside && rest > 0 && dot(at, at) < distance) {
      distance = dot(at, at);
      best = {part, at};
    }
  }
  return best;
}

/// Do all points of a lie strictly farther along the direction than all of b?
bool proves_apart(std::span<const Point3> a, std::span<const Point3> b, const Triple& along) {
  if (!(dot(along, along) < std::numeric_limits<double>::infinity())) return false;
  const Vector3 direction{along[0], along[1], along[2]}, back{-along[0], -along[1], -along[2]};
  return compare_along_direction(support_point(a, back).point, support_point(b, direction).point, direction) ==
         Sign::positive;
}

/// Of three differences given by their ends.
struct TripleOfDifferences {
  static constexpr std::string_view name = "hulls_meet";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    return f::triple(f::difference(p, 0, 1), f::difference(p, 2, 3), f::difference(p, 4, 5));
  }
};

/// Is the origin strictly inside of the tetrahedron of the exact differences?
bool proves_meeting(const Simplex& s) {
  if (s.size() != 4) return false;
  const auto without = [&](std::size_t i) {  // of the others, in an order that alternates
    const Difference &u = s[(i + 1) % 4], &v = s[(i + 2) % 4], &w = s[(i + 3) % 4];
    const Sign sign = sign_of(TripleOfDifferences{}, u.a, u.b, v.a, v.b, w.a, w.b);
    return i % 2 == 0 ? sign : -sign;
  };
  const Sign first = without(0);
  return first != Sign::zero && without(1) == first && without(2) == first && without(3) == first;
}

bool meet_by_rationals(std::span<const Point3> a, std::span<const Point3> b) {
  Constraints apart;  // direction . x - offset >= 1 on one side, <= -1 on the other
  const auto add = [&](std::span<const Point3> points, int side) {
    for (const Point3& p : points)
      apart.add({mpq_class(side * mpq_class(p.x)), mpq_class(side * mpq_class(p.y)), mpq_class(side * mpq_class(p.z)),
                 mpq_class(-side)},
                mpq_class(-1));
  };
  add(a, -1);
  add(b, 1);
  return feasible(apart, std::vector<bool>(apart.rows.size(), false)).slack < 0;
}

}  // namespace

bool hulls_meet(std::span<const Point3> a, std::span<const Point3> b) {
  Simplex simplex{{a[0], b[0]}};
  Triple at = simplex[0].value();
  for (int step = 0; step < 64; ++step) {
    const Difference next{farthest(a, at, -1), farthest(b, at, 1)};
    if (dot(next.value(), at) > 0 && proves_apart(a, b, at)) return false;
    if (std::ranges::find(simplex, next) != simplex.end()) break;
    simplex.push_back(next);
    if (proves_meeting(simplex)) return true;
    Nearest found = nearest(simplex);
    if (found.part.empty() || found.part.size() == 4) break;
    simplex = std::move(found.part);
    at = found.at;
  }
  return meet_by_rationals(a, b);
}

}  // namespace plumb::figure
