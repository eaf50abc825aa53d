// Which exact point has which number?  Points as given first, then what is constructed from them, each once.
//
// Laws: one number a point, however it is held or constructed.  A constructed point that doubles hold is held as
// Point3, any other in rational coordinates.
// Source: plumb/certify/exact_point.hpp.
// Cost: a search of what is given for a point that doubles hold; some microseconds once for any other, and a look-up.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "surface/solid/numbered_points.hpp"

namespace plumb::surface {

/// Held as law 1 of exact_mesh.hpp says.
ExactPoint3 in_plain_form(const ExactPoint3& p);

class PointTable {
 public:
  /// Points as given ascend, no two are equal, and they outlive this.
  explicit PointTable(std::span<const Point3> given) : given_(given) {}
  /// Then come such as no doubles hold.
  explicit PointTable(const NumberedPoints& points);

  [[nodiscard]] NumberedPoints points() const { return {given_, made_}; }
  [[nodiscard]] std::size_t size() const { return given_.size() + made_.size(); }
  [[nodiscard]] bool is_given(std::uint32_t number) const { return number < given_.size(); }
  [[nodiscard]] const Point3& given(std::uint32_t number) const { return given_[number]; }
  [[nodiscard]] ExactPoint3 point(std::uint32_t number) const { return points().at(number); }
  std::uint32_t number_of(const ExactPoint3& point);
  /// How many of the points as given come before this one?
  [[nodiscard]] std::uint32_t given_before(const ExactPoint3& point) const;

 private:
  [[nodiscard]] std::uint32_t given_number(const Point3& p) const;

  std::span<const Point3> given_;
  std::vector<ExactPoint3> made_;
  std::unordered_map<ExactPoint3, std::uint32_t> number_;
};

}  // namespace plumb::surface
