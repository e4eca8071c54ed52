#include <candela/whole_file.h>

#include <candela/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace candela {
namespace {

namespace fs = std::filesystem;

/// The number of links that the kernel follows.
constexpr int maxLinks = 40;

/// The number of names tried for the temporary file, in case another process uses one.
constexpr int maxNames = 100;

[[noreturn]] void fail(const fs::path& path, const std::string& text) {
    throw Error(ErrorKind::environment, path.string(), text);
}

[[noreturn]] void failWithReason(const fs::path& path, const std::string& text, int reason) {
    fail(path, text + ": " + std::generic_category().message(reason));
}

/// An open file descriptor.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() {
        if (isOpen()) ::close(number_);
    }

    bool isOpen() const { return number_ >= 0; }
    int number() const { return number_; }
    /// Closes; false, with errno set, if that failed. File systems may report a full disk only here.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_ = -1;
};

/// Writes all bytes; false, with errno set, if that failed.
bool writeAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes = bytes.subspan(std::size_t(written));
    }
    return true;
}

/// Flushes the bytes to the disk; also true where the file system does not support it.
bool synchronise(int descriptor) {
    return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == ENOSYS;
}

/// Keeps SIGXFSZ, which a write beyond the process's limit of file sizes raises, from ending the process: the
/// write fails with EFBIG.
class FileSizeSignalBlock {
  public:
    FileSizeSignalBlock() {
        sigemptyset(&signal_);
        sigaddset(&signal_, SIGXFSZ);
        ::pthread_sigmask(SIG_BLOCK, &signal_, &before_);
    }
    FileSizeSignalBlock(const FileSizeSignalBlock&) = delete;
    FileSizeSignalBlock& operator=(const FileSizeSignalBlock&) = delete;
    ~FileSizeSignalBlock() {
        constexpr timespec noTime{};
        // Takes the signal that a write has raised before it is handled.
        if (sigismember(&before_, SIGXFSZ) == 0) ::sigtimedwait(&signal_, nullptr, &noTime);
        ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    sigset_t signal_{}, before_{};
};

/// A file without a name, which the kernel deletes with the process, until it is moved to its target. Where
/// the file system has no such files it has a name and is deleted at the end of its scope.
class TemporaryFile {
  public:
    /// Creates the file in `folder`. `target` is what errors name.
    TemporaryFile(const fs::path& folder, const fs::path& target) : target_(target), folder_(folder) {
        descriptor_ = Descriptor(::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666));
        if (descriptor_.isOpen()) return;
        const bool named = tryNames([&](const fs::path& name) {
            descriptor_ = Descriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
            return descriptor_.isOpen();
        });
        if (!named) failWithReason(target_, "can not write in the folder '" + folder.string() + "'", errno);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }

    void setPermissions(mode_t mode) {
        if (::fchmod(descriptor_.number(), mode) != 0)
            failWithReason(target_, "can not keep its mode", errno);
    }

    void write(std::span<const std::byte> bytes) {
        if (!writeAll(descriptor_.number(), bytes) || !synchronise(descriptor_.number()))
            failWithReason(target_, "can not write the file", errno);
    }

    void moveTo(const fs::path& place) {
        if (path_.empty() && link(place)) return close();
        // Only a file with a name can replace another.
        if (path_.empty() && !tryNames([&](const fs::path& name) { return link(name); }))
            failWithReason(target_, "can not put the written file in its place", errno);
        close();
        if (::rename(path_.c_str(), place.c_str()) != 0)
            failWithReason(target_, "can not put the written file in its place", errno);
        path_.clear();
    }

  private:
    /// Calls `create` with names until it succeeds, and keeps that name. False, with errno set, where it
    /// fails otherwise than by a file that is there.
    template <typename Create>
    bool tryNames(const Create& create) {
        static std::atomic<unsigned> count{0};
        for (int attempt = 0; attempt < maxNames; ++attempt) {
            const fs::path name =
                folder_ / (".candela-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
            if (create(name)) {
                path_ = name;
                return true;
            }
            if (errno != EEXIST) return false;
        }
        return false;
    }

    /// Gives the file a name that no other has; false, with errno set, if that failed.
    bool link(const fs::path& name) const {
        const std::string descriptor = "/proc/self/fd/" + std::to_string(descriptor_.number());
        return ::linkat(AT_FDCWD, descriptor.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    }

    void close() {
        if (!descriptor_.close()) failWithReason(target_, "can not write the file", errno);
    }

    fs::path target_, folder_;
    fs::path path_;  ///< Empty while it has no name.
    Descriptor descriptor_;
};

/// The target of a path after all links. None for an open descriptor of a process (/dev/stdout, /dev/fd/3),
/// which has no path that could be replaced.
std::optional<fs::path> followLinks(const fs::path& path) {
    fs::path place = path;
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links) {
        if (links == maxLinks) failWithReason(path, "can not follow the link", ELOOP);
        const fs::path folder = fs::canonical(place.parent_path().empty() ? "." : place.parent_path(), error);
        if (folder.string().starts_with("/proc/")) return std::nullopt;
        const fs::path next = fs::read_symlink(place, error);
        if (error) failWithReason(path, "can not follow the link", error.value());
        place = place.parent_path() / next;
    }
    return place;
}

/// Appends, so that a descriptor shared with others (`>> log`) is not overwritten.
void writeInPlace(const fs::path& path, std::span<const std::byte> bytes) {
    Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC));
    if (!descriptor.isOpen()) failWithReason(path, "can not open the file for writing", errno);
    if (!writeAll(descriptor.number(), bytes) || !descriptor.close())
        failWithReason(path, "can not write the file", errno);
}

/// The folder of `place`, which has to exist.
fs::path folderOf(const fs::path& path, const fs::path& place) {
    const fs::path folder = place.parent_path().empty() ? fs::path(".") : place.parent_path();
    struct stat status {};
    if (::stat(folder.c_str(), &status) != 0) {
        if (errno == ENOENT) fail(path, "the folder '" + folder.string() + "' does not exist");
        failWithReason(path, "can not write in the folder '" + folder.string() + "'", errno);
    }
    if (!S_ISDIR(status.st_mode)) fail(path, "'" + folder.string() + "' is not a folder");
    return folder;
}

}  // namespace

void writeWholeFile(const fs::path& path, std::span<const std::byte> bytes) {
    if (path.empty()) fail(path, "a file to write has no name");
    const FileSizeSignalBlock block;
    const std::optional<fs::path> place = followLinks(path);
    if (!place) return writeInPlace(path, bytes);

    struct stat status {};
    const bool exists = ::stat(place->c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(path, "is a folder, expected a file to write");
    if (exists && !S_ISREG(status.st_mode)) return writeInPlace(*place, bytes);
    const fs::path folder = folderOf(path, *place);
    // Renaming would replace a file that is protected against writing.
    if (exists && ::faccessat(AT_FDCWD, place->c_str(), W_OK, AT_EACCESS) != 0)
        failWithReason(path, "can not overwrite the file", errno);

    TemporaryFile file(folder, path);
    if (exists) file.setPermissions(status.st_mode & 0777);
    file.write(bytes);
    file.moveTo(*place);
}

}  // namespace candela
