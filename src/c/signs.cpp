#include <algorithm>
#include <limits>
#include <mutex>
#include <vector>

#include "c/guarded.hpp"
#include "certify/batch/all_threads.hpp"
#include "certify/catalog.hpp"
#include "plumb/certify/batch.hpp"

using namespace plumb;
using c::guarded, c::need;

namespace {

const CatalogEntry& entry_of(std::size_t which) {
  if (which < catalog().size()) return catalog()[which];
  throw c::InvalidArgument("which is " + std::to_string(which) + ", but there are " + std::to_string(catalog().size()) +
                           " predicates");
}

/// The four classics have batches in lanes, of columns without gaps; is this one of them, and all its numbers finite?
bool decided_in_lanes(std::string_view name, const double* const* columns, std::span<Sign> out) {
  const auto flat = [&](std::size_t p) {
    return Points2View{{columns[2 * p], out.size()}, {columns[2 * p + 1], out.size()}};
  };
  const auto solid = [&](std::size_t p) {
    const double* const* at = columns + 3 * p;
    return Points3View{{at[0], out.size()}, {at[1], out.size()}, {at[2], out.size()}};
  };
  constexpr auto by = Execution::parallel;
  try {
    if (name == "orient2d") return orient2d(flat(0), flat(1), flat(2), out, by), true;
    if (name == "orient3d") return orient3d(solid(0), solid(1), solid(2), solid(3), out, by), true;
    if (name == "incircle") return incircle(flat(0), flat(1), flat(2), flat(3), out, by), true;
    if (name == "insphere") return insphere(solid(0), solid(1), solid(2), solid(3), solid(4), out, by), true;
    return false;
  } catch (const NonFinite&) {  // told by the case, one after the other
    return false;
  }
}

bool are_without_gaps(const std::ptrdiff_t* strides, std::size_t count) {
  return strides == nullptr || std::all_of(strides, strides + count, [](std::ptrdiff_t s) { return s == 1; });
}

}  // namespace

extern "C" {

std::size_t plumb_sign_count(void) { return catalog().size(); }

const char* plumb_sign_name(std::size_t which) {
  return which < catalog().size() ? catalog()[which].name.data() : nullptr;  // a literal, which ends with a 0
}

std::size_t plumb_sign_arity(std::size_t which) { return which < catalog().size() ? catalog()[which].arity() : 0; }

std::size_t plumb_find_sign(const char* name) {
  const CatalogEntry* found = name == nullptr ? nullptr : find_predicate(name);
  return found == nullptr ? std::numeric_limits<std::size_t>::max()
                          : static_cast<std::size_t>(found - catalog().data());
}

plumb_status plumb_sign(std::size_t which, const double* numbers, int* sign) {
  return guarded("plumb_sign", [&] {
    const CatalogEntry& entry = entry_of(which);
    need(numbers, "numbers");
    need(sign, "sign");
    *sign = static_cast<int>(entry.decide({numbers, entry.arity()}).sign);
  });
}

plumb_status plumb_signs(std::size_t which, const double* const* columns, const std::ptrdiff_t* strides,
                         std::size_t count, std::int8_t* signs) {
  return guarded("plumb_signs", [&] {
    const CatalogEntry& entry = entry_of(which);
    need(columns, "columns");
    need(signs, count, "signs");
    for (std::size_t k = 0; k < entry.arity(); ++k) need(columns[k], count, "a column");
    if (are_without_gaps(strides, entry.arity())) {
      std::vector<Sign> found(count);
      if (decided_in_lanes(entry.name, columns, found)) {
        std::ranges::transform(found, signs, [](Sign s) { return static_cast<std::int8_t>(s); });
        return;
      }
    }
    constexpr std::size_t part = 1024;
    std::vector<std::int8_t> answers(count);
    std::mutex guard;
    std::size_t refused = count;
    std::string text;
    certify::batch::for_each_part(Execution::parallel, (count + part - 1) / part, [&](std::size_t number) {
      std::vector<double> numbers(entry.arity());
      for (std::size_t i = number * part; i < std::min(count, (number + 1) * part); ++i) {
        for (std::size_t k = 0; k < numbers.size(); ++k)
          numbers[k] = columns[k][static_cast<std::ptrdiff_t>(i) * (strides == nullptr ? 1 : strides[k])];
        try {
          answers[i] = static_cast<std::int8_t>(entry.decide(numbers).sign);
        } catch (const NonFinite& e) {
          const std::lock_guard lock(guard);
          if (i < refused) {
            refused = i;
            text = e.what();
          }
          return;
        }
      }
    });
    if (refused != count) throw NonFinite("case " + std::to_string(refused) + ": " + text);
    std::ranges::copy(answers, signs);
  });
}

}  // extern "C"
