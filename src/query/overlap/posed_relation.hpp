// How do figures under poses lie to one another?  Of any kinds, by the exact images.
//
// Laws: those of query/overlap/posed.hpp.
// Method: straight figures by separating axes over numbers that know their errors, else by their images' generators in
// rationals; what goes into a round figure under its pose, against the round figure as it stands.
// Source: RTCD 3.2, 5.2.
// Cost: about a microsecond where axes answer; rationals some 100 us.
#pragma once

#include <string_view>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/body/posed.hpp"

namespace plumb::query {

/// The function is named in what is thrown.
Relation relate_posed(std::string_view function, const PosedView& a, const PosedView& b);

}  // namespace plumb::query
