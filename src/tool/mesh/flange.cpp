#include "tool/mesh/flange.hpp"

#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace plumb::tool {
namespace {

struct Direction {
  double c, s;
};

constexpr int kAround = 64;  // segments of a circle about the axis
constexpr int kSectors = 8;  // one bolt hole each
constexpr int kHole = 24;    // segments of a hole; also of the boundary of a sector
constexpr int kRadial = 4;   // segments of a sector's straight sides
constexpr int kArc = kAround / kSectors;
static_assert(2 * kArc + 2 * kRadial == kHole, "a hole and its sector's boundary are joined vertex by vertex");

constexpr double kLattice = 1024;

double snap(double x) { return std::floor(x * kLattice + 0.5) / kLattice; }

Direction halfway(Direction a, Direction b) {
  const double c = a.c + b.c, s = a.s + b.s, length = std::sqrt(c * c + s * s);
  return {c / length, s / length};
}

Direction turned(Direction a, Direction b) { return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s}; }

/// The n directions of a full turn from (1, 0); n is 4 or 12 times a power of two.  Bisection needs sqrt alone.
std::vector<Direction> full_turn(int n) {
  std::vector<Direction> quarter{{1, 0}};
  if (n % 3 == 0) {
    const double half_root3 = std::sqrt(3.0) / 2;
    quarter.insert(quarter.end(), {{half_root3, 0.5}, {0.5, half_root3}});
  }
  while (quarter.size() * 4 < static_cast<std::size_t>(n)) {
    std::vector<Direction> finer;
    for (std::size_t i = 0; i < quarter.size(); ++i) {
      const Direction next = i + 1 < quarter.size() ? quarter[i + 1] : Direction{0, 1};
      finer.insert(finer.end(), {quarter[i], halfway(quarter[i], next)});
    }
    quarter = std::move(finer);
  }
  std::vector<Direction> all = quarter;
  for (std::size_t i = 0; all.size() < static_cast<std::size_t>(n); ++i) all.push_back({-all[i].s, all[i].c});
  return all;
}

class Builder {
 public:
  Flange flange;

  std::uint32_t vertex(double x, double y, double z) {
    const auto [at, added] =
        index_.try_emplace({snap(x), snap(y), snap(z)}, static_cast<std::uint32_t>(flange.mesh.vertices.size()));
    if (added) flange.mesh.vertices.push_back({snap(x), snap(y), snap(z)});
    return at->second;
  }

  [[nodiscard]] std::uint32_t faces() const { return static_cast<std::uint32_t>(flange.mesh.triangles.size()); }

  std::uint32_t on_axis_circle(double r, double z, int i) {
    const Direction d = around_[static_cast<std::size_t>((i + kAround) % kAround)];
    return vertex(r * d.c, r * d.s, z);
  }

  Ring circle(double r, double z) {
    Ring ring;
    for (int i = 0; i < kAround; ++i) ring.push_back(on_axis_circle(r, z, i));
    return ring;
  }

  /// The circle of a hole, from its outermost point on.
  Ring hole(int sector, double at, double r, double z) {
    const Direction d = around_[static_cast<std::size_t>(sector * kArc)];
    Ring ring;
    for (const Direction& h : hole_) {
      const Direction t = turned(d, h);
      ring.push_back(vertex(at * d.c + r * t.c, at * d.s + r * t.s, z));
    }
    return ring;
  }

  /// The boundary of a sector of the flat annulus at height z, from the middle of its outer arc on.
  Ring sector(int k, double outer, double inner, double z) {
    Ring ring;
    const int middle = k * kArc, left = middle + kArc / 2, right = middle - kArc / 2;
    for (int i = middle; i < left; ++i) ring.push_back(on_axis_circle(outer, z, i));
    for (int j = 0; j < kRadial; ++j) ring.push_back(on_axis_circle(between(outer, inner, j), z, left));
    for (int i = left; i > right; --i) ring.push_back(on_axis_circle(inner, z, i));
    for (int j = kRadial; j > 0; --j) ring.push_back(on_axis_circle(between(outer, inner, j), z, right));
    for (int i = right; i < middle; ++i) ring.push_back(on_axis_circle(outer, z, i));
    return ring;
  }

  /// Joins two loops; walking from the first to the second along the surface, the outside is on the left of the walk
  /// drawn as a profile that climbs the rim and runs inward over the top.
  void strip(const Ring& from, const Ring& to) {
    for (std::size_t i = 0, n = from.size(); i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      flange.mesh.triangles.push_back({from[i], from[j], to[j]});
      flange.mesh.triangles.push_back({from[i], to[j], to[i]});
    }
  }

  void fan(const Ring& ring, std::uint32_t center) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      flange.mesh.triangles.push_back({ring[i], ring[(i + 1) % ring.size()], center});
    }
  }

  /// A sector of an annulus without a hole; `up` tells which way it faces.
  void plain_sector(int k, double outer, double inner, double z) {
    for (int i = k * kArc - kArc / 2; i < k * kArc + kArc / 2; ++i) {
      for (int j = 0; j < kRadial; ++j) {
        const double r = between(outer, inner, j), s = between(outer, inner, j + 1);
        const std::uint32_t a = on_axis_circle(r, z, i), b = on_axis_circle(r, z, i + 1);
        const std::uint32_t c = on_axis_circle(s, z, i + 1), d = on_axis_circle(s, z, i);
        flange.mesh.triangles.push_back({a, b, c});
        flange.mesh.triangles.push_back({a, c, d});
      }
    }
  }

  /// The loop at fraction f of the way between two flat loops.
  Ring blend(const Ring& a, const Ring& b, double f) {
    Ring ring;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Point3 p = flange.mesh.vertices[a[i]], q = flange.mesh.vertices[b[i]];
      ring.push_back(vertex(p.x + f * (q.x - p.x), p.y + f * (q.y - p.y), p.z));
    }
    return ring;
  }

 private:
  static double between(double outer, double inner, int j) { return outer + (inner - outer) * j / kRadial; }

  std::map<std::tuple<double, double, double>, std::uint32_t> index_;
  std::vector<Direction> around_ = full_turn(kAround), hole_ = full_turn(kHole);
};

