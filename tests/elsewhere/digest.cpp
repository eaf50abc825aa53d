// Are the answers of this build, on this processor, those that stand in the repository?  What `plumb doctor --digest`
// asks, for a build without the program: small by every set of instructions and on several threads, or `full`.
#include "tool/doctor/digest.hpp"

#include <string>

#include "certify/batch/take_instruction_set.hpp"
#include "plumb/certify/instruction_set.hpp"

int main(int count, char** arguments) {
  using namespace plumb;
  if (count == 2 && std::string_view(arguments[1]) == "full") return tool::run_digest(tool::DigestSize::full, 1);
  int wrong = 0;
  for (const std::string_view set : batch_instruction_sets()) {
    certify::batch::take_instruction_set(set);
    for (const unsigned threads : {1U, 3U}) {
      tool::say(std::string(set) + ", threads: " + std::to_string(threads) + "\n");
      wrong += tool::run_digest(tool::DigestSize::small, threads);
    }
  }
  return wrong == 0 ? 0 : 1;
}
