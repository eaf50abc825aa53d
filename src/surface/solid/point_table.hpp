// Which exact point has which number?  Points as given first, then what is constructed from them, each once.
//
// Laws: one number a point, however it is held or constructed.  A constructed point that doubles hold is held as
// Point3, any other in rational coordinates.
// Source: plumb/certify/exact_point.hpp.
// Cost: a search of what is given for a point that doubles hold; some microseconds once for any other, a look-up where
// the same construction comes again.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "surface/solid/numbered_points.hpp"

namespace plumb::surface {

/// Held as law 1 of exact_mesh.hpp says.
ExactPoint3 in_plain_form(ExactPoint3 p);

class PointTable {
 public:
  /// Points as given ascend, no two are equal, and they outlive this.
  explicit PointTable(std::span<const Point3> given) : given_(given) {}
  /// Then come such as no doubles hold.
  explicit PointTable(const NumberedPoints& points);
  PointTable(const PointTable&) = delete;
  PointTable& operator=(const PointTable&) = delete;

  [[nodiscard]] NumberedPoints points() const { return {given_, made_}; }
  [[nodiscard]] std::size_t size() const { return given_.size() + made_.size(); }
  [[nodiscard]] bool is_given(std::uint32_t number) const { return number < given_.size(); }
  [[nodiscard]] const Point3& given(std::uint32_t number) const { return given_[number]; }
  std::uint32_t number_of(ExactPoint3 point);
  /// Remembers that a point that is not given is on the line through these two, which saves signs that would be zero.  Two
  /// lines a point are kept.
  void note_line(std::uint32_t number, const std::array<std::uint32_t, 2>& line);
  [[nodiscard]] bool is_noted_on(std::uint32_t number, const std::array<std::uint32_t, 2>& line) const {
    if (is_given(number) || number - given_.size() >= lines_.size()) return false;
    const auto& of = lines_[number - given_.size()];
    return of[0] == line || of[1] == line;
  }
  /// How many of the points as given come before this one?
  [[nodiscard]] std::uint32_t given_before(const ExactPoint3& point) const;
  /// Gives up the points that are not given, in order of their numbers; nothing may be asked about them after it.
  std::vector<ExactPoint3> take_made() && { return std::move(made_); }

 private:
  [[nodiscard]] std::uint32_t given_number(const Point3& p) const;
  std::uint32_t number_of_place(ExactPoint3 point);

  /// Points that were made are looked up by their places among made_, so that none is held twice.
  struct HashOfPlace {
    using is_transparent = void;
    const std::vector<ExactPoint3>* made;
    std::size_t operator()(const ExactPoint3& p) const { return hash_value(p); }
    std::size_t operator()(std::uint32_t place) const { return hash_value((*made)[place]); }
  };
  struct SamePlace {
    using is_transparent = void;
    const std::vector<ExactPoint3>* made;
    bool operator()(std::uint32_t l, std::uint32_t r) const { return l == r; }  // no two of them are equal
    bool operator()(const ExactPoint3& p, std::uint32_t place) const { return p == (*made)[place]; }
    bool operator()(std::uint32_t place, const ExactPoint3& p) const { return p == (*made)[place]; }
  };
  struct HashOfConstruction {
    std::size_t operator()(const LinePlanePoint3& p) const;
  };

  std::span<const Point3> given_;
  std::vector<ExactPoint3> made_;
  using TwoLines = std::array<std::array<std::uint32_t, 2>, 2>;
  std::vector<TwoLines> lines_;  // of points that were made, as far as they are noted
  std::unordered_set<std::uint32_t, HashOfPlace, SamePlace> places_{0, HashOfPlace{&made_}, SamePlace{&made_}};
  std::unordered_map<LinePlanePoint3, std::uint32_t, HashOfConstruction> constructions_;
};

}  // namespace plumb::surface
