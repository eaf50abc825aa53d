// A guess in doubles, which holds no bound.  Compiled twice, for processors with lanes of four doubles and for others;
// each in a function of its own, which ends with the upper halves of the lanes cleared: what is compiled for all others
// is slow while they are in use.
#include "query/gjk/quick_scan.hpp"

#include "certify/fused.hpp"

namespace plumb::query::quick_scan {

PLUMB_WITH_FMA std::uint32_t farthest_by_fours(const Point3* at, std::uint32_t size, double x, double y, double z) {
  return Scan<QuadLanes>(at, size, x, y, z).farthest();
}
PLUMB_WITHOUT std::uint32_t farthest_by_pairs(const Point3* at, std::uint32_t size, double x, double y, double z) {
  return Scan<PairLanes>(at, size, x, y, z).farthest();
}

}  // namespace plumb::query::quick_scan
