// When do two figures first meet that move?  The pairs that first_contact takes.
//
// Laws: those of query/body/question_table.hpp.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include "plumb/query/body/question_table.hpp"

namespace plumb::query {

// clang-format off
/// Along lines: the time is the root of a polynomial of that degree.
inline constexpr QuestionTable translating_pairs{
    "first_contact of Translating", PairOrder::either, "-lq", {"-", "linear", "quadratic"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "l--ll--l-----qllq-----l",
     /* line               */ " ----------------------",
     /* ray                */ "  ---------------------",
     /* segment            */ "   ll--l-----qllq-----l",
     /* plane              */ "    ---l-----qllq-----l",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       l-----qllq-----l",
     /* quad               */ "        -----q--q------",
     /* polygon            */ "         ----q--q------",
     /* holed              */ "          ---q--q------",
     /* rectangle          */ "           --q--q------",
     /* tetra              */ "            -----------",
     /* ball               */ "             qqqq-----q",
     /* aabb               */ "              llq-----l",
     /* obb                */ "               lq-----l",
     /* capsule            */ "                q-----q",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ---",
     /* halfspaces         */ "                     --",
     /* polyhedron         */ "                      l"},
    {
     //                          plrsPTHtqghRebAOczynKIC (a column a letter)
     /* point              */ "l--l---l-ll--qllq------",
     /* line               */ " ----------------------",
     /* ray                */ "  ---------------------",
     /* segment            */ "   l---l-ll--qllq------",
     /* plane              */ "    -------------------",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       l-ll--qllq------",
     /* quad               */ "        ---------------",
     /* polygon            */ "         ll--qllq------",
     /* holed              */ "          l--qllq------",
     /* rectangle          */ "           ------------",
     /* tetra              */ "            -----------",
     /* ball               */ "             qqqq------",
     /* aabb               */ "              llq------",
     /* obb                */ "               lq------",
     /* capsule            */ "                q------",
     /* lozenge            */ "                 ------",
     /* cylinder           */ "                  -----",
     /* cone               */ "                   ----",
     /* k-dop              */ "                    ---",
     /* halfspaces         */ "                     --",
     /* polyhedron         */ "                      -"}};

/// Whose vertices move linearly: by the roots of a cubic.
inline constexpr QuestionTable moving_pairs{
    "first_contact of Moving", PairOrder::either, "-c", {"-", "cubic"},
    rows_named({
     //                        plrsPTHtqghRebAOczynKIC (a column a letter)
     {FigureKind::point,      "-------c---------------"},
     {FigureKind::segment,    "   c-------------------"}}),
    rows_named({})};
// clang-format on

}  // namespace plumb::query
