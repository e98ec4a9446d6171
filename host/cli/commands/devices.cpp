// `lacuna devices`: lists every backend's devices, and why some cannot be used.
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>
#include <lacuna/version.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "cli/reports/comparison.h"
#include "cli/reports/report.h"
#include "cli/terminal/driver.h"
#include "files/point_files.h"

namespace lacuna::cli {
namespace {

constexpr const char* kDevicesDescription =
    R"(Lists the backends and their devices, with the memory that Lacuna may use.

Examples:
  lacuna devices                                          a table
  lacuna devices --json                                   the same for programs
  lacuna sample --radius 0.01 --backend opencl --device 0 runs on the first device of opencl
)";

// A device with its number within its backend.
struct Row {
    Device device;
    std::size_t number;
};

// A backend without devices has a row with the reason.
std::vector<Row> rows() {
    std::vector<Row> rows;
    const std::vector<Device> devices = listed_devices();
    for (const std::string_view backend : options::words_of(options::Words::named_backends)) {
        std::size_t number = 0;
        for (const Device& device : devices)
            if (device.backend == backend) rows.push_back({device, number++});
        if (number == 0) {
            Device none;
            none.backend = std::string(backend);
            none.unusable = kNoDriver;
            rows.push_back({none, 0});
        }
    }
    return rows;
}

std::string size_text(std::uint64_t bytes) {
    return bytes == 0 ? "-" : fmt::format("{:.1f} GB", static_cast<double>(bytes) / 1e9);
}

std::string table(const std::vector<Row>& rows) {
    constexpr const char* kRow = "{:<10} {:>6}  {:<5} {:>9} {:>14}  {}\n";
    std::string text = fmt::format(fmt::runtime(kRow), "backend", "device", "kind", "memory",
                                   "largest buffer", "name");
    for (const auto& [device, number] : rows) {
        std::string name = device.name;
        if (!device.unusable.empty())
            name += (name.empty() ? "not available: " : ": not available: ") + device.unusable;
        text += fmt::format(fmt::runtime(kRow), device.backend, number,
                            device.kind.empty() ? "-" : device.kind, size_text(device.memory_bytes),
                            size_text(device.largest_buffer_bytes), name);
    }
    return text;
}

std::string json_of(const std::vector<Row>& rows) {
    Json report{{"program", "lacuna"}, {"version", LACUNA_VERSION}, {"devices", Json::array()}};
    for (const auto& [device, number] : rows)
        report["devices"].push_back(
            {{"backend", device.backend},
             {"device", number},
             {"name", device.name},
             {"kind", device.kind},
             {"memory_bytes", device.memory_bytes},
             {"largest_buffer_bytes", device.largest_buffer_bytes},
             {"usable", device.unusable.empty()},
             {"why_not", device.unusable.empty() ? Json(nullptr) : Json(device.unusable)}});
    // Device names come from drivers, which need not use UTF-8.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void add_devices(CLI::App& app) {
    const auto json = std::make_shared<bool>(false);
    add_command(app, options::kDevices, kDevicesDescription, {{"json", json.get()}},
                [json](const CommandLine&) {
                    files::write_whole("-", *json ? json_of(rows()) : table(rows()));
                });
}

}  // namespace lacuna::cli
