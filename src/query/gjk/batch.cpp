#include "plumb/query/gjk/batch.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <string>

#include "certify/batch/all_threads.hpp"
#include "certify/batch/cases.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace query {
namespace {

constexpr std::size_t pairs_in_block = 64;

void require_as_many(std::string_view function, std::string_view name, std::size_t length, std::size_t pairs) {
  if (length != pairs) certify::batch::throw_unequal(function, name, length, "pairs", pairs);
}

/// The error in hand, with the pair's number behind the function's name.
template <class Refused>
std::exception_ptr with_number(const Refused& e, std::string_view function, std::size_t pair) {
  std::string text = e.what();
  if (text.starts_with(function)) text.insert(function.size(), " of pair " + std::to_string(pair));
  return std::make_exception_ptr(Refused(text));
}
std::exception_ptr current_of_pair(std::string_view function, std::size_t pair) {
  try {
    throw;
  } catch (const NonFinite& e) {
    return with_number(e, function, pair);
  } catch (const UnevenPose& e) {
    return with_number(e, function, pair);
  } catch (const InvalidShape& e) {
    return with_number(e, function, pair);
  } catch (...) {
    return std::current_exception();
  }
}

/// Calls ask(i) for each pair; throws what the lowest that throws does.
template <class Ask>
void ask_each(std::string_view function, std::size_t pairs, Execution execution, const Ask& ask) {
  std::mutex one_at_a_time;
  std::size_t lowest = pairs;
  std::exception_ptr refusal;
  const auto block = [&](std::size_t b) {
    const std::size_t end = std::min(pairs, (b + 1) * pairs_in_block);
    for (std::size_t i = b * pairs_in_block; i < end; ++i) {
      try {
        ask(i);
      } catch (...) {
        const std::lock_guard lock(one_at_a_time);
        if (i < lowest) lowest = i, refusal = current_of_pair(function, i);
        return;
      }
    }
  };
  const std::size_t blocks = (pairs + pairs_in_block - 1) / pairs_in_block;
  if (execution == Execution::parallel) {
    certify::batch::for_each_part(execution, blocks, block);
  } else {
    for (std::size_t b = 0; b < blocks && !refusal; ++b) block(b);
  }
  if (refusal) std::rethrow_exception(refusal);
}

template <class Answer, class Ask>
void answer_pairs(std::string_view function, std::span<const AnyBody3> bodies, std::span<const BodyPair> pairs,
                  std::span<Answer> out, const GjkBatchOptions& options, const Ask& ask) {
  require_as_many(function, "out", out.size(), pairs.size());
  if (!options.caches.empty()) require_as_many(function, "caches", options.caches.size(), pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::size_t most = std::max(pairs[i].a, pairs[i].b);
    if (most >= bodies.size()) {
      throw Error(std::string(function) + ": pair " + std::to_string(i) + " names body " + std::to_string(most) +
                  ", but there are " + std::to_string(bodies.size()) + "; they are numbered from 0");
    }
  }
  ask_each(function, pairs.size(), options.execution, [&](std::size_t i) {
    const GjkOptions of_pair{.cache = options.caches.empty() ? nullptr : &options.caches[i], .pair = options.pair};
    out[i] = static_cast<Answer>(ask(bodies[pairs[i].a], bodies[pairs[i].b], of_pair));
  });
}

}  // namespace
}  // namespace query

void gjk_intersects(std::span<const AnyBody3> bodies, std::span<const BodyPair> pairs, std::span<std::uint8_t> out,
                    const GjkBatchOptions& options) {
  query::answer_pairs("gjk_intersects", bodies, pairs, out, options, query::gjk_meets);
}

void gjk(std::span<const AnyBody3> bodies, std::span<const BodyPair> pairs, std::span<GjkAnswer> out,
         const GjkBatchOptions& options) {
  query::answer_pairs("gjk", bodies, pairs, out, options, query::gjk_answer);
}

}  // namespace plumb
