#include "picture_file.h"

#include "common/output_file.h"

#include <candela/error.h>

#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace {

template <typename Value>
std::size_t bytesOf(const std::vector<Value>& values) {
    return values.size() * sizeof(Value);
}

void writeAll(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0)
            throw candela::Error(candela::ErrorKind::environment, "standard output",
                                 "cannot be written: " + std::generic_category().message(errno));
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

}  // namespace

std::size_t DrawnPicture::bytes() const {
    std::size_t sum = bytesOf(rgba) + bytesOf(radiance.rgba);
    for (const candela::Aov& aov : aovs)
        for (const std::vector<float>& values : aov.values) sum += bytesOf(values);
    return sum;
}

std::vector<std::byte> encodePicture(const std::string& name, DrawnPicture picture, PictureFormat format,
                                     const EncodingOptions& options) {
    if (format == PictureFormat::exr)
        return encodeRadiance(name, picture.radiance, picture.aovs, picture.chromaticities,
                              picture.attributes, {options.pixels, options.exr});
    makeOpaque(picture.rgba);
    if (format == PictureFormat::rgba8) {
        const auto bytes = std::as_bytes(std::span(picture.rgba));
        return {bytes.begin(), bytes.end()};
    }
    return candela::encodePng(name, static_cast<std::uint32_t>(picture.width),
                              static_cast<std::uint32_t>(picture.height), picture.rgba, picture.encoding,
                              options.png);
}

void OrderedOutput::write(std::uint64_t index, std::span<const std::byte> bytes) {
    write(index, [&] { writeAll(STDOUT_FILENO, bytes); });
}

void OrderedOutput::write(std::uint64_t index, const std::function<void()>& writing) {
    std::unique_lock lock(mutex_);
    turned_.wait(lock, [&] { return turn_ == index; });
    ++turn_;
    turned_.notify_all();
    writing();
}

void OrderedOutput::leaveOut(std::uint64_t index) {
    write(index, std::span<const std::byte>());
}
