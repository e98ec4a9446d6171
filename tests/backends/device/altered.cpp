// Kernels with a fault planted, on both devices.
#include "backends/device/altered.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace lacuna::opencl {
std::span<const std::string_view> kernel_files();  // kernels/*.cl one by one, includes expanded
}

namespace lacuna::tests {
namespace {

namespace fs = std::filesystem;

[[maybe_unused]] std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

[[maybe_unused]] void replace_first(std::string& text, std::size_t from_here, const Fault& fault) {
    const std::string from = fault.from;
    const std::size_t at = text.find(from, from_here);
    if (at == std::string::npos)
        throw std::runtime_error(std::string(fault.file) + " no longer has: " + from);
    text.replace(at, from.size(), fault.to);
}

// Whether the text defines the kernel; all texts define "".
[[maybe_unused]] bool has_kernel(std::string_view text, const std::string& kernel) {
    return kernel.empty() || text.find("\nKERNEL(" + kernel + ",") != std::string_view::npos;
}

#ifdef LACUNA_OPENCL
opencl::Trial faulty_kernels(const Fault& fault) {
    opencl::Trial trial;
    for (const std::string_view embedded : opencl::kernel_files()) {
        std::string source(embedded);
        const std::size_t at = source.find("#line 1 \"kernels/" + std::string(fault.file) + "\"");
        if (at == std::string::npos || !has_kernel(source, fault.kernel)) continue;
        replace_first(source, at, fault);
        trial.sources.push_back(source);
    }
    if (trial.sources.empty())
        throw std::runtime_error("no kernel includes " + std::string(fault.file));
    return trial;
}
#endif

#ifdef LACUNA_VULKAN
// The kernels with the fault in their text, in a folder of their own.
class FaultyCopy {
public:
    explicit FaultyCopy(const Fault& fault) {
        fs::remove_all(folder_);
        fs::copy(fs::path(LACUNA_SOURCE) / "kernels", folder_, fs::copy_options::recursive);
        std::string text = read(folder_ / fault.file);
        replace_first(text, 0, fault);
        std::ofstream(folder_ / fault.file, std::ios::binary) << text;
    }
    ~FaultyCopy() { fs::remove_all(folder_); }
    FaultyCopy(const FaultyCopy&) = delete;
    FaultyCopy& operator=(const FaultyCopy&) = delete;

    const fs::path& folder() const { return folder_; }

private:
    static inline int made_ = 0;
    const fs::path folder_ =
        fs::path(testing::TempDir()) /
        ("lacuna-faulty-" + std::to_string(::getpid()) + "-" + std::to_string(made_++));
};

// Whether the text includes the file, directly or through others.
bool includes(const std::string& text, const std::string& file) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string word = "#include \"";
        if (!line.starts_with(word)) continue;
        std::string name = line.substr(word.size(), line.rfind('"') - word.size());
        const fs::path kernels = fs::path(LACUNA_SOURCE) / "kernels";
        if (!fs::exists(kernels / name)) name = "portable/" + name;
        if (name == file || includes(read(kernels / name), file)) return true;
    }
    return false;
}

// See cmake/vulkan.cmake.
std::vector<std::uint32_t> compiled(const std::string& kernel, const fs::path& kernels) {
    const fs::path shader = fs::path(LACUNA_SHADERS) / (kernel + ".comp");
    const fs::path spirv = kernels / (kernel + ".spv");
    const std::string command = std::string("'") + LACUNA_GLSLANG +
                                "' -V --target-env vulkan1.2 --quiet '-I" + kernels.string() +
                                "' -o '" + spirv.string() + "' '" + shader.string() + "'";
    if (std::system(command.c_str()) != 0) throw std::runtime_error(command + " failed");
    const std::string bytes = read(spirv);
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
    return words;
}

vulkan::Trial faulty_shaders(const Fault& fault) {
    std::set<std::string, std::less<>> kernels;
    for (const fs::directory_entry& file :
         fs::directory_iterator(fs::path(LACUNA_SOURCE) / "kernels")) {
        if (file.path().extension() != ".cl") continue;
        const std::string text = read(file.path());
        if (includes(text, fault.file) && has_kernel(text, fault.kernel))
            kernels.insert(file.path().stem());
    }
    if (kernels.empty()) throw std::runtime_error("no shader includes " + std::string(fault.file));
    const auto copy = std::make_shared<FaultyCopy>(fault);
    vulkan::Trial trial;
    trial.shader_of = [kernels, copy](std::string_view kernel) {
        return kernels.contains(kernel) ? compiled(std::string(kernel), copy->folder())
                                        : std::vector<std::uint32_t>{};
    };
    return trial;
}
#endif

}  // namespace

void OnFaultyBackend::SetUp() {
    setenv("POCL_EXTRA_BUILD_FLAGS", "-cl-opt-disable", 1);
    setenv("GALLIVM_PERF", "nopt", 1);  // lavapipe reads it once, before its first device
    OnBackend::SetUp();
}

std::unique_ptr<Backend> make_faulty(const std::string& backend, [[maybe_unused]] const Plan& plan,
                                     [[maybe_unused]] const Fault& fault,
                                     [[maybe_unused]] const device::Tuning& tuning) {
#ifdef LACUNA_OPENCL
    if (backend == "opencl") return opencl::make_backend(plan, {}, tuning, faulty_kernels(fault));
#endif
#ifdef LACUNA_VULKAN
    if (backend == "vulkan") return vulkan::make_backend(plan, {}, tuning, faulty_shaders(fault));
#endif
    throw Unavailable("backend " + backend + ": this build was made without it");
}

std::unique_ptr<space::SpaceBackend> make_faulty_in_space(const std::string& backend,
                                                          [[maybe_unused]] const Plan& plan,
                                                          [[maybe_unused]] const Fault& fault) {
#ifdef LACUNA_OPENCL
    if (backend == "opencl") return opencl::make_space_backend(plan, {}, faulty_kernels(fault));
#endif
#ifdef LACUNA_VULKAN
    if (backend == "vulkan") return vulkan::make_space_backend(plan, {}, faulty_shaders(fault));
#endif
    throw Unavailable("backend " + backend + ": this build was made without it");
}

std::unique_ptr<device::Queue> open_faulty_queue(const std::string& backend,
                                                 [[maybe_unused]] const Fault& fault) {
#ifdef LACUNA_OPENCL
    if (backend == "opencl") return opencl::open_queue({}, faulty_kernels(fault));
#endif
#ifdef LACUNA_VULKAN
    if (backend == "vulkan") return vulkan::open_queue({}, faulty_shaders(fault));
#endif
    throw Unavailable("backend " + backend + ": this build was made without it");
}

Outcome run_on_cpu(const Plan& plan) {
    Observer nobody;
    return generate(plan, *cpu::make_backend(plan, {}), nobody);
}

}  // namespace lacuna::tests
