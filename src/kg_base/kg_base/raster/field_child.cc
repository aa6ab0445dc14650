#include "kg_base/raster/field_child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "kg_base/common/input_error.h"
#include "kg_base/raster/field_protocol.h"

namespace kg_base {
namespace {

using Clock = std::chrono::steady_clock;

constexpr char kProgram[] = "read_field_file";
constexpr double kMaxDeadline_s = 86400.0;

class FileDescriptor {
 public:
  explicit FileDescriptor(int fd) : fd_(fd) {}
  ~FileDescriptor() { Close(); }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  int get() const { return fd_; }
  void Close() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

// Folder from /proc or, if that is not mounted, from the name the program was
// started with.
std::string FolderOfThisProgram() {
  char path[4096];
  const ssize_t size = readlink("/proc/self/exe", path, sizeof(path));
  const std::string whole =
      size > 0 ? std::string(path, static_cast<std::size_t>(size))
               : std::string(program_invocation_name);
  const std::size_t slash = whole.rfind('/');
  return slash == std::string::npos ? "." : whole.substr(0, slash);
}

std::string FindProgram() {
  const char* named = std::getenv("KG_READ_FIELD_FILE");
  if (named != nullptr && *named != '\0') return named;
  const std::string folder = FolderOfThisProgram();
  for (const std::string& candidate :
       {folder + "/" + kProgram, folder + "/../kg_base/" + kProgram}) {
    if (access(candidate.c_str(), X_OK) == 0) return candidate;
  }
  throw InputError(
      std::string("program read_field_file not found, expected it in ") +
      folder + ", in ../kg_base beside it, or named by KG_READ_FIELD_FILE");
}

// Descriptors and signal settings of the child, replacing its parent's.
class SpawnSettings {
 public:
  explicit SpawnSettings(int answer) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, answer, 1);
    posix_spawn_file_actions_addopen(&actions_, 2, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_,
                             POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t* actions() { return &actions_; }
  posix_spawnattr_t* attributes() { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

// A child process; the destructor kills it and waits for it.
class ChildProcess {
 public:
  ChildProcess(const std::vector<std::string>& arguments, int answer) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
      argv.push_back(const_cast<char*>(argument.c_str()));
    }
    argv.push_back(nullptr);
    SpawnSettings settings(answer);
    const int error = posix_spawn(&pid_, argv[0], settings.actions(),
                                  settings.attributes(), argv.data(), environ);
    if (error != 0) {
      throw InputError(arguments[0] + ": cannot be run: " + strerror(error));
    }
  }
  ~ChildProcess() { End(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Kills it if it is still running; returns how it ended, for an error line.
  std::string End() {
    if (pid_ < 0) return "";
    kill(pid_, SIGKILL);
    int status = 0;
    pid_t waited = 0;
    do {
      waited = waitpid(pid_, &status, 0);
    } while (waited < 0 && errno == EINTR);
    pid_ = -1;
    if (waited > 0 && WIFSIGNALED(status)) {
      return "by signal " + std::to_string(WTERMSIG(status));
    }
    return "with status " + std::to_string(WEXITSTATUS(status));
  }

 private:
  pid_t pid_ = -1;
};

class ChildAnswer {
 public:
  ChildAnswer(const std::string& path, int fd, double deadline_s)
      : path_(path),
        fd_(fd),
        deadline_s_(deadline_s),
        deadline_(Clock::now() +
                  std::chrono::duration_cast<Clock::duration>(
                      std::chrono::duration<double>(deadline_s))) {}

  // Reads up to `count` bytes; fewer mean end of file. Throws InputError at the
  // deadline.
  std::size_t Get(void* bytes, std::size_t count) const {
    std::size_t done = 0;
    while (done < count) {
      WaitForBytes();
      const ssize_t got =
          read(fd_, static_cast<char*>(bytes) + done, count - done);
      if (got == 0 || (got < 0 && errno != EINTR)) break;
      if (got > 0) done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  void WaitForBytes() const {
    int ready = 0;
    while (ready <= 0) {
      const double left_ms =
          std::chrono::duration<double, std::milli>(deadline_ - Clock::now())
              .count();
      if (!(left_ms > 0.0)) {
        throw InputError(path_ + ": not read within " +
                         std::to_string(deadline_s_) +
                         " s, expected a file that is not damaged");
      }
      pollfd wait{fd_, POLLIN, 0};
      ready = poll(&wait, 1, static_cast<int>(std::ceil(left_ms)));
    }
  }

  const std::string& path_;
  int fd_;
  double deadline_s_;
  Clock::time_point deadline_;
};

// `wanted`: arguments of the program.
FieldFile ReadInChild(const std::string& path,
                      const std::vector<std::string>& wanted,
                      double deadline_s) {
  const double limit_s = std::min(std::max(deadline_s, 0.0), kMaxDeadline_s);
  std::vector<std::string> arguments{FindProgram(), path,
                                     std::to_string(limit_s)};
  arguments.insert(arguments.end(), wanted.begin(), wanted.end());
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw InputError(path + ": no pipe to read it through: " + strerror(errno));
  }
  const FileDescriptor from_child(ends[0]);
  FileDescriptor to_parent(ends[1]);
  ChildProcess child(arguments, to_parent.get());
  // Close our copy of the write end, or the end of file would not be seen.
  to_parent.Close();
  const ChildAnswer answer(path, from_child.get(), limit_s);
  return ReadFieldBytes(path, [&](void* bytes, std::size_t count) {
    if (answer.Get(bytes, count) == count) return;
    throw InputError(path + ": the reading process ended " + child.End() +
                     " before it was done, expected a file that is not "
                     "damaged");
  });
}

}  // namespace

FieldFile ReadFieldFileSafely(const std::string& path,
                              const std::vector<FieldQuantity>& quantities,
                              double deadline_s) {
  if (quantities.empty()) throw std::logic_error("no quantity is asked for");
  std::vector<std::string> wanted;
  for (const FieldQuantity quantity : quantities) {
    wanted.push_back(std::to_string(static_cast<int>(quantity)));
  }
  return ReadInChild(path, wanted, deadline_s);
}

FieldFile ReadVariableSafely(const std::string& path,
                             const std::string& variable, double deadline_s) {
  return ReadInChild(path, {kVariableArgument + variable}, deadline_s);
}

}  // namespace kg_base
