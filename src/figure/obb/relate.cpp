#include <optional>

#include "figure/basic/in_space.hpp"
#include "figure/minkowski/zonotope.hpp"
#include "figure/obb/quick.hpp"
#include "plumb/certify/detail/gap_filter.hpp"
#include "plumb/certify/separating_axis.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/predicates/direction.hpp"

namespace plumb {
namespace {

/// What the numbers of two boxes are called.
struct BothSpace {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
  static constexpr std::array<std::string_view, 10> argument_names{"a.center",  "b.center",  "a.axes[0]", "a.axes[1]",
                                                                   "a.axes[2]", "b.axes[0]", "b.axes[1]", "b.axes[2]",
                                                                   "a.half",    "b.half"};
};

BigDyadic product(double a, double b) { return BigDyadic(a) * BigDyadic(b); }
BigVector difference(const Point3& from, const Point3& to) {
  return {BigDyadic(to.x) - BigDyadic(from.x), BigDyadic(to.y) - BigDyadic(from.y),
          BigDyadic(to.z) - BigDyadic(from.z)};
}
BigVector generator(const Vector3& axis, double half) {
  return {product(axis.x, half), product(axis.y, half), product(axis.z, half)};
}

// All gaps that are defined, one after another; nothing when they do not decide: some are zero, or none is defined.
class GapVerdict {
 public:
  /// False when the question is answered.
  bool add(std::optional<Sign> gap) {
    if (!gap) return true;
    any_ = true;
    zero_ = zero_ || *gap == Sign::zero;
    disjoint_ = *gap == Sign::positive;
    return !disjoint_;
  }
  [[nodiscard]] std::optional<Relation> relation() const {
    if (disjoint_) return Relation::disjoint;
    if (any_ && !zero_) return Relation::overlapping;
    return {};
  }

 private:
  bool any_ = false, zero_ = false, disjoint_ = false;
};

std::optional<Relation> by_signs(const Obb3& a, const Obb3& b) {
  GapVerdict verdict;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!verdict.add(face_gap(a, b, i)) || !verdict.add(face_gap(b, a, i))) return verdict.relation();
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!verdict.add(edge_gap(a, b, i, j))) return verdict.relation();
    }
  }
  return verdict.relation();
}

[[gnu::noinline]] Relation exactly(const Obb3& a, const Obb3& b, std::string_view function) {
  require_finite<BothSpace>(coordinates_of<BothSpace>(a.center, b.center, a.axes[0], a.axes[1], a.axes[2], b.axes[0],
                                                      b.axes[1], b.axes[2], a.half, b.half),
                            function);
  if (const auto answer = by_signs(a, b)) return *answer;
  return locate_origin(
      difference(a.center, b.center),
      std::array{generator(a.axes[0], a.half.x), generator(a.axes[1], a.half.y), generator(a.axes[2], a.half.z),
                 generator(b.axes[0], b.half.x), generator(b.axes[1], b.half.y), generator(b.axes[2], b.half.z)});
}

// In the plane: along the normal of u, |(cb - ca) x u| less what the other three axes reach.
struct PlaneGap {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{2, 2, 2, 2, 2, 2, 1, 1, 1};
  static constexpr bool homogeneous = false;

  template <class T, class Absolute>
  static constexpr auto gap(const std::array<T, 15>& p, Absolute absolute) {
    const auto reach = [&](std::size_t i) { return p[12 + i] * absolute(p[6 + 2 * i] * p[5] - p[7 + 2 * i] * p[4]); };
    return absolute((p[2] - p[0]) * p[5] - (p[3] - p[1]) * p[4]) - (reach(0) + (reach(1) + reach(2)));
  }
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    return gap(p, [](const auto& product) { return product; });
  }
};

// Centers are swapped and axes reversed until no product with u's normal is negative.
std::optional<Sign> plane_gap_exactly(Coordinates<PlaneGap> p) {
  if (p[4] == 0 && p[5] == 0) return {};
  const auto cross_u = [&p](double x, double y) { return decide<predicates::Cross2d>({x, y, p[4], p[5]}); };
  if (sign_of([](auto fx, auto fy, auto tx, auto ty, auto ux, auto uy) { return (tx - fx) * uy - (ty - fy) * ux; },
              p[0], p[1], p[2], p[3], p[4], p[5]) == Sign::negative) {
    std::swap(p[0], p[2]);
    std::swap(p[1], p[3]);
  }
  for (std::size_t i = 6; i < 12; i += 2) {
    if (cross_u(p[i], p[i + 1]) != Sign::negative) continue;
    p[i] = -p[i];
    p[i + 1] = -p[i + 1];
  }
  return decide<PlaneGap>(p);
}

// Along the normal of a's axis i.
std::optional<Sign> plane_gap(const Obb2& a, const Obb2& b, std::size_t i) {
  const Vector2 &u = a.axes[i], &w = a.axes[1 - i];
  const Coordinates<PlaneGap> p{a.center.x,
                                a.center.y,
                                b.center.x,
                                b.center.y,
                                u.x,
                                u.y,
                                w.x,
                                w.y,
                                b.axes[0].x,
                                b.axes[0].y,
                                b.axes[1].x,
                                b.axes[1].y,
                                magnitude_of(i == 0 ? a.half.y : a.half.x),
                                magnitude_of(b.half.x),
                                magnitude_of(b.half.y)};
  if (const int s = gap_filter<PlaneGap>(p); s != 0) [[likely]]
    return static_cast<Sign>(s);
  return plane_gap_exactly(p);
}

struct BothPlane {
  static constexpr std::string_view name = "relate";
  static constexpr std::array arguments{2, 2, 2, 2, 2, 2, 2, 2};
  static constexpr std::array<std::string_view, 8> argument_names{"a.center", "a.axes[0]", "a.axes[1]", "a.half",
                                                                  "b.center", "b.axes[0]", "b.axes[1]", "b.half"};
};

inline Relation relate_boxes(const Obb3& a, const Obb3& b, std::string_view function) {
  assert_sound_thread();
  if (const auto quick = quick_relation(a, b)) [[likely]]
    return *quick;
  if (const auto near = near_relation(a, b)) return *near;
  return exactly(a, b, function);
}

Relation relate_boxes(const Obb2& a, const Obb2& b, std::string_view function) {
  const auto p =
      coordinates_of<BothPlane>(a.center, a.axes[0], a.axes[1], a.half, b.center, b.axes[0], b.axes[1], b.half);
  require_finite<BothPlane>(p, function);
  GapVerdict verdict;
  if (!verdict.add(plane_gap(a, b, 0)) || !verdict.add(plane_gap(a, b, 1)) || !verdict.add(plane_gap(b, a, 0)) ||
      !verdict.add(plane_gap(b, a, 1)))
    return Relation::disjoint;
  if (const auto answer = verdict.relation()) return *answer;
  return locate_origin(difference(in_space(a.center), in_space(b.center)),
                       std::array{generator(in_space(a.axes[0]), a.half.x), generator(in_space(a.axes[1]), a.half.y),
                                  generator(in_space(b.axes[0]), b.half.x), generator(in_space(b.axes[1]), b.half.y)});
}

}  // namespace

Relation relate(const Obb3& a, const Obb3& b) { return relate_boxes(a, b, "relate"); }
Relation relate(const Obb2& a, const Obb2& b) { return relate_boxes(a, b, "relate"); }
bool intersects(const Obb3& a, const Obb3& b) { return relate_boxes(a, b, "intersects") != Relation::disjoint; }
bool intersects(const Obb2& a, const Obb2& b) { return relate_boxes(a, b, "intersects") != Relation::disjoint; }

}  // namespace plumb
