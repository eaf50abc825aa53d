// Where does a straight figure first hit another?  The pairs that first_hit and hits take, what is straight first.
//
// Laws: those of query/body/question_table.hpp.  A line, a ray and a segment hit the same figures.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include "plumb/query/body/question_table.hpp"

namespace plumb::query {

// clang-format off
inline constexpr QuestionTable hit_pairs{
    "first_hit", PairOrder::as_named, "-cehq", {"-", "clipping", "edges", "inequality", "quadratic"},
    rows_named({
     //                        plrsPTHtqghRebAOczynKIC (a column a letter)
     {FigureKind::line,       "----hhheeeeecqccqqqqc-c"},
     {FigureKind::ray,        "----hhheeeeecqccqqqqc-c"},
     {FigureKind::segment,    "----hhheeeeecqccqqqqc-c"}}),
    rows_named({
     //                        plrsPTHtqghRebAOczynKIC (a column a letter)
     {FigureKind::line,       "---e---eeee--qccq---c--"},
     {FigureKind::ray,        "---e---eeee--qccq---c--"},
     {FigureKind::segment,    "---e---eeee--qccq---c--"}})};
// clang-format on

}  // namespace plumb::query
