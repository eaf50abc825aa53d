#include "plumb/degenerate/shape.hpp"

#include <utility>

#include "degenerate/body_frame.hpp"

namespace plumb::degenerate {

Form any_form(Entropy& entropy) { return entropy.coin() ? forms[entropy.below(forms.size())].form : Form::plain; }

std::vector<double> shape(ShapeKind kind, int dimension, Form form, Entropy& entropy) {
  if (!is_kind_of(kind, dimension)) return {};
  std::vector<int> features;
  for (int f = 0; f < dimension; ++f) {
    if (((features_of(kind, dimension) >> f) & 1) != 0) features.push_back(f);
  }
  const int feature = features[entropy.below(features.size())];
  const IntMap frame =
      frame_of({dimension, is_rigid(kind), kind == ShapeKind::aabb, kind == ShapeKind::points, feature}, entropy);
  BodyOrder order{.kind = kind, .dimension = dimension, .feature = feature};
  order.extent = extent_of(form, static_cast<int>(entropy.below(10)), entropy);
  order.axes = aabb_axes(frame, false);
  Body body = body_of(order, entropy);
  body.map(frame);
  auto numbers = written(body, dimension, any_placement(bits_of(body), false, entropy));
  if (!numbers) numbers = written(body, dimension, {});
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
    case ShapeKind::plane:
    case ShapeKind::halfspace:
    case ShapeKind::ball:
      return d + 1;
    case ShapeKind::triangle:
      return 3 * d;
    case ShapeKind::tetrahedron:
      return 4 * d;
    case ShapeKind::rectangle:
      return 3 * d + 2;
    case ShapeKind::obb:
      return d * d + 2 * d;
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone:
      return 2 * d + 1;
    case ShapeKind::lozenge:
      return 3 * d + 1;
    case ShapeKind::polygon:
    case ShapeKind::points:
      break;
  }
  return 0;
}

}  // namespace plumb::degenerate
