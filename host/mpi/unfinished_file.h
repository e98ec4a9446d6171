// The file that is being written, which signals take away.
#pragma once

#include <string>

namespace lacuna::mpi {

// From now on Ctrl-C, SIGTERM, SIGHUP, SIGQUIT and SIGABRT remove it, if it is there, and end the
// process with 128 and the signal's number; only rank 0 says so. An exit() removes it too. An empty
// name: nothing is to be removed.
void remove_on_signal(const std::string& name, bool speaks);

// While it lives these signals wait.
class SignalsWait {
public:
    SignalsWait();
    ~SignalsWait();
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;
};

}  // namespace lacuna::mpi
