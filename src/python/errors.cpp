#include <optional>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/space/bvh/progress.hpp"
#include "plumb/surface/file/mesh_file.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

namespace py = pybind11;

/// `with plumb.ThreadLimit(1):`
class LimitedThreads {
 public:
  explicit LimitedThreads(std::size_t most) : most_(most) {}
  unsigned enter() {
    held_.emplace(most_);
    return held_->threads();
  }
  void leave() { held_.reset(); }

 private:
  std::size_t most_;
  std::optional<ThreadLimit> held_;
};

/// What the library throws, as Python's: a file that is not there or cannot be opened is an OSError.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const MeshFileError& e) {
    using Problem = MeshFileProblem;
    const bool of_system =
        e.problem == Problem::missing || e.problem == Problem::unreadable || e.problem == Problem::unwritable;
    PyErr_SetString(e.problem == Problem::missing ? PyExc_FileNotFoundError
                    : of_system                   ? PyExc_OSError
                                                  : PyExc_ValueError,
                    e.what());
  } catch (const Error& e) {
    PyErr_SetString(PyExc_ValueError, e.what());
  }
}

}  // namespace

void add_errors(py::module_& module) {
  py::register_exception_translator(translate);
  py::class_<LimitedThreads>(
      module, "ThreadLimit",
      "ThreadLimit(most)\n--\n\nOn how many threads does the library work within a `with` block?\n\n"
      "No answer depends on it.  The limit holds for the whole process; 0 is as many as it may run.")
      .def(py::init<std::size_t>(), py::arg("most"))
      .def("__enter__", &LimitedThreads::enter)
      .def("__exit__", [](LimitedThreads& limit, const py::args&) { limit.leave(); });
}

}  // namespace plumb::python
