// The G-buffer's encoding in GLSL against C++, over many surfaces, in a minimal program.

#include "support/procedural_scene.h"

#include "gl/buffer.h"
#include "gl/shader_source.h"

#include <candela/context.h>
#include <candela/gbuffer.h>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace candela::test {
namespace {

/// Three texels a surface: normal and roughness, base colour and metallic, and the packed words.
struct Record {
    glm::vec4 normalRoughness, colorMetallic;
    glm::uvec4 words;
};

class Program {
  public:
    explicit Program(const std::string& body) : name_(glCreateProgram()) {
        const std::string text = gl::assembleShader("lib/gbuffer.glsl", {}) +
                                 "layout(local_size_x = 64) in;\n"
                                 "struct Record { vec4 normalRoughness, colorMetallic; uvec4 words; };\n"
                                 "layout(std430, binding = 0) buffer Records { Record records[]; };\n"
                                 "void main() {\n    uint i = gl_GlobalInvocationID.x;\n" +
                                 body + "}\n";
        const char* texts[] = {text.c_str()};
        const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
        glShaderSource(shader, 1, texts, nullptr);
        glCompileShader(shader);
        glAttachShader(name_, shader);
        glLinkProgram(name_);
        glDeleteShader(shader);
        GLint linked = GL_FALSE;
        glGetProgramiv(name_, GL_LINK_STATUS, &linked);
        EXPECT_EQ(linked, GL_TRUE);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { glDeleteProgram(name_); }

    void run(std::vector<Record>& records) const {
        records.resize((records.size() + 63) / 64 * 64);
        gl::Buffer buffer("records", gl::BufferUsage::device);
        buffer.upload(std::span<const Record>(records));
        glUseProgram(name_);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.name());
        glDispatchCompute(GLuint(records.size() / 64), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetNamedBufferSubData(buffer.name(), 0, GLsizeiptr(records.size() * sizeof(Record)),
                                records.data());
    }

  private:
    GLuint name_;
};

Record randomSurface(std::uint32_t i) {
    Record record{};
    const glm::vec3 box(hashed(70, i) - 0.5f, hashed(71, i) - 0.5f, hashed(72, i) - 0.5f);
    record.normalRoughness = glm::vec4(glm::normalize(box), hashed(73, i));
    record.colorMetallic =
        glm::vec4(hashed(74, i), hashed(75, i) * hashed(75, i), 1.2f * hashed(76, i) - 0.1f, hashed(77, i));
    return record;
}

GBufferSurface surfaceOf(const Record& record) {
    return {glm::vec3(record.normalRoughness),
            {glm::vec3(record.colorMetallic), record.colorMetallic.w, record.normalRoughness.w}};
}

/// The largest difference of the codes that start at `shift`, `bits` wide.
int difference(std::uint32_t a, std::uint32_t b, int shift, int bits) {
    const std::uint32_t mask = (1u << bits) - 1u;
    return std::abs(int(a >> shift & mask) - int(b >> shift & mask));
}

class GBufferShaderTest : public testing::Test {
  protected:
    Context context_ = Context::createHeadless();
};

TEST_F(GBufferShaderTest, packsLikeCpp) {
    std::vector<Record> records;
    for (std::uint32_t i = 0; i < 100000; ++i) records.push_back(randomSurface(i));
    for (const glm::vec3 normal :
         {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, -1), glm::vec3(0)})
        records.push_back({glm::vec4(normal, 0.0f), glm::vec4(1.0f), {}});
    const Program pack(
        "    records[i].words.x = packBaseColor(records[i].colorMetallic.rgb, records[i].colorMetallic.a);\n"
        "    records[i].words.y = packNormalRoughness(records[i].normalRoughness.xyz, "
        "records[i].normalRoughness.w);\n");
    pack.run(records);
    int moved = 0;
    for (const Record& record : records) {
        if (record.normalRoughness == glm::vec4(0.0f) && record.colorMetallic == glm::vec4(0.0f)) continue;
        const GBufferTexel expected = packSurface(surfaceOf(record));
        ASSERT_NE(record.words.y, 0u);
        // Values within a rounding of the middle between two codes may go either way.
        for (const int shift : {0, 8, 16, 24}) {
            ASSERT_LE(difference(record.words.x, expected.x, shift, 8), 1);
            moved += difference(record.words.x, expected.x, shift, 8);
        }
        for (const auto& [shift, bits] : {std::pair{0, 12}, {12, 12}, {24, 8}}) {
            ASSERT_LE(difference(record.words.y, expected.y, shift, bits), 1);
            moved += difference(record.words.y, expected.y, shift, bits);
        }
    }
    // pow may err by 16 units of 6e-8 of a value times 255 codes: in one of some 2,000 colours it changes the
    // code.
    EXPECT_LT(moved, 200);
}

TEST_F(GBufferShaderTest, packsAlpha2WithinAFifthOfAStep) {
    std::vector<Record> records;
    for (std::uint32_t i = 0; i < 128 * 64; ++i) {
        Record record{};
        record.normalRoughness.w = std::pow(10.0f, -6.0f * static_cast<float>(i) / (128 * 64 - 1));
        records.push_back(record);
    }
    Program("    records[i].words.x = packAlpha2(max(records[i].normalRoughness.w, 1.0e-6));\n").run(records);
    EXPECT_EQ(records.front().words.x, 255u);
    EXPECT_EQ(records.back().words.x, 1u);
    for (const Record& record : records) {
        // docs/gbuffer.md: even steps of the fourth root of the roughness, from that of alpha 0.001.
        const double first = std::pow(0.001, 0.125), root = std::pow(record.normalRoughness.w, 0.0625);
        ASSERT_NEAR(record.words.x, 1.0 + 254.0 * (root - first) / (1.0 - first), 0.5 + 0.17);
    }
}

TEST_F(GBufferShaderTest, unpacksLikeCpp) {
    std::vector<Record> records;
    for (std::uint32_t i = 0; i < 100000; ++i) {
        Record record = randomSurface(i);
        const GBufferTexel texel = packSurface(surfaceOf(record));
        record.words = {texel.x, texel.y, 0, 0};
        records.push_back(record);
    }
    const std::size_t count = records.size();
    const Program unpack(
        "    GBufferSurface surface = unpackSurface(records[i].words.xy);\n"
        "    records[i].normalRoughness = vec4(surface.normal, surface.lobes.roughness);\n"
        "    records[i].colorMetallic = vec4(surface.lobes.baseColor, surface.lobes.metallic);\n");
    unpack.run(records);
    for (std::size_t i = 0; i < count; ++i) {
        const Record& record = records[i];
        const GBufferSurface expected = unpackSurface({record.words.x, record.words.y});
        // Three roundings of unit vectors; one of a quotient, four times in the fourth power; and pow, of
        // which OpenGL asks 16 units in the last place, times its exponent.
        ASSERT_LT(glm::distance(glm::vec3(record.normalRoughness), expected.normal), 4e-7f);
        ASSERT_NEAR(record.normalRoughness.w, expected.lobes.roughness, 2e-7f);
        ASSERT_NEAR(record.colorMetallic.w, expected.lobes.metallic, 2e-7f);
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(record.colorMetallic[c], expected.lobes.baseColor[c],
                        3e-6f * expected.lobes.baseColor[c] + 1e-9f);
    }
}

}  // namespace
}  // namespace candela::test
