// Which sign is asked, of which arrays?  A function of Python, and the forms in which it takes its arguments.
//
// Laws: (1) the answers are those of the C++ function of that name, item by item.  (2) A form is chosen by which arguments
//       are given and by their last axes; the axes before them broadcast as NumPy's do.  (3) An argument is copied only
//       if it is not float64, or where NumPy's own rules leave its items with a stride that runs backward.
// Source: NumPy's universal functions.
// Cost: a batch, on all threads, without the interpreter's lock.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/signs_of.hpp"
#include "python/numbers.hpp"

namespace plumb::python {

/// Answers one item, whose numbers stand one after the other.
using SignOfOne = Sign (*)(const double* numbers);

/// Answers items whose points lie one after the other in memory, by what the library has for them.
using SignsOfRows = void (*)(const double* const* arguments, std::span<Sign> out);

/// The last axes of an argument: none for a number, one for a point, two for a matrix.
struct SignArgument {
  std::string name;
  std::vector<py::ssize_t> axes;
  std::string_view letters;  // of a point's coordinates, and of its weight
  [[nodiscard]] std::size_t numbers() const {
    std::size_t n = 1;
    for (const py::ssize_t a : axes) n *= static_cast<std::size_t>(a);
    return n;
  }
};

struct SignForm {
  std::vector<SignArgument> arguments;
  const certify::batch::BatchFormula* formula = nullptr;  // in lanes; or
  SignOfOne one = nullptr;                                // one after the other
  SignsOfRows rows = nullptr;                             // beside either, where it can
  [[nodiscard]] std::size_t numbers() const {
    std::size_t n = 0;
    for (const SignArgument& a : arguments) n += a.numbers();
    return n;
  }
};

struct SignQuestion {
  std::string name, summary;
  std::vector<SignForm> forms;
  bool is_truth = false;  // the answer is True or False
};

template <class A>
std::vector<py::ssize_t> axes_of() {
  if constexpr (std::is_same_v<A, double>) {
    return {};
  } else if constexpr (requires(A a) { a[0][0]; }) {
    constexpr auto n = static_cast<py::ssize_t>(std::tuple_size_v<A>);
    return {n, n};
  } else {
    return {static_cast<py::ssize_t>(sizeof(A) / sizeof(double))};
  }
}

template <class A>
constexpr std::string_view letters_of() {
  if constexpr (requires(A a) { a.weight; }) return sizeof(A) == 3 * sizeof(double) ? "xyw" : "xyzw";
  return "xyz";
}

template <class... A>
std::vector<SignArgument> sign_arguments(const std::array<const char*, sizeof...(A)>& names) {
  std::size_t next = 0;
  return {SignArgument{names[next++], axes_of<A>(), letters_of<A>()}...};
}

/// The question is a formula of the manifest, whose arguments are these in turn.
template <class F, class... A>
SignForm formula_form(const std::array<const char*, sizeof...(A)>& names) {
  static_assert((sizeof(A) + ...) / sizeof(double) == arity<F>);
  return {sign_arguments<A...>(names), &certify::batch::asked<F>, nullptr};
}

/// The question is one of the four classics, which have batches of their own.
template <class F, class... Point>
SignForm classic_form(const std::array<const char*, sizeof...(Point)>& names, auto batch) {
  using Batch = decltype(batch);
  SignForm form = formula_form<F, Point...>(names);
  form.rows = [](const double* const* arguments, std::span<Sign> out) {
    const auto points = [&arguments, &out]<class P>(std::type_identity<P>) {
      return std::span(reinterpret_cast<const P*>(*arguments++), out.size());
    };
    const std::tuple given{points(std::type_identity<Point>{})...};
    std::apply([&out](const auto&... spans) { Batch{}(spans..., out, Execution::parallel); }, given);
  };
  return form;
}

/// The question is a function without a capture that takes these.
template <class... A, class Function>
SignForm form(const std::array<const char*, sizeof...(A)>& names, Function) {
  return {sign_arguments<A...>(names), nullptr, [](const double* numbers) -> Sign {
            std::tuple<A...> given;
            const auto read = [&numbers](auto& to) {
              std::memcpy(static_cast<void*>(&to), numbers, sizeof(to));
              numbers += sizeof(to) / sizeof(double);
            };
            std::apply([&read](auto&... to) { (read(to), ...); }, given);
            const auto answer = std::apply([](const auto&... a) { return Function{}(a...); }, given);
            return static_cast<Sign>(answer);
          }};
}

/// Whoever tells the question in Python's words.
std::string docstring_of(const SignQuestion& question);
py::object ask(const SignQuestion& question, const py::args& positional, const py::kwargs& named);

std::vector<SignQuestion> orientation_questions();
std::vector<SignQuestion> direction_questions();
std::vector<SignQuestion> distance_questions();
std::vector<SignQuestion> sphere_questions();

}  // namespace plumb::python
