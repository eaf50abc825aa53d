// The digest's answers about points: signs one by one and in batches.
#include <algorithm>

#include "certify/catalog.hpp"
#include "plumb/certify/batch.hpp"
#include "plumb/degenerate/points.hpp"
#include "tool/doctor/digest.hpp"

namespace plumb::tool {
namespace {

/// Points of the family, one after the other; of what takes no points, half of the rows are small integers.
std::vector<double> digest_row(const CatalogEntry& predicate, Family family, Entropy& e) {
  std::vector<double> row(predicate.arity());
  const bool are_points = predicate.dimension == 2 || predicate.dimension == 3;
  if (!are_points && e.coin()) {
    for (double& x : row) x = static_cast<double>(e.within(3));
    return row;
  }
  const int dimension = are_points ? predicate.dimension : 3;
  const auto axes = static_cast<std::size_t>(dimension);
  std::vector<double> drawn((row.size() + axes - 1) / axes * axes);
  fill_points(family, degeneracies[e.below(degeneracies.size())], dimension, drawn, e);
  std::copy_n(drawn.begin(), row.size(), row.begin());
  return row;
}

}  // namespace

void answer_signs(HashedAnswers& to, std::uint64_t times) {
  std::uint64_t number = 0;
  for (const CatalogEntry& predicate : catalog()) {
    for (std::uint64_t i = 0; i < 12 * times; ++i) {
      for (const FamilyInfo& f : families) {
        Entropy e(1, number++);
        to.add(predicate.decide(digest_row(predicate, f.family, e)).sign);
      }
    }
  }
}

void answer_batches(HashedAnswers& to, std::uint64_t times) {
  const std::size_t count = 451 * times;  // no multiple of a vector's lanes
  std::uint64_t number = 0;
  std::vector<Sign> signs(count);
  for (const FamilyInfo& f : families) {
    std::array<std::vector<Point2>, 4> flat;
    std::array<std::vector<Point3>, 5> solid;
    for (std::size_t i = 0; i < count; ++i) {
      Entropy e(2, number++);
      const std::vector<Point2> p = points2(f.family, Degeneracy::cocircular, flat.size(), e);
      for (std::size_t k = 0; k < flat.size(); ++k) flat[k].push_back(p[k]);
      const Degeneracy about = i % 2 == 0 ? Degeneracy::coplanar : Degeneracy::cospherical;
      const std::vector<Point3> q = points3(f.family, about, solid.size(), e);
      for (std::size_t k = 0; k < solid.size(); ++k) solid[k].push_back(q[k]);
    }
    orient2d(flat[0], flat[1], flat[2], signs, Execution::parallel);
    to.add(signs);
    incircle(flat[0], flat[1], flat[2], flat[3], signs, Execution::parallel);
    to.add(signs);
    orient3d(solid[0], solid[1], solid[2], solid[3], signs, Execution::parallel);
    to.add(signs);
    insphere(solid[0], solid[1], solid[2], solid[3], solid[4], signs, Execution::parallel);
    to.add(signs);
  }
}

}  // namespace plumb::tool
