#include "image.h"

#include <algorithm>

#include "parallel.h"

namespace candela_plugins {
namespace {

// The images of a batch are in memory together.
constexpr std::uint64_t maxBatchBytes = std::uint64_t{256} << 20;

std::int32_t addImage(const std::string& name, const Image& image, const Host& host) {
    candela_image source{};
    source.struct_size = sizeof source;
    source.name = name.c_str();
    source.width = image.width;
    source.height = image.height;
    source.format = image.sampleSize == SampleSize::bits16 ? CANDELA_PIXELS_RGBA16 : CANDELA_PIXELS_RGBA8;
    source.pixels = image.pixels.data();
    source.pixels_size = image.pixels.size();
    return host.add(source);
}

// The end of the batch that begins at `first`: one job, and more as long as they fit.
std::size_t batchEnd(const std::vector<ImageJob>& jobs, std::size_t first) {
    std::uint64_t bytes = jobs[first].bytes;
    std::size_t end = first + 1;
    while (end < jobs.size() && jobs[end].bytes <= maxBatchBytes - std::min(bytes, maxBatchBytes)) {
        bytes += jobs[end].bytes;
        ++end;
    }
    return end;
}

}  // namespace

Image decodeImage(const Bytes& file, const std::string& element) {
    if (isPng(file)) return decodePng(file, element);
    if (isJpeg(file)) return decodeJpeg(file, element);
    throw Failure{element, "is neither a PNG nor a JPEG file"};
}

std::uint64_t decodedSize(const Bytes& file) {
    if (isPng(file)) return decodedPngSize(file);
    return isJpeg(file) ? decodedJpegSize(file) : 0;
}

std::vector<std::int32_t> addImages(const std::vector<ImageJob>& jobs, const Host& host, double from,
                                    double to) {
    std::vector<std::int32_t> indices;
    for (std::size_t first = 0; first < jobs.size();) {
        const std::size_t end = batchEnd(jobs, first);
        std::vector<Image> images(end - first);
        host.progress(from + (to - from) * static_cast<double>(first) / static_cast<double>(jobs.size()));
        host.parallelFor(images.size(), [&](std::size_t i) { images[i] = jobs[first + i].make(); });
        for (std::size_t i = 0; i < images.size(); ++i) {
            indices.push_back(addImage(jobs[first + i].name, images[i], host));
            images[i] = {};
        }
        first = end;
    }
    return indices;
}

}  // namespace candela_plugins
