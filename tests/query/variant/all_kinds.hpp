// One figure of every kind: of the plane, then of space.
#pragma once

#include <vector>

#include "plumb/query/body/any_figure.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/body/pair_types.hpp"

namespace plumb::pair_cases {

template <class... Shapes>
std::vector<plumb::AnyFigure> one_of_each(Types<Shapes...>, Material& m) {
  std::vector<plumb::AnyFigure> all;
  (all.push_back(plumb::AnyFigure(figure<Shapes>(m))), ...);
  return all;
}
inline std::vector<plumb::AnyFigure> all_kinds(Material& m) {
  std::vector<plumb::AnyFigure> all = one_of_each(Plane{}, m);
  for (const plumb::AnyFigure& s : one_of_each(Space{}, m)) all.push_back(s);
  return all;
}

}  // namespace plumb::pair_cases
