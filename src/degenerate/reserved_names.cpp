#include "degenerate/reserved_names.hpp"

#include <string>

namespace plumb::degenerate {

namespace {

// Between blanks, each.
constexpr std::string_view kCpp =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t "
    "class co_await co_return co_yield compl concept const const_cast consteval constexpr constinit continue "
    "decltype default delete do double dynamic_cast else enum explicit export extern false float for friend "
    "goto if inline int long mutable namespace new noexcept not not_eq nullptr operator or or_eq private "
    "protected public register reinterpret_cast requires restrict return short signed sizeof static "
    "static_assert static_cast struct switch template this thread_local throw true try typedef typeid "
    "typename union unsigned using virtual void volatile wchar_t while xor xor_eq ";
constexpr std::string_view kPythonKeywords =
    " False None True as assert async await def del elif except finally from global import in is lambda "
    "nonlocal pass raise with yield ";
constexpr std::string_view kCalledByScripts =
    " Fraction abs any ask bytes ctypes getattr guarded judge len math max mmap os place_of print select "
    "signal str struct sys verdict within ";

bool has(std::string_view words, std::string_view name) {
  return words.find(std::string(" ").append(name).append(" ")) != std::string_view::npos;
}

}  // namespace

bool is_keyword_of_c_or_cpp(std::string_view name) { return has(kCpp, name); }

bool is_taken_in_python(std::string_view name) { return has(kPythonKeywords, name) || has(kCalledByScripts, name); }

}  // namespace plumb::degenerate
