// The compilation of the kernels.
#include "backends/opencl/program.h"

#include <map>
#include <mutex>
#include <utility>

namespace lacuna::opencl {
namespace {

void CL_CALLBACK add_to_log(const char* message, const void*, std::size_t, void* log) {
    static_cast<Log*>(log)->add(message);
}

std::shared_ptr<Program> compile(const Found& found, const std::string& source) {
    auto made = std::make_shared<Program>();
    made->entry = found.entry;
    made->device = found.device;
    guarded(found.entry.name, made->log, [&] {
        made->context =
            cl::Context(made->device, nullptr, add_to_log, static_cast<void*>(&made->log));
        made->program = cl::Program(made->context, source);
        // See kernels/bodies/prelude.h.
        const bool is_oclgrind = found.entry.name.find("Oclgrind") != std::string::npos;
        const char* const options =
            is_oclgrind ? "-cl-std=CL1.2 -DLACUNA_ATOMIC_LOOKS" : "-cl-std=CL1.2";
        try {
            made->program.build(made->device, options);
        } catch (const cl::BuildError& error) {
            for (const auto& [device, text] : error.getBuildLog()) made->log.add(text.c_str());
            throw;
        }
    });
    return made;
}

}  // namespace

std::shared_ptr<Program> compiled(const Found& found, const std::string& source) {
    static std::mutex mutex;
    // Never destroyed: by the end of the process a driver may have destroyed itself.
    using All = std::map<std::pair<cl_device_id, std::string>, std::shared_ptr<Program>>;
    static All& all = *std::make_unique<All>().release();
    const std::lock_guard lock(mutex);
    std::shared_ptr<Program>& program = all[{found.device(), source}];
    if (program == nullptr) program = compile(found, source);
    return program;
}

}  // namespace lacuna::opencl
