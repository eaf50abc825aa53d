#include "tool/manual/help_text.hpp"

namespace plumb::tool {

Manual doctor_manual() {
  return {"plumb doctor",
          "is this machine as the proofs assume?",
          {"plumb doctor", "plumb doctor --digest[=SIZE] [--threads N]"},
          {{"DESCRIPTION", R"(
Exact signs rest on IEEE-754 doubles, rounded to nearest, with
subnormals, without fused or reordered operations. This command looks
whether that holds here, and prints the version, the build and the
instruction sets at hand: what a bug report should contain. It also
says which vectors batches of signs take here, and which they can.

With --digest it asks instead: questions of every kind, drawn from a
seed. Their answers are the same bits by every compiler, by every set
of instructions and on any number of threads. For each kind it prints
how many answers there were and a hash of them, in order; what differs
from the hashes that the program was built with is marked. Sizes are
full, a million answers in seconds, and small.)"}},
          {{"EXIT STATUS", R"(
0      Everything is as the proofs assume, or the digest as it must be.
1      Something is not; the report names it and its mend.
2      Wrong usage, or the report could not be written.)"},
           {"ENVIRONMENT", environment() + "\n" + environment_of_batches()}}};
}

}  // namespace plumb::tool
