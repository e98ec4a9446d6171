// Given a path, the picture there is read whatever its name says, and errors name the path.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>
#include <thread>

#include "files/point_files.h"
#include "folder.h"
#include "pictures/image.h"
#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace {

using tests::Folder;

TEST(APictureFile, IsReadByItsContentAndNotByItsName) {
    const Folder folder;
    for (const auto& [name, bytes] : one_of_each())
        for (const char* given : {"picture", "picture.txt", "picture.png"}) {
            const std::string path = folder.path(given);
            files::write_whole(path, bytes);
            const Image image = read_image(path);
            EXPECT_EQ(image.luminance, decode_image(bytes, name).luminance) << name;
            EXPECT_EQ(image.name, path);
        }
}

TEST(APictureFile, ThatIsNotThereOrNoPictureIsToldByItsPath) {
    const Folder folder;
    files::write_whole(folder.path("text.png"), "not a picture\n");
    files::write_whole(folder.path("empty.png"), "");
    for (const char* name : {"missing.png", "text.png", "empty.png", "."}) {
        const std::string path = folder.path(name);
        try {
            read_image(path);
            ADD_FAILURE() << name << " was read";
        } catch (const files::FileError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(path + ": ")) << error.what();
        }
    }
}

TEST(APicture, MayComeFromStandardInputInPieces) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const int standard_input = ::dup(STDIN_FILENO);
    ::dup2(ends[0], STDIN_FILENO);
    const Samples samples(std::size_t{500} * 400, 51);
    const std::string bytes = "P5 500 400 255 " + bytes_of(samples);
    std::thread writer([&] {
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t written = ::write(ends[1], bytes.data() + at, bytes.size() - at);
            if (written <= 0) break;
            at += static_cast<std::size_t>(written);
        }
        ::close(ends[1]);
    });
    const Image image = read_image("-");
    writer.join();
    ::dup2(standard_input, STDIN_FILENO);
    ::close(standard_input);
    ::close(ends[0]);
    EXPECT_EQ(image.columns, 500U);
    EXPECT_EQ(image.rows, 400U);
    EXPECT_EQ(image.luminance, std::vector<double>(samples.size(), 0.2));
    EXPECT_EQ(image.name, "standard input");
}

}  // namespace
}  // namespace lacuna::pictures
