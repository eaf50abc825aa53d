#include <pybind11/stl.h>

#include <exception>
#include <limits>

#include "degenerate/fields.hpp"
#include "plumb/degenerate/check.hpp"
#include "plumb/degenerate/paste.hpp"
#include "plumb/query/kinds/kinds.hpp"
#include "python/numbers.hpp"
#include "python/rooms.hpp"

namespace plumb::python {
namespace {

using degenerate::Answer, degenerate::AnswerForm, degenerate::Kind, degenerate::Numbers;

/// Rows of points and directions; what is no rows of one length is one row.
py::object argument_of(const degenerate::Given& given) {
  const std::vector<degenerate::Part>& parts = given.argument.parts;
  const auto n = static_cast<py::ssize_t>(given.numbers.size());
  const int columns = parts[0].dimension;
  const bool is_row = !given.argument.any_number() && parts.size() == 1 && parts[0].count == 1;
  const bool is_even = std::ranges::all_of(parts, [&](const degenerate::Part& p) { return p.dimension == columns; });
  const std::vector<py::ssize_t> shape =
      is_row || !is_even ? std::vector<py::ssize_t>{n} : std::vector<py::ssize_t>{n / columns, columns};
  if (degenerate::names_points(parts[0].role)) {
    py::array_t<std::int32_t> indices(shape);
    std::ranges::transform(given.numbers, indices.mutable_data(), [](double x) { return static_cast<int>(x); });
    return indices;
  }
  py::array_t<double> numbers(shape);
  std::ranges::copy(given.numbers, numbers.mutable_data());
  return numbers;
}

py::tuple arguments_of(const Kind& kind, std::span<const double> numbers) {
  py::list all;
  for (const degenerate::Given& given : degenerate::given(kind, numbers)) all.append(argument_of(given));
  return py::tuple(all);
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A fraction that is smaller than all doubles has a sign.
double sign_of_object(const py::object& given) {
  const py::int_ zero(0);
  return given > zero ? 1 : given < zero ? -1 : given.equal(zero) ? 0 : unknown;
}

Answer answer_of_object(AnswerForm form, const py::object& given) {
  const bool is_truth = py::isinstance<py::bool_>(given) || std::string(Py_TYPE(given.ptr())->tp_name) == "numpy.bool_";
  switch (form) {
    case AnswerForm::hit: {
      Answer answer(given.is_none() || (is_truth && !py::bool_(given)) ? 0.0 : 1.0);
      if (!given.is_none() && !is_truth) answer.numbers.push_back(py::float_(given));
      return answer;
    }
    case AnswerForm::triangles: {
      if (given.is_none()) return unknown;
      const py::array_t<double> rows = rows_of(given, {"fuzz", "the answer"}, 3);
      Answer answer;
      answer.numbers.assign(rows.data(), rows.data() + rows.size());
      return answer;
    }
    default:
      break;
  }
  if (given.is_none()) return unknown;
  if (form == AnswerForm::sign) return sign_of_object(given);
  if (form == AnswerForm::number) return py::float_(given).cast<double>();
  const double sign = is_truth ? (py::bool_(given) ? 1 : 0) : sign_of_object(given);
  return sign == sign ? (sign != 0 ? 1.0 : 0.0) : unknown;
}

/// What the function raises is a finding, unless it ends programs (Ctrl-C); an answer that is none ends the run.
class FuzzedFunction {
 public:
  FuzzedFunction(const Kind& kind, py::object function) : kind_(kind), function_(std::move(function)) {}

  Answer operator()(std::span<const double> numbers) {
    if (thrown_) return unknown;
    py::object given;
    try {
      given = function_(*arguments_of(kind_, numbers));
    } catch (py::error_already_set& e) {
      if (e.matches(PyExc_Exception)) {
        const std::string name = py::str(e.type().attr("__name__"));
        return Answer(degenerate::Outcome::threw, name + ": " + std::string(py::str(e.value())));
      }
      thrown_ = std::current_exception();
      return unknown;
    }
    try {
      return answer_of_object(kind_.form, given);
    } catch (...) {
      thrown_ = std::current_exception();
      return unknown;
    }
  }

  bool goes_on() {
    if (!thrown_ && PyErr_CheckSignals() != 0) {
      try {
        throw py::error_already_set();
      } catch (...) {
        thrown_ = std::current_exception();
      }
    }
    return !thrown_;
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const Kind& kind_;
  py::object function_;
  std::exception_ptr thrown_;
};

py::tuple fuzz(const py::object& function, const std::string& name, std::uint64_t seed, std::uint64_t cases,
               const std::vector<std::string>& generators, std::optional<std::uint64_t> ulps, double largest,
               const py::object& progress) {
  const Kind& kind = degenerate::kind_named(name);
  FuzzedFunction asked(kind, function);
  degenerate::CheckOptions options{.seed = seed, .cases = cases, .generators = generators};
  if (ulps) options.tolerance = degenerate::Tolerance{.ulps = *ulps};
  options.domain.largest = largest;
  options.progress = [&](const degenerate::Findings& so_far) {
    if (!asked.goes_on()) return false;
    return progress.is_none() || !progress(so_far.asked()).is(py::bool_(false));
  };
  const degenerate::Findings found = degenerate::check(
      kind, [&](std::span<const double> numbers) { return asked(numbers); }, options);
  asked.rethrow();
  py::list tallies, findings;
  for (const degenerate::Tally& t : found.tallies)
    tallies.append(py::make_tuple(t.generator, t.asked, t.wrong, t.unsure, t.failed));
  for (const degenerate::Finding& f : found.findings) {
    findings.append(py::make_tuple(f.generator, f.index, f.sort, arguments_of(kind, f.smallest),
                                   degenerate::words(kind, f.given), degenerate::words(kind, f.exact),
                                   degenerate::case_line(kind, f.smallest)));
  }
  return py::make_tuple(tallies, findings, degenerate::text(kind, found));
}

}  // namespace

void add_fuzzing(py::module_& module) {
  py::dict kinds;
  for (const auto all : {degenerate::kinds(), degenerate::predicate_kinds()}) {
    for (const Kind& kind : all) {
      std::string names;
      for (const degenerate::Argument& a : kind.arguments) names += (names.empty() ? "" : ", ") + a.name;
      kinds[py::str(kind.name)] = "f(" + names + "): " + kind.question + "  " + kind.convention;
    }
  }
  module.attr("_fuzz_kinds") = kinds;
  module.def("_fuzz", fuzz);
}

}  // namespace plumb::python
