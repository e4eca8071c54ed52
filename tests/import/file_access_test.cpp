// What a plugin may read: only regular files in the scene's folder and its subfolders.
#include "import/file_access.h"

#include "expect_error.h"
#include "note_lines.h"
#include "temporary_folder.h"

#include <candela/import.h>

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

// The fixture importer reads each path of a .list file, and notes its size.
class FilePolicy : public testing::Test {
  protected:
    FilePolicy() {
        folder.write("outside.txt", "secret");
        folder.write("scene/inside.txt", "12345");
        folder.write("scene/deep/er/file.txt", "123");
        folder.write("scene-beside/file.txt", "beside");
    }

    Lines read(const std::string& path) {
        const fs::path scene = folder.write("scene/scene.list", path + "\n");
        return noteLines(importScene(plugins, scene.string()));
    }

    void expectRefused(const std::string& path, ErrorKind kind, const std::string& part) {
        const std::string text = expectError([&] { read(path); }, kind, part);
        EXPECT_NE(text.find((folder.path() / "scene" / "scene.list").string()), std::string::npos) << text;
        EXPECT_NE(text.find("file '" + path + "'"), std::string::npos) << text;
    }

    const PluginRegistry plugins{{fs::path(CANDELA_TEST_FIXTURES) / "importers"}};
    TemporaryFolder folder;
};

TEST_F(FilePolicy, FilesInTheFolderAreRead) {
    EXPECT_EQ(read("inside.txt"), Lines{"inside.txt: 5"});
    EXPECT_EQ(read("deep/er/file.txt"), Lines{"deep/er/file.txt: 3"});
    EXPECT_EQ(read("./deep//er/../../inside.txt"), Lines{"./deep//er/../../inside.txt: 5"});
}

TEST_F(FilePolicy, AFileMayBeReadTwice) {
    EXPECT_EQ(read("inside.txt\ninside.txt"), Lines{"inside.txt: 5 (2 times)"});
}

TEST_F(FilePolicy, AnOptionalFileMayBeAbsent) {
    EXPECT_EQ(read("?inside.txt\n?gone.txt\n?../outside.txt"),
              (Lines{"inside.txt: 5", "gone.txt: file 'gone.txt': No such file or directory",
                     "../outside.txt: file '../outside.txt': it leads out of the scene's folder"}));
    EXPECT_EQ(read("?"), Lines{"file '': the path is empty"});
}

TEST_F(FilePolicy, ALinkOutToNothingLeadsOut) {
    fs::create_symlink("../nowhere.txt", folder.path() / "scene" / "relative");
    fs::create_symlink("/nowhere/at/all", folder.path() / "scene" / "absolute");
    fs::create_symlink("gone.txt", folder.path() / "scene" / "inside");
    for (const char* link : {"relative", "absolute", "absolute/file.txt"})
        expectRefused(link, ErrorKind::badInput, "a symbolic link leads out of the scene's folder");
    expectRefused("inside", ErrorKind::environment, "No such file");
}

TEST_F(FilePolicy, AnEmptyFileIsRead) {
    folder.write("scene/empty", "");
    EXPECT_EQ(read("empty"), Lines{"empty: 0"});
}

// Such a file is read in parts.
TEST_F(FilePolicy, LargeFilesAreRead) {
    std::string content(std::size_t{37} << 20, '\0');
    for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * 2654435761u >> 13);
    folder.write("large.bin", content);
    FileAccess files(folder.path());
    const std::span<const std::byte> bytes = files.read("large.bin");
    ASSERT_EQ(bytes.size(), content.size());
    EXPECT_EQ(std::memcmp(bytes.data(), content.data(), content.size()), 0);
}

TEST_F(FilePolicy, AbsolutePath) {
    expectRefused((folder.path() / "scene" / "inside.txt").string(), ErrorKind::badInput,
                  "absolute paths are refused");
}

TEST_F(FilePolicy, DotsThatLeaveTheFolder) {
    expectRefused("../outside.txt", ErrorKind::badInput, "it leads out of the scene's folder");
    expectRefused("deep/../../outside.txt", ErrorKind::badInput, "it leads out of the scene's folder");
    expectRefused("../scene/inside.txt", ErrorKind::badInput, "it leads out of the scene's folder");
}

TEST_F(FilePolicy, LinkWithinTheFolder) {
    fs::create_symlink("deep/er/file.txt", folder.path() / "scene" / "link");
    EXPECT_EQ(read("link"), Lines{"link: 3"});
}

TEST_F(FilePolicy, LinkOutOfTheFolder) {
    fs::create_symlink("../outside.txt", folder.path() / "scene" / "link");
    expectRefused("link", ErrorKind::badInput, "a symbolic link leads out of the scene's folder");
    fs::create_directory_symlink(folder.path(), folder.path() / "scene" / "up");
    expectRefused("up/outside.txt", ErrorKind::badInput, "a symbolic link leads out of the scene's folder");
}

