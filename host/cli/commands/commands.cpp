// The subcommands of lacuna.
#include "cli/commands/commands.h"

#include <CLI/App.hpp>

#include "cli/terminal/run_program.h"

namespace lacuna::cli {
namespace {

constexpr const char* kLacunaDescription = R"(Makes blue-noise point sets.

Examples:
  lacuna sample --radius 0.01 -o points.svg
  lacuna sample --count 10000 --torus > points.txt
  lacuna stipple photo.jpg --count 20000 -o dots.svg
  lacuna relax points.txt --torus -o even.npy
  lacuna order points.txt -o ordered.npy
  lacuna again dots.svg -o again.svg                the same file by the command that it records
  lacuna mask 64x64 -o mask.png
  lacuna sample --help
  lacuna verify points.txt --radius 0.01
  lacuna analyze points.txt -o sheet.pdf
  lacuna reproduce fig5 -o figures
  lacuna compare --radius 0.005
  lacuna devices
  lacuna help stipple                               the same as lacuna stipple --help
)";

void add_commands(CLI::App& app, const Sampler& sampler) {
    add_sample(app);
    add_stipple(app);
    add_relax_command(app);
    add_order(app);
    add_verify(app);
    add_analyze(app);
    add_reproduce(app);
    add_compare(app, sampler);
    add_mask(app);
    add_devices(app);
    add_again(app, [sampler](CLI::App& own) { add_commands(own, sampler); });
}

}  // namespace

int run_commands(int argc, char** argv, const Sampler& sampler) {
    const Program lacuna("lacuna", kLacunaDescription,
                         [&](CLI::App& app) { add_commands(app, sampler); });
    return run_program(lacuna, argc, argv);
}

}  // namespace lacuna::cli
