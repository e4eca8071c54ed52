#include <candela/plugin.h>

#include <exception>

#include "../common/image.h"

namespace candela_plugins {
namespace {

std::uint32_t recognizes(const std::uint8_t* data, std::uint64_t size) {
    const Bytes file{data, size};
    return isPng(file) || isJpeg(file) || isWebp(file) || isKtx2(file) ? 1 : 0;
}

candela_status setResult(const candela_decoding& decoding, const Image& image) {
    candela_image result = CANDELA_IMAGE_INIT;
    result.width = image.width;
    result.height = image.height;
    result.format = image.sampleSize == SampleSize::bits16 ? CANDELA_PIXELS_RGBA16 : CANDELA_PIXELS_RGBA8;
    result.pixels = image.pixels.data();
    result.pixels_size = image.pixels.size();
    return decoding.set_result(decoding.self, &result);
}

candela_status decode(const candela_decoding* decoding, const std::uint8_t* data, std::uint64_t size) {
    try {
        return setResult(*decoding, decodeImage({data, size}, ""));
    } catch (const Failure& failure) {
        decoding->fail(decoding->self, failure.reason.c_str());
    } catch (const std::exception& error) {
        decoding->fail(decoding->self, error.what());
    }
    return CANDELA_FAILED;
}

constexpr candela_image_decoder decoder{sizeof(candela_image_decoder), recognizes, decode};
constexpr candela_plugin plugin{sizeof(candela_plugin),
                                CANDELA_PLUGIN_MAJOR,
                                CANDELA_PLUGIN_MINOR,
                                "decoders",
                                CANDELA_DECODERS_VERSION,
                                "Decodes PNG, JPEG, WebP and KTX2 images for importers",
                                nullptr,
                                nullptr,
                                &decoder};

// Image decoders came with 1.6.
constexpr std::uint32_t minMinor = 6;

}  // namespace
}  // namespace candela_plugins

const candela_plugin* candela_plugin_query(uint32_t hostMajor, uint32_t hostMinor) {
    const bool serves = hostMajor == CANDELA_PLUGIN_MAJOR && hostMinor >= candela_plugins::minMinor;
    return serves ? &candela_plugins::plugin : nullptr;
}
