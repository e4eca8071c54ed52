// The decoders of images behind add_image_bytes of the host.
#include "import/host.h"
#include "tests/plugins/gltf/image_files.h"

#include <candela/plugin_registry.h>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace candela {
namespace {

using candela_test::Bytes;

struct Decoded {
    Scene scene;
    std::vector<std::int32_t> indices;
    std::vector<std::string> reasons;
};

Decoded decode(const std::vector<Bytes>& files) {
    static const PluginRegistry plugins({CANDELA_TEST_PLUGINS});
    ImportHost importing("test", nullptr, {}, plugins.imageDecoders());
    const candela_host& host = importing.interface();
    std::vector<candela_image_bytes> images;
    for (const Bytes& file : files) images.push_back({"file", file.data(), file.size()});
    Decoded result;
    result.indices.resize(files.size());
    std::vector<const char*> reasons(files.size());
    EXPECT_EQ(host.add_image_bytes(host.self, images.data(), static_cast<std::uint32_t>(files.size()),
                                   result.indices.data(), reasons.data()),
              CANDELA_OK);
    for (const char* reason : reasons) result.reasons.emplace_back(reason ? reason : "");
    importing.rethrowFailure();
    result.scene = importing.takeScene();
    return result;
}

TEST(Decoders, ReadPngAndJpeg) {
    const Bytes wide = candela_test::makePng(1, 1, 16, candela_test::PngColor::grey, {0x12, 0x34});
    const Decoded decoded =
        decode({candela_test::makePng(3, 2, 10, 20, 30, 40), candela_test::makeGreyJpeg(), wide});
    EXPECT_EQ(decoded.indices, (std::vector<std::int32_t>{0, 1, 2}));
    const std::vector<Image>& images = decoded.scene.images;
    ASSERT_EQ(images.size(), 3u);
    EXPECT_EQ(images[0].width, 3u);
    EXPECT_EQ(images[0].height, 2u);
    const std::array<std::byte, 4> texel{std::byte{10}, std::byte{20}, std::byte{30}, std::byte{40}};
    EXPECT_TRUE(std::equal(texel.begin(), texel.end(), images[0].pixels.end() - 4));
    EXPECT_EQ(images[1].width, 8u);
    EXPECT_EQ(images[1].pixels.at(0), std::byte{192});
    EXPECT_EQ(images[2].format, PixelFormat::rgba16);
}

TEST(Decoders, SayWhatIsWrong) {
    Bytes cut = candela_test::makePng(3, 2, 10, 20, 30, 40);
    cut.resize(cut.size() / 2);
    const Decoded decoded = decode({cut, {'G', 'I', 'F', '8'}, {}});
    EXPECT_EQ(decoded.indices, (std::vector<std::int32_t>{-1, -1, -1}));
    EXPECT_NE(decoded.reasons[0].find("PNG"), std::string::npos) << decoded.reasons[0];
    EXPECT_EQ(decoded.reasons[1], "no plugin decodes a file that begins like this one");
    EXPECT_TRUE(decoded.scene.images.empty());
}

TEST(Decoders, AreReported) {
    const PluginRegistry plugins({CANDELA_TEST_PLUGINS});
    std::size_t count = 0;
    for (const PluginReport& report : plugins.reports()) count += report.decodesImages;
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(plugins.imageDecoders().size(), 1u);
}

}  // namespace
}  // namespace candela
