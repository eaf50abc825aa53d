// How is Qhull asked?  By its reentrant library; what it found is read before it is freed.
//
// Laws: what Qhull reports as an error (points that span less than space, and others) is told, not thrown.
// Source: Qhull 2020's user_eg2_r and manual.
// Cost: Qhull's.
#pragma once

#include <cstddef>
#include <cstdio>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace plumb::bench {

/// Asks for the hull of n points by a command of Qhull's options, and calls read(state); false where Qhull fails.
template <class Read>
bool with_qhull(int dimension, const double* coordinates, std::size_t n, const char* options, Read read) {
  static std::FILE* const nowhere = std::fopen("/dev/null", "w");
  qhT state;
  qh_zero(&state, nowhere);
  // Neither array is written to: the options ask for no joggling and no transformation.
  const int failed = qh_new_qhull(&state, dimension, static_cast<int>(n), const_cast<double*>(coordinates), False,
                                  const_cast<char*>(options), nowhere, nowhere);
  if (failed == 0) read(state);
  qh_freeqhull(&state, qh_ALL);
  int left = 0, total = 0;
  qh_memfreeshort(&state, &left, &total);
  return failed == 0;
}

}  // namespace plumb::bench
