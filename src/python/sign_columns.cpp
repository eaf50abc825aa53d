#include "python/sign_columns.hpp"

#include <algorithm>

namespace plumb::python {
namespace {

using Shape = std::vector<py::ssize_t>;
constexpr auto item = static_cast<py::ssize_t>(sizeof(double));
// Below this a call for each run costs more than to lay out the numbers.
constexpr std::size_t short_run = 256;

Shape outer_shape(const GivenNumbers& given) {
  const py::ssize_t* shape = given.array.shape();
  return {shape, shape + given.array.ndim() - static_cast<py::ssize_t>(given.own)};
}

Shape broadcast_shape(const std::vector<GivenNumbers>& given, const SignQuestion& question, const SignForm& form) {
  Shape all;
  for (const GivenNumbers& g : given) {
    const Shape own = outer_shape(g);
    if (own.size() > all.size()) all.insert(all.begin(), own.size() - all.size(), 1);
    for (std::size_t i = 1; i <= own.size(); ++i) {
      py::ssize_t& to = all[all.size() - i];
      const py::ssize_t length = own[own.size() - i];
      if (to == 1) {
        to = length;
      } else if (length != 1 && length != to) {
        std::string text = question.name + ": shapes do not broadcast together:";
        for (std::size_t a = 0; a < given.size(); ++a) {
          const py::array& array = given[a].array;
          text += (a == 0 ? " " : ", ") + form.arguments[a].name + " " +
                  told(std::span(array.shape(), static_cast<std::size_t>(array.ndim())));
        }
        throw py::value_error(text);
      }
    }
  }
  return all;
}

/// Tells by how many bytes an argument goes on along each axis of the answer.
Shape strides_along(const GivenNumbers& given, const Shape& shape) {
  const Shape own = outer_shape(given);
  Shape strides(shape.size(), 0);
  for (std::size_t i = 1; i <= own.size(); ++i) {
    const std::size_t axis = own.size() - i;
    if (own[axis] != 1) strides[shape.size() - i] = given.array.strides(static_cast<py::ssize_t>(axis));
  }
  return strides;
}

/// Axes of which each is one run in all arguments, outermost first.
struct Axes {
  Shape lengths;
  std::vector<Shape> strides;  // by argument
};
Axes merged(const Shape& shape, const std::vector<Shape>& strides) {
  Axes axes{{}, std::vector<Shape>(strides.size())};
  for (std::size_t d = 0; d < shape.size(); ++d) {
    if (shape[d] == 1) continue;
    bool goes_on = !axes.lengths.empty();
    for (std::size_t a = 0; a < strides.size() && goes_on; ++a) {
      goes_on = axes.strides[a].back() == strides[a][d] * shape[d];
    }
    if (goes_on) {
      axes.lengths.back() *= shape[d];
    } else {
      axes.lengths.push_back(shape[d]);
    }
    for (std::size_t a = 0; a < strides.size(); ++a) {
      if (goes_on) {
        axes.strides[a].back() = strides[a][d];
      } else {
        axes.strides[a].push_back(strides[a][d]);
      }
    }
  }
  return axes;
}

bool are_whole_numbers(const Shape& strides) {
  return std::ranges::all_of(strides, [](py::ssize_t s) { return s % item == 0; });
}

/// Can columns reach it?  Strides of whole numbers, and along the run none that goes backward.
bool is_reached(const GivenNumbers& given, const Shape& strides) {
  const Shape all(given.array.strides(), given.array.strides() + given.array.ndim());
  return are_whole_numbers(all) && (strides.empty() || strides.back() >= 0);
}

/// The numbers of one argument laid out anew, each item of the answer having its own.
py::array laid_out(const GivenNumbers& given, const Shape& shape) {
  Shape whole = shape;
  whole.insert(whole.end(), given.array.shape() + given.array.ndim() - static_cast<py::ssize_t>(given.own),
               given.array.shape() + given.array.ndim());
  py::tuple shape_wanted(whole.size());
  for (std::size_t d = 0; d < whole.size(); ++d) shape_wanted[d] = whole[d];
  const py::module_ numpy = py::module_::import("numpy");
  return numpy.attr("ascontiguousarray")(numpy.attr("broadcast_to")(given.array, shape_wanted));
}

Axes axes_of(const std::vector<GivenNumbers>& given, const Shape& shape) {
  std::vector<Shape> strides;
  for (const GivenNumbers& g : given) strides.push_back(strides_along(g, shape));
  return merged(shape, strides);
}

/// The columns of one argument's numbers, in their order.
void add_columns(const GivenNumbers& given, const Shape& along, std::size_t run, SignColumns& to) {
  const auto* base = static_cast<const char*>(given.array.data());
  const py::ssize_t first_axis = given.array.ndim() - static_cast<py::ssize_t>(given.own);
  Shape at(given.own, 0);
  const auto add = [&](py::ssize_t offset) {
    const auto stride = along.empty() ? 0 : along.back() / item;
    to.columns.push_back({reinterpret_cast<const double*>(base + offset), static_cast<std::size_t>(stride), run, true});
    Shape outer;
    for (std::size_t d = 0; d + 1 < along.size(); ++d) outer.push_back(along[d] / item);
    to.strides.push_back(std::move(outer));
  };
  if (given.own == 0) return add(0);
  const auto length = [&](std::size_t axis) { return given.array.shape(first_axis + static_cast<py::ssize_t>(axis)); };
  const auto stride = [&](std::size_t axis) {
    return given.array.strides(first_axis + static_cast<py::ssize_t>(axis));
  };
  for (py::ssize_t i = 0; i < length(0); ++i) {
    if (given.own == 1) {
      add(i * stride(0));
      continue;
    }
    for (py::ssize_t j = 0; j < length(1); ++j) add(i * stride(0) + j * stride(1));
  }
}

}  // namespace

std::size_t SignColumns::runs() const {
  std::size_t n = 1;
  for (const py::ssize_t length : outer) n *= static_cast<std::size_t>(length);
  return n;
}

std::vector<certify::batch::Column> SignColumns::of_run(std::size_t r) const {
  std::vector<certify::batch::Column> moved = columns;
  for (std::size_t d = outer.size(); d-- > 0;) {
    const auto index = static_cast<py::ssize_t>(r % static_cast<std::size_t>(outer[d]));
    r /= static_cast<std::size_t>(outer[d]);
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k].at += index * strides[k][d];
  }
  return moved;
}

SignColumns columns_of(std::vector<GivenNumbers>& given, const SignQuestion& question, const SignForm& form) {
  SignColumns out;
  out.shape = broadcast_shape(given, question, form);
  Axes axes = axes_of(given, out.shape);
  bool anew = axes.lengths.size() > 1 && static_cast<std::size_t>(axes.lengths.back()) < short_run;
  for (std::size_t a = 0; a < given.size(); ++a) anew = anew || !is_reached(given[a], axes.strides[a]);
  if (anew) {
    for (GivenNumbers& g : given) g.array = laid_out(g, out.shape);
    axes = axes_of(given, out.shape);
  }
  if (!axes.lengths.empty()) {
    out.run = static_cast<std::size_t>(axes.lengths.back());
    out.outer.assign(axes.lengths.begin(), axes.lengths.end() - 1);
  }
  for (std::size_t a = 0; a < given.size(); ++a) add_columns(given[a], axes.strides[a], out.run, out);
  return out;
}

}  // namespace plumb::python
