// How near are two figures, and where?  The pairs that closest_points and distance take.
//
// Laws: those of query/body/question_table.hpp.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include "plumb/query/body/question_table.hpp"

namespace plumb::query {

// clang-format off
inline constexpr QuestionTable closest_pairs{
    "closest_points", PairOrder::either, "-frs", {"-", "feature", "radius", "search"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "fffffffffffffrffrr----f",
     /* line               */ " sss---s---------------",
     /* ray                */ "  ss---s---------------",
     /* segment            */ "   s---s---------------",
     /* plane              */ "    -------------------",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       s---------------",
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
     /* point              */ "ffff--fffff--rffr------",
     /* line               */ " sss---s---------------",
     /* ray                */ "  ss---s---------------",
     /* segment            */ "   s---s---------------",
     /* plane              */ "    -------------------",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       s---------------",
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
     /* polyhedron         */ "                      -"}};
// clang-format on

}  // namespace plumb::query
