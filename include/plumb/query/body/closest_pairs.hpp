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
     /* point              */ "fffffffffffffrffrr--ssf",
     /* line               */ " ssssssssssssrssrr--sss",
     /* ray                */ "  sssssssssssrssrr--sss",
     /* segment            */ "   ssssssssssrssrr--sss",
     /* plane              */ "    sssssssssrssrr--sss",
     /* three-point plane  */ "     ssssssssrssrr--sss",
     /* halfspace          */ "      sssssssrssrr--sss",
     /* triangle           */ "       ssssssrssrr--sss",
     /* quad               */ "        sssssrssrr--sss",
     /* polygon            */ "         ssssrssrr--sss",
     /* holed              */ "          sssrssrr--sss",
     /* rectangle          */ "           ssrssrr--sss",
     /* tetra              */ "            srssrr--sss",
     /* ball               */ "             rrrrr--rrr",
     /* aabb               */ "              ssrr--sss",
     /* obb                */ "               srr--sss",
     /* capsule            */ "                rr--rrr",
     /* lozenge            */ "                 r--rrr",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    sss",
     /* halfspaces         */ "                     ss",
     /* polyhedron         */ "                      s"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "ffff--fffff--rffr---ss-",
     /* line               */ " sss--sssss--rssr---ss-",
     /* ray                */ "  ss--sssss--rssr---ss-",
     /* segment            */ "   s--sssss--rssr---ss-",
     /* plane              */ "    -------------------",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      sssss--rssr---ss-",
     /* triangle           */ "       ssss--rssr---ss-",
     /* quad               */ "        sss--rssr---ss-",
     /* polygon            */ "         ss--rssr---ss-",
     /* holed              */ "          s--rssr---ss-",
     /* rectangle          */ "           ------------",
     /* tetra              */ "            -----------",
     /* ball               */ "             rrrr---rr-",
     /* aabb               */ "              ssr---ss-",
     /* obb                */ "               sr---ss-",
     /* capsule            */ "                r---rr-",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ss-",
     /* halfspaces         */ "                     s-",
     /* polyhedron         */ "                      -"}};
// clang-format on

}  // namespace plumb::query
