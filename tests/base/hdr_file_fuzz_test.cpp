// Damaged pictures end in an `Error` or in a picture, and in nothing else.

#include "hdr_samples.h"
#include "support/fuzz_iterations.h"
#include "temporary_folder.h"

#include <candela/error.h>
#include <candela/image_file.h>

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

namespace candela {
namespace {

std::string exrBytes(const std::filesystem::path& path) {
    std::vector<float> values;
    for (int i = 0; i < 24 * 20; ++i) values.push_back(static_cast<float>(i % 7) * 0.125f);
    writeExr(path, 24, 20, std::vector<ExrChannel>{{"R", values}, {"G", values}, {"B", values}}, {});
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void damage(std::string& bytes, std::mt19937& random) {
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
    // Most of what a header says lies at the start.
    const auto place = [&] {
        return below(below(2) ? bytes.size() : std::min<std::size_t>(bytes.size(), 400));
    };
    for (std::size_t i = 0; i < 1 + below(4); ++i) {
        if (bytes.size() < 8) return;
        switch (below(5)) {
            case 0:
                bytes[place()] = static_cast<char>(random());
                break;
            case 1:
                bytes.resize(place());
                break;
            case 2:
                bytes.erase(place(), 1 + below(8));
                break;
            case 3:
                bytes.insert(place(), 1 + below(8), static_cast<char>(random()));
                break;
            default: {
                constexpr std::uint32_t edges[] = {0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 65536, 1u << 24};
                const std::size_t at = std::min(place(), bytes.size() - 4);
                std::memcpy(&bytes[at], &edges[below(std::size(edges))], 4);
            }
        }
    }
}

void expectPictureOrError(const std::filesystem::path& path, const std::string& bytes) {
    writeBytes(path, bytes);
    try {
        const HdrFile file = readHdrFile(path);
        ASSERT_EQ(file.image.pixels.size(), std::size_t{16} * file.image.width * file.image.height);
        for (std::size_t i = 0; i < file.image.pixels.size(); i += sizeof(float)) {
            float value = 0.0f;
            std::memcpy(&value, file.image.pixels.data() + i, sizeof value);
            ASSERT_TRUE(value >= 0.0f && value <= 1e20f);
        }
    } catch (const Error& error) {
        EXPECT_EQ(error.path(), path.string());
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

TEST(HdrFileFuzz, RadianceFiles) {
    const TemporaryFolder folder;
    const std::vector<Rgbe> texels = someTexels(24 * 20);
    const std::vector<std::string> samples{
        radianceHeader("-Y 20 +X 24", "EXPOSURE=2\n") + newRuns(texels, 24),
        radianceHeader("+X 24 -Y 20") + uncoded(texels), radianceHeader("-Y 20 +X 24") + oldRuns(texels, 24)};
    std::mt19937 random(1);
    for (int i = 0; i < candela_test::fuzzIterations(600); ++i) {
        std::string bytes = samples[static_cast<std::size_t>(i) % samples.size()];
        damage(bytes, random);
        expectPictureOrError(folder.path() / "a.hdr", bytes);
    }
}

TEST(HdrFileFuzz, ExrFiles) {
    const TemporaryFolder folder;
    const std::string sample = exrBytes(folder.path() / "a.exr");
    std::mt19937 random(2);
    for (int i = 0; i < candela_test::fuzzIterations(600); ++i) {
        std::string bytes = sample;
        damage(bytes, random);
        expectPictureOrError(folder.path() / "a.exr", bytes);
    }
}

}  // namespace
}  // namespace candela
