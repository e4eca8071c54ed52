#include "import/file_access.h"

#include "base/large_pages.h"
#include "base/thread_pool.h"
#include "import/text.h"

#include <candela/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

namespace candela {
namespace fs = std::filesystem;
namespace {

// glTF's binary container ends at 4 GiB. The limit protects memory from huge sparse files.
constexpr std::int64_t maxFileBytes = std::int64_t{16} << 30;

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    int number() const { return number_; }

  private:
    int number_;
};

std::string systemMessage(int error) {
    return std::generic_category().message(error);
}

[[noreturn]] void refuse(ErrorKind kind, const std::string& path, const std::string& text) {
    throw Error(kind, "", joined("file '", oneLine(path), "': ", text));
}

[[noreturn]] void refuseLink(const std::string& path) {
    refuse(ErrorKind::badInput, path, "a symbolic link leads out of the scene's folder");
}

// Checks the text of the path alone, for the clearest message. Links are checked on the opened file.
void checkText(const std::string& path) {
    if (path.empty()) refuse(ErrorKind::badInput, path, "the path is empty");
    if (path.front() == '/')
        refuse(ErrorKind::badInput, path,
               "absolute paths are refused; it must be relative to the scene's folder");
    int depth = 0;
    std::istringstream parts(path);
    for (std::string part; std::getline(parts, part, '/');) {
        if (part.empty() || part == ".") continue;
        depth += part == ".." ? -1 : 1;
        if (depth < 0) refuse(ErrorKind::badInput, path, "it leads out of the scene's folder");
    }
}

std::string openedPath(int descriptor) {
    return fs::read_symlink(joined("/proc/self/fd/", descriptor)).string();
}

bool liesWithin(const std::string& file, const std::string& folder) {
    const std::string prefix = folder.ends_with('/') ? folder : folder + '/';
    return file == folder || file.starts_with(prefix);
}

void readAt(int descriptor, std::uint64_t offset, std::span<std::byte> into, const std::string& path) {
    for (std::size_t done = 0; done < into.size();) {
        const ssize_t count =
            ::pread(descriptor, into.data() + done, into.size() - done, static_cast<off_t>(offset + done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) refuse(ErrorKind::environment, path, "reading failed: " + systemMessage(errno));
        if (count == 0) refuse(ErrorKind::environment, path, "it became shorter while it was read");
        done += static_cast<std::size_t>(count);
    }
}

// Parts are copied from the system's cache on all cores.
FileAccess::Bytes readAll(int descriptor, std::size_t size, const std::string& path) {
    FileAccess::Bytes bytes{std::make_unique_for_overwrite<std::byte[]>(size), size};
    requestLargePages(bytes.data.get(), size);
    constexpr std::size_t part = std::size_t{16} << 20;
    ThreadPool::shared()->run((size + part - 1) / part, [&](std::size_t i, unsigned) {
        const std::size_t offset = i * part;
        readAt(descriptor, offset, {bytes.data.get() + offset, std::min(part, size - offset)}, path);
    });
    return bytes;
}

// Where a link leads out of the folder, that is the reason, and not that there is nothing at its end.
[[noreturn]] void refuseAbsent(int folder, const std::string& path, int error) {
    const fs::path root = openedPath(folder);
    fs::path walked = root;
    std::error_code ignored;
    for (const fs::path& part : fs::path(path)) {
        walked /= part;
        if (!fs::is_symlink(walked, ignored)) continue;
        const fs::path target = (walked.parent_path() / fs::read_symlink(walked, ignored)).lexically_normal();
        if (!liesWithin(target.string(), root.string())) refuseLink(path);
        walked = target;
    }
    refuse(ErrorKind::environment, path, systemMessage(error));
}

// A regular file within the folder, open for reading.
struct OpenedFile {
    Descriptor descriptor;
    std::int64_t size;
};

// The file is first opened without reading (O_PATH), which touches no device and waits for no pipe. Its path
// and type are checked, and the same file is then opened for reading, so that it cannot be replaced in
// between.
OpenedFile openWithin(int folder, const std::string& path) {
    const Descriptor named(::openat(folder, path.c_str(), O_PATH | O_CLOEXEC));
    if (named.number() < 0) refuseAbsent(folder, path, errno);
    if (!liesWithin(openedPath(named.number()), openedPath(folder))) refuseLink(path);
    struct stat status {};
    if (::fstat(named.number(), &status) != 0) refuse(ErrorKind::environment, path, systemMessage(errno));
    if (S_ISDIR(status.st_mode)) refuse(ErrorKind::badInput, path, "it is a folder, but a file was expected");
    if (!S_ISREG(status.st_mode)) refuse(ErrorKind::badInput, path, "it is not a regular file");
    const std::string again = joined("/proc/self/fd/", named.number());
    OpenedFile file{Descriptor(::open(again.c_str(), O_RDONLY | O_CLOEXEC)), status.st_size};
    if (file.descriptor.number() < 0) refuse(ErrorKind::environment, path, systemMessage(errno));
    return file;
}

FileAccess::Bytes readWithin(int folder, const std::string& path) {
    const OpenedFile file = openWithin(folder, path);
    if (file.size > maxFileBytes)
        refuse(ErrorKind::limit, path, joined("it has ", file.size, " bytes, more than the 16 GiB allowed"));
    return readAll(file.descriptor.number(), static_cast<std::size_t>(file.size), path);
}

// The first entry of the folder `at`, by bytes, whose name differs from `name` in the case of ASCII letters.
// Nothing where it lies outside of the scene's folder: its names are not read.
std::optional<std::string> entryInOtherCase(int at, int folder, const std::string& name) {
    if (!liesWithin(openedPath(at), openedPath(folder))) return std::nullopt;
    const std::string wanted = lowerCase(name);
    std::optional<std::string> found;
    std::error_code error;
    for (fs::directory_iterator entry(joined("/proc/self/fd/", at), error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string candidate = entry->path().filename().string();
        if (lowerCase(candidate) == wanted && (!found || candidate < *found)) found = candidate;
    }
    return found;
}

bool exists(int at, const std::string& name) {
    struct stat status {};
    return ::fstatat(at, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

}  // namespace

FileAccess::FileAccess(const fs::path& folder)
    : folder_(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC)) {
    if (folder_ < 0)
        throw Error(ErrorKind::environment, folder.string(),
                    "the folder can not be opened: " + systemMessage(errno));
}

FileAccess::~FileAccess() {
    ::close(folder_);
}

std::span<const std::byte> FileAccess::read(const std::string& path) {
    auto file = files_.find(path);
    if (file == files_.end()) {
        checkText(path);
        file = files_.emplace(path, readWithin(folder_, path)).first;
    }
    return {file->second.data.get(), file->second.size};
}

std::uint64_t FileAccess::size(const std::string& path) const {
    checkText(path);
    return static_cast<std::uint64_t>(openWithin(folder_, path).size);
}

void FileAccess::readPart(const std::string& path, std::uint64_t offset, std::span<std::byte> into) const {
    checkText(path);
    const OpenedFile file = openWithin(folder_, path);
    const auto size = static_cast<std::uint64_t>(file.size);
    if (offset > size || into.size() > size - offset)
        refuse(
            ErrorKind::badInput, path,
            joined("it has ", size, " bytes, but ", into.size(), " from byte ", offset, " on were expected"));
    readAt(file.descriptor.number(), offset, into, path);
}

std::string FileAccess::inAnyCase(const std::string& path) const {
    if (path.empty() || path.front() == '/' || exists(folder_, path)) return path;
    Descriptor at(::openat(folder_, ".", O_PATH | O_DIRECTORY | O_CLOEXEC));
    std::string found;
    std::istringstream parts(path);
    for (std::string part; std::getline(parts, part, '/');) {
        if (part.empty()) continue;
        if (at.number() < 0) return path;
        const auto name = exists(at.number(), part) ? part : entryInOtherCase(at.number(), folder_, part);
        if (!name) return path;
        found += found.empty() ? *name : '/' + *name;
        at = Descriptor(::openat(at.number(), name->c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    }
    return found;
}

}  // namespace candela
