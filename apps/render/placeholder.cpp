#include "placeholder.h"

#include <candela/error.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path) {
    throw candela::Error(candela::ErrorKind::environment, path.string(),
                         "can not create the placeholder: " + std::generic_category().message(errno));
}

enum class Lock { taken, ofAnother, unsupported };

Lock tryLock(int descriptor) {
    struct flock whole {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (fcntl(descriptor, F_OFD_SETLK, &whole) == 0) return Lock::taken;
    return errno == EAGAIN || errno == EACCES ? Lock::ofAnother : Lock::unsupported;
}

/// Whether the open file is still the one of that name: its owner may have deleted it before it was locked.
bool isStillThere(int descriptor, const fs::path& path) {
    struct stat open {
    }, named{};
    return fstat(descriptor, &open) == 0 && stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

/// Says whose it is, for people.
void writeOwner(int descriptor) {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    const std::string text =
        std::string("drawn on ") + host.data() + " by process " + std::to_string(getpid()) + "\n";
    // What can not be written is missing from a text that no program reads.
    if (ftruncate(descriptor, 0) != 0) return;
    [[maybe_unused]] const ssize_t written = write(descriptor, text.data(), text.size());
}

}  // namespace

std::optional<Placeholder> Placeholder::take(const fs::path& picture) {
    fs::path path = picture;
    path += ".lock";
    while (true) {
        bool isNew = true;
        int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor < 0 && errno == EEXIST) {
            isNew = false;
            descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC);
            if (descriptor < 0 && errno == ENOENT) continue;  // Deleted meanwhile.
        }
        if (descriptor < 0) fail(path);
        Placeholder placeholder(path, descriptor);
        const Lock lock = tryLock(descriptor);
        if (lock == Lock::taken && !isStillThere(descriptor, path)) {
            placeholder.path_.clear();
            continue;
        }
        if (lock == Lock::taken || (lock == Lock::unsupported && isNew)) {
            writeOwner(descriptor);
            return placeholder;
        }
        placeholder.path_.clear();
        return std::nullopt;
    }
}

Placeholder::Placeholder(fs::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

Placeholder::Placeholder(Placeholder&& other) noexcept
    : path_(std::exchange(other.path_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}

Placeholder::~Placeholder() {
    if (!path_.empty()) unlink(path_.c_str());
    if (descriptor_ >= 0) close(descriptor_);
}
