// Does a figure hold a point, or another figure?  The pairs that contains takes, the outer figure first.
//
// Laws: those of query/body/question_table.hpp.  A point is told by locate (figure/containment/contains.hpp), two bounds of
// one kind where they are declared.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include "plumb/query/body/question_table.hpp"

namespace plumb::query {

// clang-format off
inline constexpr QuestionTable contains_pairs{
    "contains", PairOrder::as_named, "-lb", {"-", "location", "bounds"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "-----------------------",
     /* line               */ "l----------------------",
     /* ray                */ "l----------------------",
     /* segment            */ "l----------------------",
     /* plane              */ "l----------------------",
     /* three-point plane  */ "l----------------------",
     /* halfspace          */ "l----------------------",
     /* triangle           */ "l----------------------",
     /* quad               */ "l----------------------",
     /* polygon            */ "l----------------------",
     /* holed              */ "l----------------------",
     /* rectangle          */ "l----------------------",
     /* tetra              */ "l----------------------",
     /* ball               */ "l------------b---------",
     /* aabb               */ "l-------------b--------",
     /* obb                */ "l----------------------",
     /* capsule            */ "l---------------b------",
     /* lozenge            */ "l----------------b-----",
     /* cylinder           */ "l----------------------",
     /* cone               */ "l----------------------",
     /* k-dop              */ "l-------------------b--",
     /* halfspaces         */ "l----------------------",
     /* polyhedron         */ "l----------------------"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "-----------------------",
     /* line               */ "l----------------------",
     /* ray                */ "l----------------------",
     /* segment            */ "l----------------------",
     /* plane              */ "-----------------------",
     /* three-point plane  */ "-----------------------",
     /* halfspace          */ "l----------------------",
     /* triangle           */ "l----------------------",
     /* quad               */ "l----------------------",
     /* polygon            */ "l----------------------",
     /* holed              */ "l----------------------",
     /* rectangle          */ "-----------------------",
     /* tetra              */ "-----------------------",
     /* ball               */ "l------------b---------",
     /* aabb               */ "l-------------b--------",
     /* obb                */ "l----------------------",
     /* capsule            */ "l----------------------",
     /* lozenge            */ "-----------------------",
     /* cylinder           */ "-----------------------",
     /* cone               */ "-----------------------",
     /* k-dop              */ "l-------------------b--",
     /* halfspaces         */ "l----------------------",
     /* polyhedron         */ "-----------------------"}};
// clang-format on

}  // namespace plumb::query
