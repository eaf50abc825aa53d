#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <new>
#include <string>

#include "c/guarded.hpp"
#include "plumb/query/body/any_figure.hpp"

// The library's operators new and delete are its own (src/c/CMakeLists.txt): nobody else sees them, and the C++ library
// within uses them too.  So what handles hold is the caller's memory without a word about it elsewhere.
#ifdef PLUMB_C_OWNS_NEW

namespace plumb::c {
namespace {

void* allocate_as_c(std::size_t bytes, std::size_t alignment, void*) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes);
  const std::size_t rest = bytes % alignment;
  return std::aligned_alloc(alignment, rest == 0 ? bytes : bytes + (alignment - rest));
}
void release_as_c(void* block, std::size_t, std::size_t, void*) { std::free(block); }

/// An allocator that was set once is kept for good: blocks refer to it.
struct Giver {
  plumb_allocator by;
  Giver* before;
};
constinit Giver c_library{{sizeof(plumb_allocator), allocate_as_c, release_as_c, nullptr}, nullptr};
constinit std::atomic<const Giver*> giver{&c_library};

/// Stands before each block, so that it goes back to whom it came from.
struct alignas(std::max_align_t) Head {
  const Giver* from;
  std::size_t bytes;
};
std::size_t alignment_of_whole(std::size_t alignment) { return std::max(alignment, alignof(Head)); }
/// So many bytes lie before the block in what an allocator has given.
std::size_t bytes_before(std::size_t alignment) { return std::max(alignment, sizeof(Head)); }

void* give(std::size_t bytes, std::size_t alignment) {
  const std::size_t before = bytes_before(alignment);
  if (bytes > PTRDIFF_MAX - before) throw std::bad_alloc();
  const Giver* const from = giver.load(std::memory_order_acquire);
  void* const whole = from->by.allocate(bytes + before, alignment_of_whole(alignment), from->by.user);
  if (whole == nullptr) throw std::bad_alloc();
  char* const block = static_cast<char*>(whole) + before;
  new (block - sizeof(Head)) Head{from, bytes};
  return block;
}

void take(void* block, std::size_t alignment) noexcept {
  if (block == nullptr) return;
  char* const at = static_cast<char*>(block);
  const Head head = *reinterpret_cast<const Head*>(at - sizeof(Head));
  const std::size_t before = bytes_before(alignment);
  head.from->by.release(at - before, head.bytes + before, alignment_of_whole(alignment), head.from->by.user);
}

bool equal(const plumb_allocator& a, const plumb_allocator& b) {
  return a.allocate == b.allocate && a.release == b.release && a.user == b.user;
}

const Giver* kept(const plumb_allocator& by) {
  static std::mutex one_at_a_time;
  static Giver* last = &c_library;
  const std::lock_guard lock(one_at_a_time);
  for (const Giver* g = last; g != nullptr; g = g->before) {
    if (equal(g->by, by)) return g;
  }
  void* const memory = std::malloc(sizeof(Giver));
  if (memory == nullptr) throw std::bad_alloc();
  return last = new (memory) Giver{by, last};
}

}  // namespace
}  // namespace plumb::c

void* operator new(std::size_t bytes) { return plumb::c::give(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return plumb::c::give(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { plumb::c::take(block, 1); }
void operator delete(void* block, std::size_t) noexcept { plumb::c::take(block, 1); }
void operator delete(void* block, std::align_val_t alignment) noexcept {
  plumb::c::take(block, static_cast<std::size_t>(alignment));
}
void operator delete(void* block, std::size_t, std::align_val_t alignment) noexcept {
  plumb::c::take(block, static_cast<std::size_t>(alignment));
}

extern "C" plumb_status plumb_set_allocator(const plumb_allocator* allocator) {
  return plumb::c::guarded("plumb_set_allocator", [&] {
    using namespace plumb::c;
    if (allocator != nullptr) {
      need_size(allocator, "allocator");
      if (allocator->allocate == nullptr) throw InvalidArgument("allocator->allocate is NULL");
      if (allocator->release == nullptr) throw InvalidArgument("allocator->release is NULL");
    }
    giver.store(allocator == nullptr ? &c_library : kept(*allocator), std::memory_order_release);
  });
}

#else

extern "C" plumb_status plumb_set_allocator(const plumb_allocator*) {
  return plumb::c::guarded("plumb_set_allocator", [] {
    throw plumb::Unsupported(
        "this library shares its memory with other libraries of C++: it was built with "
        "BUILD_SHARED_LIBS or with sanitizers");
  });
}

#endif
