// k-DOPs by their faces: tightened, moved, measured.
#include <algorithm>

#include "arith/big_rounding.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "figure/k_dop/sets.hpp"

namespace plumb {
namespace {

using namespace figure;

template <class Vector>
KDop<Vector> no_points(const KDop<Vector>& k_dop) {
  const std::size_t n = k_dop.directions.size();
  return {k_dop.directions, std::vector<double>(n, 1.0), std::vector<double>(n, -1.0)};
}

// The greatest direction . x + by, of the halfspaces' common points.
double greatest(const arith::RationalVector& direction, const mpq_class& by, const arith::Constraints& halfspaces,
                std::string_view function, const std::string& part, Rounding rounding = Rounding::up) {
  const arith::Optimum farthest = arith::maximize(direction, halfspaces);
  if (farthest.kind != arith::Optimum::Kind::optimal)
    throw InvalidShape(std::string(function)
                           .append(": the k-DOP is unbounded along ")
                           .append(part)
                           .append("; give directions that span all of space"));
  return within_doubles(rounded(rounding, arith::dot(direction, farthest.at) + by), function, part);
}

/// The first numbers of a vector of space, over another number.
arith::RationalVector quotients(const arith::Vec<mpq_class>& v, const mpq_class& by, std::size_t dimension) {
  arith::RationalVector made{mpq_class(v.x / by), mpq_class(v.y / by)};
  if (dimension == 3) made.push_back(mpq_class(v.z / by));
  return made;
}

// The interval of each direction, of the image under the pose.
template <class Vector>
KDop<Vector> image(std::string_view function, const KDop<Vector>& k_dop, const PoseNumbers<mpq_class>& pose) {
  constexpr std::size_t dimension = coordinate_count<Vector>;
  require_sound(function, k_dop);
  const arith::Constraints set = halfspaces(k_dop);
  if (is_empty(set)) return no_points(k_dop);
  KDop<Vector> result{k_dop.directions, {}, {}};
  for (const Vector& d : k_dop.directions.all()) {
    const arith::RationalVector direction = rational(d);
    arith::RationalVector pulled;  // direction . (M x) = pulled . x
    for (std::size_t j = 0; j < dimension; ++j)
      pulled.push_back(arith::dot(direction, quotients(pose.columns[j], pose.weight, dimension)));
    const mpq_class by = arith::dot(direction, quotients(pose.translation, pose.weight, dimension));
    const std::string part = std::string("directions[").append(std::to_string(result.max.size())).append("]");
    result.max.push_back(greatest(pulled, by, set, function, part));
    for (mpq_class& x : pulled) x = -x;
    result.min.push_back(0.0 - greatest(pulled, mpq_class(-by), set, function, part));
  }
  return result;
}

template <class Vector>
KDop<Vector> tight(const KDop<Vector>& k_dop) {
  require_sound("tighten", k_dop);
  if (has_empty_interval(k_dop)) return no_points(k_dop);
  return image("tighten", k_dop, pose_numbers<mpq_class>(identity_pose));
}

// Corners in turn, in two coordinates.
using RationalChain = std::vector<std::array<mpq_class, 2>>;

// What of the convex chain has u x + v y <= limit.
RationalChain clipped(const RationalChain& chain, const mpq_class& u, const mpq_class& v, const mpq_class& limit) {
  RationalChain kept;
  const auto excess = [&](const std::array<mpq_class, 2>& p) { return mpq_class(u * p[0] + v * p[1] - limit); };
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto &p = chain[i], &q = chain[(i + 1) % chain.size()];
    const mpq_class at_p = excess(p), at_q = excess(q);
    if (sgn(at_p) <= 0) kept.push_back(p);
    if (sgn(at_p) * sgn(at_q) < 0) {
      const mpq_class t = at_p / (at_p - at_q);
      kept.push_back({mpq_class(p[0] + t * (q[0] - p[0])), mpq_class(p[1] + t * (q[1] - p[1]))});
    }
  }
  return kept;
}

mpq_class area_of(const RationalChain& chain) {
  mpq_class twice;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto &p = chain[i], &q = chain[(i + 1) % chain.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return abs(twice) / 2;
}

struct Span {
  mpq_class min, max;
};

// Of each coordinate, in a set that is not empty.
std::vector<Span> bounds(std::string_view function, const arith::Constraints& set, std::size_t dimension) {
  std::vector<Span> all(dimension);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    arith::RationalVector direction(dimension);
    for (const int way : {1, -1}) {
      direction[axis] = way;
      const arith::Optimum farthest = arith::maximize(direction, set);
      if (farthest.kind != arith::Optimum::Kind::optimal)
        throw InvalidShape(
            std::string(function).append(": the k-DOP is unbounded; give directions that span all of space"));
      (way > 0 ? all[axis].max : all[axis].min) = farthest.at[axis];
    }
  }
  return all;
}

// Does an earlier halfspace have the same plane and side?  A face is counted once.
bool repeats(const arith::Constraints& set, std::size_t i) {
  const auto same = [&](std::size_t k) {
    std::size_t lead = 0;
    while (sgn(set.rows[i][lead]) == 0) ++lead;
    const mpq_class ratio = set.rows[k][lead] / set.rows[i][lead];
    if (sgn(ratio) <= 0 || set.limits[k] != ratio * set.limits[i]) return false;
    for (std::size_t axis = 0; axis < set.rows[i].size(); ++axis) {
      if (set.rows[k][axis] != ratio * set.rows[i][axis]) return false;
    }
    return true;
  };
  for (std::size_t k = 0; k < i; ++k) {
    if (same(k)) return true;
  }
  return false;
}

// The face in the plane of halfspace i, seen along an axis that the plane is not parallel to: its shadow's area over
// the size of the normal along this axis.  Times the length of the normal it is the face's area, times the limit three
// times the volume of the cone from the origin to the face.
mpq_class face_measure(const arith::Constraints& set, std::size_t i, const std::vector<Span>& bounds) {
  const arith::RationalVector& normal = set.rows[i];
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (abs(normal[k]) > abs(normal[axis])) axis = k;
  }
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  RationalChain chain{{bounds[u].min, bounds[v].min},
                      {bounds[u].max, bounds[v].min},
                      {bounds[u].max, bounds[v].max},
                      {bounds[u].min, bounds[v].max}};
  for (std::size_t k = 0; k < set.rows.size() && !chain.empty(); ++k) {
    if (k == i) continue;
    const mpq_class factor = set.rows[k][axis] / normal[axis];
    const mpq_class of_u = set.rows[k][u] - factor * normal[u], of_v = set.rows[k][v] - factor * normal[v];
    const mpq_class limit = set.limits[k] - factor * set.limits[i];
    if (sgn(of_u) == 0 && sgn(of_v) == 0) {
      if (sgn(limit) < 0) chain.clear();
    } else {
      chain = clipped(chain, of_u, of_v, limit);
    }
  }
  return area_of(chain) / abs(normal[axis]);
}

