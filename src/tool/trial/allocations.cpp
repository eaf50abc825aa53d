#include "tool/trial/allocations.hpp"

#include <gmp.h>

#include <cstdlib>
#include <new>

namespace plumb::tool::trial {
namespace {

thread_local std::uint64_t taken = 0;

void* counted(std::size_t size) {
  ++taken;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// GMP cannot bear an exception: where its own functions fail they end the program, and so do these.
void* for_gmp(std::size_t size) {
  ++taken;
  void* const memory = std::malloc(size);
  if (memory == nullptr) std::abort();
  return memory;
}

void* again_for_gmp(void* memory, std::size_t, std::size_t size) {
  ++taken;
  void* const moved = std::realloc(memory, size);
  if (moved == nullptr) std::abort();
  return moved;
}

void given_back_by_gmp(void* memory, std::size_t) { std::free(memory); }

}  // namespace

std::uint64_t allocations() { return taken; }

void count_gmp_allocations() { mp_set_memory_functions(for_gmp, again_for_gmp, given_back_by_gmp); }

}  // namespace plumb::tool::trial

// The whole program's; the forms for arrays and without exceptions end in these.
void* operator new(std::size_t size) { return plumb::tool::trial::counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