struct Profile {
  double r, z;
};

// Millimeters.
constexpr double kFoot = 58, kRim = 60, kTop = 16, kRimFillet = 4, kChamfer = 2;
constexpr double kHubRadius = 28, kHubFillet = 6, kHubTop = 38, kHubChamfer = 1.5;
constexpr double kBore = 18, kBoreChamfer = 1, kBottomRing = 32;
constexpr double kBoltCircle = 45, kBolt = 4.5, kCounterbore = 7.5, kCounterboreDepth = 7;
constexpr double kBlindCircle = 22.75, kBlind = 2, kBlindDepth = 9, kDrillPoint = 1.25;

/// Quarter circle of radius r about (cr, cz) from direction `first` counterclockwise (or clockwise) in four steps.
std::array<Profile, 5> quarter(double cr, double cz, double r, int first, bool clockwise) {
  const std::vector<Direction> turn = full_turn(16);
  std::array<Profile, 5> out{};
  for (int i = 0; i < 5; ++i) {
    const Direction d = turn[static_cast<std::size_t>((first + (clockwise ? 16 - i : i)) % 16)];
    out[static_cast<std::size_t>(i)] = {cr + r * d.c, cz + r * d.s};
  }
  return out;
}

void build_plate(Builder& b) {
  Ring last = b.circle(kFoot, 0);
  const auto climb = [&](double r, double z) {
    Ring next = b.circle(r, z);
    b.strip(last, next);
    last = std::move(next);
  };
  climb(kRim, kChamfer);
  b.flange.rim_first = b.faces();
  for (const Profile& p : quarter(kRim - kRimFillet, kTop - kRimFillet, kRimFillet, 0, false)) {
    climb(p.r, p.z);
  }
}

void build_hub(Builder& b) {
  const double base = kHubRadius + kHubFillet;
  const auto fillet = quarter(base, kTop + kHubFillet, kHubFillet, 12, true);
  Ring last = b.circle(base, kTop);
  const auto climb = [&](double r, double z) {
    Ring next = b.circle(r, z);
    b.strip(last, next);
    last = std::move(next);
  };
  for (std::size_t i = 1; i < fillet.size(); ++i) climb(fillet[i].r, fillet[i].z);
  climb(kHubRadius, kHubTop - kHubChamfer);
  climb(kHubRadius - kHubChamfer, kHubTop);
  last = b.flange.bore_edge = b.circle(kBore + kBoreChamfer, kHubTop);
  b.flange.bore_first = b.faces();
  climb(kBore, kHubTop - kBoreChamfer);
  climb(kBore, kTop);
  climb(kBore, 0);
  b.flange.bore_last = b.faces();
  climb(kBottomRing, 0);
}

void build_bolt_holes(Builder& b) {
  for (int k = 0; k < kSectors; ++k) {
    const double floor = kTop - kCounterboreDepth;
    const Ring top = b.sector(k, kRim - kRimFillet, kHubRadius + kHubFillet, kTop);
    const Ring bottom = b.sector(k, kFoot, kBottomRing, 0);
    const Ring mouth = b.hole(k, kBoltCircle, kCounterbore, kTop), foot = b.hole(k, kBoltCircle, kBolt, 0);
    const Ring above = b.blend(top, mouth, 0.625), below = b.blend(foot, bottom, 0.375);
    const std::array<Ring, 8> walk{
        top,  above, mouth, b.hole(k, kBoltCircle, kCounterbore, floor), b.hole(k, kBoltCircle, kBolt, floor),
        foot, below, bottom};
    for (std::size_t i = 0; i + 1 < walk.size(); ++i) b.strip(walk[i], walk[i + 1]);
  }
}

void build_hub_face(Builder& b) {
  const double outer = kHubRadius - kHubChamfer, inner = kBore + kBoreChamfer;
  for (int k = 0; k < kSectors; ++k) {
    if (k % 2 == 0) {
      b.plain_sector(k, outer, inner, kHubTop);
      continue;
    }
    const bool flat = k == 3;  // this one hole was milled, not drilled
    const double floor = kHubTop - kBlindDepth;
    const Ring mouth = b.hole(k, kBlindCircle, kBlind, kHubTop), depth = b.hole(k, kBlindCircle, kBlind, floor);
    b.strip(b.sector(k, outer, inner, kHubTop), mouth);
    b.strip(mouth, depth);
    const Point3 p = b.flange.mesh.vertices[depth[0]], q = b.flange.mesh.vertices[depth[kHole / 2]];
    const std::uint32_t center = b.vertex((p.x + q.x) / 2, (p.y + q.y) / 2, flat ? floor : floor - kDrillPoint);
    const std::uint32_t first = b.faces();
    b.fan(depth, center);
    if (!flat) continue;
    b.flange.cap_center = center;
    b.flange.mesh.vertices[center].z += 0x1p-36;
    for (std::uint32_t f = first; f < b.faces(); ++f) b.flange.cap_faces.push_back(f);
  }
}

}  // namespace

Flange build_flange() {
  Builder b;
  build_plate(b);
  build_hub(b);
  build_bolt_holes(b);
  build_hub_face(b);
  return std::move(b.flange);
}

}  // namespace plumb::tool