constexpr mp_bitcnt_t root_bits = 512;

// A root to far more bits than a double has; exact for squares.
mpq_class root(const mpq_class& square) {
  const auto bits = [](const mpz_class& x) { return mpz_sizeinbase(x.get_mpz_t(), 2); };
  const std::size_t n = bits(square.get_num()), d = bits(square.get_den());
  const mp_bitcnt_t places = root_bits + (d > n ? (d - n) / 2 + 1 : 0);  // of a small root as many as of a large one
  const mpz_class scaled = (square.get_num() << (2 * places)) / square.get_den();
  mpq_class result(sqrt(scaled), mpz_class(1) << places);
  result.canonicalize();
  return result;
}

template <class Measure>
mpq_class sum_over_faces(std::string_view function, const KDop3& k_dop, Measure measure) {
  require_sound(function, k_dop);
  const arith::Constraints set = halfspaces(k_dop);
  if (has_empty_interval(k_dop) || is_empty(set)) return 0;
  const std::vector<Span> box = bounds(function, set, 3);
  mpq_class sum;
  for (std::size_t i = 0; i < set.rows.size(); ++i) {
    if (!repeats(set, i)) sum += measure(set, i, face_measure(set, i, box));
  }
  return sum;
}

template <class Vector>
double value_along(const KDop<Vector>& k_dop, const Vector& direction, Rounding rounding) {
  require_sound("support_value", k_dop);
  require_finite_parts("support_value", {"direction"}, direction);
  const arith::Constraints set = halfspaces(k_dop);
  if (is_empty(set)) throw InvalidShape("support_value: k_dop is empty; it has no farthest point");
  return greatest(rational(direction), 0, set, "support_value", "direction", rounding);
}

}  // namespace

