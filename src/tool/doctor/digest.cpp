#include "tool/doctor/digest.hpp"

#include <fmt/format.h>

#include "plumb/certify/thread_limit.hpp"

namespace plumb::tool {
namespace {

PartDigest whole_of(const std::array<PartDigest, digest_parts.size()>& parts) {
  HashedAnswers all;
  std::uint64_t count = 0;
  for (const PartDigest& part : parts) {
    all.add(part.count), all.add(part.hash);
    count += part.count;
  }
  return {count, all.hash()};
}

}  // namespace

Digest digest_of_answers(DigestSize size) {
  Digest digest{};
  for (std::size_t k = 0; k < digest_parts.size(); ++k) {
    HashedAnswers answers;
    digest_parts[k].answer(answers, size == DigestSize::full ? 16 : 1);
    digest.parts[k] = {answers.count(), answers.hash()};
  }
  digest.all = whole_of(digest.parts);
  return digest;
}

std::string digest_text(const Digest& found, const Digest& expected, const Style& style) {
  std::string text;
  const auto line = [&](std::string_view name, const PartDigest& is, const PartDigest& should) {
    text += fmt::format("{:<10}{:>9}  {:016x}", name, is.count, is.hash);
    text += is == should ? "\n"
                         : "  " + style.red("DIFFERS") + fmt::format(" from {} {:016x}\n", should.count, should.hash);
  };
  for (std::size_t k = 0; k < digest_parts.size(); ++k) line(digest_parts[k].name, found.parts[k], expected.parts[k]);
  line("all", found.all, expected.all);
  return text + (found.all == expected.all ? "\nThe answers are as they must be.\n"
                                           : "\nThe answers are not those that they must be: please report this.\n");
}

int run_digest(DigestSize size, unsigned threads) {
  const ThreadLimit limit(threads);
  const Digest found = digest_of_answers(size);
  const Digest& expected = expected_digest(size);
  say(digest_text(found, expected, Style(stdout)));
  return found.all == expected.all ? 0 : 1;
}

}  // namespace plumb::tool
