#include "tool/terminal/out_of_memory.hpp"

#include <gmp.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace plumb::tool {
namespace {

std::array<char, 1024> line;  // written when there is memory
std::size_t line_length = 0;
std::terminate_handler terminate_before = nullptr;

void add(std::string_view text) {
  for (const char c : text) {
    if (line_length + 1 < line.size())
      line[line_length++] = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
}

[[noreturn]] void end_now() {
  say_out_of_memory();
  ::_exit(2);
}

/// A bad_alloc that no handler has seen, as of code that asks malloc() itself, in a frame that lets none through.
[[noreturn]] void terminate() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    end_now();
  } catch (...) {
  }
  terminate_before();
  std::abort();
}

void* allocate(std::size_t size) {
  void* const memory = std::malloc(size);
  if (memory == nullptr) end_now();
  return memory;
}
void* reallocate(void* old, std::size_t /*size*/, std::size_t size) {
  void* const memory = std::realloc(old, size);
  if (memory == nullptr) end_now();
  return memory;
}
void free_sized(void* memory, std::size_t /*size*/) { std::free(memory); }

/// The stack grows as it is used, and what it grows by may be missing: so far, it grows now.
void reserve_stack() {
  constexpr std::size_t size = std::size_t{1} << 20;
  void* const room = ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) end_now();  // as a signal would, where the stack cannot grow
  ::munmap(room, size);
  std::array<char, size> far;
  volatile char* const lowest = far.data();
  *lowest = 0;
}

}  // namespace

void end_without_memory(std::string_view program, int argc, char** argv) {
  line_length = 0;
  add(program), add(": out of memory: "), add(program);
  for (int k = 1; k < argc; ++k) add(" "), add(argv[k]);
  line[line_length] = '\n';
  reserve_stack();
  std::set_new_handler(end_now);
  terminate_before = std::set_terminate(terminate);
  ::mp_set_memory_functions(allocate, reallocate, free_sized);
}

void say_out_of_memory() {
  std::fflush(stdout);  // answers given before the fault come first
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line_length + 1);
}

void obey_memory_no_more() {
  std::set_new_handler(nullptr);
  if (terminate_before != nullptr) std::set_terminate(terminate_before);
  ::mp_set_memory_functions(nullptr, nullptr, nullptr);
}

}  // namespace plumb::tool