// "scene-beside" begins with "scene", but is not in that folder.
TEST_F(FilePolicy, LinkToAFolderWithTheSamePrefix) {
    fs::create_symlink("../scene-beside/file.txt", folder.path() / "scene" / "link");
    expectRefused("link", ErrorKind::badInput, "a symbolic link leads out of the scene's folder");
}

// ".." after a link is relative to the link's target: the path stays in the folder as text, but the file is
// outside.
TEST_F(FilePolicy, DotsAfterALink) {
    fs::create_directories(folder.path() / "away" / "below");
    folder.write("away/file.txt", "away");
    fs::create_directory_symlink(folder.path() / "away" / "below", folder.path() / "scene" / "down");
    expectRefused("down/../file.txt", ErrorKind::badInput, "a symbolic link leads out of the scene's folder");
}

TEST_F(FilePolicy, CircularLink) {
    fs::create_symlink("circle", folder.path() / "scene" / "circle");
    expectRefused("circle", ErrorKind::environment, "symbolic links");
}

// Opening a pipe without a writer would block.
TEST_F(FilePolicy, Pipe) {
    ASSERT_EQ(::mkfifo((folder.path() / "scene" / "pipe").c_str(), 0600), 0);
    expectRefused("pipe", ErrorKind::badInput, "it is not a regular file");
}

TEST_F(FilePolicy, Folder) {
    expectRefused("deep", ErrorKind::badInput, "it is a folder");
    expectRefused(".", ErrorKind::badInput, "it is a folder");
}

TEST_F(FilePolicy, MissingFile) {
    expectRefused("missing.bin", ErrorKind::environment, "No such file or directory");
}

TEST_F(FilePolicy, FileWithoutPermission) {
    if (::geteuid() == 0) GTEST_SKIP() << "the superuser may read all files";
    const fs::path file = folder.write("scene/locked", "locked");
    fs::permissions(file, fs::perms::none);
    expectRefused("locked", ErrorKind::environment, "Permission denied");
}

TEST_F(FilePolicy, FileBeyondTheSizeLimit) {
    const fs::path file = folder.write("scene/giant", "");
    std::error_code error;
    fs::resize_file(file, std::uintmax_t{17} << 30, error);
    if (error)
        GTEST_SKIP() << "the file system of the temporary folder does not support sparse files of 17 GiB";
    expectRefused("giant", ErrorKind::limit, "more than the 16 GiB allowed");
}

TEST_F(FilePolicy, EmptyPath) {
    expectRefused("", ErrorKind::badInput, "the path is empty");
}

TEST_F(FilePolicy, PathTooLongForTheSystem) {
    const std::string path(5000, 'a');
    expectError([&] { read(path); }, ErrorKind::environment, "File name too long");
}

// The scene file may be a link; other files are then relative to its target.
TEST_F(FilePolicy, SceneFileThatIsALink) {
    folder.write("scene/scene.list", "inside.txt\n");
    const fs::path link = folder.path() / "link.list";
    fs::create_symlink(folder.path() / "scene" / "scene.list", link);
    EXPECT_EQ(noteLines(importScene(plugins, link.string())), Lines{"inside.txt: 5"});
}

TEST_F(FilePolicy, AnOptionalFileIsFoundInAnotherCase) {
    const std::string note = "': read, though its name differs in upper and lower case";
    EXPECT_EQ(read("?DEEP/er/File.TXT"), (Lines{"file 'DEEP/er/File.TXT" + note, "DEEP/er/File.TXT: 3"}));
    // The very name first, and else the first one by bytes.
    folder.write("scene/a.PNG", "1");
    folder.write("scene/a.png", "22");
    folder.write("scene/A.png", "333");
    EXPECT_EQ(read("?a.png"), Lines{"a.png: 2"});
    EXPECT_EQ(read("?A.PNG").at(1), "A.PNG: 3");
    EXPECT_EQ(read("?missing.PNG").at(0), "missing.PNG: file 'missing.PNG': No such file or directory");
}

TEST_F(FilePolicy, NoNameOutsideTheFolderIsTriedInAnotherCase) {
    fs::create_directory_symlink(folder.path(), folder.path() / "scene" / "up");
    EXPECT_EQ(read("?up/OUTSIDE.txt").size(), 1u);
    EXPECT_EQ(read("?../OUTSIDE.txt").at(0),
              "../OUTSIDE.txt: file '../OUTSIDE.txt': it leads out of the scene's folder");
    fs::create_symlink("../outside.txt", folder.path() / "scene" / "link");
    EXPECT_EQ(read("?LINK").at(0), "LINK: file 'link': a symbolic link leads out of the scene's folder");
}

}  // namespace
}  // namespace candela
