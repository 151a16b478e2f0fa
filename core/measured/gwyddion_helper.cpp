// Reads files that only Gwyddion knows: Gwyddion runs as a separate program with a time limit and
// writes a GWY file into a temporary folder. Where it is not installed, the error says so and names
// the kinds of files that are read without it.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/base/input_error.h"
#include "core/base/program.h"
#include "core/base/regular_file.h"
#include "core/base/stop.h"
#include "core/base/text_encoding.h"
#include "core/measured/surface_draft.h"

extern char** environ;

namespace asperity {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto kLongest = 60s;
constexpr std::size_t kLargestResult = std::size_t{1} << 30;  // bytes

/// A temporary folder, which is removed with everything in it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& file) {
    std::error_code none;
    std::string form = (fs::temp_directory_path(none) / "asperity-XXXXXX").string();
    if (::mkdtemp(form.data()) == nullptr)
      throw InputError(file, "", "cannot be converted: there is no temporary folder");
    path_ = form;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A program in its own process group, which ends with the object.
class Process {
 public:
  Process(const std::string& program, const std::vector<std::string>& arguments) {
    std::vector<char*> words;
    for (const std::string& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    posix_spawnattr_setpgroup(&how, 0);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
    if (::posix_spawn(&process_, program.c_str(), &files, &how, words.data(), environ) != 0)
      process_ = -1;
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
  }
  ~Process() {
    if (process_ <= 0) return;
    ::kill(-process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool hasStarted() const { return process_ > 0; }

  /// Returns whether the program has ended, without waiting; `succeeded` then tells how.
  bool hasEnded() {
    if (process_ <= 0) return true;
    int status = 0;
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
    succeeded_ = ended == process_ && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    process_ = -1;
    return true;
  }
  bool succeeded() const { return succeeded_; }

 private:
  pid_t process_ = -1;
  bool succeeded_ = false;
};

}  // namespace

std::string convertWithGwyddion(const fs::path& file, const std::stop_token& stop) {
  const std::string name = file.string();
  const RegularFile regular(file);  // refuses a pipe, for which Gwyddion would wait
  const std::string program = findProgram("gwyddion");
  if (program.empty()) {
    const std::string_view kind = detectNonText(regular.read(0, kBeginning));
    if (!kind.empty())
      throw InputError(name, "",
                       message("is {}; without Gwyddion, which is not installed, text (profiles, "
                               "matrices, points) and files of these kinds are read: {}",
                               Message(kind), readableFormats()));
    throw InputError(name, "",
                     message("is of a kind that only Gwyddion reads, which is not installed; text "
                             "(profiles, matrices, points) and files of these kinds are read "
                             "without it: {}",
                             readableFormats()));
  }
  const TemporaryFolder folder(name);
  const fs::path result = folder.path() / "surface.gwy";
  Process process(program, {"gwyddion", "--no-splash", "--disable-gl",
                            "--convert-to-gwy=" + result.string(), fs::absolute(file).string()});
  if (!process.hasStarted())
    throw InputError(name, "", "cannot be converted: Gwyddion does not start");
  const auto latest = std::chrono::steady_clock::now() + kLongest;
  while (!process.hasEnded()) {
    throwIfStopped(stop);
    if (std::chrono::steady_clock::now() > latest)
      throw InputError(
          name, "",
          message("cannot be converted: Gwyddion has not ended within {} s", kLongest.count()));
    std::this_thread::sleep_for(20ms);
  }
  std::error_code none;
  if (!process.succeeded() || !fs::is_regular_file(result, none))
    throw InputError(name, "", "is of a kind that Gwyddion does not read either");
  return readRegularFile(result, kLargestResult);
}

}  // namespace asperity
