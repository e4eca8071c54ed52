#include "shader_watch.h"

#include <candela/error.h>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace {

/// An editor saves a file in several steps; what follows within this time belongs to the same change.
constexpr int settlingMilliseconds = 50;

}  // namespace

ShaderWatch::ShaderWatch(void (*wake)()) : wake_(wake) {
    const char* folder = std::getenv("CANDELA_SHADER_DIR");
    if (!folder || !*folder) return;
    events_ = inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    stop_ = eventfd(0, EFD_CLOEXEC);
    add(folder);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_directory()) add(entry.path());
    thread_ = std::thread([this] { wait(); });
}

ShaderWatch::~ShaderWatch() {
    if (thread_.joinable()) {
        eventfd_write(stop_, 1);
        thread_.join();
    }
    if (events_ >= 0) close(events_);
    if (stop_ >= 0) close(stop_);
}

void ShaderWatch::add(const std::filesystem::path& folder) {
    constexpr std::uint32_t changes = IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_CREATE | IN_DELETE;
    if (inotify_add_watch(events_, folder.c_str(), changes) >= 0) return;
    throw candela::Error(
        candela::ErrorKind::environment, folder.string(),
        std::string("the folder of CANDELA_SHADER_DIR can not be watched: ") + std::strerror(errno));
}

void ShaderWatch::wait() {
    std::array<pollfd, 2> sources{{{events_, POLLIN, 0}, {stop_, POLLIN, 0}}};
    std::array<char, 4096> buffer;
    bool pending = false;
    for (;;) {
        const int ready = poll(sources.data(), sources.size(), pending ? settlingMilliseconds : -1);
        if (sources[1].revents) return;
        if (ready > 0) {
            while (read(events_, buffer.data(), buffer.size()) > 0) {
            }
            pending = true;
        } else if (ready == 0) {
            pending = false;
            changed_ = true;
            wake_();
        }
    }
}
