// Two meshes that one rotation turns alike: which contacts do the ways of posing them lose?
#include <algorithm>
#include <cmath>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/question_figures.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "tool/mesh/flange.hpp"

namespace plumb::lab::stability {
namespace {

using Pair = std::array<double, 18>;

Pair pair_of(const Triangle3& a, const Triangle3& b) {
  Pair q{};
  double* to = q.data();
  for (const Point3& p : {a.a, a.b, a.c, b.a, b.b, b.c}) *to++ = p.x, *to++ = p.y, *to++ = p.z;
  return q;
}
bool meet_as_given(const Pair& q) { return intersects(triangle_at(q.data()), triangle_at(&q[9])); }

/// The surface of an upright brick, each side cut into so many squares, and these into two triangles each.
std::vector<Triangle3> brick(const Point3& low, const Point3& high, int cuts) {
  std::vector<Triangle3> all;
  const auto side = [&](std::size_t axis, bool upper) {
    const auto at = [&](int i, int j) {
      const std::array from{low.x, low.y, low.z}, to{high.x, high.y, high.z};
      std::array<double, 3> p{};
      p[axis] = upper ? to[axis] : from[axis];
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      p[u] = from[u] + (to[u] - from[u]) * i / cuts;
      p[v] = from[v] + (to[v] - from[v]) * j / cuts;
      return Point3{p[0], p[1], p[2]};
    };
    for (int i = 0; i < cuts; ++i) {
      for (int j = 0; j < cuts; ++j) {
        all.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        all.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  };
  for (const std::size_t axis : {0U, 1U, 2U}) side(axis, false), side(axis, true);
  return all;
}

std::vector<Triangle3> part(double shift) {
  const TriangleMesh mesh = build_flange().mesh;
  const auto at = [&](std::uint32_t i) {
    const Point3 p = mesh.vertices[i];
    return Point3{p.x + shift, p.y, p.z};
  };
  std::vector<Triangle3> all;
  for (const auto& [a, b, c] : mesh.triangles) all.push_back({at(a), at(b), at(c)});
  return all;
}

Aabb3 box_of(const Triangle3& t) {
  return {{std::min({t.a.x, t.b.x, t.c.x}), std::min({t.a.y, t.b.y, t.c.y}), std::min({t.a.z, t.b.z, t.c.z})},
          {std::max({t.a.x, t.b.x, t.c.x}), std::max({t.a.y, t.b.y, t.c.y}), std::max({t.a.z, t.b.z, t.c.z})}};
}

/// Those whose boxes meet; so many at the most, evenly.
std::vector<Pair> near_pairs(const std::vector<Triangle3>& a, const std::vector<Triangle3>& b, std::size_t most) {
  std::vector<Aabb3> boxes;
  for (const Triangle3& t : b) boxes.push_back(box_of(t));
  std::vector<Pair> pairs;
  for (const Triangle3& t : a) {
    const Aabb3 box = box_of(t);
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (intersects(box, boxes[j])) pairs.push_back(pair_of(t, b[j]));
    }
  }
  if (pairs.size() <= most) return pairs;
  std::vector<Pair> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(pairs[i * pairs.size() / most]);
  return some;
}

/// Turned at random and moved, the matrix as orthonormal as doubles can be.
Pose random_pose(Entropy& entropy) {
  std::array<double, 4> q{};
  double length = 0;
  for (double& x : q) x = signed_unit_coordinate(entropy), length += x * x;
  length = std::sqrt(length);
  for (double& x : q) x /= length;
  const auto [w, x, y, z] = q;
  return {{{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}},
          {signed_unit_coordinate(entropy), signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)}};
}

template <class T>
using Matrix = std::array<trial::Vec<T>, 3>;  // columns

template <class T>
trial::Vec<T> vec_of(const Vector3& v) {
  return {static_cast<T>(v.x), static_cast<T>(v.y), static_cast<T>(v.z)};
}
template <class T>
Matrix<T> matrix_of(const Pose& pose) {
  return {vec_of<T>(pose.columns[0]), vec_of<T>(pose.columns[1]), vec_of<T>(pose.columns[2])};
}
template <class T>
trial::Vec<T> times(const Matrix<T>& m, const trial::Vec<T>& v) {
  return m[0] * v.x + m[1] * v.y + m[2] * v.z;
}

/// Each corner from `first` on moved by matrix and shift, in the numbers of T.
template <class T>
void move_corners(Pair& q, std::size_t first, const Matrix<T>& m, const trial::Vec<T>& by) {
  for (std::size_t i = first; i < q.size(); i += 3) {
    const trial::Vec<T> v = times(m, {static_cast<T>(q[i]), static_cast<T>(q[i + 1]), static_cast<T>(q[i + 2])}) + by;
    q[i] = v.x, q[i + 1] = v.y, q[i + 2] = v.z;
  }
}

/// Both triangles where the pose takes them.
template <class T>
Pair both_posed(Pair q, const Pose& pose) {
  move_corners<T>(q, 0, matrix_of<T>(pose), vec_of<T>(pose.translation));
  return q;
}

/// The second where the first sees it: by the inverse of its pose, the transpose of a rotation, times that of the
/// second.
template <class T>
Pair second_in_first(Pair q, const Pose& pose) {
  const Matrix<T> m = matrix_of<T>(pose);
  Matrix<T> relative{};
  for (std::size_t j = 0; j < 3; ++j) relative[j] = {dot(m[0], m[j]), dot(m[1], m[j]), dot(m[2], m[j])};
  move_corners<T>(q, 9, relative, {T(0), T(0), T(0)});  // the shifts are one: their difference is none
  return q;
}

struct Posing {
  std::string name;
  std::function<bool(const Pair&, const Pose&)> meet;
  bool exact = false;
};

std::vector<Posing> posings() {
  std::vector<Posing> all;
  const auto add = [&](const std::string& name, Pair (*pose)(Pair, const Pose&), const Ask<18>& ask) {
    all.push_back({name, [=](const Pair& q, const Pose& p) { return ask(pose(q, p)); }});
  };
  for (const Way<18>& way : float_ways<18>(trial::TriangleAgainstTriangle{})) {
    if (way.name == "long-double") continue;  // coordinates are kept in doubles
    add(way.name, way.name == "float32" ? both_posed<float> : both_posed<double>, way.ask);
    add(way.name + ", in one's space", way.name == "float32" ? second_in_first<float> : second_in_first<double>,
        way.ask);
  }
  add("exact, rounded points", both_posed<double>, meet_as_given);
  add("exact, in one's space", second_in_first<double>, meet_as_given);
  all.push_back({"exact, posed",
                 [](const Pair& q, const Pose& p) {
                   return intersects(Posed{triangle_at(q.data()), p}, Posed{triangle_at(&q[9]), p});
                 },
                 true});
  return all;
}

Findings contacts(const std::vector<Triangle3>& a, const std::vector<Triangle3>& b, const Settings& settings) {
  const std::vector<Pair> pairs = near_pairs(a, b, settings.quick ? 400 : 3'000);
  std::vector<bool> meet;
  for (const Pair& q : pairs) meet.push_back(meet_as_given(q));
  Findings findings;
  for (const Posing& posing : posings()) {
    Count lost{"contacts of triangles that were lost"}, invented{"contacts of triangles that were invented"};
    for (std::uint64_t number = 0, n = settings.quick ? 2 : 8; number < n; ++number) {
      Entropy entropy(settings.seed, number);
      const Pose pose = random_pose(entropy);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        Count& count = meet[i] ? lost : invented;
        ++count.of;
        if (posing.meet(pairs[i], pose) != meet[i]) ++count.failures;
      }
    }
    findings.outcomes.push_back({posing.name, {lost, invented}, posing.exact});
  }
  return findings;
}

}  // namespace

Experiment pose_experiment() {
  return {
      "posed-contacts", "which contacts of two meshes are lost when one rotation turns both?", "RTCD 3.2, 4.4.1",
      [](const Settings& settings) {
        return std::vector<Scene>{
            {"bricks", "a brick on another, in squares of other sizes: every contact is a touch",
             [settings] {
               return contacts(brick({0, 0, 0}, {8, 8, 4}, 8), brick({1.25, 2.25, 4}, {7.25, 8.25, 7}, 4), settings);
             }},
            {"parts", "a machined part and its copy, moved by an eighth: their flats lie in each other",
             [settings] { return contacts(part(0), part(0.125), settings); }},
        };
      }};
}

}  // namespace plumb::lab::stability
