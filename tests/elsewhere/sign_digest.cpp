// Are the signs and the batches of this build, on this processor, those of the digest that stands in the repository?  By
// every set of instructions, on several threads, and in full.
#include <cstdio>
#include <string>

#include "certify/batch/take_instruction_set.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "tool/doctor/digest.hpp"

namespace plumb::tool {
namespace {

bool is_expected(std::size_t part, DigestSize size, const std::string& how) {
  HashedAnswers answers;
  const std::uint64_t times = size == DigestSize::full ? 16 : 1;
  part == 0 ? answer_signs(answers, times) : answer_batches(answers, times);
  const PartDigest found{answers.count(), answers.hash()};
  const bool is = found == expected_digest(size).parts[part];
  std::printf("%s %llu answers, %016llx, by %s: %s\n", part == 0 ? "signs" : "batches",
              static_cast<unsigned long long>(found.count), static_cast<unsigned long long>(found.hash), how.c_str(),
              is ? "as expected" : "DIFFER");
  return is;
}

}  // namespace
}  // namespace plumb::tool

int main() {
  using namespace plumb;
  bool good = true;
  for (const std::string_view set : batch_instruction_sets()) {
    certify::batch::take_instruction_set(set);
    for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
      const ThreadLimit limit(threads);
      const std::string how = std::string(set) + ", threads: " + std::to_string(threads);
      good = tool::is_expected(0, tool::DigestSize::small, how) && good;
      good = tool::is_expected(1, tool::DigestSize::small, how) && good;
    }
  }
  certify::batch::take_instruction_set({});
  good = tool::is_expected(0, tool::DigestSize::full, "the best") && good;
  good = tool::is_expected(1, tool::DigestSize::full, "the best") && good;
  return good ? 0 : 1;
}
