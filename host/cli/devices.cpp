// `lacuna devices`: every backend's devices, and why one cannot be used.
#include "cli/devices.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <cstdio>
#include <string>

#include "files/point_files.h"

namespace lacuna::cli {
namespace {

constexpr const char* kDescription =
    R"(Lists the backends and their devices, with what Lacuna may use of each.

Examples:
  lacuna devices                                          what there is
  lacuna sample --radius 0.01 --backend opencl --device 0 the first of opencl's
)";

std::string size_text(std::uint64_t bytes) {
    return bytes == 0 ? "-" : fmt::format("{:.1f} GB", static_cast<double>(bytes) / 1e9);
}

std::string table(const std::vector<Device>& devices) {
    constexpr const char* kRow = "{:<10} {:>6}  {:<5} {:>9} {:>14}  {}\n";
    std::string text = fmt::format(fmt::runtime(kRow), "backend", "device", "kind", "memory",
                                   "largest buffer", "name");
    std::size_t number = 0;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const Device& device = devices[i];
        number = i > 0 && devices[i - 1].backend == device.backend ? number + 1 : 0;
        std::string name = device.name;
        if (!device.unusable.empty())
            name += (name.empty() ? "not available: " : ": not available: ") + device.unusable;
        text += fmt::format(fmt::runtime(kRow), device.backend, number,
                            device.kind.empty() ? "-" : device.kind, size_text(device.memory_bytes),
                            size_text(device.largest_buffer_bytes), name);
    }
    return text;
}

}  // namespace

void add_devices(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("devices", kDescription);
    command.callback([] { files::write_whole("-", table(devices())); });
}

}  // namespace lacuna::cli
