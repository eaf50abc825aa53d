// Continuous collision detection: is it enough to know whether figures in motion meet, or also when first?
//
// Law: whether they meet does not depend on what is wanted.
// Source: RTCD 5.5.
// Cost: none.
#pragma once

namespace plumb::query {

enum class ContactWanted : unsigned char { whether, when };

}  // namespace plumb::query
