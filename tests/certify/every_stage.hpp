// Do all stages of a formula say the same?
#pragma once

#include <gtest/gtest.h>

#include "plumb/certify/decide.hpp"

namespace plumb {

/// The chain and the last stage say `exact` at p, and so do the others as far as they are certain.
template <Formula F, class Recorder = NoRecorder>
void expect_of_every_stage(const Coordinates<F>& p, Sign exact, Recorder&& recorder = {}) {
  EXPECT_EQ(decide<F>(p, recorder), exact);
  EXPECT_EQ(big_integer_sign(certify::tape::program<F>(), p), exact);
  for (const int s : {magnitude_filter<F>(p), largest_filter<F>(p)}) {
    if (s != 0) {
      EXPECT_EQ(static_cast<Sign>(s), exact);
    }
  }
  for (const Unsure<Sign> s :
       {structural_zero_sign<F>(p), integer_sign<F>(p), wide_integer_sign<F>(p), interval_sign<F>(p)}) {
    if (s.certain()) {
      EXPECT_EQ(s.value(), exact);
    }
  }
}

}  // namespace plumb
