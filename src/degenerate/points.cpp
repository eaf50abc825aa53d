#include "plumb/degenerate/points.hpp"

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/moves.hpp"

namespace plumb {

namespace {

using CoordinateSpan = std::span<double>;

template <class Make>
void fill_each(CoordinateSpan coordinates, const Make& make) {
  for (double& x : coordinates) x = make();
}

void fill_exact_short(Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  const int bits = least_exact_bits + static_cast<int>(entropy.below(15));
  fill_exact(degeneracy, dimension, bits, coordinates, entropy);
}

void fill_exact_any(Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  entropy.coin() ? fill_exact_long(degeneracy, dimension, coordinates, entropy)
                 : fill_exact_short(degeneracy, dimension, coordinates, entropy);
}

void fill_grid(CoordinateSpan coordinates, Entropy& entropy) {
  const int bits = 1 + static_cast<int>(entropy.below(20));
  fill_each(coordinates, [&] { return grid_coordinate(entropy, bits); });
}

void fill_uniform(CoordinateSpan coordinates, Entropy& entropy) {
  if (entropy.coin()) {
    fill_each(coordinates, [&] { return signed_unit_coordinate(entropy); });
  } else {
    fill_each(coordinates, [&] { return unit_coordinate(entropy); });
  }
}

// Neighbors of (1/2, 1/2), and far points of the diagonal such as (12, 12) and (24, 24), which all but line up.
void fill_near_half(int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  const std::int64_t most = std::int64_t{4} << entropy.below(7);
  for (std::size_t first = 0; first + stride <= coordinates.size(); first += stride) {
    const CoordinateSpan point = coordinates.subspan(first, stride);
    if (entropy.below(4) == 3) {
      const auto far = static_cast<double>(entropy.below(32));
      fill_each(point, [&] { return far; });
    } else {
      fill_each(point, [&] { return near_half_coordinate(entropy, most); });
    }
  }
}

void fill_wide(Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  if (entropy.below(2) == 0) return fill_each(coordinates, [&] { return wide_coordinate(entropy); });
  fill_exact_long(degeneracy, dimension, coordinates, entropy);
  if (!is_flat(degeneracy)) return;
  const auto stride = static_cast<std::size_t>(dimension);
  for (std::size_t axis = 0; axis < stride; ++axis) {  // flats stay flat when an axis is scaled
    const std::int64_t exponent = entropy.within(40);
    const double power = exponent < 0 ? 1 / static_cast<double>(std::int64_t{1} << -exponent)
                                      : static_cast<double>(std::int64_t{1} << exponent);
    for (std::size_t i = axis; i < coordinates.size(); i += stride) coordinates[i] *= power;
  }
}

void fill_extreme(Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  const std::uint64_t kind = entropy.below(4);
  if (kind == 0) return fill_each(coordinates, [&] { return extreme_coordinate(entropy); });
  fill_exact_any(degeneracy, dimension, coordinates, entropy);
  if (kind == 2 && is_flat(degeneracy)) {
    scale_axes_exactly(coordinates, dimension, entropy);
  } else {
    scale_exactly(coordinates, entropy);
  }
  if (kind == 3) move_by_ulps(coordinates, 2, 4, entropy);
}

void fill_repeated(Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  switch (entropy.below(4)) {
    case 0:
      fill_grid(coordinates, entropy);
      break;
    case 1:
      fill_uniform(coordinates, entropy);
      break;
    case 2:
      fill_exact_any(degeneracy, dimension, coordinates, entropy);
      break;
    default:
      fill_each(coordinates, [&] { return extreme_coordinate(entropy); });
      break;
  }
  repeat_points(coordinates, dimension, entropy);
}

CoordinateClass any_class(Entropy& entropy) {
  return static_cast<CoordinateClass>(entropy.below(coordinate_class_count));
}

void fill_mixture(Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  const auto stride = static_cast<std::size_t>(dimension);
  const auto fill_point = [&](std::size_t first) {
    const CoordinateClass which = any_class(entropy);
    fill_each(coordinates.subspan(first, stride), [&] { return coordinate_of(which, entropy); });
  };
  switch (entropy.below(4)) {
    case 0:  // every point of a class of its own
      for (std::size_t first = 0; first + stride <= coordinates.size(); first += stride) fill_point(first);
      break;
    case 1:  // every coordinate of a class of its own
      fill_each(coordinates, [&] { return coordinate_of(any_class(entropy), entropy); });
      break;
    case 2:  // degenerate but for one point
      fill_exact_any(degeneracy, dimension, coordinates, entropy);
      if (coordinates.size() >= stride) fill_point(entropy.below(coordinates.size() / stride) * stride);
      break;
    default:  // degenerate, then any of the moves
      fill_exact_any(degeneracy, dimension, coordinates, entropy);
      if (entropy.coin()) repeat_points(coordinates, dimension, entropy);
      if (entropy.coin()) scale_exactly(coordinates, entropy);
      if (entropy.coin()) move_by_ulps(coordinates, 4, 2, entropy);
      permute_axes(coordinates, dimension, entropy);
      permute_points(coordinates, dimension, entropy);
      break;
  }
}

}  // namespace

void fill_points(Family family, Degeneracy degeneracy, int dimension, CoordinateSpan coordinates, Entropy& entropy) {
  switch (family) {
    case Family::grid:
      return fill_grid(coordinates, entropy);
    case Family::uniform:
      return fill_uniform(coordinates, entropy);
    case Family::float32:
      return fill_each(coordinates, [&] { return float32_coordinate(entropy); });
    case Family::near_half:
      return fill_near_half(dimension, coordinates, entropy);
    case Family::degenerate_short:
      return fill_exact_short(degeneracy, dimension, coordinates, entropy);
    case Family::degenerate_long:
      return fill_exact_long(degeneracy, dimension, coordinates, entropy);
    case Family::off_by_ulps:
      fill_exact_any(degeneracy, dimension, coordinates, entropy);
      return move_by_ulps(coordinates, 3, 4, entropy);
    case Family::repeated:
      return fill_repeated(degeneracy, dimension, coordinates, entropy);
    case Family::wide:
      return fill_wide(degeneracy, dimension, coordinates, entropy);
    case Family::extreme:
      return fill_extreme(degeneracy, dimension, coordinates, entropy);
    case Family::mixture:
      break;
  }
  fill_mixture(degeneracy, dimension, coordinates, entropy);
}

std::vector<Point2> points2(Family family, Degeneracy degeneracy, std::size_t count, Entropy& entropy) {
  std::vector<double> coordinates(2 * count);
  fill_points(family, degeneracy, 2, coordinates, entropy);
  std::vector<Point2> points(count);
  for (std::size_t i = 0; i < count; ++i) points[i] = {coordinates[2 * i], coordinates[2 * i + 1]};
  return points;
}

std::vector<Point3> points3(Family family, Degeneracy degeneracy, std::size_t count, Entropy& entropy) {
  std::vector<double> coordinates(3 * count);
  fill_points(family, degeneracy, 3, coordinates, entropy);
  std::vector<Point3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  }
  return points;
}

}  // namespace plumb
