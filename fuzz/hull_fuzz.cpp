// Do both methods give one hull, whatever the points, and does its proof hold?  And point by point the same.
#include <cstdint>
#include <cstring>
#include <iostream>
#include <span>

#include "plumb/degenerate/cloud.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/hull/verify_hull.hpp"

namespace plumb::fuzz {
namespace {

/// From the bytes: a cloud, a family, a small lattice, or coordinates as they stand.
std::vector<Point3> points_from(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  const unsigned form = bytes[0] % 4;
  bytes = bytes.subspan(1);
  Entropy entropy = Entropy::from_bytes(bytes);
  std::vector<Point3> points;
  if (form == 0) return cloud3(clouds[entropy.below(clouds.size())].cloud, entropy.below(100), entropy);
  if (form == 1) {
    const Family family = any_family(entropy);
    return points3(family, degeneracies[entropy.below(degeneracies.size())], 1 + entropy.below(20), entropy);
  }
  if (form == 2) {
    while (!entropy.exhausted() && points.size() < 100) {
      const auto coordinate = [&] { return static_cast<double>(entropy.within(3)); };
      points.push_back({coordinate(), coordinate(), coordinate()});
    }
    return points;
  }
  for (; bytes.size() >= sizeof(Point3) && points.size() < 60; bytes = bytes.subspan(sizeof(Point3))) {
    Point3 p{};
    std::memcpy(&p, bytes.data(), sizeof p);
    if (p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0) points.push_back(p);
  }
  return points;
}

[[noreturn]] void fail(const std::string& text, const HullOptions& options) {
  std::cerr << text << (options.triangulate ? ", triangulated" : "")
            << (options.all_boundary_points ? ", all points" : "") << std::endl;
  std::abort();
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  const std::vector<Point3> points = fuzz::points_from({data, size});
  Hull3Builder builder;
  for (const Point3& p : points) builder.insert(p);
  for (const bool triangulate : {false, true}) {
    for (const bool all : {false, true}) {
      HullOptions options{.triangulate = triangulate, .all_boundary_points = all};
      const Hull3 hull = convex_hull(points, options);
      options.method = HullMethod::incremental;
      if (convex_hull(points, options) != hull) fuzz::fail("the methods differ", options);
      if (builder.hull(options) != hull) fuzz::fail("the builder differs", options);
      if (const HullVerdict verdict = verify_hull(hull, points, options); !verdict) fuzz::fail(verdict.flaw, options);
    }
  }
  return 0;
}
