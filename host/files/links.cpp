// Follows symbolic links, also links to files that do not exist.
#include "files/links.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "files/parse.h"

namespace lacuna::files {

std::string behind_links(const std::string& path) {
    constexpr int kMaximalLinks = 40;  // the same limit as the kernel's
    std::filesystem::path target = path;
    std::error_code error;
    for (int i = 0; i < kMaximalLinks; ++i) {
        if (!std::filesystem::is_symlink(target, error)) return target.string();
        const std::filesystem::path link = std::filesystem::read_symlink(target, error);
        if (error) refuse(path, std::generic_category().message(error.value()));
        target = target.parent_path() / link;
    }
    refuse(path, std::generic_category().message(ELOOP));
}

}  // namespace lacuna::files
