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
     /* line               */ " xxxxxcx-c-cc-cc------c",
     /* ray                */ "  xxxxcx-c-cc-cc------c",
     /* segment            */ "   xxxcx-c-cc-cc------c",
     /* plane              */ "    cc-c-c-cc-cc------c",
     /* three-point plane  */ "     c-c-c-cc-cc------c",
     /* halfspace          */ "      cc-c-cc-cc----ccc",
     /* triangle           */ "       c-c-cc-cc------c",
     /* quad               */ "        ---------------",
     /* polygon            */ "         c-cc-cc------c",
     /* holed              */ "          -------------",
     /* rectangle          */ "           cc-cc------c",
     /* tetra              */ "            c-cc----ccc",
     /* ball               */ "             ----------",
     /* aabb               */ "              cc----ccc",
     /* obb                */ "               c----ccc",
     /* capsule            */ "                -------",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ccc",
     /* halfspaces         */ "                     cc",
     /* polyhedron         */ "                      c"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "-----------------------",
     /* line               */ " xxx---c-c----cc-------",
     /* ray                */ "  xx---c-c----cc-------",
     /* segment            */ "   x---c-c----cc-------",
     /* plane              */ "    -------------------",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       c-c----cc-------",
     /* quad               */ "        ---------------",
     /* polygon            */ "         c----cc-------",
     /* holed              */ "          -------------",
     /* rectangle          */ "           ------------",
     /* tetra              */ "            -----------",
     /* ball               */ "             ----------",
     /* aabb               */ "              cc-------",
     /* obb                */ "               c-------",
     /* capsule            */ "                -------",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ---",
     /* halfspaces         */ "                     --",
     /* polyhedron         */ "                      -"}};
// clang-format on

}  // namespace plumb::query
