// The command lacuna.
#include <lacuna/lacuna.h>

#include "cli/commands/commands.h"

int main(int argc, char** argv) {
    return lacuna::cli::run_commands(
        argc, argv, [](const lacuna::Request& request, lacuna::Observer& observer) {
            return lacuna::sample(request, observer);
        });
}
