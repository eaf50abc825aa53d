#include "lab/crowd/crowds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plumb/degenerate/coordinates.hpp"

namespace plumb::lab::trial {
namespace {

constexpr double far_from_origin = 0x1p20;
constexpr std::uint64_t spreads = 8;
constexpr std::size_t lattice_side = 8;  // of crowd_size boxes

/// By coordinates that stand on each axis: of what was made, or of both corners.
Point3 on_axes(const MeshKey& key, const Point3& p) {
  const std::array<double, 3> made{p.x, p.y, p.z};
  return {made[static_cast<std::size_t>(key[1])], made[static_cast<std::size_t>(key[2])],
          made[static_cast<std::size_t>(key[3])]};
}

Point3 in_unit_cube(Entropy& e) {
  const double x = unit_coordinate(e), y = unit_coordinate(e), z = unit_coordinate(e);
  return {x, y, z};
}

/// About a middle, denser towards it.
Point3 in_cluster(Entropy& e, const Point3& middle) {
  const Point3 p = in_unit_cube(e), q = in_unit_cube(e);
  constexpr double spread = 0.1;
  return {middle.x + spread * (p.x - q.x), middle.y + spread * (p.y - q.y), middle.z + spread * (p.z - q.z)};
}

std::array<Point3, 8> cluster_middles(Entropy& e) {
  std::array<Point3, 8> middles;
  for (Point3& m : middles) m = in_unit_cube(e);
  return middles;
}

Aabb3 box_from(Entropy& e, const Point3& p, double length) {
  const Point3 part = in_unit_cube(e);
  return {p, {p.x + length * (0.5 + part.x), p.y + length * (0.5 + part.y), p.z + length * (0.5 + part.z)}};
}

double nudged_by_ulp(Entropy& e, double x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::int64_t way = e.within(1);
  return way == 0 ? x : std::nextafter(x, way > 0 ? infinity : -infinity);
}

Aabb3 box_of(Spread spread, std::size_t i, Entropy& e, const std::array<Point3, 8>& middles) {
  const double length = std::cbrt(2 / static_cast<double>(crowd_size));
  switch (spread) {
    case Spread::clustered:
      return box_from(e, in_cluster(e, middles[e.below(8)]), length / 3);
    case Spread::sizes: {
      const Point3 p = in_unit_cube(e);
      const double edge = std::pow(1000.0, unit_coordinate(e)), side = 1700;
      return box_from(e, {side * p.x, side * p.y, side * p.z}, edge);
    }
    case Spread::touching:
    case Spread::nudged: {
      const auto wall = [](std::size_t k) { return 0.1 * static_cast<double>(k); };
      const std::size_t x = i % lattice_side, y = i / lattice_side % lattice_side, z = i / lattice_side / lattice_side;
      Aabb3 box{{wall(x), wall(y), wall(z)}, {wall(x + 1), wall(y + 1), wall(z + 1)}};
      if (spread == Spread::touching) return box;
      for (double* side : {&box.min.x, &box.min.y, &box.min.z, &box.max.x, &box.max.y, &box.max.z})
        *side = nudged_by_ulp(e, *side);
      return box;
    }
    case Spread::degenerate: {
      const auto place = [&e] { return static_cast<double>(e.below(12)); };
      const auto edge = [&e] { return static_cast<double>(e.below(2)); };
      const double x = place(), y = place(), z = place(), u = edge(), v = edge(), w = edge();
      return {{x, y, z}, {x + u, y + v, z + w}};
    }
    case Spread::far: {
      const Point3 p = in_unit_cube(e);
      return box_from(e, {far_from_origin + p.x, far_from_origin + p.y, far_from_origin + p.z}, length);
    }
    default:
      return box_from(e, in_unit_cube(e), length);
  }
}

Point3 point_of(Spread spread, Entropy& e, const std::array<Point3, 8>& middles) {
  const auto integer = [&e](std::int64_t most) { return static_cast<double>(e.within(most)); };
  Point3 p = in_unit_cube(e);
  switch (spread) {
    case Spread::clustered:
      p = in_cluster(e, middles[e.below(8)]);
      break;
    case Spread::touching:
    case Spread::degenerate: {
      const std::int64_t most = spread == Spread::touching ? 5 : 2;
      const double x = integer(most), y = integer(most), z = integer(most);
      return {x, y, z};
    }
    case Spread::sphere: {
      const Point3 from{p.x - 0.5, p.y - 0.5, p.z - 0.5};
      const double r = std::sqrt(from.x * from.x + from.y * from.y + from.z * from.z);
      p = r > 0 ? Point3{from.x / r, from.y / r, from.z / r} : Point3{1, 0, 0};
      break;
    }
    case Spread::far:
      p = {far_from_origin + p.x, far_from_origin + p.y, far_from_origin + p.z};
      break;
    default:
      break;
  }
  return {rounded_to(p.x, 50), rounded_to(p.y, 50), rounded_to(p.z, 50)};
}

struct CrowdName {
  Spread spread;
  Entropy dice;
};
CrowdName crowd_named(double name) {
  const auto number = static_cast<std::uint64_t>(name);
  return {static_cast<Spread>(number % spreads), Entropy(7, number)};
}

}  // namespace

double crowd_name(Spread spread, std::uint64_t dice) {
  return static_cast<double>(spreads * dice + static_cast<std::uint64_t>(spread));
}

std::vector<Aabb3> box_crowd(const MeshKey& key) {
  auto [spread, dice] = crowd_named(key[0]);
  const std::array<Point3, 8> middles = cluster_middles(dice);
  std::vector<Aabb3> boxes;
  for (std::size_t i = 0; i < crowd_size; ++i) {
    const auto [min, max] = box_of(spread, i, dice, middles);
    boxes.push_back({on_axes(key, min), on_axes(key, max)});
  }
  return boxes;
}

std::vector<Point3> point_crowd(const MeshKey& key) {
  auto [spread, dice] = crowd_named(key[0]);
  const std::array<Point3, 8> middles = cluster_middles(dice);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < 2 * crowd_size; ++i) points.push_back(on_axes(key, point_of(spread, dice, middles)));
  return points;
}

