#include "lab/trial/mesh_scenes.hpp"

#include <cmath>
#include <numbers>

#include "plumb/degenerate/entropy.hpp"

namespace plumb::lab::trial {
namespace {

Point3 image_of(const Pose& pose, const Point3& p) {
  const auto& [u, v, w] = pose.columns;
  const Vector3& t = pose.translation;
  return {u.x * p.x + v.x * p.y + w.x * p.z + t.x, u.y * p.x + v.y * p.y + w.y * p.z + t.y,
          u.z * p.x + v.z * p.y + w.z * p.z + t.z};
}

/// The turn of an integer quaternion: every number is one quotient, the same on all machines.
constexpr Pose turn_of(double w, double x, double y, double z) {
  const double n = w * w + x * x + y * y + z * z;
  return {{{{(w * w + x * x - y * y - z * z) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n},
            {2 * (x * y - w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z + w * x) / n},
            {2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (w * w - x * x - y * y + z * z) / n}}},
          {0, 0, 0}};
}

double integer(Entropy& dice, std::int64_t most) { return static_cast<double>(dice.within(most)); }

void round_to(TriangleMesh& mesh, int bits) {
  for (Point3& p : mesh.vertices) p = {rounded_to(p.x, bits), rounded_to(p.y, bits), rounded_to(p.z, bits)};
}

/// A closed wavy ring of 4 n^2 triangles; multiples of 2^-11, so that the middle of an edge is a float as well.
TriangleMesh wavy_ring(std::uint32_t n) {
  TriangleMesh mesh;
  const std::uint32_t around = 2 * n;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * k / around;
      const double r = 1 + 0.4 * std::cos(u) + 0.05 * std::sin(5 * u) * std::cos(7 * v);
      mesh.vertices.push_back({r * std::cos(v), r * std::sin(v), 0.4 * std::sin(u)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) { return i % n * around + k % around; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      mesh.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  round_to(mesh, 11);
  return mesh;
}

TriangleMesh three_shells() {
  const TriangleMesh one = wavy_ring(24);
  TriangleMesh mesh;
  for (const double above : {0.0, 0x1p-20, 0x1p-50}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Point3& p : one.vertices) mesh.vertices.push_back({p.x, p.y, p.z + above});
    for (const auto& [a, b, c] : one.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
  }
  return mesh;
}

/// The surface of the cube from 0 to n, each side of n x n squares that share their corners.
TriangleMesh cube_of_squares(std::uint32_t n) {
  TriangleMesh mesh;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers;
  const auto corner = [&](const std::array<std::uint32_t, 3>& c) {
    const auto [at, is_new] = numbers.emplace(c, static_cast<std::uint32_t>(numbers.size()));
    if (is_new) mesh.vertices.push_back({1.0 * c[0], 1.0 * c[1], 1.0 * c[2]});
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const std::uint32_t side : {0U, n}) {
      for (std::uint32_t i = 0; i < n * n; ++i) {
        const auto at = [&](std::uint32_t du, std::uint32_t dv) {
          std::array<std::uint32_t, 3> c{};
          c[axis] = side;
          c[(axis + 1) % 3] = i % n + du;
          c[(axis + 2) % 3] = i / n + dv;
          return corner(c);
        };
        const std::array square{at(0, 0), side == 0 ? at(0, 1) : at(1, 0), at(1, 1), side == 0 ? at(1, 0) : at(0, 1)};
        mesh.triangles.push_back({square[0], square[1], square[2]});
        mesh.triangles.push_back({square[0], square[2], square[3]});
      }
    }
  }
  return mesh;
}

/// Every eighth is a segment, and some of those a point.
TriangleMesh integers(Entropy& dice, std::uint32_t triangles) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const Point3 at{integer(dice, 4), integer(dice, 4), integer(dice, 4)};
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back({at.x + integer(dice, 2), at.y + integer(dice, 2), at.z + integer(dice, 2)});
    const std::uint32_t first = 3 * i, last = i % 8 == 7 ? (i % 64 == 63 ? first : first + 1) : first + 2;
    mesh.triangles.push_back({first, i % 64 == 63 ? first : first + 1, last});
  }
  return mesh;
}

TriangleMesh made(Surface surface, Entropy& dice) {
  switch (surface) {
    case Surface::ring:
      return wavy_ring(40);
    case Surface::band:
      return wavy_ring(16);
    case Surface::loop:
      return wavy_ring(8);
    case Surface::shells:
      return three_shells();
    case Surface::blocks:
      return cube_of_squares(5);
    case Surface::die:
      return cube_of_squares(3);
    case Surface::heap:
      return integers(dice, 2000);
    case Surface::pile:
      break;
  }
  return integers(dice, 200);
}

void move(TriangleMesh& mesh, const Vector3& by) {
  for (Point3& p : mesh.vertices) p = {p.x + by.x, p.y + by.y, p.z + by.z};
}

constexpr double surfaces = 8, moves = 64;

}  // namespace

