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
     /* halfspace          */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* triangle           */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* quad               */ "l----------------------",
     /* polygon            */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* holed              */ "l----------------------",
     /* rectangle          */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* tetra              */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* ball               */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* aabb               */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* obb                */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* capsule            */ "lbbb--bbbbbbbbbbbb--bbb",
     /* lozenge            */ "lbbb--bbbbbbbbbbbb--bbb",
     /* cylinder           */ "lbbb--bbbbbbbbbbbb--bbb",
     /* cone               */ "l----------------------",
     /* k-dop              */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* halfspaces         */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* polyhedron         */ "lbbb--bbbbbbbbbbbbbbbbb",
     /* cap                */ "l"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "-----------------------",
     /* line               */ "l----------------------",
     /* ray                */ "l----------------------",
     /* segment            */ "l----------------------",
     /* plane              */ "-----------------------",
     /* three-point plane  */ "-----------------------",
     /* halfspace          */ "lbbb--bbbbb--bbbb---bb-",
     /* triangle           */ "lbbb--bbbbb--bbbb---bb-",
     /* quad               */ "l----------------------",
     /* polygon            */ "lbbb--bbbbb--bbbb---bb-",
     /* holed              */ "l----------------------",
     /* rectangle          */ "-----------------------",
     /* tetra              */ "-----------------------",
     /* ball               */ "lbbb--bbbbb--bbbb---bb-",
     /* aabb               */ "lbbb--bbbbb--bbbb---bb-",
     /* obb                */ "lbbb--bbbbb--bbbb---bb-",
     /* capsule            */ "lbbb--bbbbb--bbbb---bb-",
     /* lozenge            */ "-----------------------",
     /* cylinder           */ "-----------------------",
     /* cone               */ "-----------------------",
     /* k-dop              */ "lbbb--bbbbb--bbbb---bb-",
     /* halfspaces         */ "lbbb--bbbbb--bbbb---bb-",
     /* polyhedron         */ "-----------------------"}};
// clang-format on

}  // namespace plumb::query
