#include "plumb/figure/containment/polygon_location.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "figure/basic/plane_of_points.hpp"
#include "figure/containment/chain_winding.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

constexpr std::string_view kFunction = "locate";

/// Adds up over chains.
class Windings {
 public:
  void add(std::span<const Point2> chain, const Point2& p) {
    const ChainWinding w = chain.size() < 3 ? ChainWinding{.is_finite = false} : parity_of(chain, p);
    is_sound_ = is_sound_ && w.is_finite;
    is_on_ = is_on_ || w.is_on;
    odd_ ^= (w.turns & 1) != 0;
  }
  /// Of chains or a point that are none, `require` throws.
  template <class Require>
  [[nodiscard]] Location location(const Require& require) const {
    if (!is_sound_) [[unlikely]]
      require();
    return is_on_ ? Location::boundary : odd_ ? Location::inside : Location::outside;
  }

 private:
  bool is_sound_ = true, is_on_ = false, odd_ = false;
};

using Chain3 = std::span<const Point3>;

bool on_segment(const Point3& a, const Point3& b, const Point3& p) {
  return p == a || p == b || (collinear(a, b, p) && are_ordered_along_line(a, p, b));
}

/// Chains in one plane, or on one line.
Location locate_in_space(std::span<const Chain3> chains, const Point3& p) {
  std::vector<Point3> all;
  for (const Chain3& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
  const PlaneOfPoints plane = plane_of_points(all);
  require_planar("locate", "polygon", plane);
  if (plane.dimension < 2) {
    for (const Chain3& chain : chains) {
      const Point3* a = &chain.back();
      for (const Point3& b : chain) {
        if (on_segment(*a, b, p)) return Location::boundary;
        a = &b;
      }
    }
    return Location::outside;
  }
  const auto [i, j, k] = plane.span;
  if (orient3d(all[i], all[j], all[k], p) != Sign::zero) return Location::outside;
  const Look look = look_at_plane(all[i], all[j], all[k]);
  Windings windings;
  std::vector<Point2> flat;
  for (const Chain3& chain : chains) {
    flat.clear();
    for (const Point3& v : chain) flat.push_back(projected(look, v));
    windings.add(flat, projected(look, p));
  }
  return windings.location([] {});
}

Location surface(Location in_plane) { return in_plane == Location::outside ? Location::outside : Location::boundary; }

}  // namespace

std::optional<int> winding_number(const Polygon2& polygon, const Point2& p) {
  assert_sound_thread();
  figure::require_sound("winding_number", polygon, part::place("p", p));
  const ChainWinding w = winding_of(polygon.vertices, p);
  return w.is_on ? std::nullopt : std::optional(w.turns);
}

Location locate(const Quadrilateral2& q, const Point2& p) {
  assert_sound_thread();
  const std::array chain{q.a, q.b, q.c, q.d};
  Windings windings;
  windings.add(chain, p);
  return windings.location([&] { figure::require_sound(kFunction, q, part::place("p", p)); });
}

Location locate(const Polygon2& polygon, const Point2& p) {
  assert_sound_thread();
  Windings windings;
  windings.add(polygon.vertices, p);
  return windings.location([&] { figure::require_sound(kFunction, polygon, part::place("p", p)); });
}

Location locate(const HoledPolygon2& polygon, const Point2& p) {
  assert_sound_thread();
  Windings windings;
  windings.add(polygon.outer.vertices, p);
  for (const Polygon2& hole : polygon.holes) windings.add(hole.vertices, p);
  return windings.location([&] { figure::require_sound(kFunction, polygon, part::place("p", p)); });
}

Location locate_in_plane(const Quadrilateral3& q, const Point3& p) {
  figure::require_sound(kFunction, q, part::place("p", p));
  const std::array corners{q.a, q.b, q.c, q.d};
  const std::array<Chain3, 1> chains{corners};
  return locate_in_space(chains, p);
}

Location locate_in_plane(const Polygon3& polygon, const Point3& p) {
  figure::require_sound(kFunction, polygon, part::place("p", p));
  const std::array<Chain3, 1> chains{polygon.vertices};
  return locate_in_space(chains, p);
}

Location locate_in_plane(const HoledPolygon3& polygon, const Point3& p) {
  figure::require_sound(kFunction, polygon, part::place("p", p));
  std::vector<Chain3> chains{polygon.outer.vertices};
  for (const Polygon3& hole : polygon.holes) chains.emplace_back(hole.vertices);
  return locate_in_space(chains, p);
}

Location locate(const Quadrilateral3& q, const Point3& p) { return surface(locate_in_plane(q, p)); }
Location locate(const Polygon3& polygon, const Point3& p) { return surface(locate_in_plane(polygon, p)); }
Location locate(const HoledPolygon3& polygon, const Point3& p) { return surface(locate_in_plane(polygon, p)); }

bool contains(const Quadrilateral2& q, const Point2& p) { return locate(q, p) != Location::outside; }
bool contains(const Polygon2& polygon, const Point2& p) { return locate(polygon, p) != Location::outside; }
bool contains(const HoledPolygon2& polygon, const Point2& p) { return locate(polygon, p) != Location::outside; }
bool contains(const Quadrilateral3& q, const Point3& p) { return locate(q, p) != Location::outside; }
bool contains(const Polygon3& polygon, const Point3& p) { return locate(polygon, p) != Location::outside; }
bool contains(const HoledPolygon3& polygon, const Point3& p) { return locate(polygon, p) != Location::outside; }

}  // namespace plumb
