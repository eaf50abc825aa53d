// In which words is it refused?
#pragma once

#include <string>

namespace plumb {

/// What the call throws says, if it throws this.
template <class Thrown, class Call>
std::string text_of(Call call) {
  try {
    call();
  } catch (const Thrown& e) {
    return e.what();
  }
  return "nothing thrown";
}

}  // namespace plumb
