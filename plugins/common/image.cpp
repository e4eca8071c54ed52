#include "image.h"

#include <algorithm>
#include <optional>
#include <string_view>

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

/// How the files of other formats begin; "?" stands for any byte.
struct Signature {
    std::string_view bytes;
    const char* name;
};

using namespace std::string_view_literals;

constexpr Signature signatures[] = {
    {"\xABKTX 11\xBB"sv, "a KTX file"},
    {"GIF8"sv, "a GIF file"},
    {"BM????\0\0\0\0"sv, "a BMP file"},
    {"DDS "sv, "a DDS file"},
    {"#?RADIANCE"sv, "a Radiance HDR file"},
    {"#?RGBE"sv, "a Radiance HDR file"},
    {"????ftypavi"sv, "an AVIF file"},
    {"????ftyphei"sv, "a HEIC file"},
    {"II*\0"sv, "a TIFF file"},
    {"MM\0*"sv, "a TIFF file"},
    {"\x76\x2F\x31\x01"sv, "an OpenEXR file"},
    {"8BPS"sv, "a Photoshop file"},
    {"sB"sv, "a Basis Universal file"},
    {"\0\0\0\x0CjP  "sv, "a JPEG 2000 file"},
    {"\xFF\x0A"sv, "a JPEG XL file"},
    {"\0\0\0\x0CJXL "sv, "a JPEG XL file"},
    {"\0\0\1\0"sv, "an icon file"},
    {"<svg"sv, "an SVG file"},
    {"<?xml"sv, "an XML file"},
    {"<!DOCTYPE"sv, "an HTML page"},
    {"<html"sv, "an HTML page"},
    {"version https://git-lfs"sv, "a Git LFS pointer in place of the file"},
};

bool begins(const Bytes& file, std::string_view signature) {
    if (file.size < signature.size()) return false;
    for (std::size_t i = 0; i < signature.size(); ++i) {
        if (signature[i] != '?' && static_cast<std::uint8_t>(signature[i]) != file.data[i]) return false;
    }
    return true;
}

}  // namespace

std::string otherFormat(const Bytes& file) {
    const std::string expected = ", expected PNG, JPEG, WebP or KTX2";
    if (file.size == 0) return "an empty file" + expected;
    for (const Signature& signature : signatures) {
        if (begins(file, signature.bytes)) return signature.name + expected;
    }
    return "of no known format" + expected;
}

bool isKtx2(const Bytes& file) {
    return begins(file, "\xABKTX 20\xBB"sv);
}

Image decodeImage(const Bytes& file, const std::string& element) {
    if (isPng(file)) return decodePng(file, element);
    if (isJpeg(file)) return decodeJpeg(file, element);
    if (isWebp(file)) return decodeWebp(file, element);
    if (isKtx2(file)) return decodeKtx2(file, element);
    throw Failure{element, otherFormat(file)};
}

std::uint64_t decodedSize(const Bytes& file) {
    if (isPng(file)) return decodedPngSize(file);
    if (isJpeg(file)) return decodedJpegSize(file);
    if (isWebp(file)) return decodedWebpSize(file);
    return isKtx2(file) ? decodedKtx2Size(file) : 0;
}

std::vector<std::int32_t> addImages(const std::vector<ImageJob>& jobs, const Host& host, double from,
                                    double to) {
    std::vector<std::int32_t> indices;
    for (std::size_t first = 0; first < jobs.size();) {
        const std::size_t end = batchEnd(jobs, first);
        std::vector<Image> images(end - first);
        std::vector<std::optional<Failure>> failures(end - first);
        host.progress(from + (to - from) * static_cast<double>(first) / static_cast<double>(jobs.size()));
        host.parallelFor(images.size(), [&](std::size_t i) {
            try {
                images[i] = jobs[first + i].make();
            } catch (const Failure& failure) {
                failures[i] = failure;
            }
        });
        for (std::size_t i = 0; i < images.size(); ++i) {
            if (failures[i]) host.noteLeftOut(*failures[i]);
            indices.push_back(failures[i] ? -1 : addImage(jobs[first + i].name, images[i], host));
            images[i] = {};
        }
        first = end;
    }
    return indices;
}

}  // namespace candela_plugins
