// Which line of text is a figure?  What query/body/any_figure.hpp says of to_string, of one that nobody has copied.
//
// Source: none.
// Cost: linear in the numbers.  Nothing is searched.
#pragma once

#include <string>

#include "plumb/query/body/any_figure.hpp"
#include "query/body/line_parts.hpp"

namespace plumb::query {

std::string figure_line(const PosedView& posed);
/// The same behind what the line has so far, not written out.
void tell_figure(const PosedView& posed, LineParts& line);

}  // namespace plumb::query
