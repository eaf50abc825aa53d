// How does this thread stay fit for exact signs, whatever foreign code has set?  Its rounding mode and its treatment of
// subnormals, put back at the end of a scope.
//
// Source: the C standard, <fenv.h>.
// Cost: some tens of ns.
#pragma once

#include <cfenv>

namespace plumb::degenerate {

class KeptEnvironment {
 public:
  KeptEnvironment() { std::fegetenv(&before_); }
  KeptEnvironment(const KeptEnvironment&) = delete;
  KeptEnvironment& operator=(const KeptEnvironment&) = delete;
  ~KeptEnvironment() { std::fesetenv(&before_); }

 private:
  std::fenv_t before_{};
};

}  // namespace plumb::degenerate
