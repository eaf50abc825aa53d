// Where does a file put a part?  An affine map, composed exactly, and points under it, each coordinate rounded once.
//
// Laws: (1) maps compose without rounding, whatever their numbers; (2) a coordinate of an image is the double nearest
// to its exact value, and unchanged under the identity; (3) all is counted: what was mapped, and what of it no double
// holds.
// Source: RTCD 11.4.
// Cost: about 60 ns a coordinate where the map's numbers are doubles, 1 us otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "plumb/arith/big.hpp"
#include "plumb/arith/point.hpp"

namespace plumb::surface {

/// Coordinates that a map has made.
struct Placed {
  std::uint64_t coordinates = 0, inexact = 0;
};

class Placement {
 public:
  /// Row i is the coordinate i of the image: three factors, then what is added.
  using Rows = std::array<std::array<double, 4>, 3>;

  Placement();  // the identity
  explicit Placement(const Rows& rows);
  /// Scaled, then turned by the quaternion (x, y, z, w) taken by its formula, whatever its length, then moved.
  Placement(const std::array<double, 3>& move, const std::array<double, 4>& turn, const std::array<double, 3>& scale);

  /// First `inner`, then `outer`.
  friend Placement operator*(const Placement& outer, const Placement& inner);

  [[nodiscard]] bool is_identity() const { return identity_; }
  /// Does it turn right-handed frames into left-handed ones?
  [[nodiscard]] bool mirrors() const;
  /// The image; nothing where a coordinate is beyond all doubles.
  [[nodiscard]] std::optional<Point3> operator()(const Point3& p, Placed& placed) const;

 private:
  using Exact = std::array<std::array<BigDyadic, 4>, 3>;
  void look();

  Exact exact_;
  std::optional<Rows> doubles_;  // where they hold it
  bool identity_ = false;
};

}  // namespace plumb::surface
