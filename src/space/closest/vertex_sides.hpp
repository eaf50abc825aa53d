// Which vertices lie on one side of a plane?  Each is asked once, whichever triangles have it.
//
// Law: is_beyond(vertex, quick, exactly) is that quick() is positive, or, where its sign is not certain, exactly(); all
// calls must ask about the same plane.
// Cost: a byte a vertex.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::space {

class VertexSides {
 public:
  explicit VertexSides(std::size_t vertices) : known_(vertices) {}

  template <class Quick, class Exactly>
  bool is_beyond(std::uint32_t vertex, const Quick& quick, const Exactly& exactly) {
    Side& known = known_[vertex];
    if (known == Side::unknown) {
      const Unsure<Sign> sign = quick().sign();
      known = (sign.certain() ? sign.value() : exactly().sign()) == Sign::positive ? Side::beyond : Side::not_beyond;
    }
    return known == Side::beyond;
  }

 private:
  enum class Side : std::uint8_t { unknown, beyond, not_beyond };
  std::vector<Side> known_;
};

}  // namespace plumb::space
