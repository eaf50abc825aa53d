// How often does this program take memory?  Every allocation is counted, those of GMP as well.
//
// The operators are replaced for the whole program, so that one file of it includes this.
#pragma once

#include <gmp.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace plumb {

inline std::atomic<int> allocations{0};

namespace counted {

inline void* taken(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
inline void* taken_again(void* p, std::size_t, std::size_t size) {
  ++allocations;
  return std::realloc(p, size);
}
inline void released(void* p, std::size_t) { std::free(p); }

/// What GMP took before is of malloc as well.
inline const bool counts_gmp = (mp_set_memory_functions(taken, taken_again, released), true);

}  // namespace counted
}  // namespace plumb

void* operator new(std::size_t size) { return plumb::counted::taken(size); }
void* operator new[](std::size_t size) { return plumb::counted::taken(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // what sorts stably asks so
  ++plumb::allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
