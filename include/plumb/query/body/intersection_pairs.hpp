// What have two figures in common?  The pairs that intersection takes.
//
// Laws: those of query/body/question_table.hpp.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include "plumb/query/body/question_table.hpp"

namespace plumb::query {

// clang-format off
inline constexpr QuestionTable intersection_pairs{
    "intersection", PairOrder::either, "-xc", {"-", "crossing", "clipping"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "-----------------------",
     /* line               */ " xxxxxcx----c-cc------c",
     /* ray                */ "  xxxxcx----c-cc------c",
     /* segment            */ "   xxxcx----c-cc------c",
     /* plane              */ "    cc-c----c-cc------c",
     /* three-point plane  */ "     c-c----c-cc------c",
     /* halfspace          */ "      -c---------------",
     /* triangle           */ "       c----c-cc------c",
     /* quad               */ "        ---------------",
     /* polygon            */ "         --------------",
     /* holed              */ "          -------------",
     /* rectangle          */ "           ------------",
     /* tetra              */ "            -----------",
     /* ball               */ "             ----------",
     /* aabb               */ "              ---------",
     /* obb                */ "               --------",
     /* capsule            */ "                -------",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ---",
     /* halfspaces         */ "                     --",
     /* polyhedron         */ "                      -"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "-----------------------",
     /* line               */ " xxx---c-c----c--------",
     /* ray                */ "  xx---c-c----c--------",
     /* segment            */ "   x---c-c----c--------",
     /* plane              */ "    -------------------",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       c-c----c--------",
     /* quad               */ "        ---------------",
     /* polygon            */ "         c----c--------",
     /* holed              */ "          -------------",
     /* rectangle          */ "           ------------",
     /* tetra              */ "            -----------",
     /* ball               */ "             ----------",
     /* aabb               */ "              c--------",
     /* obb                */ "               --------",
     /* capsule            */ "                -------",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ---",
     /* halfspaces         */ "                     --",
     /* polyhedron         */ "                      -"}};
// clang-format on

}  // namespace plumb::query
