#include <algorithm>
#include <cmath>
#include <optional>

#include "certify/batch/all_threads.hpp"
#include "plumb/arith/error.hpp"
#include "python/sign_columns.hpp"

namespace plumb::python {
namespace {

using Columns = std::vector<certify::batch::Column>;

// Between so many items the interpreter is asked whether Ctrl-C was pressed.
constexpr std::size_t most_at_once = std::size_t{1} << 22;
// A thread takes so many items of a question that has no lanes.
constexpr std::size_t part = 2048;

/// The arguments' names, each once, in the order in which the forms give them.
std::vector<std::string> names_of(const SignQuestion& question) {
  std::vector<std::string> names;
  for (const SignForm& form : question.forms) {
    for (const SignArgument& a : form.arguments) {
      if (std::ranges::find(names, a.name) == names.end()) names.push_back(a.name);
    }
  }
  return names;
}

struct Named {
  std::string name;
  py::object value;
};

std::vector<Named> bound_arguments(const SignQuestion& question, const py::args& positional, const py::kwargs& named) {
  const std::vector<std::string> names = names_of(question);
  if (positional.size() > names.size()) {
    throw py::type_error(question.name + "() takes " + std::to_string(names.size()) + " arguments, but " +
                         std::to_string(positional.size()) + " were given");
  }
  std::vector<Named> bound;
  for (std::size_t i = 0; i < positional.size(); ++i) {
    if (!positional[i].is_none()) bound.push_back({names[i], positional[i]});
  }
  for (const auto& [key, value] : named) {
    const std::string name = py::str(key);
    const auto at = std::ranges::find(names, name);
    if (at == names.end()) throw py::type_error(question.name + "() has no argument '" + name + "'");
    if (static_cast<std::size_t>(at - names.begin()) < positional.size())
      throw py::type_error(question.name + "() got argument '" + name + "' twice");
    if (!value.is_none()) bound.push_back({name, py::reinterpret_borrow<py::object>(value)});
  }
  std::ranges::sort(bound, {}, [&](const Named& n) { return std::ranges::find(names, n.name) - names.begin(); });
  return bound;
}

bool takes(const SignForm& form, const std::vector<Named>& bound) {
  return std::ranges::equal(form.arguments, bound, {}, &SignArgument::name, &Named::name);
}

bool fits(const SignArgument& argument, const py::array& array) {
  const auto own = static_cast<py::ssize_t>(argument.axes.size());
  if (array.ndim() < own) return false;
  return std::equal(argument.axes.begin(), argument.axes.end(), array.shape() + array.ndim() - own);
}

std::string told(const SignArgument& argument) {
  if (argument.axes.empty()) return "numbers of any shape";
  std::string text = "shape (...";
  for (const py::ssize_t a : argument.axes) text += ", " + std::to_string(a);
  return text + ")";
}

std::string told(const std::vector<const SignForm*>& forms, std::size_t argument) {
  std::vector<std::string> all;
  for (const SignForm* form : forms) {
    const std::string one = told(form->arguments[argument]);
    if (std::ranges::find(all, one) == all.end()) all.push_back(one);
  }
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : " or ") + one;
  return text + ", of float64 or what widens to it";
}

const SignForm& chosen_form(const SignQuestion& question, const std::vector<Named>& bound,
                            std::vector<GivenNumbers>& given) {
  std::vector<const SignForm*> open;
  for (const SignForm& form : question.forms) {
    if (takes(form, bound)) open.push_back(&form);
  }
  if (open.empty()) {
    std::string text = question.name + "() takes ";
    std::vector<std::string> ways;
    for (const SignForm& form : question.forms) {
      std::string way;
      for (const SignArgument& a : form.arguments) way += (way.empty() ? "" : ", ") + a.name;
      if (std::ranges::find(ways, way) == ways.end()) ways.push_back(way);
    }
    for (const std::string& way : ways) text += (&way == &ways.front() ? "(" : ", or (") + way + ")";
    throw py::type_error(text);
  }
  for (std::size_t a = 0; a < bound.size(); ++a) {
    const Asked asked{question.name, bound[a].name};
    const py::array numbers = numbers_of(bound[a].value, asked);
    std::vector<const SignForm*> left;
    std::ranges::copy_if(open, std::back_inserter(left),
                         [&](const SignForm* form) { return fits(form->arguments[a], numbers); });
    if (left.empty()) refuse(asked, py::array::ensure(bound[a].value), told(open, a));
    open = std::move(left);
    given.push_back({numbers, 0});
  }
  for (std::size_t a = 0; a < bound.size(); ++a) given[a].own = open.front()->arguments[a].axes.size();
  return *open.front();
}

void ask_one_by_one(SignOfOne one, const Columns& columns, std::span<Sign> out) {
  certify::batch::for_each_part(Execution::parallel, (out.size() + part - 1) / part, [&](std::size_t number) {
    std::vector<double> numbers(columns.size());
    const std::size_t end = std::min(out.size(), (number + 1) * part);
    for (std::size_t i = number * part; i < end; ++i) {
      for (std::size_t k = 0; k < columns.size(); ++k) numbers[k] = columns[k].at[i * columns[k].stride];
      out[i] = one(numbers.data());
    }
  });
}

/// Tells where each argument begins, if its items lie one after the other; nothing otherwise.
std::vector<const double*> rows_in(const SignForm& form, const Columns& columns) {
  std::vector<const double*> rows;
  std::size_t first = 0;
  for (const SignArgument& a : form.arguments) {
    const std::size_t n = a.numbers();
    for (std::size_t k = 0; k < n; ++k) {
      const certify::batch::Column& c = columns[first + k];
      if (c.stride != n || c.at != columns[first].at + k) return {};
    }
    rows.push_back(columns[first].at);
    first += n;
  }
  return rows;
}

void ask_run(const SignForm& form, Columns columns, std::span<Sign> out) {
  for (std::size_t first = 0; first < out.size(); first += most_at_once) {
    const std::size_t n = std::min(most_at_once, out.size() - first);
    for (certify::batch::Column& c : columns) c.length = n;
    const std::vector<const double*> rows =
        form.rows != nullptr && n > 1 ? rows_in(form, columns) : std::vector<const double*>();
    if (!rows.empty()) {
      form.rows(rows.data(), out.subspan(first, n));
    } else if (form.formula != nullptr) {
      certify::batch::decide_all(*form.formula, columns, out.subspan(first, n), Execution::parallel);
    } else {
      ask_one_by_one(form.one, columns, out.subspan(first, n));
    }
    for (certify::batch::Column& c : columns) c.at += n * c.stride;
    if (first + n == out.size()) return;
    const py::gil_scoped_acquire held;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

/// Which number of an argument it is: "b.y", "rows[2][0]", "distance".
std::string place_of(const SignForm& form, std::size_t number) {
  for (const SignArgument& a : form.arguments) {
    if (number >= a.numbers()) {
      number -= a.numbers();
      continue;
    }
    if (a.axes.empty()) return a.name;
    const auto row = static_cast<std::size_t>(a.axes.back());
    if (a.axes.size() == 2)
      return a.name + "[" + std::to_string(number / row) + "][" + std::to_string(number % row) + "]";
    return a.name + "." + a.letters[number];
  }
  return {};
}

/// Names item `flat` of the answer: " of row 17", " of row (2, 5)"; nothing where there is one item.
std::string row_of(const std::vector<py::ssize_t>& shape, std::size_t flat) {
  if (shape.empty()) return {};
  std::vector<py::ssize_t> at(shape.size());
  for (std::size_t d = shape.size(); d-- > 0;) {
    at[d] = static_cast<py::ssize_t>(flat) % shape[d];
    flat /= static_cast<std::size_t>(shape[d]);
  }
  return " of row " + (at.size() == 1 ? std::to_string(at[0]) : python::told(std::span<const py::ssize_t>(at)));
}

/// Says what NonFinite says, by the rows that Python knows.
[[noreturn]] void throw_first_non_finite(const SignQuestion& question, const SignForm& form, const SignColumns& all) {
  for (std::size_t r = 0; r < all.runs(); ++r) {
    const Columns columns = all.of_run(r);
    for (std::size_t i = 0; i < all.run; ++i) {
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const double x = columns[k].at[i * columns[k].stride];
        if (std::isfinite(x)) continue;
        throw py::value_error(question.name + ": " + place_of(form, k) + row_of(all.shape, r * all.run + i) + " is " +
                              (std::isnan(x) ? "nan"
                               : x < 0       ? "-inf"
                                             : "inf") +
                              "; a finite number is needed");
      }
    }
  }
  throw py::value_error(question.name + ": a number is not finite");
}

}  // namespace

py::object ask(const SignQuestion& question, const py::args& positional, const py::kwargs& named) {
  std::vector<GivenNumbers> given;
  const SignForm& form = chosen_form(question, bound_arguments(question, positional, named), given);
  const SignColumns columns = columns_of(given, question, form);
  const py::dtype type = question.is_truth ? py::dtype::of<bool>() : py::dtype::of<std::int8_t>();
  py::array out(type, columns.shape);
  const std::span signs(static_cast<Sign*>(out.mutable_data()), static_cast<std::size_t>(out.size()));
  if (!signs.empty()) {
    std::optional<NonFinite> refused;
    {
      const py::gil_scoped_release released;
      try {
        for (std::size_t r = 0; r < columns.runs(); ++r)
          ask_run(form, columns.of_run(r), signs.subspan(r * columns.run, columns.run));
      } catch (const NonFinite& e) {
        refused = e;
      }
    }
    if (refused) throw_first_non_finite(question, form, columns);
  }
  return columns.shape.empty() ? out[py::tuple()] : py::object(out);
}

std::string docstring_of(const SignQuestion& question) {
  const std::vector<std::string> names = names_of(question);
  const auto in_all = [&](const std::string& name) {
    return std::ranges::all_of(question.forms, [&](const SignForm& form) {
      return std::ranges::find(form.arguments, name, &SignArgument::name) != form.arguments.end();
    });
  };
  std::string signature, parameters;
  for (const std::string& name : names) {
    signature += (signature.empty() ? "" : ", ") + name + (in_all(name) ? "" : "=None");
    std::vector<std::string> shapes;
    for (const SignForm& form : question.forms) {
      const auto a = std::ranges::find(form.arguments, name, &SignArgument::name);
      if (a == form.arguments.end()) continue;
      const std::string shape = told(*a);
      if (std::ranges::find(shapes, shape) == shapes.end()) shapes.push_back(shape);
    }
    std::string all;
    for (const std::string& shape : shapes) all += (all.empty() ? "" : " or ") + shape;
    parameters += name + " : array_like, " + all + (in_all(name) ? "\n" : "; or left out\n");
  }
  return question.name + "(" + signature + ")\n--\n\n" + question.summary +
         "\n\nExact for every finite double.  Runs on all threads, without the interpreter's lock.\n\n"
         "Parameters\n----------\n" +
         parameters + "\nThe axes written as ... broadcast against one another.\n\nReturns\n-------\n" +
         (question.is_truth ? "bool, or an array of bool of the shape that the arguments broadcast to."
                            : "int8, or an array of int8 of the shape that the arguments broadcast to: -1, 0 or 1.") +
         "\n\nRaises\n------\nValueError\n    If a shape is another, or a number is nan, infinite or no double; the "
         "text says "
         "which.\nTypeError\n    If an argument is missing, or holds no numbers.\n";
}

}  // namespace plumb::python
