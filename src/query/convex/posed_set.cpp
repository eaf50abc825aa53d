#include "query/convex/posed_set.hpp"

#include "arith/root_sign.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "query/convex/cap_relation.hpp"
#include "query/convex/core.hpp"

namespace plumb::query {
namespace {

/// The core, and the radius; of polygons neither.
template <class Shape>
void fill(PosedSet& s, const Shape& shape) {
  if constexpr (requires { axis_of(shape); }) {
    const RoundAxis axis = axis_of(shape);
    if (axis.is_itself()) s.axis = axis;
    s.core = axis.from == axis.to ? flat_set(axis.from) : flat_set(Segment3{axis.from, axis.to});
    s.radius = axis.from == axis.to ? axis.radius : 0;
  } else if constexpr (std::is_same_v<Shape, SphericalCap3>) {
    if (auto thin = thin_cap(shape)) {
      s.core = std::move(*thin);
    } else {
      s.core = flat_set(shape.sphere.center);
      s.cap = &shape;
    }
  } else {
    s.core = core_of(shape);
    s.radius = radius_of(view_of(shape));
  }
}

}  // namespace

PosedSet posed_set(const PosedView& figure) {
  PosedSet s;
  s.dimension = figure.figure.dimension;
  s.map = exact_map(figure.pose);
  with_figure(figure.figure, [&](const auto& shape) { fill(s, shape); });
  const bool is_curved = s.is_round() || s.has_axis() || s.cap != nullptr;
  if (is_curved && squared_scale(s.map, s.dimension) == 0) s.radius = 0, s.axis = {}, s.cap = nullptr;
  return s;
}

FlatSet image(const PosedSet& s) { return image(s.map, s.core); }

ExactChains image(const ExactMap& map, const ExactChains& chains) {
  ExactChains all = chains;
  for (auto& chain : all) {
    for (Exact3& p : chain) p = image(map, p);
  }
  return all;
}

// root(a) + root(b) against root(c): a + b - c + 2 root(a b) against zero.
int sign_of_roots(const mpq_class& first, const mpq_class& second, const mpq_class& third) {
  return static_cast<int>(sign_of_root(mpq_class(first + second - third), mpq_class(2), mpq_class(first * second)));
}

}  // namespace plumb::query
