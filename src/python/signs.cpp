#include <memory>

#include "python/rooms.hpp"
#include "python/sign_question.hpp"

namespace plumb::python {

void add_signs(py::module_& module) {
  using Table = std::vector<SignQuestion>;
  for (Table (*table)() : {orientation_questions, direction_questions, distance_questions, sphere_questions}) {
    for (SignQuestion& question : table()) {
      const std::string docstring = docstring_of(question);
      const auto kept = std::make_shared<const SignQuestion>(std::move(question));
      module.def(
          kept->name.c_str(),
          [kept](const py::args& positional, const py::kwargs& named) { return ask(*kept, positional, named); },
          docstring.c_str());
    }
  }
}

}  // namespace plumb::python
