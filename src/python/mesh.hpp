// A mesh as Python holds it: vertices and triangles that NumPy sees without a copy, and that nobody changes.
//
// Source: none.
// Cost: one copy where it is made of arrays.
#pragma once

#include <memory>

#include "plumb/figure/basic/mesh.hpp"
#include "python/numbers.hpp"

namespace plumb::python {

/// Trees and views keep it alive.
using SharedMesh = std::shared_ptr<const TriangleMesh>;

/// What os.fspath makes of it.
std::string path_of(const py::handle& given);

/// A read-only array over items that `owner` keeps alive.
template <class Number, class Item>
py::array view_of(std::span<const Item> items, const py::handle& owner) {
  constexpr auto columns = static_cast<py::ssize_t>(sizeof(Item) / sizeof(Number));
  py::array_t<Number> view(std::vector<py::ssize_t>{static_cast<py::ssize_t>(items.size()), columns},
                           reinterpret_cast<const Number*>(items.data()), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

}  // namespace plumb::python
