#include "lab/crowd/weld_clouds.hpp"

#include "plumb/degenerate/coordinates.hpp"

namespace plumb::lab::trial {
namespace {

Point3 any_place(Entropy& entropy) {
  return {unit_coordinate(entropy), unit_coordinate(entropy), unit_coordinate(entropy)};
}

/// The vertices of triangles that are written each with its own, by the same doubles.
void fill_equals(WeldCloud& cloud, Entropy& entropy) {
  while (cloud.size() < weld_vertices) {
    const Point3 p = any_place(entropy);
    cloud.push_back(p), cloud.push_back(p);
  }
}

/// Pairs of points at about the tolerance, along an axis or not.
void fill_pairs(WeldCloud& cloud, Entropy& entropy) {
  while (cloud.size() < weld_vertices) {
    const Point3 p = any_place(entropy);
    Point3 q = p;
    const double by =
        weld_tolerance * (entropy.below(3) == 0 ? 0.5 : 1) + static_cast<double>(entropy.within(2)) * 0x1p-53;
    (entropy.below(2) == 0 ? q.x : entropy.below(2) == 0 ? q.y : q.z) += by;
    cloud.push_back(p), cloud.push_back(q);
  }
}

/// The vertices of triangles that are written each with its own, with errors of ulps.
void fill_copies(WeldCloud& cloud, Entropy& entropy) {
  while (cloud.size() < weld_vertices) {
    const auto at = [&] { return 0.1 * static_cast<double>(entropy.within(20)); };
    const Point3 p{at(), at(), at()};
    for (int copy = 0; copy < 2; ++copy) {
      const auto off = [&] { return static_cast<double>(entropy.within(2)) * 0x1p-52; };
      cloud.push_back({p.x + off(), p.y + off(), p.z + off()});
    }
  }
}

/// Steps of three quarters of the tolerance, one behind the other.
void fill_chains(WeldCloud& cloud, Entropy& entropy) {
  while (cloud.size() < weld_vertices) {
    Point3 p = any_place(entropy);
    for (int step = 0; step < 6; ++step) {
      cloud.push_back(p);
      p.x += 0.75 * weld_tolerance;
    }
  }
}

/// The pairs, a hundred thousand units from the origin.
void fill_far(WeldCloud& cloud, Entropy& entropy) {
  fill_pairs(cloud, entropy);
  for (Point3& p : cloud) p = {p.x + 100'000, p.y + 100'000, p.z + 100'000};
}

/// Equal points, some with 0.0 and some with -0.0.
void fill_zeros(WeldCloud& cloud, Entropy& entropy) {
  while (cloud.size() < weld_vertices) {
    const auto zero = [&] { return entropy.below(2) == 0 ? 0.0 : -0.0; };
    const auto x = static_cast<double>(entropy.within(9));
    cloud.push_back({x, zero(), zero()});
  }
}

}  // namespace

std::span<const WeldFamily> weld_families() {
  static const std::vector<WeldFamily> all{
      {"equals", "vertices that are written twice, by the same doubles", fill_equals},
      {"pairs", "pairs of vertices at half the tolerance, or at it but for ulps", fill_pairs},
      {"copies", "vertices that are written twice, with errors of ulps", fill_copies},
      {"chains", "rows of vertices in steps below the tolerance", fill_chains},
      {"far", "the pairs, a hundred thousand units from the origin", fill_far},
      {"zeros", "equal vertices, with 0.0 and -0.0", fill_zeros}};
  return all;
}

}  // namespace plumb::lab::trial
