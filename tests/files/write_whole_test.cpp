// A file appears whole or not at all; devices, pipes and links are written to, not replaced.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "files/point_files.h"
#include "folder.h"

namespace lacuna::files {
namespace {

namespace fs = std::filesystem;
using tests::content_of;

// A folder of its own for each test.
class WriteWhole : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::size_t files_in_folder() const { return folder_.names().size(); }

    const tests::Folder folder_;
};

mode_t permissions_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 0777U;
}

std::string message_of_failure(const std::string& path, const std::string& bytes) {
    try {
        write_whole(path, bytes);
    } catch (const FileError& error) {
        return error.what();
    }
    return "no failure";
}

TEST_F(WriteWhole, GivenNoFileThenOneAppearsWithTheseBytesAlone) {
    const std::string bytes("a\0b\n", 4);
    write_whole(path("points.txt"), bytes);
    EXPECT_EQ(content_of(path("points.txt")), bytes);
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteWhole, GivenNoBytesThenTheFileIsEmpty) {
    write_whole(path("points.txt"), "");
    EXPECT_TRUE(fs::exists(path("points.txt")));
    EXPECT_EQ(content_of(path("points.txt")), "");
}

TEST_F(WriteWhole, GivenAnOlderFileThenItIsReplacedAndKeepsItsPermissions) {
    tests::write_file(path("points.txt"), "a longer older file");
    ASSERT_EQ(::chmod(path("points.txt").c_str(), 0640), 0);
    write_whole(path("points.txt"), "new");
    EXPECT_EQ(content_of(path("points.txt")), "new");
    EXPECT_EQ(permissions_of(path("points.txt")), 0640U);
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteWhole, GivenANewFileThenItsPermissionsAreWhatTheUmaskLeaves) {
    const mode_t before = ::umask(0027);
    write_whole(path("points.txt"), "new");
    EXPECT_EQ(::umask(before), mode_t{0027}) << "the umask was changed";
    EXPECT_EQ(permissions_of(path("points.txt")), 0640U);
}

TEST_F(WriteWhole, GivenARelativeNameThenTheFileIsInTheCurrentFolder) {
    const fs::path before = fs::current_path();
    fs::current_path(path("."));
    write_whole("points.txt", "new");
    fs::current_path(before);
    EXPECT_EQ(content_of(path("points.txt")), "new");
}

TEST_F(WriteWhole, GivenTheLongestNameThatTheSystemTakesThenItIsWritten) {
    const std::string name = std::string(251, 'n') + ".txt";
    write_whole(path(name), "new");
    EXPECT_EQ(content_of(path(name)), "new");
}

TEST_F(WriteWhole, GivenALinkThenTheFileBehindItIsWrittenAndTheLinkStays) {
    fs::create_directory(path("deep"));
    tests::write_file(path("deep/points.txt"), "old");
    fs::create_symlink("deep/points.txt", path("second.txt"));
    fs::create_symlink(path("second.txt"), path("first.txt"));
    write_whole(path("first.txt"), "new");
    EXPECT_EQ(content_of(path("deep/points.txt")), "new");
    EXPECT_TRUE(fs::is_symlink(path("first.txt")));
    EXPECT_TRUE(fs::is_symlink(path("second.txt")));
    EXPECT_EQ(files_in_folder(), 3U);
}

TEST_F(WriteWhole, GivenALinkToNothingThenTheFileBehindItAppears) {
    fs::create_symlink("points.txt", path("link.txt"));
    write_whole(path("link.txt"), "new");
    EXPECT_TRUE(fs::is_symlink(path("link.txt")));
    EXPECT_EQ(content_of(path("points.txt")), "new");
}

TEST_F(WriteWhole, GivenALinkToItselfThenTheErrorSaysSo) {
    fs::create_symlink("link.txt", path("link.txt"));
    EXPECT_EQ(message_of_failure(path("link.txt"), "new"),
              path("link.txt") + ": Too many levels of symbolic links");
}

TEST_F(WriteWhole, GivenAMissingFolderThenTheErrorNamesThePathAndTheReason) {
    EXPECT_EQ(message_of_failure(path("missing/points.txt"), "new"),
              path("missing/points.txt") + ": No such file or directory");
    EXPECT_EQ(files_in_folder(), 0U);
}

TEST_F(WriteWhole, GivenAFileInPlaceOfTheFolderThenTheErrorSaysSo) {
    tests::write_file(path("file"), "old");
    EXPECT_EQ(message_of_failure(path("file/points.txt"), "new"),
              path("file/points.txt") + ": Not a directory");
    EXPECT_EQ(content_of(path("file")), "old");
}

