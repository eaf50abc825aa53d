// Batches of any formula, by its own filter of a block.
#include "plumb/certify/signs_of.hpp"

#include <string>

#include "certify/batch/cases.hpp"
#include "certify/batch/instruction_sets.hpp"
#include "certify/refused_number.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/batch/signs_of.cpp"
#include <hwy/foreach_target.h>

#include "certify/batch/run_blocks.hpp"

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::certify::batch {
namespace {

PLUMB_EXPORT(run_blocks);

/// What an argument, or one of its coordinates, is called: "b", "b.y".
std::string name_of(const BatchFormula& asked, std::size_t coordinate, bool with_axis) {
  std::string name = place_of(coordinate, asked.arguments, asked.axes, asked.argument_names);
  return with_axis ? name : name.substr(0, name.find('.'));
}

void require_equal_lengths(const BatchFormula& asked, std::span<const Column> columns, std::size_t out) {
  std::size_t known = columns.size();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Column& c = columns[k];
    if (c.stride == 0) continue;
    if (known == columns.size()) known = k;
    const Column& first = columns[known];
    if (c.length != first.length) {
      throw_unequal(asked.name, name_of(asked, k, c.apart), c.length, name_of(asked, known, first.apart), first.length);
    }
  }
  if (known != columns.size() && columns[known].length != out)
    throw_unequal(asked.name, "out", out, name_of(asked, known, columns[known].apart), columns[known].length);
}

}  // namespace

void decide_all(const BatchFormula& asked, std::span<const Column> columns, std::span<Sign> out, Execution execution) {
  require_equal_lengths(asked, columns, out.size());
  if (out.empty()) return;
  Cases cases;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    cases.at[k] = columns[k].at;
    cases.stride[k] = columns[k].stride;
  }
  const BatchQuestion question{asked.name,    asked.arguments, columns.size(),
                               asked.exactly, asked.axes,      asked.argument_names};
  const AskedColumns given{&asked, columns};
  const Filter filter = [](const void* all, const double* const* at, std::size_t n, signed char* signs,
                           std::uint32_t* unsure) { return PLUMB_DISPATCH(run_blocks)(all, at, n, signs, unsure); };
  decide_cases(question, cases, filter, &given, out, execution);
}

}  // namespace plumb::certify::batch
#endif
