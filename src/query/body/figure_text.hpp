// Which line of text is a figure?  What query/body/any_figure.hpp says of to_string, of one that nobody has copied.
//
// Source: none.
// Cost: linear in the numbers.  Nothing is searched.
#pragma once

#include <string>

#include "plumb/query/body/any_figure.hpp"

namespace plumb::query {

std::string figure_line(const PosedView& posed);

}  // namespace plumb::query
