// Which signs are certain?  For one algorithm that runs over doubles with their errors first, over integers where these
// do not tell.
//
// Law: once a sign is not certain, certain() says so for good, and the answers so far mean nothing.
// Cost: a comparison or two.
#pragma once

#include "plumb/arith/big.hpp"
#include "running_error.hpp"

namespace plumb::query {

class RunningSigns {
 public:
  Sign operator()(const Running& x) {
    const Unsure<Sign> s = x.sign();
    certain_ = certain_ && s.certain();
    return s.certain() ? s.value() : Sign::zero;
  }
  Sign operator()(const BigDyadic& x) { return x.sign(); }
  [[nodiscard]] bool certain() const { return certain_; }

 private:
  bool certain_ = true;
};

}  // namespace plumb::query
