// Does a thread pool do all parts: once each, on as many threads as may be, on one where none can be made, and in a child?
#include "certify/batch/thread_pool.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <csignal>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "certify/batch/all_threads.hpp"
#include "certify/forbidden_threads.hpp"
#include "certify/sanitized.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/space/kd_tree/kd_tree.hpp"

namespace plumb::certify::batch {
namespace {

using namespace std::chrono_literals;

/// The threads that took part in n parts, each of which waits until `wanted` have come, or a while.
std::size_t threads_seen(std::size_t n, std::size_t wanted) {
  std::mutex lock;
  std::set<std::thread::id> seen;
  std::vector<int> times(n);
  const auto many = [&] {
    const std::scoped_lock own(lock);
    return seen.size();
  };
  for_each_part(Execution::parallel, n, [&](std::size_t part) {
    {
      const std::scoped_lock own(lock);
      seen.insert(std::this_thread::get_id());
    }
    ++times[part];
    for (int k = 0; k < 2000 && many() < wanted; ++k) std::this_thread::sleep_for(1ms);
  });
  EXPECT_EQ(times, std::vector<int>(n, 1));
  return seen.size();
}

int threads_of_process() {
  int threads = 0;
  const std::string status = [] {
    std::string text(4096, '\0');
    const int file = ::open("/proc/self/status", O_RDONLY);
    const ssize_t got = ::read(file, text.data(), text.size());
    ::close(file);
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }();
  const std::size_t at = status.find("Threads:");
  if (at != std::string::npos) threads = std::stoi(status.substr(at + 8));
  return threads;
}

/// How a child ends in which this is done: 0 where it returns true.
template <class Work>
int in_child(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(60);
    ::_exit(work() ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(ThreadPool, TakePartUpToTheLimit) {
  for (const unsigned most : {1U, 2U, 3U, 5U}) {
    const ThreadLimit limit(most);
    EXPECT_EQ(limit.threads(), most);
    EXPECT_EQ(threads_seen(8, most), most);
  }
  const ThreadLimit outer(3);
  {
    const ThreadLimit inner(1);
    EXPECT_EQ(threads_seen(4, 1), 1U);
  }
  EXPECT_EQ(thread_limit(), 3U);
}

TEST(ThreadPool, AreNotMadeWhereOneThreadIsAsked) {
  EXPECT_EQ(in_child([] {
              const ThreadLimit one(1);
              threads_seen(100, 1);
              return threads_of_process() == 1;
            }),
            0);
}

TEST(ThreadPool, AreDoneWithoutWhereNoThreadCanBeMade) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers make threads of their own";
  EXPECT_EQ(in_child([] {
              if (!forbid_threads()) return false;
              try {
                std::thread([] {}).join();
                return false;  // the kernel does not forbid it
              } catch (const std::system_error&) {
              }
              const ThreadLimit four(4);
              std::vector<Point3> points;
              for (int i = 0; i < 100'000; ++i) points.push_back({0.1 * (i % 317), 0.3 * (i % 211), 0.7 * (i % 101)});
              const KdTree3 tree = build_kd_tree(std::span<const Point3>(points), {.execution = Execution::parallel});
              return tree.count == points.size() && threads_seen(100, 1) == 1 && threads_of_process() == 1;
            }),
            0);
}

// As where the parts are done one after the other.
TEST(ThreadPool, ThrowWhatTheLowestPartThrew) {
  const ThreadLimit four(4);
  for (int round = 0; round < 200; ++round) {
    std::string said;
    std::atomic<int> below = 0;
    try {
      for_each_part(Execution::parallel, 50, [&](std::size_t part) {
        below += part < 7 ? 1 : 0;
        if (part >= 7) throw std::runtime_error(std::to_string(part));
      });
    } catch (const std::runtime_error& e) {
      said = e.what();
    }
    EXPECT_EQ(said, "7");
    EXPECT_EQ(below, 7);
  }
}

TEST(ThreadPool, ShareWorkWithinWork) {
  const ThreadLimit four(4);
  for (int round = 0; round < 50; ++round) {
    std::atomic<int> sum = 0;
    for_each_part(Execution::parallel, 9, [&](std::size_t) {
      for_each_part(Execution::parallel, 9,
                    [&](std::size_t) { for_each_part(Execution::parallel, 9, [&](std::size_t) { ++sum; }); });
    });
    EXPECT_EQ(sum, 729);
  }
}

TEST(ThreadPool, ServeManyWhoAskAtOnce) {
  const ThreadLimit three(3);
  std::atomic<int> sum = 0;
  std::vector<std::thread> askers;
  for (int k = 0; k < 6; ++k) {
    askers.emplace_back([&] {
      for (int round = 0; round < 100; ++round) for_each_part(Execution::parallel, 10, [&](std::size_t) { ++sum; });
    });
  }
  for (std::thread& asker : askers) asker.join();
  EXPECT_EQ(sum, 6000);
}

// Its parent's helpers are not there; it makes its own.
TEST(ThreadPool, AreAChildsOwn) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers do not follow fork() with threads";
  const ThreadLimit three(3);
  EXPECT_EQ(threads_seen(6, 3), 3U);
  EXPECT_EQ(in_child([] { return threads_seen(6, 3) == 3 && threads_of_process() == 3; }), 0);
  EXPECT_EQ(threads_seen(6, 3), 3U);
}

// Whatever the thread does that asks, and whoever made them.
TEST(ThreadPool, RoundToNearestAndTakeNoSignals) {
  EXPECT_EQ(in_child([] {
              const ThreadLimit three(3);
              std::fesetround(FE_UPWARD);
              const std::thread::id own = std::this_thread::get_id();
              std::atomic<int> helpers = 0, sound = 0;
              for_each_part(Execution::parallel, 300, [&](std::size_t) {
                std::this_thread::sleep_for(1ms);
                if (std::this_thread::get_id() == own) return;
                sigset_t blocked;
                ::pthread_sigmask(SIG_BLOCK, nullptr, &blocked);
                ++helpers;
                sound += std::fegetround() == FE_TONEAREST && sigismember(&blocked, SIGINT) == 1 &&
                                 sigismember(&blocked, SIGSEGV) == 0
                             ? 1
                             : 0;
              });
              return helpers > 0 && helpers == sound && std::fegetround() == FE_UPWARD;
            }),
            0);
}

}  // namespace
}  // namespace plumb::certify::batch
