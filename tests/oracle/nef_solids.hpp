// Which points do solids made by boolean operations hold, and are two solids the same?  By CGAL's Nef polyhedra.
//
// Laws: exact for all rational coordinates.  Operations are regularized: the closure of what is inside.  A surface that is
// no 2-manifold makes no solid here.
// Source: CGAL's manual, "3D Boolean Operations on Nef Polyhedra"; Hachenberger, Kettner and Mehlhorn 2007.
// Cost: some milliseconds an operation of a few dozen faces.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plumb/arith/sign.hpp"

namespace plumb::oracle {

/// Quotients of integers: {"1/3", "2", "-5"}.
using QuotientPoint = std::array<std::string, 3>;

enum class SolidOperation { unite, intersect, subtract, symmetric_difference };

class NefSolid {
 public:
  /// Of a closed surface that is wound outward.
  static std::optional<NefSolid> of(const std::vector<QuotientPoint>& vertices,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles);

  [[nodiscard]] NefSolid by(SolidOperation operation, const NefSolid& other) const;
  /// Positive inside, zero on the boundary.
  [[nodiscard]] Sign place(const QuotientPoint& p) const;
  [[nodiscard]] bool is_same(const NefSolid& other) const;

 private:
  struct Polyhedron;
  explicit NefSolid(std::shared_ptr<const Polyhedron> p) : polyhedron_(std::move(p)) {}
  std::shared_ptr<const Polyhedron> polyhedron_;
};

}  // namespace plumb::oracle
