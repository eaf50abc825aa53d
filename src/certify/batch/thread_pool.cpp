#include "certify/batch/thread_pool.hpp"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <csignal>
#include <exception>
#include <mutex>
#include <new>
#include <thread>
#include <utility>

#include "plumb/certify/thread_limit.hpp"

namespace plumb::certify::batch {
namespace {

constexpr std::size_t stack_bytes = std::size_t{2} << 20;  // of address space: only what is used becomes memory

struct Job {
  void (*call)(const void* work, std::size_t part);
  const void* work;
  std::size_t parts;
  std::atomic<std::size_t> next{0};
  // What follows is guarded by the lock of Helpers.
  std::size_t wanted, busy = 0;  // helpers that may still come, and that are there
  std::size_t thrower;           // the lowest part that has thrown
  std::exception_ptr thrown{};
  Job* below = nullptr;
};

class Helpers {
 public:
  /// Never destroyed, as its threads end with the process alone.
  static Helpers& all() {
    static Helpers* const made = [] {
      ::pthread_atfork([] { place()->lock_.lock(); }, [] { place()->lock_.unlock(); }, [] { new (place()) Helpers; });
      return new (place()) Helpers;
    }();
    return *made;
  }

  void share_out(Job& job, unsigned limit) {
    {
      std::unique_lock lock(lock_);
      job.below = std::exchange(top_, &job);
      limit_ = limit;
      while (idle_ < job.wanted && helpers_ + 1 < limit && add_helper()) ++helpers_, ++idle_;
    }
    job.wanted == 1 ? come_.notify_one() : come_.notify_all();
    run(job);
    std::unique_lock lock(lock_);
    Job** at = &top_;
    while (*at != &job) at = &(*at)->below;
    *at = job.below;
    gone_.wait(lock, [&] { return job.busy == 0; });
  }

 private:
  static Helpers* place() {
    alignas(Helpers) static std::byte bytes[sizeof(Helpers)];
    return reinterpret_cast<Helpers*>(bytes);
  }

  /// Parts are begun in their order, so that all below one that throws are done or under way.
  void run(Job& job) noexcept {
    for (std::size_t part = job.next++; part < job.parts; part = job.next++) {
      try {
        job.call(job.work, part);
      } catch (...) {
        job.next = job.parts;
        const std::lock_guard lock(lock_);
        if (part < job.thrower) job.thrower = part, job.thrown = std::current_exception();
      }
    }
  }

  [[nodiscard]] Job* waiting_job() const {
    Job* job = top_;
    while (job != nullptr && (job->wanted == 0 || job->next >= job->parts)) job = job->below;
    return busy_ + 1 < limit_ ? job : nullptr;
  }

  void help() noexcept {
    std::fesetenv(FE_DFL_ENV);  // a thread inherits the settings of the one that makes it
    for (std::unique_lock lock(lock_);;) {
      Job* job = nullptr;
      come_.wait(lock, [&] { return (job = waiting_job()) != nullptr; });
      --job->wanted, ++job->busy, ++busy_, --idle_;
      lock.unlock();
      run(*job);
      lock.lock();
      --job->busy, --busy_, ++idle_;
      if (job->busy == 0) gone_.notify_all();
    }
  }

  bool add_helper() {
    sigset_t blocked, before;
    sigfillset(&blocked);
    for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS, SIGPROF}) {
      sigdelset(&blocked, fault);
    }
    pthread_attr_t attributes;
    if (::pthread_attr_init(&attributes) != 0) return false;
    ::pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    ::pthread_attr_setstacksize(&attributes, stack_bytes);
    ::pthread_sigmask(SIG_SETMASK, &blocked, &before);
    pthread_t thread{};
    const auto begin = [](void* helpers) -> void* {
      static_cast<Helpers*>(helpers)->help();
      return nullptr;
    };
    const int error = ::pthread_create(&thread, &attributes, begin, this);
    ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
    ::pthread_attr_destroy(&attributes);
    return error == 0;
  }

  std::mutex lock_;
  std::condition_variable come_, gone_;
  Job* top_ = nullptr;  // the latest
  std::size_t helpers_ = 0, idle_ = 0, busy_ = 0;
  unsigned limit_ = 1;
};

std::atomic<unsigned> most_threads = 0;

/// Those that this process may use, where the system tells; the standard's function counts the machine's.
unsigned processors() {
#if defined(__linux__)
  cpu_set_t own;
  if (::sched_getaffinity(0, sizeof own, &own) == 0) return std::max(1U, static_cast<unsigned>(CPU_COUNT(&own)));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

void share_out(std::size_t n, void (*call)(const void* work, std::size_t part), const void* work) {
  const unsigned limit = thread_limit();
  if (limit == 1 || n < 2) {
    for (std::size_t part = 0; part < n; ++part) call(work, part);
    return;
  }
  Job job{call, work, n, 0, std::min<std::size_t>(n, limit) - 1, 0, n};
  Helpers::all().share_out(job, limit);
  if (job.thrown) std::rethrow_exception(job.thrown);
}

unsigned thread_limit() {
  const unsigned most = most_threads;
  return most != 0 ? most : processors();
}

unsigned set_thread_limit(unsigned most) { return most_threads.exchange(most); }

}  // namespace plumb::certify::batch

namespace plumb {

ThreadLimit::ThreadLimit(std::size_t most)
    : threads_(0),
      before_(certify::batch::set_thread_limit(static_cast<unsigned>(std::min<std::size_t>(most, 1 << 16)))) {
  threads_ = certify::batch::thread_limit();
}

ThreadLimit::~ThreadLimit() { certify::batch::set_thread_limit(before_); }

}  // namespace plumb
