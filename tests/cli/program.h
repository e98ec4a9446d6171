// Runs the program under test as a user would, and keeps its output.
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "folder.h"

namespace lacuna::tests {

struct Outcome {
    int exit_code;  // 128 + the signal if one ended it, as shells say
    std::string out;
    std::string err;
};

// How to start the program. The defaults leave everything as it is in this process.
struct Setting {
    int stdout_fd = -1;            // instead of a file whose content is Outcome::out
    int stderr_fd = -1;            // likewise
    long largest_file_bytes = -1;  // the system's limit
    long stack_bytes = -1;         // likewise
    long memory_bytes = -1;        // likewise, of addresses
    bool no_threads = false;       // the system refuses the program further threads
    std::map<std::string, std::string> environment;  // added to this process's
    std::string program;                             // instead of the one under test
};

class Program {
public:
    explicit Program(const std::vector<std::string>& arguments, const Setting& setting = {});
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void send(int signal) const;
    // Waits until the program has a handler for `signal`; false when it ends without one.
    bool waits_for(int signal) const;
    bool is_running();
    Outcome wait();

private:
    Folder folder_;
    pid_t pid_ = -1;
    int status_ = 0;
    bool ended_ = false;
};

Outcome run(const std::vector<std::string>& arguments, const Setting& setting = {});

// Runs a command of the shell in a folder.
Outcome run_in(const Folder& folder, const std::string& command);

}  // namespace lacuna::tests
