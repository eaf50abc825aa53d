// What is right where functions differ in what they promise?  A kind of question under a declared convention.
//
//   const Kind kind = under(kind_named("point-in-polygon"), {.boundary = Boundary::out});
//   EXPECT_TRUE(check(kind, my_inside).clean());
//
// Laws: (1) the exact answer is that of the convention: without its boundary a figure is its interior, relative to what
// it spans where it spans less than the space (figure/basic/relation.hpp), so that two figures meet where `relate` says
// overlapping; without its origin a ray hits where a point of it beyond the origin does, and its parameter is the
// greatest lower bound of all such; (2) under `any` the answers under both are right, and `exact` is the closed one;
// (3) all else of the kind stays, its name and its lines of cases too.
// Source: RTCD 11.
// Cost: the exact answer, once for each that is right.
#pragma once

#include <string>

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

/// Throws Error where the convention makes no difference to the kind.
Kind under(const Kind& kind, const Convention& convention);

inline constexpr std::array<std::string_view, 3> boundary_names = {"in", "out", "any"},
                                                 ends_names = {"closed", "open", "any"};
constexpr std::string_view name_of(Boundary boundary) { return boundary_names[static_cast<std::size_t>(boundary)]; }
constexpr std::string_view name_of(Ends ends) { return ends_names[static_cast<std::size_t>(ends)]; }

}  // namespace plumb::degenerate