const Pose common_turn = turn_of(3, 1, 2, -1);

double rounded_to(double x, int bits) { return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits); }

Point3 turned_point(const Point3& p) {
  const Point3 q = image_of(common_turn, p);
  return {rounded_to(q.x, 50), rounded_to(q.y, 50), rounded_to(q.z, 50)};
}

TriangleMesh rounded_image(TriangleMesh mesh, const Pose& pose) {
  for (Point3& p : mesh.vertices) p = image_of(pose, p);
  return mesh;
}

double mesh_name(Surface surface, const Moved& m, std::uint64_t dice) {
  const std::array flags{m.turned_at_random, m.stepped, m.aside, m.nudged, m.turned, m.far};
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) bits |= std::uint64_t{flags[i]} << i;
  return static_cast<double>(surface) +
         surfaces * (static_cast<double>(bits) + moves * static_cast<double>(dice & 0xffffffff));
}

TriangleMesh mesh_of(const MeshKey& key) {
  const auto name = static_cast<std::uint64_t>(key[0]);
  const std::uint64_t bits = name / 8 % 64;
  const auto is = [bits](int i) { return (bits >> i & 1) != 0; };
  Entropy dice(2026, name / 512);
  TriangleMesh mesh = made(static_cast<Surface>(name % 8), dice);
  if (is(0)) {
    Pose pose = turn_of(1 + static_cast<double>(dice.below(9)), integer(dice, 9), integer(dice, 9), integer(dice, 9));
    pose.translation = {integer(dice, 99) / 100, integer(dice, 99) / 100, integer(dice, 99) / 100};
    mesh = rounded_image(std::move(mesh), pose);
    round_to(mesh, 20);
  }
  if (is(1)) move(mesh, {integer(dice, 6), integer(dice, 6), integer(dice, 6)});
  if (is(2)) move(mesh, {5 + static_cast<double>(dice.below(4)), integer(dice, 2), integer(dice, 2)});
  if (is(3)) move(mesh, {0x1p-48 * integer(dice, 1), 0x1p-48 * integer(dice, 1), 0x1p-48 * integer(dice, 1)});
  if (is(4)) {
    for (Point3& p : mesh.vertices) p = turned_point(p);
  }
  if (is(5)) move(mesh, {0x1p20, 0x1p20, 0x1p20});
  for (Point3& p : mesh.vertices) {
    const std::array<double, 3> of{p.x, p.y, p.z};
    p = {of[static_cast<std::size_t>(key[1])], of[static_cast<std::size_t>(key[2])],
         of[static_cast<std::size_t>(key[3])]};
  }
  return mesh;
}

const TriangleMesh& MeshShelf::operator()(double name) {
  const auto at = made_.find(name);
  return at != made_.end() ? at->second : made_.emplace(name, mesh_of({name, 0, 1, 2})).first->second;
}

}  // namespace plumb::lab::trial
