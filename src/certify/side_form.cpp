// What is thrown of a formula that cannot be taken apart; apart, because the header needs no more than the name.
#include "plumb/certify/detail/side_form.hpp"

#include <stdexcept>

namespace plumb::certify::side {

void throw_no_form(const char* reason) { throw std::logic_error(reason); }

}  // namespace plumb::certify::side
