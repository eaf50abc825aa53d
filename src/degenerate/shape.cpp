#include "plumb/degenerate/shape.hpp"

#include <algorithm>
#include <utility>

#include "degenerate/body_frame.hpp"

namespace plumb::degenerate {

Form any_form(Entropy& entropy) {
  static_assert(forms.back().form == Form::empty);
  return entropy.coin() ? forms[entropy.below(forms.size() - 1)].form : Form::plain;
}

namespace {

// Of a plain shape: one interval of it the other way round, or one halfspace more, beyond another.
void make_empty(Body& body) {
  auto& p = body.points;
  const Int3 first = p[0], within = p.size() > 3 ? p[3] - p[0] : Int3{};
  switch (body.kind) {
    case ShapeKind::halfspaces:
      for (const Int3& at : {first - within, p[1] - within, p[2] - within, first - 2 * within}) p.push_back(Int3(at));
      break;
    case ShapeKind::k_dop:
      std::swap(p[0], p[1]);
      break;
    default:
      break;
  }
}

}  // namespace

std::vector<double> shape(ShapeKind kind, int dimension, Form form, Entropy& entropy) {
  const bool empty = form == Form::empty;
  if (!is_kind_of(kind, dimension) || (empty && !can_be_empty(kind))) return {};
  std::vector<int> features;
  for (int f = 0; f < dimension; ++f) {
    if (((features_of(kind, dimension) >> f) & 1) != 0) features.push_back(f);
  }
  int feature = features[entropy.below(features.size())];
  // A k-DOP is flat along its own directions.
  const bool k_dop = kind == ShapeKind::k_dop;
  if (k_dop && form >= Form::flat) feature = dimension - 1;
  const IntMap frame = frame_of({.dimension = dimension,
                                 .rigid = is_rigid(kind),
                                 .aabb = kind == ShapeKind::aabb,
                                 .k_dop = k_dop,
                                 .slabs = kind == ShapeKind::points,
                                 .aligned_feature = feature},
                                entropy);
  BodyOrder order{.kind = kind, .dimension = dimension, .feature = feature};
  order.extent = extent_of(empty ? Form::plain : form, static_cast<int>(entropy.below(10)), entropy);
  order.axes = axes_of_space(frame, false);
  Body body = body_of(order, entropy);
  if (empty) make_empty(body);
  body.map(frame);
  auto numbers = written(body, dimension, any_placement(bits_of(body), false, entropy));
  if (!numbers) numbers = written(body, dimension, {});
  const auto d = static_cast<std::ptrdiff_t>(dimension);
  if (empty && kind == ShapeKind::aabb) std::swap_ranges(numbers->begin(), numbers->begin() + d, numbers->begin() + d);
  if (empty && kind == ShapeKind::slab) std::swap(numbers->end()[-1], numbers->end()[-2]);
  return std::move(*numbers);
}

std::size_t shape_size(ShapeKind kind, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  switch (kind) {
    case ShapeKind::point:
      return d;
    case ShapeKind::line:
    case ShapeKind::ray:
    case ShapeKind::segment:
    case ShapeKind::aabb:
      return 2 * d;
    case ShapeKind::slab:
      return d + 2;
    case ShapeKind::k_dop:
      return 2 * k_dop_normals(dimension).size();
    case ShapeKind::plane:
    case ShapeKind::halfspace:
    case ShapeKind::ball:
      return d + 1;
    case ShapeKind::triangle:
    case ShapeKind::three_point_plane:
      return 3 * d;
    case ShapeKind::tetrahedron:
    case ShapeKind::quadrilateral:
      return 4 * d;
    case ShapeKind::rectangle:
      return 3 * d + 2;
    case ShapeKind::obb:
    case ShapeKind::ellipsoid:
      return d * d + 2 * d;
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone:
      return 2 * d + 1;
    case ShapeKind::lozenge:
      return 3 * d + 1;
    case ShapeKind::polygon:
    case ShapeKind::holed_polygon:
    case ShapeKind::points:
    case ShapeKind::halfspaces:
    case ShapeKind::mesh:
      break;
  }
  return 0;
}

}  // namespace plumb::degenerate
