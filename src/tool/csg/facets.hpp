// Which mesh has a cube, polyhedron, cylinder or sphere of OpenSCAD?
//
// Laws: (1) cubes and polyhedra have the corners as given; what is centered has corners of sums that are rounded once.
// (2) Cylinders and spheres have the facets that OpenSCAD gives them, by $fn, $fa and $fs: they are solids with flat
// sides, whose corners are what they are, and no balls.  (3) Faces turn counterclockwise seen from outside; those of a
// polyhedron are given clockwise.  (4) What OpenSCAD would not make throws Error, which names the text and line.
// Source: OpenSCAD's manual; its rule for the number of fragments.
// Cost: linear in the facets, of which there are at most most_fragments around.
#pragma once

#include <string>

#include "plumb/figure/basic/mesh.hpp"
#include "tool/csg/syntax.hpp"

namespace plumb::tool {

inline constexpr double most_fragments = 4096;

/// Arguments by name, or by their place among these names where they have none.
class CsgArguments {
 public:
  CsgArguments(const CsgCall& call, const std::string& text, std::vector<std::string> in_order);

  [[nodiscard]] const CsgValue* find(const std::string& name) const;
  [[nodiscard]] double number(const std::string& name, double otherwise) const;
  [[nodiscard]] bool flag(const std::string& name) const;
  /// Rows of so many numbers each, from fewest to most.
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& name, std::size_t fewest,
                                                      std::size_t most) const;
  [[nodiscard]] std::vector<double> numbers(const CsgValue& list, const std::string& name) const;
  [[noreturn]] void fail(const std::string& text) const;

 private:
  const CsgCall& call_;
  const std::string& text_;
  std::vector<std::string> in_order_;
};

PolygonMesh mesh_of_cube(const CsgCall& call, const std::string& text);
PolygonMesh mesh_of_polyhedron(const CsgCall& call, const std::string& text);
PolygonMesh mesh_of_cylinder(const CsgCall& call, const std::string& text);
PolygonMesh mesh_of_sphere(const CsgCall& call, const std::string& text);

}  // namespace plumb::tool
