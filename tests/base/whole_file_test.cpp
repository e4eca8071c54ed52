#include <candela/whole_file.h>

#include "temporary_folder.h"

#include <candela/error.h>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& path, const std::string& text) {
    writeWholeFile(path, std::as_bytes(std::span(text)));
}

/// The error that writing ends in; fails the test when there is none.
std::string failureOf(const fs::path& path, const std::string& text = "new") {
    try {
        write(path, text);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::environment);
        EXPECT_EQ(error.path(), path.string());
        return error.what();
    }
    ADD_FAILURE() << "writing " << path << " did not fail";
    return {};
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Lets no file of this process grow beyond `bytes`: the write fails as on a full disk, after some of the
/// bytes were written. The signal SIGXFSZ keeps its default action, which ends the process.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }

  private:
    rlimit before_{};
};

TEST(WholeFile, writesAndReplaces) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.bin";
    write(path, "first, and longer");
    EXPECT_EQ(read(path), "first, and longer");
    write(path, "second");
    EXPECT_EQ(read(path), "second");
    write(path, "");
    EXPECT_EQ(fs::file_size(path), 0u);
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, writesALongFile) {
    const TemporaryFolder folder;
    std::string text(5'000'000, 'x');
    for (std::size_t i = 0; i < text.size(); i += 1021) text[i] = char(i);
    write(folder.path() / "long", text);
    EXPECT_EQ(read(folder.path() / "long"), text);
}

TEST(WholeFile, takesANameWithoutFolder) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    write("plain", "here");
    fs::current_path(before);
    EXPECT_EQ(read(folder.path() / "plain"), "here");
}

TEST(WholeFile, givesPermissionsByTheUmaskAndKeepsThoseOfAReplacedFile) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a";
    const mode_t before = ::umask(0027);
    write(path, "x");
    ::umask(before);
    EXPECT_EQ(unsigned(fs::status(path).permissions()), 0640u);
    fs::permissions(path, fs::perms(0600));
    write(path, "y");
    EXPECT_EQ(unsigned(fs::status(path).permissions()), 0600u);
}

TEST(WholeFile, followsLinks) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "real");
    fs::create_symlink("real/target", folder.path() / "link");
    write(folder.path() / "link", "through a link to nothing");
    write(folder.path() / "link", "through a link");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_EQ(read(folder.path() / "real/target"), "through a link");

    fs::create_symlink("circle", folder.path() / "circle");
    EXPECT_TRUE(contains(failureOf(folder.path() / "circle"), "link"));
}

