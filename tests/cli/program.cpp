// Starts, signals and waits for the program under test.
#include "program.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <thread>

namespace lacuna::tests {
namespace {

void must(bool done, const char* what) {
    if (!done) throw std::runtime_error(std::string("the test cannot ") + what);
}

int new_file(const std::string& path) {
    const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    must(file >= 0, "make a file");
    return file;
}

// Called between fork and exec. Undoes what the test runner ignores or limits.
[[noreturn]] void become_program(char* const* arguments, int out, int err, const Setting& setting) {
    for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGXFSZ})
        signal(number, SIG_DFL);
    const auto limit = [](auto resource, long bytes) {
        const rlimit both{static_cast<rlim_t>(bytes), static_cast<rlim_t>(bytes)};
        if (bytes >= 0) setrlimit(resource, &both);
    };
    limit(RLIMIT_FSIZE, setting.largest_file_bytes);
    limit(RLIMIT_STACK, setting.stack_bytes);
    limit(RLIMIT_AS, setting.memory_bytes);
    if (setting.no_threads) {
        // The limit counts a user's processes, and root has none.
        constexpr uid_t kNobody = 65534;
        const rlimit one{1, 1};
        if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) _exit(126);
        setrlimit(RLIMIT_NPROC, &one);
    }
    for (const auto& [name, value] : setting.environment) setenv(name.c_str(), value.c_str(), 1);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    execv(arguments[0], arguments);
    _exit(126);
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const Setting& setting) {
    std::vector<std::string> words{setting.program.empty() ? LACUNA_PROGRAM : setting.program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    const int out = new_file(folder_.path("out"));
    const int err = new_file(folder_.path("err"));
    pid_ = fork();
    must(pid_ >= 0, "start the program");
    if (pid_ == 0)
        become_program(pointers.data(), setting.stdout_fd >= 0 ? setting.stdout_fd : out,
                       setting.stderr_fd >= 0 ? setting.stderr_fd : err, setting);
    close(out);
    close(err);
}

Program::~Program() {
    if (!ended_) {
        send(SIGKILL);
        waitpid(pid_, &status_, 0);
    }
}

void Program::send(int signal) const {
    kill(pid_, signal);
}

bool Program::waits_for(int signal) const {
    const std::string status = "/proc/" + std::to_string(pid_) + "/status";
    for (;;) {
        const std::string text = content_of(status);
        const std::size_t caught = text.find("SigCgt:");
        if (caught == std::string::npos || text.find("State:\tZ") != std::string::npos)
            return false;
        const std::uint64_t mask = std::stoull(text.substr(caught + 7), nullptr, 16);
        if ((mask >> (signal - 1) & 1) != 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

bool Program::is_running() {
    if (!ended_) ended_ = waitpid(pid_, &status_, WNOHANG) == pid_;
    return !ended_;
}

Outcome Program::wait() {
    if (!ended_) waitpid(pid_, &status_, 0);
    ended_ = true;
    const int code = WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
    return {code, content_of(folder_.path("out")), content_of(folder_.path("err"))};
}

Outcome run(const std::vector<std::string>& arguments, const Setting& setting) {
    return Program(arguments, setting).wait();
}

Outcome run_in(const Folder& folder, const std::string& command) {
    Setting shell;
    shell.program = "/bin/sh";
    return run({"-c", "cd " + folder.path("") + " && " + command}, shell);
}

}  // namespace lacuna::tests
