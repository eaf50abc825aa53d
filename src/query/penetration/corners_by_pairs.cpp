#include "query/penetration/corners_by_pairs.hpp"

#include "certify/fused.hpp"

namespace plumb::query::parting {
namespace {

PLUMB_WITH_FMA Vec<FusedPair> fused_corner(const CoreCorners& c, std::size_t i) { return c.at<FusedPair>(i); }
PLUMB_WITH_FMA Vec<FusedPair> fused_edge(const CoreCorners& c, std::size_t k) { return c.edge<FusedPair>(k); }
PLUMB_WITH_FMA Vec<FusedPair> fused_middle(const CoreCorners& c) { return c.twice_middle<FusedPair>(); }

}  // namespace

Vec<FusedPair> corner_by_pairs(const CoreCorners& c, std::size_t i) { return fused_corner(c, i); }
Vec<FusedPair> edge_by_pairs(const CoreCorners& c, std::size_t k) { return fused_edge(c, k); }
Vec<FusedPair> twice_middle_by_pairs(const CoreCorners& c) { return fused_middle(c); }

}  // namespace plumb::query::parting