TEST_F(WriteWhole, GivenAFolderThenTheErrorSaysSoAndTheFolderStays) {
    fs::create_directory(path("folder.txt"));
    EXPECT_EQ(message_of_failure(path("folder.txt"), "new"),
              path("folder.txt") + ": Is a directory");
    EXPECT_TRUE(fs::is_directory(path("folder.txt")));
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteWhole, GivenAFolderThatMayNotBeWrittenThenTheOlderFileIsUntouched) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    tests::write_file(path("points.txt"), "old");
    fs::permissions(path("."), fs::perms::owner_read | fs::perms::owner_exec);
    const std::string message = message_of_failure(path("points.txt"), "new");
    fs::permissions(path("."), fs::perms::owner_all);
    EXPECT_EQ(message, path("points.txt") + ": Permission denied");
    EXPECT_EQ(content_of(path("points.txt")), "old");
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteWhole, GivenAWriteProtectedFileThenItIsUntouched) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anything";
    tests::write_file(path("points.txt"), "old");
    ASSERT_EQ(::chmod(path("points.txt").c_str(), 0444), 0);
    EXPECT_EQ(message_of_failure(path("points.txt"), "new"),
              path("points.txt") + ": Permission denied");
    EXPECT_EQ(content_of(path("points.txt")), "old");
}

TEST_F(WriteWhole, GivenNoRoomHalfwayThenTheOlderFileIsUntouchedAndNothingElseIsLeft) {
    tests::write_file(path("points.txt"), "old");
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const rlimit tight{1000, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
    const std::string message = message_of_failure(path("points.txt"), std::string(5000, 'n'));
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(message, path("points.txt") + ": File too large");
    EXPECT_EQ(content_of(path("points.txt")), "old");
    EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(WriteWhole, GivenAFullDeviceThenTheErrorNamesItAndTheReason) {
    EXPECT_EQ(message_of_failure("/dev/full", "new"), "/dev/full: No space left on device");
}

TEST_F(WriteWhole, GivenALinkToADeviceThenTheDeviceIsWrittenToAndTheLinkStays) {
    fs::create_symlink("/dev/full", path("full.txt"));
    EXPECT_EQ(message_of_failure(path("full.txt"), "new"),
              path("full.txt") + ": No space left on device");
    EXPECT_TRUE(fs::is_symlink(path("full.txt")));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

void do_nothing(int) {}

// Reads a pipe to its end. Before each piece it interrupts `writer` twice: once when write() has
// done a part, and once when it has done nothing.
std::string read_slowly(const std::string& pipe, pthread_t writer) {
    const int descriptor = ::open(pipe.c_str(), O_RDONLY | O_CLOEXEC);
    std::string bytes;
    std::array<char, 60000> piece{};
    for (;;) {
        for (int i = 0; i < 2; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            ::pthread_kill(writer, SIGUSR1);
        }
        const ssize_t count = ::read(descriptor, piece.data(), piece.size());
        if (count <= 0) break;
        bytes.append(piece.data(), static_cast<std::size_t>(count));
    }
    ::close(descriptor);
    return bytes;
}

TEST_F(WriteWhole, GivenAPipeAndSignalsThenEveryByteArrivesInOrder) {
    ASSERT_EQ(::mkfifo(path("pipe.txt").c_str(), 0600), 0);
    std::string bytes;
    while (bytes.size() < 1000000) bytes += std::to_string(bytes.size()) + "\n";
    struct sigaction interrupting {};
    struct sigaction before {};
    interrupting.sa_handler = do_nothing;  // and no SA_RESTART: write() returns early
    ASSERT_EQ(::sigaction(SIGUSR1, &interrupting, &before), 0);

    std::string received;
    std::thread reader(
        [&, writer = ::pthread_self()] { received = read_slowly(path("pipe.txt"), writer); });
    EXPECT_EQ(message_of_failure(path("pipe.txt"), bytes), "no failure");
    reader.join();
    ASSERT_EQ(::sigaction(SIGUSR1, &before, nullptr), 0);
    EXPECT_TRUE(received == bytes) << received.size() << " of " << bytes.size() << " bytes";
    EXPECT_TRUE(fs::is_fifo(path("pipe.txt")));
}

// While this object lives, standard output is appended to a file.
class StandardOutputInto {
public:
    explicit StandardOutputInto(const std::string& path) : before_(::dup(STDOUT_FILENO)) {
        std::fflush(stdout);
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
        EXPECT_EQ(::dup2(file, STDOUT_FILENO), STDOUT_FILENO);
        ::close(file);
    }
    StandardOutputInto(const StandardOutputInto&) = delete;
    StandardOutputInto& operator=(const StandardOutputInto&) = delete;
    ~StandardOutputInto() {
        std::fflush(stdout);
        ::dup2(before_, STDOUT_FILENO);
        ::close(before_);
    }

private:
    int before_;
};

TEST_F(WriteWhole, GivenADashThenStandardOutputGetsTheBytes) {
    {
        const StandardOutputInto file(path("out.txt"));
        write_whole("-", "points\n");
    }
    EXPECT_EQ(content_of(path("out.txt")), "points\n");
}

TEST_F(WriteWhole, GivenDevStdoutIntoAFileThenTheBytesAreAppendedToIt) {
    tests::write_file(path("out.txt"), "earlier\n");
    {
        const StandardOutputInto file(path("out.txt"));
        write_whole("/dev/stdout", "points\n");
    }
    EXPECT_EQ(content_of(path("out.txt")), "earlier\npoints\n");
}

TEST_F(WriteWhole, GivenAFullStandardOutputThenTheErrorNamesIt) {
    std::string message;
    {
        const StandardOutputInto file("/dev/full");
        message = message_of_failure("-", "points\n");
    }
    EXPECT_EQ(message, "standard output: No space left on device");
}

}  // namespace
}  // namespace lacuna::files
