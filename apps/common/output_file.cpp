#include "output_file.h"

#include "deferred_signals.h"

#include <candela/error.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

using candela::Error;
using candela::ErrorKind;

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& text) {
    throw Error(ErrorKind::environment, path.string(), text);
}

[[noreturn]] void failWithErrno(const std::filesystem::path& path, const std::string& doing) {
    fail(path, doing + ": " + std::strerror(errno));
}

std::filesystem::path folderOf(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

/// A device, a pipe and the like: there is nothing to put in its place.
bool isSpecial(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(path, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

/// An open file that closes with its scope.
class File {
  public:
    /// Opens `path`; what goes wrong is told about `shownPath`, the name that the user knows.
    File(const std::filesystem::path& path, int flags, const std::filesystem::path& shownPath)
        : shownPath_(shownPath), descriptor_(open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0666)) {
        if (descriptor_ < 0) failWithErrno(shownPath_, "cannot be opened for writing");
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }

    void write(const std::string& text) {
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t count = ::write(descriptor_, text.data() + done, text.size() - done);
            if (count < 0 && errno != EINTR) failWithErrno(shownPath_, "cannot be written");
            if (count > 0) done += static_cast<std::size_t>(count);
        }
    }
    /// Some file systems tell only now that the disk is full.
    void close() {
        if (::close(std::exchange(descriptor_, -1)) != 0) failWithErrno(shownPath_, "cannot be written");
    }

  private:
    std::filesystem::path shownPath_;
    int descriptor_;
};

void writeInto(const std::filesystem::path& path, int flags, const std::filesystem::path& shownPath,
               const std::string& text) {
    File file(path, flags, shownPath);
    file.write(text);
    file.close();
}

}  // namespace

void checkWritable(const std::filesystem::path& path) {
    std::error_code ignored;
    const std::filesystem::path folder = folderOf(path);
    if (!std::filesystem::exists(folder, ignored))
        fail(path, "the folder " + folder.string() + " does not exist");
    if (!std::filesystem::is_directory(folder, ignored)) fail(path, folder.string() + " is not a folder");
    if (std::filesystem::is_directory(path, ignored)) fail(path, "is a folder");
    if (isSpecial(path)) return;
    if (access(folder.c_str(), W_OK | X_OK) != 0)
        failWithErrno(path, "the folder " + folder.string() + " cannot be written to");
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    if (isSpecial(path)) return writeInto(path, 0, path, text);
    const DeferredSignals deferred;
    const std::filesystem::path partial = path.string() + "." + std::to_string(getpid()) + ".part";
    try {
        writeInto(partial, O_CREAT | O_TRUNC, path, text);
        if (rename(partial.c_str(), path.c_str()) != 0) failWithErrno(path, "cannot be written");
    } catch (const Error&) {
        unlink(partial.c_str());
        throw;
    }
}
