// Given a file without end, reading stops at a limit and says so.
#include "files/read_whole.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "files/point_files.h"
#include "plan/sizes.h"

namespace lacuna::files {
namespace {

std::string message_of_reading(const std::string& path, std::uint64_t most) {
    try {
        return std::to_string(read_whole(path, most).size()) + " bytes";
    } catch (const FileError& error) {
        return error.what();
    }
}

TEST(ReadWhole, GivenADeviceWithoutEndThenItStopsAtTheLimitAndNamesIt) {
    EXPECT_EQ(message_of_reading("/dev/zero", 1000000),
              "/dev/zero: has more than 1000000 bytes, which a file to be read may have at most");
}

TEST(ReadWhole, GivenAFileOfAsManyBytesAsAreAllowedThenItIsReadAndOneMoreIsRefused) {
    const std::string path = testing::TempDir() + "/lacuna-read-whole";
    for (const std::size_t size : {std::size_t{0}, std::size_t{100}, std::size_t{65536}}) {
        std::ofstream(path, std::ios::binary) << std::string(size, 'a');
        EXPECT_EQ(message_of_reading(path, size), std::to_string(size) + " bytes");
        if (size == 0) continue;
        EXPECT_EQ(message_of_reading(path, size - 1),
                  path + ": has more than " + std::to_string(size - 1) +
                      " bytes, which a file to be read may have at most");
    }
    std::filesystem::remove(path);
}

TEST(ReadWhole, AllowsLessThanTheMachineHas) {
    EXPECT_GT(most_bytes(), 0u);
    EXPECT_GT(machine_memory_bytes(), 3 * most_bytes());
}

}  // namespace
}  // namespace lacuna::files
