#include "tool/terminal/held_signals.hpp"

namespace plumb::tool {
namespace {

volatile std::sig_atomic_t first_signal = 0;

void note(int signal) {
  if (first_signal == 0) first_signal = signal;
}

}  // namespace

HeldSignals::HeldSignals() {
  first_signal = 0;
  struct sigaction noting {};
  noting.sa_handler = note;
  noting.sa_flags = SA_RESTART;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    ::sigaction(held_[k], nullptr, &before_[k]);
    if (before_[k].sa_handler != SIG_IGN) ::sigaction(held_[k], &noting, nullptr);  // nohup's wish stands
  }
}

HeldSignals::~HeldSignals() {
  for (std::size_t k = 0; k < held_.size(); ++k) ::sigaction(held_[k], &before_[k], nullptr);
  if (first_signal != 0) ::raise(first_signal);
}

bool HeldSignals::arrived() { return first_signal != 0; }

}  // namespace plumb::tool