double support_value(const KDop2& k_dop, const Vector2& direction, Rounding rounding) {
  return value_along(k_dop, direction, rounding);
}
double support_value(const KDop3& k_dop, const Vector3& direction, Rounding rounding) {
  return value_along(k_dop, direction, rounding);
}

KDop2 tighten(const KDop2& k_dop) { return tight(k_dop); }
KDop3 tighten(const KDop3& k_dop) { return tight(k_dop); }

Aabb2 fit_aabb(const KDop2& k_dop) {
  require_sound("fit_aabb", k_dop);
  const arith::Constraints set = halfspaces(k_dop);
  if (is_empty(set)) return {{1, 1}, {-1, -1}};
  const auto along = [&](double x, double y, const char* part) { return greatest({x, y}, 0, set, "fit_aabb", part); };
  return {{0.0 - along(-1, 0, "min.x"), 0.0 - along(0, -1, "min.y")}, {along(1, 0, "max.x"), along(0, 1, "max.y")}};
}

Aabb3 fit_aabb(const KDop3& k_dop) {
  require_sound("fit_aabb", k_dop);
  const arith::Constraints set = halfspaces(k_dop);
  if (is_empty(set)) return {{1, 1, 1}, {-1, -1, -1}};
  const auto along = [&](double x, double y, double z, const char* part) {
    return greatest({x, y, z}, 0, set, "fit_aabb", part);
  };
  return {{0.0 - along(-1, 0, 0, "min.x"), 0.0 - along(0, -1, 0, "min.y"), 0.0 - along(0, 0, -1, "min.z")},
          {along(1, 0, 0, "max.x"), along(0, 1, 0, "max.y"), along(0, 0, 1, "max.z")}};
}

KDop2 transform(const KDop2& k_dop, PoseView2 pose) {
  figure::require_sound("transform", pose);
  return image("transform", k_dop, pose_numbers<mpq_class>(pose));
}

KDop3 transform(const KDop3& k_dop, PoseView pose) {
  figure::require_sound("transform", pose);
  return image("transform", k_dop, pose_numbers<mpq_class>(pose));
}

double area(const KDop2& k_dop) {
  require_sound("area", k_dop);
  const arith::Constraints set = halfspaces(k_dop);
  if (has_empty_interval(k_dop) || is_empty(set)) return 0;
  const std::vector<Span> box = bounds("area", set, 2);
  RationalChain chain{
      {box[0].min, box[1].min}, {box[0].max, box[1].min}, {box[0].max, box[1].max}, {box[0].min, box[1].max}};
  for (std::size_t i = 0; i < set.rows.size(); ++i)
    chain = clipped(chain, set.rows[i][0], set.rows[i][1], set.limits[i]);
  return rounded(Rounding::nearest, area_of(chain));
}

double volume(const KDop3& k_dop) {
  const auto cone = [](const arith::Constraints& set, std::size_t i, const mpq_class& measure) {
    return mpq_class(set.limits[i] * measure / 3);
  };
  return rounded(Rounding::nearest, sum_over_faces("volume", k_dop, cone));
}

double surface_area(const KDop3& k_dop) {
  const auto face = [](const arith::Constraints& set, std::size_t i, const mpq_class& measure) {
    if (sgn(measure) == 0) return mpq_class(0);
    return mpq_class(measure * root(arith::dot(set.rows[i], set.rows[i])));
  };
  return rounded(Rounding::nearest, sum_over_faces("surface_area", k_dop, face));
}

}  // namespace plumb
