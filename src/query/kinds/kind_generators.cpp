#include "query/kinds/kind_generators.hpp"

#include <algorithm>
#include <cmath>

#include "degenerate/families_of_cases.hpp"
#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace plumb::degenerate {

namespace {

// Axes that are perpendicular and of length one, as well as doubles can: a random quaternion's.
void fill_frame(std::span<double> nine, Entropy& entropy) {
  double w = signed_unit_coordinate(entropy), x = signed_unit_coordinate(entropy);
  double y = signed_unit_coordinate(entropy), z = signed_unit_coordinate(entropy);
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  for (double* const c : {&w, &x, &y, &z}) *c = length == 0 ? 0 : *c / length;
  const std::array rotation{1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                            2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                            2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
  std::ranges::copy(rotation, nine.begin());
}

void fill_along_coordinates(std::span<double> nine, Entropy& entropy) {
  std::ranges::fill(nine, 0.0);
  const std::size_t turn = entropy.below(3);
  for (std::size_t k = 0; k < 3; ++k) nine[3 * k + (k + turn) % 3] = entropy.coin() ? -1 : 1;
}

constexpr std::size_t box_numbers = 15, frame_at = 3, half_at = 12;

// The frames of both boxes; those of the second the same as the first's, or others.
void fill_frames(std::span<double> boxes, Entropy& entropy) {
  const std::span<double> a = boxes.subspan(frame_at, 9), b = boxes.subspan(box_numbers + frame_at, 9);
  const auto fill = [&](std::span<double> nine) {
    entropy.coin() ? fill_frame(nine, entropy) : fill_along_coordinates(nine, entropy);
  };
  fill(a);
  switch (entropy.below(3)) {
    case 0:
      std::ranges::copy(a, b.begin());
      break;
    case 1: {  // one axis off by ulps: edges that are nearly parallel
      std::ranges::copy(a, b.begin());
      double& x = b[entropy.below(9)];
      constexpr double ulp = 0x1p-53;  // a power of two: of numbers from a half to 1
      x += static_cast<double>(entropy.within(8)) * ulp;
      break;
    }
    default:
      fill(b);
      break;
  }
}

}  // namespace

void append_counted(Numbers& numbers, std::span<const double> coordinates, std::size_t dimension) {
  numbers.push_back(static_cast<double>(coordinates.size() / dimension));
  numbers.insert(numbers.end(), coordinates.begin(), coordinates.end());
}

void aim_at_second(std::span<double> ray) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double way = ray[3 + axis] - ray[axis];
    if (std::isfinite(way)) ray[3 + axis] = way;
  }
}

std::vector<Generator> family_generators(Degeneracy aim, int dimension, Arrange arrange) {
  return families_of_cases(aim, [=](Numbers& numbers, Entropy& entropy, const FillOf& fill) {
    arrange(numbers, entropy, [&](std::span<double> c, Entropy& choices) { fill(dimension, c, choices); });
  });
}

void arrange_boxes(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  numbers.resize(12);
  fill(numbers, entropy);
  for (const std::size_t box : {0u, 6u}) {
    for (std::size_t k = box; k < box + 3; ++k) {
      if (numbers[k] > numbers[k + 3]) std::swap(numbers[k], numbers[k + 3]);
    }
  }
}

void arrange_ray(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  numbers.resize(15);
  fill(numbers, entropy);
  aim_at_second(numbers);
}

void arrange_oriented_boxes(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  std::array<double, 12> given{};  // center and half extents of either
  fill(given, entropy);
  numbers.resize(2 * box_numbers);
  for (std::size_t box = 0; box < 2; ++box) {
    for (std::size_t k = 0; k < 3; ++k) {
      numbers[box * box_numbers + k] = given[6 * box + k];
      numbers[box * box_numbers + half_at + k] = std::fabs(given[6 * box + 3 + k]);
    }
  }
  fill_frames(numbers, entropy);
}

void arrange_polygon(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  std::vector<double> points(2 * (4 + entropy.below(8)));
  fill(points, entropy);
  numbers.assign(points.begin(), points.begin() + 2);
  append_counted(numbers, std::span(points).subspan(2), 2);
}

void arrange_point_sets(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  const std::size_t first = 3 * (1 + entropy.below(8));
  std::vector<double> points(first + 3 * (1 + entropy.below(8)));
  fill(points, entropy);
  numbers.clear();
  append_counted(numbers, std::span(points).first(first), 3);
  append_counted(numbers, std::span(points).subspan(first), 3);
}

