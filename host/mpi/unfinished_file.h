// Removes the file that is being written if a signal ends the process.
#pragma once

#include <string>

namespace lacuna::mpi {

// From now on SIGINT (Ctrl-C), SIGTERM, SIGHUP, SIGQUIT and SIGABRT remove the file `name`, and end
// the process with exit code 128 + the signal's number. They print a message if `speaks`. exit()
// removes the file too. An empty name: nothing is to be removed.
void remove_on_signal(const std::string& name, bool speaks);

// While an object of this class exists, these signals wait.
class SignalsWait {
public:
    SignalsWait();
    ~SignalsWait();
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;
};

}  // namespace lacuna::mpi