TEST(WholeFile, manyThreadsWriteAtOnce) {
    const TemporaryFolder folder;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&, i] { write(folder.path() / "same", std::string(100'000, char('a' + i))); });
    for (std::thread& thread : threads) thread.join();
    const std::string text = read(folder.path() / "same");
    EXPECT_EQ(text, std::string(100'000, text.at(0)));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, aMissingFolderIsNamed) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "missing" / "a.png";
    const std::string text = failureOf(path);
    EXPECT_TRUE(contains(text, path.string())) << text;
    EXPECT_TRUE(contains(text, "'" + (folder.path() / "missing").string() + "' does not exist")) << text;
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WholeFile, aFileInPlaceOfTheFolderIsNamed) {
    const TemporaryFolder folder;
    write(folder.path() / "file", "x");
    const std::string text = failureOf(folder.path() / "file" / "a.png");
    EXPECT_TRUE(contains(text, "'" + (folder.path() / "file").string() + "'")) << text;
    EXPECT_TRUE(contains(text, "not a folder")) << text;
}

TEST(WholeFile, aFolderIsNotAFile) {
    const TemporaryFolder folder;
    EXPECT_TRUE(contains(failureOf(folder.path()), "is a folder"));
    EXPECT_TRUE(contains(failureOf(folder.path() / "new" / ""), "does not exist"));
    EXPECT_EQ(folder.entries(), 0);
    EXPECT_THROW(write("", "x"), Error);
}

TEST(WholeFile, aFolderThatCanNotHoldFilesIsNamed) {
    // Not even root can create files here.
    EXPECT_TRUE(contains(failureOf("/proc/candela-test.png"), "'/proc'"));
}

TEST(WholeFile, aProtectedFileIsUnchanged) {
    if (::geteuid() == 0) GTEST_SKIP() << "root ignores file permissions";
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a";
    write(path, "old");
    fs::permissions(path, fs::perms(0400));
    EXPECT_TRUE(contains(failureOf(path), "can not overwrite"));
    EXPECT_EQ(read(path), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, aFailedWriteLeavesOnlyTheOldFile) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a";
    write(path, "old");
    {
        const FileSizeLimit limit(10'000);
        EXPECT_TRUE(contains(failureOf(path, std::string(100'000, 'n')), std::strerror(EFBIG)));
        EXPECT_TRUE(
            contains(failureOf(folder.path() / "b", std::string(100'000, 'n')), std::strerror(EFBIG)));
    }
    EXPECT_EQ(read(path), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, aKilledProcessLeavesNoTemporaryFile) {
    const TemporaryFolder folder;
    const pid_t writer = ::fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
        const std::string text(20'000'000, 'k');
        for (int i = 0;; ++i) write(folder.path() / std::to_string(i), text);
    }
    while (folder.entries() < 2) std::this_thread::yield();
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
        EXPECT_EQ(fs::file_size(entry.path()), 20'000'000u) << entry.path();
    }
}

TEST(WholeFile, aFullDiskLeavesOnlyTheOldFile) {
    const TemporaryFolder folder;
    const fs::path disk = folder.path() / "disk";
    fs::create_directory(disk);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0)
        GTEST_SKIP() << "cannot mount a small disk: " << std::strerror(errno);
    write(disk / "a", "old");
    const std::string text = failureOf(disk / "a", std::string(200'000, 'n'));
    const std::string kept = read(disk / "a");
    const auto entries = std::distance(fs::directory_iterator(disk), fs::directory_iterator());
    ::umount(disk.c_str());
    EXPECT_TRUE(contains(text, std::strerror(ENOSPC))) << text;
    EXPECT_EQ(kept, "old");
    EXPECT_EQ(entries, 1);
}

TEST(WholeFile, aFullDeviceIsAnErrorAndStaysADevice) {
    EXPECT_TRUE(contains(failureOf("/dev/full"), std::strerror(ENOSPC)));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_NO_THROW(write("/dev/null", "gone"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WholeFile, aPipeIsWrittenInPlace) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = read(path); });
    write(path, "through the pipe");
    reader.join();
    EXPECT_EQ(received, "through the pipe");
    EXPECT_TRUE(fs::is_fifo(path));
}

TEST(WholeFile, anOpenDescriptorIsAppendedTo) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "log";
    write(path, "before ");
    std::FILE* file = std::fopen(path.c_str(), "a");
    ASSERT_NE(file, nullptr);
    write("/dev/fd/" + std::to_string(::fileno(file)), "after");
    std::fclose(file);
    EXPECT_EQ(read(path), "before after");
    EXPECT_EQ(folder.entries(), 1);
}

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

TEST(WholeFile, isWrittenPieceByPieceAndThereAtItsEnd) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a";
    write(path, "before");
    WholeFile file(path);
    file.write(bytesOf("some "));
    file.write(bytesOf("pieces"));
    file.writeAt(0, bytesOf("more"));
    file.writeAt(9, bytesOf("es longer"));
    EXPECT_EQ(file.size(), 18u);
    EXPECT_THROW(file.writeAt(19, bytesOf("x")), Error);
    EXPECT_EQ(read(path), "before");
    file.finish();
    EXPECT_EQ(read(path), "more pieces longer");
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_THROW(file.write(bytesOf("x")), Error);
    EXPECT_THROW(file.finish(), Error);
    WholeFile dropped(path);
    dropped.write(bytesOf("nothing of this"));
    dropped = WholeFile(folder.path() / "b");
    EXPECT_EQ(read(path), "more pieces longer");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WholeFile, piecesGoIntoAPipeAndADescriptorAtTheEnd) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "pipe";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    // More than is copied at once.
    const std::string text = std::string(3'000'000, 'a') + "end";
    std::string received;
    std::thread reader([&] { received = read(path); });
    WholeFile file(path);
    file.write(bytesOf(text));
    file.writeAt(1, bytesOf("b"));
    file.finish();
    reader.join();
    EXPECT_EQ(received.size(), text.size());
    EXPECT_EQ(received.substr(0, 3), "aba");
    EXPECT_EQ(received.substr(3'000'000), "end");
    std::FILE* log = std::fopen((folder.path() / "log").c_str(), "a");
    ASSERT_NE(log, nullptr);
    WholeFile appended(::fileno(log), "the log");
    EXPECT_EQ(appended.name(), "the log");
    appended.write(bytesOf("once"));
    EXPECT_EQ(read(folder.path() / "log"), "");
    appended.finish();
    EXPECT_EQ(read(folder.path() / "log"), "once");
    std::fclose(log);
}

}  // namespace
}  // namespace candela
