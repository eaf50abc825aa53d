// How is what takes long run?  Without the interpreter's lock, and until Ctrl-C.
//
// Source: none.
// Cost: none.
#pragma once

#include <pybind11/pybind11.h>

#include "plumb/space/bvh/progress.hpp"

namespace plumb::python {

/// Asks now and then whether Ctrl-C was pressed; the error is raised where the answer would be returned.
inline Progress interruptible() {
  return [](double) {
    const pybind11::gil_scoped_acquire held;
    return PyErr_CheckSignals() == 0;
  };
}

/// Runs without the interpreter's lock; what Ctrl-C stopped raises KeyboardInterrupt.
template <class Work>
auto unlocked(const Work& work) {
  try {
    const pybind11::gil_scoped_release released;
    return work();
  } catch (const Cancelled&) {
    throw pybind11::error_already_set();
  }
}

}  // namespace plumb::python
