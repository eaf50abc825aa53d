#include "lab/trial/allocations.hpp"

#include <gmp.h>

#include <cstdlib>
#include <new>

namespace plumb::lab::trial {
namespace {

thread_local std::uint64_t taken = 0;

void* counted(std::size_t size) noexcept {
  ++taken;
  return std::malloc(size == 0 ? 1 : size);
}

// GMP cannot bear an exception: where its own functions fail they end the program, and so do these, as it is told to end.
[[noreturn]] void end() {
  if (const std::new_handler handler = std::get_new_handler()) handler();
  std::abort();
}

void* for_gmp(std::size_t size) {
  ++taken;
  void* const memory = std::malloc(size);
  if (memory == nullptr) end();
  return memory;
}

void* again_for_gmp(void* memory, std::size_t, std::size_t size) {
  ++taken;
  void* const moved = std::realloc(memory, size);
  if (moved == nullptr) end();
  return moved;
}

void given_back_by_gmp(void* memory, std::size_t) { std::free(memory); }

}  // namespace

std::uint64_t allocations() { return taken; }

void count_gmp_allocations() { mp_set_memory_functions(for_gmp, again_for_gmp, given_back_by_gmp); }

}  // namespace plumb::lab::trial

// The whole program's; the forms for arrays end in these.  Without exceptions as well, for sanitizers bring that one
// along.
void* operator new(std::size_t size) {
  for (;;) {
    if (void* const memory = plumb::lab::trial::counted(size)) return memory;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return plumb::lab::trial::counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
