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
     /* point              */ "l--ll--llllllqllqq----l",
     /* line               */ " ----------------------",
     /* ray                */ "  ---------------------",
     /* segment            */ "   ll--llllllqllqq----l",
     /* plane              */ "    ---llllllqllqq----l",
     /* three-point plane  */ "     ------------------",
     /* halfspace          */ "      -----------------",
     /* triangle           */ "       llllllqllqq----l",
     /* quad               */ "        lllllqllqq----l",
     /* polygon            */ "         llllqllqq----l",
     /* holed              */ "          lllqllqq----l",
     /* rectangle          */ "           llqllqq----l",
     /* tetra              */ "            lqllqq----l",
     /* ball               */ "             qqqqq----q",
     /* aabb               */ "              llqq----l",
     /* obb                */ "               lqq----l",
     /* capsule            */ "                qq----q",
     /* lozenge            */ "                 q----q",
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
