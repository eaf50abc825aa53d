// A guess in doubles, which holds no bound.
#include "query/vclip/guessed_start.hpp"

#include <algorithm>

namespace plumb::query::vclipping {
namespace {

using arith::Plain;

Plain middle_of(const Solid& s) {
  Plain sum{0, 0, 0};
  for (std::size_t v = 0; v < s.core().size(); ++v) sum = sum + s.core().at<double>(v);
  return sum * (1 / static_cast<double>(s.core().size()));
}

MeshFeature climbed(const Solid& s, const Plain& way) {
  std::uint32_t at = 0;
  double most = dot(way, s.core().at<double>(at));
  for (bool better = true; better;) {  // ends, for `most` grows with each vertex
    better = false;
    for (const std::uint32_t v : s.core().polyhedron()->neighbors_of(at)) {
      const double along = dot(way, s.core().at<double>(v));
      if (along > most) most = along, at = v, better = true;
    }
  }
  const auto& corners = s.mesh().corners;
  return {FeatureKind::vertex, static_cast<std::uint32_t>(std::ranges::find(corners, at) - corners.begin())};
}

}  // namespace

MeshFeaturePair guessed_start(const Solid& a, const Solid& b) {
  const Plain way = middle_of(b) - middle_of(a);
  return {climbed(a, way), climbed(b, way * -1)};
}

}  // namespace plumb::query::vclipping
