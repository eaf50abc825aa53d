#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual doctor_manual() {
  return {"plumb doctor",
          "is this machine as the proofs assume?",
          {"plumb doctor"},
          {{"DESCRIPTION", R"(
Exact signs rest on IEEE-754 doubles, rounded to nearest, with
subnormals, without fused or reordered operations. This command looks
whether that holds here, and prints the version, the build and the
instruction sets at hand: what a bug report should contain. It also
says which vectors batches of signs take here, and which they can.)"}},
          {{"EXIT STATUS", R"(
0      Everything is as the proofs assume.
1      Something is not; the report names it and its mend.
2      Wrong usage, or the report could not be written.)"},
           {"ENVIRONMENT", environment() + "\n" + environment_of_batches()}}};
}

}  // namespace plumb::tool
