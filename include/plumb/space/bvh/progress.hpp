// How far is long work, and shall it go on?
//
//   intersecting_pairs(a, b, {.progress = [&](double share) { return show(share) && !escape_pressed(); }});
//
// Laws: (1) it is called with the share of the work that is done, above 0 and up to 1, never falling; by one thread at a
// time, though not always by the same.  (2) Where it returns false, no further part of the work is begun, and
// the function that was called throws Cancelled: there are no partial answers.  (3) It changes no answer.  (4) What it
// throws reaches the caller.
// Source: none.
// Cost: a lock for each of some thousand parts at most.  Nothing is searched.
#pragma once

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

#include "plumb/arith/error.hpp"

namespace plumb {

/// Any function of the share that says whether to go on; nothing where nobody wants to know.  (The standard's is in
/// <functional>, which costs every reader of plumb.hpp a tenth of a second.)
class Progress {
 public:
  Progress() = default;
  template <class F>
  requires(!std::same_as<F, Progress> && std::is_invocable_r_v<bool, F&, double>)
      Progress(F f)  // NOLINT: a lambda is one
      : called_(std::make_shared<F>(std::move(f))),
        call_([](void* called, double share) -> bool { return (*static_cast<F*>(called))(share); }) {}

  explicit operator bool() const { return called_ != nullptr; }
  bool operator()(double share) const { return call_(called_.get(), share); }

 private:
  std::shared_ptr<void> called_;
  bool (*call_)(void* called, double share) = nullptr;
};

/// A Progress returned false; the text names the function.
struct Cancelled : Error {
  using Error::Error;
};

}  // namespace plumb
