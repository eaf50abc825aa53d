#include "query/section/flat_outline.hpp"

#include <algorithm>

#include "query/overlap/flat_areas.hpp"

namespace plumb::query {
namespace {

/// Corners of a triangle, counterclockwise.
struct Turning {
  std::array<int, 3> corner{0, 1, 2};
  std::array<Point2, 3> at;

  explicit Turning(const Triangle2& t) : at{t.a, t.b, t.c} {
    if (area(from_to(t.a, t.b), from_to(t.a, t.c)) < 0) std::swap(corner[1], corner[2]), std::swap(at[1], at[2]);
  }
};

class Walk {
 public:
  Walk(const TriangleAreas<double>& areas, const Turning& a, const Turning& b, const Ascending& a_ascends,
       const Ascending& b_ascends)
      : areas_(areas), a_(a), b_(b), a_ascends_(a_ascends), b_ascends_(b_ascends) {}

  Outline operator()() {
    for (std::size_t i = 0; i < 3; ++i) {
      if (within(areas_.over_b, i)) add_a(i);
      add_crossing(i, false);
      const std::size_t left = add_crossing(i, true);
      for (std::size_t j = left + 1; left < 3 && j < left + 3 && within(areas_.over_a, j % 3); ++j) add_b(j % 3);
    }
    if (outline_.count == 0 && within(areas_.over_a, 0)) {
      for (std::size_t j = 0; j < 3; ++j) add_b(j);
    }
    std::size_t first = 0;
    while (first < outline_.count && (!ascends_[first] || ascends_[(first + outline_.count - 1) % outline_.count]))
      ++first;
    std::rotate(outline_.corners.begin(), outline_.corners.begin() + static_cast<std::ptrdiff_t>(first),
                outline_.corners.begin() + static_cast<std::ptrdiff_t>(outline_.count));
    return outline_;
  }

 private:
  using Over = std::array<Three<double>, 3>;
  static bool within(const Over& edges, std::size_t corner) {
    return edges[0][corner] > 0 && edges[1][corner] > 0 && edges[2][corner] > 0;
  }
  [[nodiscard]] bool cross(std::size_t i, std::size_t j) const {
    const auto parts = [](const Three<double>& edge, std::size_t k) {
      return (edge[k] < 0) != (edge[(k + 1) % 3] < 0);
    };
    return parts(areas_.over_a[i], j) && parts(areas_.over_b[j], i);
  }
  /// Where edge i of a comes into b, or leaves it: by this edge of b; 3 where it does not.
  std::size_t add_crossing(std::size_t i, bool leaves) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!cross(i, j) || (areas_.over_b[j][i] > 0) != leaves) continue;
      add({a_.corner[i], b_.corner[j], a_.corner[(i + 1) % 3], b_.corner[(j + 1) % 3]},
          leaves ? ascends(b_, b_ascends_, j) : ascends(a_, a_ascends_, i));
      return j;
    }
    return 3;
  }
  void add_a(std::size_t i) { add({a_.corner[i], no_edge}, ascends(a_, a_ascends_, i)); }
  void add_b(std::size_t j) { add({no_edge, b_.corner[j]}, ascends(b_, b_ascends_, j)); }
  void add(const OutlineCorner& corner, bool ascends) {
    ascends_[outline_.count] = ascends;
    outline_.corners[outline_.count++] = corner;
  }
  static bool ascends(const Turning& t, const Ascending& ascending, std::size_t edge) {
    return ascending[static_cast<std::size_t>(t.corner[edge])][static_cast<std::size_t>(t.corner[(edge + 1) % 3])];
  }

  const TriangleAreas<double>& areas_;
  const Turning &a_, &b_;
  const Ascending &a_ascends_, &b_ascends_;
  Outline outline_;
  std::array<bool, 6> ascends_{};  // the edge that the corner begins
};

}  // namespace

std::optional<Outline> common_outline(const Triangle2& a, const Triangle2& b, const Ascending& a_ascends,
                                      const Ascending& b_ascends) {
  const Turning s(a), t(b);
  const auto at = [&](const Point2& p) { return from_to(s.at[0], p); };
  const Seen2<double> p = at(s.at[1]), q = at(s.at[2]), u = at(t.at[0]), v = at(t.at[1]), w = at(t.at[2]);
  const auto areas = triangle_areas(p, q, {u, v, w});
  double least = std::min(areas.of_a, areas.of_b);
  for (const auto& over : {areas.over_a, areas.over_b}) {
    for (const auto& edge : over) {
      for (const double x : edge) least = std::min(least, magnitude_of(x));
    }
  }
  if (!(least > area_error_of(p, q, u, v, w))) return {};
  return Walk(areas, s, t, a_ascends, b_ascends)();
}

}  // namespace plumb::query
