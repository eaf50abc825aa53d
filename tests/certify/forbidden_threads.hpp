// From here on this process makes no thread: the kernel refuses, as where a limit is reached.  Of Linux.
//
// RLIMIT_NPROC does not bind root, so a filter of system calls says it: a clone() of a thread is refused with EAGAIN,
// clone3() is not known, and the C library takes clone() instead.  A process of its own, fork(), is still to be had.
#pragma once

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <array>
#include <cerrno>
#include <cstddef>

namespace plumb {

enum class Forbidden : bool { refused, deadly };  // with EAGAIN, or the end of the process

/// False where the kernel knows no filters.
inline bool forbid_threads(Forbidden how = Forbidden::refused) {
  const auto load = [](std::size_t at) {
    return sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<unsigned>(at)};
  };
  const auto equal = [](unsigned number, unsigned char no) {
    return sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, no, number};
  };
  const auto end = [](unsigned value) { return sock_filter{BPF_RET | BPF_K, 0, 0, value}; };
  std::array filter{
      load(offsetof(seccomp_data, nr)),
      equal(__NR_clone3, 1),
      end(SECCOMP_RET_ERRNO | ENOSYS),
      equal(__NR_clone, 3),
      load(offsetof(seccomp_data, args[0])),
      sock_filter{BPF_JMP | BPF_JSET | BPF_K, 0, 1, CLONE_THREAD},
      end(how == Forbidden::deadly ? SECCOMP_RET_KILL_PROCESS : SECCOMP_RET_ERRNO | EAGAIN),
      end(SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{filter.size(), filter.data()};
  return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace plumb
