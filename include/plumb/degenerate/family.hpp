// What kinds of hard point sets are there?  The families of inputs, and the degeneracies that they are aimed at.
//
// Laws: `families` holds every Family once, in the order of the enumeration, simplest first; names are unique.
// docs/degeneracies.md shows each with a picture.
// Cost: none, constants.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "plumb/degenerate/entropy.hpp"

namespace plumb {

/// What a point set is to be degenerate in.  In the plane `coplanar` reads as collinear and `cospherical` as
/// cocircular; in space `cocircular` points lie on one circle in some plane.
enum class Degeneracy : unsigned char { collinear, coplanar, cocircular, cospherical };

inline constexpr std::array degeneracies = {Degeneracy::collinear, Degeneracy::coplanar, Degeneracy::cocircular,
                                            Degeneracy::cospherical};

enum class Family : unsigned char {
  grid,
  uniform,
  float32,
  near_half,
  degenerate_short,
  degenerate_long,
  off_by_ulps,
  repeated,
  wide,
  extreme,
  mixture,
};

struct FamilyInfo {
  Family family;
  std::string_view name;
  std::string_view about;
};

inline constexpr std::array families = {
    FamilyInfo{Family::grid, "grid", "integers of 1 to 20 bits, the size chosen once a set"},
    FamilyInfo{Family::uniform, "uniform", "uniform doubles in [0, 1) or (-1, 1), multiples of 2^-53"},
    FamilyInfo{Family::float32, "float32", "values a float32 holds, of magnitude below 1"},
    FamilyInfo{Family::near_half, "near_half",
               "0.5 + k 2^-53 with |k| up to 4 ... 256, and some small integers on the diagonal"},
    FamilyInfo{Family::degenerate_short, "degenerate_short", "exactly degenerate integers of 6 to 20 bits"},
    FamilyInfo{Family::degenerate_long, "degenerate_long", "exactly degenerate with mantissas of up to 53 bits"},
    FamilyInfo{Family::off_by_ulps, "off_by_ulps", "exactly degenerate, then up to three coordinates moved by ulps"},
    FamilyInfo{Family::repeated, "repeated", "points equal to others, shared coordinates, 0.0 beside -0.0"},
    FamilyInfo{Family::wide, "wide", "exponents from -40 to 40, independent or exactly degenerate"},
    FamilyInfo{Family::extreme, "extreme", "every exponent a double has, independent or degenerate to the ulp"},
    FamilyInfo{Family::mixture, "mixture", "points, coordinates and transformations of all other families"},
};

constexpr std::string_view name_of(Family family) { return families[static_cast<std::size_t>(family)].name; }

constexpr std::string_view name_of(Degeneracy degeneracy) {
  constexpr std::array<std::string_view, 4> names = {"collinear", "coplanar", "cocircular", "cospherical"};
  return names[static_cast<std::size_t>(degeneracy)];
}

/// The family of a name, if there is one.
constexpr std::optional<Family> family_named(std::string_view name) {
  for (const FamilyInfo& info : families) {
    if (info.name == name) return info.family;
  }
  return std::nullopt;
}

/// Any of the families: what fuzzers and properties start with.
inline Family any_family(Entropy& entropy) { return families[entropy.below(families.size())].family; }

}  // namespace plumb
