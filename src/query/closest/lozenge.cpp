// Lozenges: what is nearest of the parallelogram, and from there toward p by the radius.
//
// The far corners need not be doubles: the parts of the core are asked over intervals first, over integers for certain.
#include "certify/carried_errors.hpp"
#include "figure/swept_sphere/core_distance.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "query/closest/answers.hpp"

namespace plumb {
namespace query {
namespace {

constexpr std::uint32_t the_plate = 0, first_edge = 1, first_corner = 5;

template <class T>
struct Plate {
  Vec<T> corner;
  std::array<Vec<T>, 2> edge;

  explicit Plate(const Lozenge3& s) : corner(vec<T>(s.corner)), edge{vec<T>(s.edges[0]), vec<T>(s.edges[1])} {}
  [[nodiscard]] Vec<T> vertex(std::uint32_t v) const {
    Vec<T> at = corner;
    if ((v & 1) != 0) at = at + edge[0];
    if ((v & 2) != 0) at = at + edge[1];
    return at;
  }
  /// Edge i is along i / 2, at the upper end of the other where i is odd.
  [[nodiscard]] Vec<T> start(std::uint32_t i) const { return (i & 1) != 0 ? corner + edge[1 - i / 2] : corner; }
};

/// Of all parts that p projects into the nearest: of equal ones the first of corners, edges and the plate.
template <class T, class Ask>
std::uint32_t nearest_part(const Lozenge3& s, const Point3& p, Ask& ask) {
  const Plate<T> plate(s);
  const Vec<T> q = vec<T>(p);
  const std::array there{s.edges[0] != Vector3{}, s.edges[1] != Vector3{}};
  std::uint32_t best = first_corner;
  const Vec<T> from_corner = q - plate.corner;
  T square = dot(from_corner, from_corner), over(1.0);
  const auto see = [&](std::uint32_t part, const T& numerator, const T& denominator) {
    if (ask(numerator * over - square * denominator) != Sign::negative) return;
    best = part, square = numerator, over = denominator;
  };
  const auto within = [&](const T& x, const T& most) {
    return ask(x) == Sign::positive && ask(most - x) == Sign::positive;
  };
  for (std::uint32_t v = 1; v < 4; ++v) {
    if (((v & 1) != 0 && !there[0]) || ((v & 2) != 0 && !there[1])) continue;
    const Vec<T> w = q - plate.vertex(v);
    see(first_corner + v, dot(w, w), T(1.0));
  }
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (!there[i / 2] || ((i & 1) != 0 && !there[1 - i / 2])) continue;
    const Vec<T>& along = plate.edge[i / 2];
    const Vec<T> w = q - plate.start(i), c = cross(w, along);
    const T whole = dot(along, along);
    if (within(dot(w, along), whole)) see(first_edge + i, dot(c, c), whole);
  }
  const auto& [e, f] = plate.edge;
  const Vec<T> n = cross(e, f);
  const T whole = dot(n, n);
  if (!there[0] || !there[1] || ask(whole) != Sign::positive) return best;
  if (within(dot(cross(from_corner, f), n), whole) && within(dot(cross(e, from_corner), n), whole)) {
    const T gap = dot(from_corner, n);
    see(the_plate, gap * gap, whole);
  }
  return best;
}

}  // namespace

template <>
struct Nearest<Lozenge3> {
  static double radius(const Lozenge3& s) { return s.radius; }
  static Feature feature(const Lozenge3& s, const Point3& p) {
    if (locate(s, p) == Location::inside) return {FeatureKind::interior, 0};
    return {FeatureKind::face, certainly<SignWorlds<Interval, BigDyadic>>(
                                   [&]<class T>(Carrying<T>& ask) { return nearest_part<T>(s, p, ask); })};
  }
  template <class T>
  static Foot<T> foot(const Lozenge3& s, const Point3& p, const Feature& f) {
    const Vec<T> q = vec<T>(p);
    if (f.kind == FeatureKind::interior) return foot_of_itself(q);
    const Plate<T> plate(s);
    if (f.index >= first_corner) return foot_on_point(plate.vertex(f.index - first_corner), q);
    if (f.index >= first_edge) {
      const std::uint32_t i = f.index - first_edge;
      return foot_on_line(plate.start(i), plate.edge[i / 2], q);
    }
    const Vec<T> n = cross(plate.edge[0], plate.edge[1]);
    return foot_on_plane(n, dot(n, q - plate.corner), q);
  }
};

}  // namespace query

PLUMB_CLOSEST_ROUND(Closest, Point3, Lozenge3)

}  // namespace plumb