Method of_box_crowds(std::string name, std::string about, std::function<FindPairs(const std::vector<Aabb3>&)> make) {
  return {std::move(name), std::move(about), [make](std::span<const double> questions, const Scene&) {
            std::vector<FindPairs> all;
            for (std::size_t i = 0; i < questions.size(); i += box_crowd_numbers)
              all.push_back(make(box_crowd(key_of(questions.subspan(i, box_crowd_numbers)))));
            return one_by_one(std::move(all), [](const FindPairs& find) { return find(); });
          }};
}

Method of_point_crowds(std::string name, std::string about,
                       std::function<FindNearest(const std::vector<Point3>&)> make) {
  return {std::move(name), std::move(about), [make](std::span<const double> questions, const Scene&) {
            struct Question {
              std::shared_ptr<const FindNearest> find;
              Point3 place;
            };
            std::map<MeshKey, std::shared_ptr<const FindNearest>> made;
            std::vector<Question> all;
            for (std::size_t i = 0; i < questions.size(); i += place_numbers) {
              const auto q = questions.subspan(i, place_numbers);
              auto& find = made[key_of(q)];
              if (!find) find = std::make_shared<const FindNearest>(make(point_crowd(key_of(q))));
              all.push_back({find, place_in(q)});
            }
            return one_by_one(std::move(all),
                              [](const Question& q) { return static_cast<double>((*q.find)(q.place)); });
          }};
}

std::uint64_t count_lacking(Pairs from, Pairs without) {
  std::ranges::sort(from);
  std::ranges::sort(without);
  Pairs rest;
  std::ranges::set_difference(from, without, std::back_inserter(rest));
  return rest.size();
}

}  // namespace plumb::lab::trial
