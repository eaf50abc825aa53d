// How is a hull in the plane commonly computed?  Four algorithms of textbooks, over signs that somebody else takes.
//
// An answer is the indices of corners, counterclockwise, or none where the algorithm did not end within its bound.
// Laws: (1) with exact signs each returns the strictly extreme points, one index each, for whatever points there are;
// (2) an algorithm looks at points through HullSigns alone; (3) every loop that wrong signs may keep running is bounded
// by what it needs at most with right ones.
// Source: RTCD 3.9.1 (Andrew), 3.9.2 (quickhull); Jarvis 1973 (gift wrapping); Kettner and others, "Classroom examples
// of robustness problems in geometric computations" (incremental); cost: n log n to n^2 signs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::tool::stability {

/// What an algorithm asks of points, by index.
class HullSigns {
 public:
  HullSigns() = default;
  HullSigns(const HullSigns&) = delete;
  HullSigns& operator=(const HullSigns&) = delete;
  virtual ~HullSigns() = default;
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// By x, then y, as the method keeps them.
  [[nodiscard]] virtual bool before(std::uint32_t a, std::uint32_t b) const = 0;
  /// Positive where a, b, c turn left.
  [[nodiscard]] virtual int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const = 0;
  /// Positive where c lies farther to the left of the line from a to b than d.
  [[nodiscard]] virtual int farther(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const = 0;

  [[nodiscard]] bool same(std::uint32_t a, std::uint32_t b) const { return !before(a, b) && !before(b, a); }
};

/// How a number takes signs: rounded to float, double or long double, an epsilon counting as zero; or exactly.
struct HullMethod {
  std::string name;
  bool exact;
  std::unique_ptr<HullSigns> (*signs)(std::span<const Point2> points);
};
const std::vector<HullMethod>& hull_methods();

using Corners = std::optional<std::vector<std::uint32_t>>;

struct HullWay {
  std::string name, about;
  Corners (*run)(const HullSigns& signs);
};
const std::vector<HullWay>& hull_ways();

}  // namespace plumb::tool::stability
