#include "plumb/certify/kernel.hpp"

namespace plumb {
namespace {

template <std::size_t N, class Point>
std::vector<LatticePoint<N>> taken(const LatticeIntake& lattice, std::span<const Point> points) {
  std::vector<LatticePoint<N>> all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto x = coordinates(points[i]);
    if (!lattice.take(x, all[i])) lattice.refuse_point(i, x);
  }
  return all;
}

}  // namespace

std::vector<LatticePoint<2>> Kernel::points(std::span<const Point2> points) const { return taken<2>(intake_, points); }
std::vector<LatticePoint<3>> Kernel::points(std::span<const Point3> points) const { return taken<3>(intake_, points); }

}  // namespace plumb
