#include "python/numbers.hpp"

#include <cmath>
#include <cstdint>

namespace plumb::python {
namespace {

// Every integer up to this is a double.
constexpr std::int64_t whole = std::int64_t{1} << 53;

bool is_usable(const py::array& array) {
  constexpr int aligned = py::detail::npy_api::NPY_ARRAY_ALIGNED_;
  return py::isinstance<py::array_t<double>>(array) && (array.flags() & aligned) != 0;
}

std::string where(const Asked& asked) { return std::string(asked.function) + ": " + std::string(asked.argument); }

void require_whole(const py::array& integers, const Asked& asked) {
  if (integers.size() == 0) return;
  const py::int_ bound(whole);
  for (const char* extreme : {"min", "max"}) {
    const py::object value = py::int_(integers.attr(extreme)());
    if (value.attr("__abs__")() <= bound) continue;
    throw py::value_error(where(asked) + " holds " + std::string(py::str(value)) +
                          "; integers beyond 2^53 are not all doubles, and nothing is rounded here");
  }
}

void require_finite(const py::array_t<double>& rows, const Asked& asked, py::ssize_t columns) {
  const double* at = rows.data();
  for (py::ssize_t i = 0; i < rows.size(); ++i) {
    if (std::isfinite(at[i])) [[likely]]
      continue;
    const std::string value = std::isnan(at[i]) ? "nan" : at[i] < 0 ? "-inf" : "inf";
    throw py::value_error(where(asked) + "[" + std::to_string(i / columns) + ", " + std::to_string(i % columns) +
                          "] is " + value + "; a finite number is needed");
  }
}

py::array_t<double> finite_rows(const py::array& numbers, const Asked& asked, py::ssize_t columns) {
  auto rows = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(numbers);
  if (!rows) throw py::error_already_set();
  py::array_t<double> plain(std::move(rows));
  require_finite(plain, asked, columns);
  return plain;
}

}  // namespace

std::string told(std::span<const py::ssize_t> shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

std::string told(const py::array& array) {
  return "shape " + told(std::span(array.shape(), static_cast<std::size_t>(array.ndim()))) + " and dtype " +
         std::string(py::str(array.dtype()));
}

void refuse(const Asked& asked, const py::array& given, const std::string& expected) {
  throw py::value_error(where(asked) + " has " + told(given) + "; expected " + expected);
}

py::array numbers_of(const py::handle& given, const Asked& asked) {
  py::array array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(where(asked) + " is no array of numbers, but " +
                         std::string(py::str(py::type::of(given).attr("__name__"))));
  }
  if (is_usable(array)) return array;
  const char kind = array.dtype().kind();
  const bool floats = kind == 'f' && array.itemsize() <= 8;
  const bool integers = kind == 'i' || kind == 'u';
  if (!floats && !integers) {
    throw py::type_error(where(asked) + " has " + told(array) +
                         "; expected float64, or what is float64 without rounding: float16, float32, integers");
  }
  if (integers && array.itemsize() > 4) require_whole(array, asked);
  return py::array(array.attr("astype")(py::dtype::of<double>()));
}

py::array_t<double> rows_of(const py::handle& given, const Asked& asked, py::ssize_t columns) {
  py::array numbers = numbers_of(given, asked);
  if (numbers.ndim() != 2 || numbers.shape(1) != columns) {
    if (numbers.size() == 0 && numbers.ndim() == 1) return py::array_t<double>(std::vector<py::ssize_t>{0, columns});
    refuse(asked, py::array::ensure(given), "shape (n, " + std::to_string(columns) + ")");
  }
  return finite_rows(numbers, asked, columns);
}

py::array_t<double> rows_of_plane_or_space(const py::handle& given, const Asked& asked) {
  const py::array numbers = numbers_of(given, asked);
  if (numbers.ndim() != 2 || (numbers.shape(1) != 2 && numbers.shape(1) != 3))
    refuse(asked, py::array::ensure(given), "shape (n, 2) or (n, 3)");
  return rows_of(numbers, asked, numbers.shape(1));
}

py::array_t<double> row_or_rows_of(const py::handle& given, const Asked& asked, py::ssize_t columns, bool& single) {
  py::array numbers = numbers_of(given, asked);
  single = numbers.ndim() == 1 && numbers.shape(0) == columns;
  if (!single && (numbers.ndim() != 2 || numbers.shape(1) != columns)) {
    const std::string n = std::to_string(columns);
    refuse(asked, py::array::ensure(given), "shape (" + n + ",) or (n, " + n + ")");
  }
  return finite_rows(numbers, asked, columns);
}

}  // namespace plumb::python
