#include <candela/whole_file.h>

#include <candela/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

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

/// Bytes that are copied at once.
constexpr std::size_t copiedBytes = std::size_t{1} << 20;

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

/// Writes all bytes from `position` on; false, with errno set, if that failed.
bool writeAllAt(int descriptor, std::uint64_t position, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written =
            ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(position));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes = bytes.subspan(std::size_t(written));
        position += std::size_t(written);
    }
    return true;
}

/// Writes all that `from` holds; false, with errno set, if that failed.
bool copyAll(int from, int to) {
    std::vector<std::byte> bytes(copiedBytes);
    for (std::uint64_t position = 0;;) {
        const ssize_t read = ::pread(from, bytes.data(), bytes.size(), static_cast<off_t>(position));
        if (read < 0 && errno == EINTR) continue;
        if (read <= 0) return read == 0;
        if (!writeAll(to, std::span(bytes).first(std::size_t(read)))) return false;
        position += std::size_t(read);
    }
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
        descriptor_ = Descriptor(::open(folder.c_str(), O_RDWR | O_TMPFILE | O_CLOEXEC, 0666));
        if (descriptor_.isOpen()) return;
        const bool named = tryNames([&](const fs::path& name) {
            descriptor_ = Descriptor(::open(name.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
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

    void writeAt(std::uint64_t position, std::span<const std::byte> bytes) {
        if (!writeAllAt(descriptor_.number(), position, bytes))
            failWithReason(target_, "can not write the file", errno);
    }

    int descriptor() const { return descriptor_.number(); }

    void moveTo(const fs::path& place) {
        if (!synchronise(descriptor_.number())) failWithReason(target_, "can not write the file", errno);
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
Descriptor openInPlace(const fs::path& path) {
    Descriptor descriptor(::open(path.c_str(), O_WRONLY | O_APPEND | O_NOCTTY | O_CLOEXEC));
    if (!descriptor.isOpen()) failWithReason(path, "can not open the file for writing", errno);
    return descriptor;
}

void writeInPlace(const fs::path& path, std::span<const std::byte> bytes) {
    Descriptor descriptor = openInPlace(path);
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

/// Where a file goes.
struct Target {
    fs::path path;                    ///< What errors name.
    fs::path place;                   ///< After all links.
    bool isSpecial = false;           ///< No ordinary file: it is written in place.
    std::optional<mode_t> mode = {};  ///< Of the file that is replaced.
    fs::path folder = {};
};

Target targetOf(const fs::path& path) {
    if (path.empty()) fail(path, "a file to write has no name");
    const std::optional<fs::path> place = followLinks(path);
    if (!place) return {path, path, true};
    struct stat status {};
    const bool exists = ::stat(place->c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(path, "is a folder, expected a file to write");
    if (exists && !S_ISREG(status.st_mode)) return {path, *place, true};
    Target target{path, *place, false, std::nullopt, folderOf(path, *place)};
    if (!exists) return target;
    // Renaming would replace a file that is protected against writing.
    if (::faccessat(AT_FDCWD, place->c_str(), W_OK, AT_EACCESS) != 0)
        failWithReason(path, "can not overwrite the file", errno);
    target.mode = status.st_mode & 0777;
    return target;
}

fs::path temporaryFolder(const fs::path& target) {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    if (error) failWithReason(target, "there is no folder for temporary files", error.value());
    return folder;
}

}  // namespace

void writeWholeFile(const fs::path& path, std::span<const std::byte> bytes) {
    const Target target = targetOf(path);
    const FileSizeSignalBlock block;
    if (target.isSpecial) return writeInPlace(target.place, bytes);
    TemporaryFile file(target.folder, path);
    if (target.mode) file.setPermissions(*target.mode);
    file.writeAt(0, bytes);
    file.moveTo(target.place);
}

struct WholeFile::State {
    State(Target to, const fs::path& folder)
        : target(std::move(to)), name(target.path.string()), file(folder, target.path) {}

    Target target;
    std::string name;
    int descriptor = -1;  ///< Of the caller, where the file has no path.
    TemporaryFile file;
    std::uint64_t size = 0;
};

WholeFile::WholeFile(const fs::path& path) {
    Target target = targetOf(path);
    const fs::path folder = target.isSpecial ? temporaryFolder(path) : target.folder;
    state_ = std::make_unique<State>(std::move(target), folder);
    if (state_->target.mode) state_->file.setPermissions(*state_->target.mode);
}

WholeFile::WholeFile(int descriptor, const std::string& name)
    : state_(std::make_unique<State>(Target{name, name, true}, temporaryFolder(name))) {
    state_->descriptor = descriptor;
}

WholeFile::WholeFile(WholeFile&&) noexcept = default;
WholeFile& WholeFile::operator=(WholeFile&&) noexcept = default;
WholeFile::~WholeFile() = default;

WholeFile::State& WholeFile::open() const {
    if (state_) return *state_;
    throw Error(ErrorKind::badInput, "", "a file is written to that is finished already, or was moved from");
}

void WholeFile::write(std::span<const std::byte> bytes) {
    writeAt(size(), bytes);
}

void WholeFile::writeAt(std::uint64_t position, std::span<const std::byte> bytes) {
    State& state = open();
    if (position > state.size)
        throw Error(ErrorKind::badInput, state.name,
                    "byte " + std::to_string(position) + " is written where the file has " +
                        std::to_string(state.size));
    const FileSizeSignalBlock block;
    state.file.writeAt(position, bytes);
    state.size = std::max(state.size, position + bytes.size());
}

void WholeFile::finish() {
    State& state = open();
    const FileSizeSignalBlock block;
    if (!state.target.isSpecial) {
        state.file.moveTo(state.target.place);
    } else {
        Descriptor opened;
        if (state.descriptor < 0) opened = openInPlace(state.target.place);
        const int to = opened.isOpen() ? opened.number() : state.descriptor;
        if (!copyAll(state.file.descriptor(), to) || (opened.isOpen() && !opened.close()))
            failWithReason(state.target.path, "can not write the file", errno);
    }
    state_.reset();
}

std::uint64_t WholeFile::size() const {
    return open().size;
}

const std::string& WholeFile::name() const {
    return open().name;
}

}  // namespace candela
