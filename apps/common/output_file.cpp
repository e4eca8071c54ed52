#include "output_file.h"

#include <candela/error.h>
#include <candela/whole_file.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <span>
#include <system_error>

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

constexpr std::array interrupts{SIGINT, SIGTERM, SIGHUP};

std::array<struct sigaction, interrupts.size()> previous;
volatile std::sig_atomic_t waiting = 0;

void remember(int signal) {
    waiting = signal;
}

/// While one lives, an interrupt (SIGINT, SIGTERM, SIGHUP) waits: a file that is being written is finished or
/// not there, and nothing is left beside it. The signal then takes effect at the end of the scope.
class DeferredSignals {
  public:
    DeferredSignals();
    DeferredSignals(const DeferredSignals&) = delete;
    DeferredSignals& operator=(const DeferredSignals&) = delete;
    ~DeferredSignals();
};

DeferredSignals::DeferredSignals() {
    waiting = 0;
    struct sigaction later {};
    later.sa_handler = remember;
    sigemptyset(&later.sa_mask);
    later.sa_flags = SA_RESTART;
    for (std::size_t i = 0; i < interrupts.size(); ++i) {
        sigaction(interrupts[i], nullptr, &previous[i]);
        // A signal that the parent process had ignored (nohup) stays ignored.
        if (previous[i].sa_handler != SIG_IGN) sigaction(interrupts[i], &later, nullptr);
    }
}

DeferredSignals::~DeferredSignals() {
    for (std::size_t i = 0; i < interrupts.size(); ++i) sigaction(interrupts[i], &previous[i], nullptr);
    if (waiting != 0) std::raise(waiting);
}

/// R, G, B and A as a plane each.
std::array<std::vector<float>, 4> splitPlanes(const std::vector<float>& rgba) {
    std::array<std::vector<float>, 4> planes;
    for (std::size_t channel = 0; channel < planes.size(); ++channel) {
        planes[channel].reserve(rgba.size() / 4);
        for (std::size_t i = channel; i < rgba.size(); i += 4) planes[channel].push_back(rgba[i]);
    }
    return planes;
}

/// Whether an AOV is a depth, a position, a way, a count or a number, for which 11 bits are not enough.
bool needsFloats(const std::string& aov) {
    constexpr std::array names{"Z",       "P",           "light_count", "shadowed_count",
                               "node_id", "material_id", "instance_id", "motion"};
    return std::ranges::find(names, aov) != names.end();
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
    const DeferredSignals deferred;
    candela::writeWholeFile(path, std::as_bytes(std::span(text)));
}

void makeOpaque(std::vector<std::uint8_t>& rgba) {
    for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
}

void writeDisplayedFrame(const std::filesystem::path& path, int width, int height,
                         std::vector<std::uint8_t> rgba, const candela::DisplayTransform& display) {
    makeOpaque(rgba);
    const DeferredSignals deferred;
    candela::writePng(path, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), rgba,
                      display.encoding());
}

std::vector<candela::ExrChannelType> radianceChannels(const std::vector<candela::Aov>& aovs,
                                                      candela::ExrPixelType pixels) {
    std::vector<candela::ExrChannelType> channels;
    for (const char* name : {"R", "G", "B", "A"}) channels.push_back({name, pixels});
    for (const candela::Aov& aov : aovs) {
        const auto type = needsFloats(aov.name) ? candela::ExrPixelType::float32 : pixels;
        for (const std::string& name : aov.channels) channels.push_back({name, type});
    }
    return channels;
}

RadiancePlanes::RadiancePlanes(const candela::HdrImage& radiance, const std::vector<candela::Aov>& aovs)
    : planes_(splitPlanes(radiance.rgba)) {
    for (const std::vector<float>& plane : planes_) values_.emplace_back(plane);
    for (const candela::Aov& aov : aovs)
        for (const std::vector<float>& values : aov.values) values_.emplace_back(values);
}

std::vector<std::byte> encodeRadiance(const std::string& name, const candela::HdrImage& radiance,
                                      const std::vector<candela::Aov>& aovs,
                                      const candela::Chromaticities& chromaticities,
                                      const std::vector<candela::ExrAttribute>& attributes,
                                      const RadianceEncoding& encoding) {
    const std::vector<candela::ExrChannelType> types = radianceChannels(aovs, encoding.pixels);
    const RadiancePlanes planes(radiance, aovs);
    std::vector<candela::ExrChannel> channels;
    for (std::size_t i = 0; i < types.size(); ++i)
        channels.push_back({types[i].name, planes.values()[i], types[i].type});
    return candela::encodeExr(name, static_cast<std::uint32_t>(radiance.width),
                              static_cast<std::uint32_t>(radiance.height), channels, chromaticities,
                              attributes, encoding.exr);
}

void writeRadiance(const std::filesystem::path& path, const candela::HdrImage& radiance,
                   const std::vector<candela::Aov>& aovs, const candela::ColorConfig& color,
                   const std::vector<candela::ExrAttribute>& attributes) {
    const std::vector<std::byte> bytes =
        encodeRadiance(path.string(), radiance, aovs, color.chromaticities(), attributes);
    const DeferredSignals deferred;
    candela::writeWholeFile(path, bytes);
}
