#include "certify/batch/instruction_sets.hpp"
// First, as it says for which targets there are filters.
#if defined(__x86_64__)
#include <cpuid.h>
#endif

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "certify/batch/chosen_target.hpp"
#include "certify/batch/take_instruction_set.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/instruction_set.hpp"

namespace plumb {
namespace certify::batch {
namespace {

struct Named {
  std::string_view name;
  std::int64_t target;
};
constexpr std::array all{Named{"avx512", HWY_AVX3}, Named{"avx2", HWY_AVX2}, Named{"ssse3", HWY_SSSE3},
                         Named{"neon", HWY_NEON}, Named{"none", HWY_SCALAR}};

#if defined(__x86_64__)
constexpr unsigned bit_of_aes = 25, bit_of_f16c = 29, bit_of_lzcnt = 5;

bool has_bit(unsigned leaf, unsigned bit) {
  unsigned a = 0, b = 0, c = 0, d = 0;
  return __get_cpuid(leaf, &a, &b, &c, &d) != 0 && (c >> bit & 1) != 0;
}

/// What the compiler may use in code for a target, as Highway's set_macros-inl.h names it.
std::int64_t present() {
  const auto has = [](auto... sets) { return (sets && ...); };
  const bool sse4 = has(__builtin_cpu_supports("sse4.1") != 0, __builtin_cpu_supports("sse4.2") != 0,
                        __builtin_cpu_supports("pclmul") != 0, has_bit(1, bit_of_aes));
  const bool avx2 = has(sse4, __builtin_cpu_supports("avx2") != 0, __builtin_cpu_supports("fma") != 0,
                        __builtin_cpu_supports("bmi") != 0, __builtin_cpu_supports("bmi2") != 0,
                        has_bit(1, bit_of_f16c), has_bit(0x80000001, bit_of_lzcnt));
  const bool avx3 = has(avx2, __builtin_cpu_supports("avx512f") != 0, __builtin_cpu_supports("avx512vl") != 0,
                        __builtin_cpu_supports("avx512dq") != 0, __builtin_cpu_supports("avx512bw") != 0);
  return HWY_SCALAR | (__builtin_cpu_supports("ssse3") != 0 ? HWY_SSSE3 : 0) | (avx2 ? HWY_AVX2 : 0) |
         (avx3 ? HWY_AVX3 : 0);
}
#elif defined(__aarch64__)
std::int64_t present() { return HWY_NEON | HWY_SCALAR; }
#else
std::int64_t present() { return HWY_SCALAR; }
#endif

/// What the environment asked for when it was first looked at; empty: nothing.
const std::string& asked_at_start() {
  static const std::string name = [] {
    const char* value = std::getenv("PLUMB_INSTRUCTION_SET");
    return std::string(value != nullptr ? value : "");
  }();
  return name;
}

/// 0 where it is none of this machine.
std::int64_t targets_named(std::string_view name) noexcept {
  if (name.empty()) return present();
  const auto found = std::ranges::find(all, name, &Named::name);
  return found == all.end() ? 0 : found->target & present();
}

std::int64_t required_targets() {
  const std::int64_t targets = targets_named(asked_at_start());
  if (targets != 0) return targets;
  std::string text =
      "PLUMB_INSTRUCTION_SET is \"" + asked_at_start() + "\", which this processor does not have; there are";
  for (const std::string_view name : batch_instruction_sets()) text.append(" ").append(name);
  throw Error(text);
}

hwy::ChosenTarget& target() {
  static hwy::ChosenTarget chosen;
  return chosen;
}

}  // namespace

const hwy::ChosenTarget& chosen_target() {
  static const bool ready = (target().Update(required_targets()), true);
  static_cast<void>(ready);
  return target();
}

std::int64_t targets_or_all() noexcept {
  const std::int64_t targets = targets_named(asked_at_start());
  return targets != 0 ? targets : present();
}

void take_instruction_set(std::string_view name) {
  chosen_target();
  target().Update(name.empty() ? required_targets() : targets_named(name));
}

}  // namespace certify::batch

std::vector<std::string_view> batch_instruction_sets() {
  std::vector<std::string_view> names;
  for (const certify::batch::Named& set : certify::batch::all) {
    if ((certify::batch::present() & set.target) != 0) names.push_back(set.name);
  }
  return names;
}

std::string_view batch_instruction_set() {
  const std::int64_t targets = certify::batch::required_targets();
  return std::ranges::find_if(certify::batch::all,
                              [&](const certify::batch::Named& set) { return (targets & set.target) != 0; })
      ->name;
}

}  // namespace plumb