void arrange_cloud(Numbers& numbers, Entropy& entropy, const Fill& fill) {
  std::vector<double> points(3 * (4 + entropy.below(13)));
  fill(points, entropy);
  numbers.clear();
  append_counted(numbers, points, 3);
}

std::vector<Generator> position_generators(ShapeKind a, ShapeKind b, int dimension, Join join) {
  std::vector<Generator> all;
  for (const PositionInfo& info : positions) {
    if (!has_position(a, b, dimension, info.position)) continue;
    all.push_back({std::string(info.name), std::string(info.about),
                   [=, position = info.position](Numbers& numbers, Entropy& entropy) {
                     const Nearness nearness = entropy.coin() ? Nearness::nearly : Nearness::exactly;
                     numbers.clear();
                     join(numbers, shape_pair(a, b, dimension, position, nearness, entropy));
                   }});
  }
  return all;
}

void join_plainly(Numbers& numbers, const ShapePair& pair) {
  numbers = pair.a;
  numbers.insert(numbers.end(), pair.b.begin(), pair.b.end());
}

void join_point_and_polygon(Numbers& numbers, const ShapePair& pair) {
  numbers = pair.a;
  append_counted(numbers, pair.b, 2);
}

void join_point_sets(Numbers& numbers, const ShapePair& pair) {
  append_counted(numbers, pair.a, 3);
  append_counted(numbers, pair.b, 3);
}

void join_oriented_boxes(Numbers& numbers, const ShapePair& pair) {
  join_plainly(numbers, pair);
  for (std::size_t box = 0; box < 2; ++box) {
    for (std::size_t i = 0; i < 3; ++i) {
      double* const axis = &numbers[box * box_numbers + frame_at + 3 * i];
      const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
      if (!(length > 0) || !std::isfinite(length)) continue;
      for (std::size_t k = 0; k < 3; ++k) axis[k] /= length;
      numbers[box * box_numbers + half_at + i] *= length;
    }
  }
}

Generator boundary_points() {
  return {"boundary", "even integers, the point on a vertex, in the middle of an edge, or at a vertex's height",
          [](Numbers& numbers, Entropy& entropy) {
            std::vector<double> vertices(2 * (3 + entropy.below(8)));
            for (double& x : vertices) x = static_cast<double>(2 * entropy.within(4));
            const std::size_t n = vertices.size() / 2, i = entropy.below(n), j = (i + 1) % n;
            numbers = {vertices[2 * i], vertices[2 * i + 1]};
            switch (entropy.below(4)) {
              case 0:
                break;
              case 1:
                for (std::size_t k = 0; k < 2; ++k) numbers[k] = (vertices[2 * i + k] + vertices[2 * j + k]) / 2;
                break;
              default:
                numbers[0] = static_cast<double>(entropy.within(9));
                break;
            }
            append_counted(numbers, vertices, 2);
          }};
}

Generator stacked_boxes() {
  return {"stacked", "of the same axes, the second moved along one until it touches, but for rounding",
          [](Numbers& numbers, Entropy& entropy) {
            const Fill uniform = [](std::span<double> c, Entropy& e) {
              for (double& x : c) x = signed_unit_coordinate(e);
            };
            arrange_oriented_boxes(numbers, entropy, uniform);
            const auto at = [&](std::size_t i) -> double& { return numbers[box_numbers + i]; };
            for (std::size_t i = frame_at; i < frame_at + 9; ++i) at(i) = numbers[i];
            const std::size_t axis = entropy.below(3);
            const double reach = numbers[half_at + axis] + at(half_at + axis);
            for (std::size_t k = 0; k < 3; ++k) at(k) = numbers[k] + numbers[frame_at + 3 * axis + k] * reach;
          }};
}

std::vector<Generator> cloud_generators() {
  std::vector<Generator> all;
  for (const CloudInfo& info : clouds) {
    all.push_back(
        {std::string(info.name), std::string(info.about), [cloud = info.cloud](Numbers& numbers, Entropy& entropy) {
           std::vector<double> points;
           for (const Point3& p : cloud3(cloud, 4 + entropy.below(21), entropy)) {
             points.insert(points.end(), {p.x, p.y, p.z});
           }
           numbers.clear();
           append_counted(numbers, points, 3);
         }});
  }
  return all;
}

}  // namespace plumb::degenerate
