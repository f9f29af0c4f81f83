// SPDX-License-Identifier: MIT
// fork, a pipe, setrlimit. The child sends a tag, then the mesh's two arrays with their sizes, or the text of an error.
#include "homolog/shape/read_in_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <new>
#include <system_error>
#include <type_traits>
#include <vector>

#include "homolog/base/errors.h"
#include "homolog/base/own_memory.h"

namespace homolog {
namespace {

constexpr std::uint64_t most_items = std::uint64_t{1} << 32;  // corners have 32 bits

enum Tag : char { mesh_follows = 'm', error_follows = 'e', no_memory = 'n' };

template <class T>
std::uint64_t bytes_in(const std::vector<T>& items) {
  return items.size() * sizeof(T);
}

// ---- in the child

void send(int pipe, const void* data, std::size_t size) {
  for (const char* next = static_cast<const char*>(data); size > 0;) {
    const ssize_t sent = write(pipe, next, size);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) _exit(1);
    next += sent;
    size -= static_cast<std::size_t>(sent);
  }
}

template <class Items>
void send_items(int pipe, const Items& items) {
  const std::uint64_t count = items.size();
  send(pipe, &count, sizeof count);
  send(pipe, items.data(), count * sizeof items[0]);
}

void lower_limit(int resource, std::uint64_t most) {
  rlimit limit{};
  getrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &limit);
  limit.rlim_cur = std::min<rlim_t>(limit.rlim_cur, most);
  setrlimit(static_cast<decltype(RLIMIT_CPU)>(resource), &limit);
}

/// Whoever started us may have handlers for crashes and hopes for a core file; here a crash is an answer like others, and a silent one.
void become_quiet() {
  for (const int signal_number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGINT, SIGTERM, SIGXCPU}) std::signal(signal_number, SIG_DFL);
  lower_limit(RLIMIT_CORE, 0);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

[[noreturn]] void be_the_child(int pipe, const std::function<Mesh()>& read, const ChildLimits& limits) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  become_quiet();
  if (const std::uint64_t data = data_bytes(); data > 0) lower_limit(RLIMIT_DATA, data + limits.bytes);
  lower_limit(RLIMIT_CPU, limits.seconds);
  try {
    const Mesh mesh = read();
    send(pipe, std::array{mesh_follows}.data(), 1);
    send_items(pipe, mesh.vertices);
    send_items(pipe, mesh.triangles);
  } catch (const FileError& error) {
    send(pipe, std::array{error_follows}.data(), 1);
    send_items(pipe, std::string(error.what()));
  } catch (const std::bad_alloc&) {
    send(pipe, std::array{no_memory}.data(), 1);
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

// ---- in the parent

/// The child's end of the conversation; it does not outlive this.
class Child {
 public:
  Child(pid_t process, int pipe, unsigned patience)
      : process_(process), pipe_(pipe), end_(std::chrono::steady_clock::now() + std::chrono::seconds(patience)) {}
  ~Child() {
    close(pipe_);
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// False when the child ends before, or is out of time.
  bool receive(void* data, std::size_t size) {
    for (char* next = static_cast<char*>(data); size > 0;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end_ - std::chrono::steady_clock::now()).count();
      pollfd ready{pipe_, POLLIN, 0};
      const int answers = poll(&ready, 1, static_cast<int>(std::max<std::int64_t>(0, left)));
      if (answers < 0 && errno == EINTR) continue;
      if (answers <= 0) return false;
      const ssize_t got = read(pipe_, next, size);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      next += got;
      size -= static_cast<std::size_t>(got);
    }
    return true;
  }

  template <class Items>
  bool receive_items(Items& items) {
    static_assert(std::is_trivially_copyable_v<typename Items::value_type> || std::is_same_v<typename Items::value_type, Vec3>);
    std::uint64_t count = 0;
    if (!receive(&count, sizeof count) || count > most_items) return false;  // a child gone mad may say anything
    items.resize(count);
    return receive(items.data(), count * sizeof items[0]);
  }

  /// Whether it was ended for the time it took; only asked after it failed.
  bool was_too_slow() {
    if (std::chrono::steady_clock::now() >= end_) return true;
    siginfo_t info{};
    while (waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    return info.si_code != CLD_EXITED && (info.si_status == SIGXCPU);
  }

 private:
  pid_t process_;
  int pipe_;
  std::chrono::steady_clock::time_point end_;
};

Mesh receive_mesh(Child& child, const std::string& file, const ChildLimits& limits) {
  char tag = 0;
  std::string error;
  Mesh mesh;
  if (child.receive(&tag, 1)) {
    if (tag == mesh_follows && child.receive_items(mesh.vertices) && child.receive_items(mesh.triangles)) return mesh;
    if (tag == error_follows && child.receive_items(error)) throw FileError(error);
    if (tag == no_memory) {
      throw FileError(fmt::format(
          "{}: there is not enough memory to read it, or it takes more than {} MiB of memory; it is damaged, or should be saved as PLY",
          file, limits.bytes >> 20));
    }
  }
  if (child.was_too_slow()) {
    throw FileError(fmt::format("{}: reading it takes more than {} s; it is damaged, or should be saved as PLY", file, limits.seconds));
  }
  throw FileError(fmt::format("{}: the library that reads this format crashed on it; it is damaged, or should be saved as PLY", file));
}

}  // namespace

Mesh read_in_child(const std::function<Mesh()>& read, const std::string& file, const ChildLimits& limits) {
  std::array<int, 2> ends{};
  const pid_t process = pipe(ends.data()) == 0 ? fork() : -1;
  if (process < 0)
    throw FileError(fmt::format("{}: no process could be started to read it: {}", file, std::generic_category().message(errno)));
  if (process == 0) {
    close(ends[0]);
    be_the_child(ends[1], read, limits);
  }
  close(ends[1]);
  Child child(process, ends[0], 10 * limits.seconds);
  return receive_mesh(child, file, limits);
}

}  // namespace homolog
