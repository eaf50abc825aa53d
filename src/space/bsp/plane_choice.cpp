#include "space/bsp/plane_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::space {
namespace {

constexpr std::size_t most_looked_at = 256;

/// Guesses: how much of the pieces is on each side, and how many a plane cuts.
struct Cost {
  double front = 0, back = 0, splits = 0;
  [[nodiscard]] double of(double split_weight) const {
    const double all = front + back - splits + 1;
    return 2 * split_weight * splits / all + (1 - split_weight) * std::abs(front - back) / all;
  }
};

template <class Distance>
Cost cost_of(const PieceList& list, double size, const Distance& distance) {
  Cost cost;
  const std::size_t n = list.pieces.size(), step = (n + most_looked_at - 1) / most_looked_at;
  const double near = 1e-12 * size;  // a guess of what is in the plane
  for (std::size_t i = 0; i < n; i += step) {
    bool before = false, behind = false;
    for (const GuessedCorner& c : list.corners_of(list.pieces[i])) {
      const double d = distance(c.guess);
      before |= d > near;
      behind |= d < -near;
    }
    cost.front += before ? 1 : 0;
    cost.back += behind ? 1 : 0;
    cost.splits += before && behind ? 1 : 0;
  }
  return cost;
}

/// Of the pieces' centers, guessed.
double median(const PieceList& list, std::uint32_t axis) {
  std::vector<double> centers;
  for (const ListedPiece& p : list.pieces) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const GuessedCorner& c : list.corners_of(p)) {
      least = std::min(least, along_axis(c.guess, axis));
      most = std::max(most, along_axis(c.guess, axis));
    }
    centers.push_back(least / 2 + most / 2);
  }
  const auto middle = centers.begin() + static_cast<std::ptrdiff_t>(centers.size() / 2);
  std::nth_element(centers.begin(), middle, centers.end());
  return *middle;
}

}  // namespace

PlaneChoice choose_plane(const BspTree& tree, const PieceList& list, const BspOptions& options) {
  PlaneChoice choice;
  double least = std::numeric_limits<double>::infinity();
  const std::size_t n = list.pieces.size();
  const std::size_t unused = static_cast<std::size_t>(
      std::count_if(list.pieces.begin(), list.pieces.end(), [](const ListedPiece& p) { return !p.is_used; }));
  const std::size_t step = std::max<std::size_t>(1, unused / std::max<std::size_t>(1, options.candidates));
  std::size_t seen = 0;
  for (const ListedPiece& p : list.pieces) {
    if (p.is_used || seen++ % step != 0) continue;
    if (unused == 1) {
      choice.face = p.face;
      if (n == 1) return choice;
    }
    const GuessedPlane plane(tree, BspCorner::face_plane | p.face);
    const double cost = cost_of(list, tree.reach, plane).of(options.split_weight);
    if (choice.face && !(cost < least)) continue;
    least = cost;
    choice.face = p.face;
  }
  if (options.planes != BspPlanes::faces_and_axes || n < 2) return choice;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const double at = median(list, axis);
    const auto distance = [&](const Point3& p) { return along_axis(p, axis) - at; };
    const Cost cost = cost_of(list, tree.reach, distance);
    if (cost.front == 0 || cost.back == 0 || !(cost.of(options.split_weight) < least)) continue;
    least = cost.of(options.split_weight);
    choice.across = BspAxisPlane{axis, at};
  }
  return choice;
}

}  // namespace plumb::space
