// Are answers the same bits by every set of instructions, on any number of threads, and by every compiler?  `plumb
// doctor --digest`: the hashes stand in src/tool/doctor/expected_digest.cpp, and every build is held against them.
#include "tool/doctor/digest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Digest, IsTheSameByEverySetOfInstructionsAndOnAnyNumberOfThreads) {
  std::size_t asked = 0;
  for (const std::string_view set : batch_instruction_sets()) {
    if (battery::sanitized && asked == 1) break;  // seconds each
    certify::batch::take_instruction_set(set);
    for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
      if (battery::sanitized && threads == 1) continue;
      const ThreadLimit limit(threads);
      const Digest found = digest_of_answers(DigestSize::small), &expected = expected_digest(DigestSize::small);
      EXPECT_EQ(found.all, expected.all) << set << ", " << threads << " threads\n"
                                         << digest_text(found, expected, Style(false));
      ++asked;
    }
  }
  certify::batch::take_instruction_set({});
  EXPECT_GT(asked, battery::sanitized ? 0U : 3U);
}

TEST(Digest, InFullHasAMillionAnswersOfEveryKind) {
  const Digest& expected = expected_digest(DigestSize::full);
  EXPECT_GT(expected.all.count, 1'000'000U);
  for (const PartDigest& part : expected.parts) EXPECT_GT(part.count, 10'000U);
  if (battery::sanitized) return;
  const Digest found = digest_of_answers(DigestSize::full);
  EXPECT_EQ(found.all, expected.all) << digest_text(found, expected, Style(false));
}

TEST(Digest, NoticesEveryBitAndTheOrder) {
  std::set<std::uint64_t> hashes;
  const auto hash = [](std::initializer_list<double> numbers) {
    HashedAnswers a;
    for (const double x : numbers) a.add(x);
    return a.hash();
  };
  for (const double x : {0.0, -0.0, 1.0, 1 + 0x1p-52}) {
    for (const double y : {0.0, -0.0, 1.0, 1 + 0x1p-52}) hashes.insert(hash({x, y}));
  }
  hashes.insert({hash({}), hash({0}), hash({0, 0, 0})});
  EXPECT_EQ(hashes.size(), 19U);
  HashedAnswers refused;
  refused.ask([] { throw Error("no"); });
  EXPECT_EQ(refused.count(), 1U);
}

TEST(Digest, SaysWhatDiffers) {
  const Digest& expected = expected_digest(DigestSize::small);
  Digest other = expected;
  EXPECT_THAT(digest_text(other, expected, Style(false)), Not(HasSubstr("DIFFERS")));
  ++other.parts[2].hash;
  other.all.hash = 1;
  EXPECT_THAT(
      digest_text(other, expected, Style(false)),
      ContainsRegex("relations +[0-9]+ +[0-9a-f]+  DIFFERS from [0-9]+ [0-9a-f]+\ndistances +[0-9]+ +[0-9a-f]+\n"
                    "(.*\n)*all +[0-9]+  0000000000000001  DIFFERS.*\n\nThe answers are not"));
}

TEST(Digest, IsACommand) {
  const Outcome o = run("$PLUMB doctor --digest=small --threads 2");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("The answers are as they must be."));
  EXPECT_THAT(run("$PLUMB help doctor").out, HasSubstr("--digest"));
  const Outcome wrong = run("$PLUMB doctor --digest=tiny");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("tiny"));
  EXPECT_EQ(run("$PLUMB doctor --digest=small --threads 0").code, 2);
}

}  // namespace
}  // namespace plumb::tool
