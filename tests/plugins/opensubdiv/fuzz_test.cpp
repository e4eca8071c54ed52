#include "generated_cages.h"
#include "plugin_call.h"
#include "support/fuzz_iterations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

namespace candela {
namespace {

/// A cage of small random numbers, most of which are valid.
class RandomCage {
  public:
    explicit RandomCage(Random& random) : random_(random) {
        cage_.struct_size = sizeof(cage_);
        const std::uint32_t values[] = {below(3) + rarely(), below(3) + rarely(), below(6) + rarely(),
                                        below(2) + rarely(), below(2) + rarely()};
        std::memcpy(&cage_.scheme, &values[0], 4);
        std::memcpy(&cage_.boundary_interpolation, &values[1], 4);
        std::memcpy(&cage_.face_varying_interpolation, &values[2], 4);
        std::memcpy(&cage_.crease_method, &values[3], 4);
        std::memcpy(&cage_.triangle_subdivision, &values[4], 4);
        cage_.vertex_count = 3 + below(8);
        positions_ = floats(3 * cage_.vertex_count);
        cage_.positions = positions_.data();
        cage_.face_count = 1 + below(8);
        setFaces();
        setUvs();
        setSharpness();
        holes_ = numbers(below(3), cage_.face_count + rarely());
        cage_.hole_count = static_cast<std::uint32_t>(holes_.size());
        cage_.holes = holes_.data();
    }

    const candela_cage& get() const { return cage_; }

  private:
    std::uint32_t below(std::uint32_t end) {
        return std::uniform_int_distribution<std::uint32_t>(0, end - 1)(random_);
    }
    std::uint32_t rarely() { return below(20) == 0 ? 1 : 0; }

    std::vector<std::uint32_t> numbers(std::size_t count, std::uint32_t end) {
        std::vector<std::uint32_t> result(count);
        for (std::uint32_t& number : result) number = below(end);
        return result;
    }

    std::vector<float> floats(std::size_t count) {
        std::vector<float> result(count);
        for (float& number : result) {
            number = static_cast<float>(below(200)) / 10.0f - (below(60) == 0 ? 20.0f : 0.0f);
            const std::uint32_t bits = below(0xFFFFFFFFu);
            if (below(500) == 0) std::memcpy(&number, &bits, sizeof(number));
        }
        return result;
    }

    void setFaces() {
        sizes_.resize(cage_.face_count);
        for (std::uint32_t& size : sizes_) {
            size = 3 + (below(3) == 0 ? below(4) : 0) - rarely() * rarely();
            // Most faces use each vertex once, or all cages would be rejected by the first check.
            std::vector<std::uint32_t> vertices(cage_.vertex_count);
            for (std::uint32_t i = 0; i < cage_.vertex_count; ++i) vertices[i] = i;
            std::shuffle(vertices.begin(), vertices.end(), random_);
            for (std::uint32_t i = 0; i < size; ++i) {
                vertices_.push_back(i < vertices.size() ? vertices[i] : below(cage_.vertex_count));
                if (below(300) == 0) vertices_.back() = below(0xFFFFFFFFu);
            }
        }
        cage_.face_sizes = sizes_.data();
        cage_.face_vertices = vertices_.data();
    }

    void setUvs() {
        cage_.uv_count = below(2) == 0 ? 0 : 1 + below(10);
        uvs_ = floats(2 * cage_.uv_count);
        faceUvs_ = numbers(vertices_.size(), cage_.uv_count + rarely() + 1);
        for (std::uint32_t& uv : faceUvs_) uv = uv == cage_.uv_count && rarely() == 0 ? 0 : uv;
        cage_.uvs = uvs_.data();
        cage_.face_uvs = faceUvs_.data();
    }

    void setSharpness() {
        // Most creases are edges of faces.
        for (std::uint32_t i = below(5); i > 0; --i) {
            const std::size_t corner = below(static_cast<std::uint32_t>(vertices_.size()) - 1);
            creases_.push_back(vertices_[corner]);
            creases_.push_back(vertices_[corner + 1]);
        }
        creaseSharpness_ = floats(creases_.size() / 2);
        cage_.crease_count = static_cast<std::uint32_t>(creaseSharpness_.size());
        cage_.crease_edges = creases_.data();
        cage_.crease_sharpness = creaseSharpness_.data();
        corners_ = numbers(below(3), cage_.vertex_count + rarely());
        cornerSharpness_ = floats(corners_.size());
        cage_.corner_count = static_cast<std::uint32_t>(corners_.size());
        cage_.corner_vertices = corners_.data();
        cage_.corner_sharpness = cornerSharpness_.data();
    }

    Random& random_;
    candela_cage cage_{};
    std::vector<float> positions_, uvs_, creaseSharpness_, cornerSharpness_;
    std::vector<std::uint32_t> sizes_, vertices_, faceUvs_, creases_, corners_, holes_;
};

/// The number of random cages that are refined. Each call ends with a result or with one error.
int countRefined(std::uint32_t seed, int count) {
    Random random(seed);
    int refined = 0;
    for (int i = 0; i < count; ++i) {
        const RandomCage cage(random);
        const CallResult result = callPlugin(cage.get(), 1 + static_cast<std::uint32_t>(i % 3));
        EXPECT_EQ(result.hasResult, result.status == CANDELA_OK);
        EXPECT_EQ(result.failures, result.status == CANDELA_OK ? 0 : 1);
        if (result.status == CANDELA_OK) ++refined;
    }
    return refined;
}

TEST(Fuzz, randomCagesGiveResultsOrErrors) {
    const int count = candela_test::fuzzIterations<int>(4000);
    const int refined = countRefined(31, count);
    // The cages have to exercise both outcomes.
    EXPECT_GT(refined, count / 10);
    EXPECT_LT(refined, count);
}

TEST(Fuzz, concurrentCallsAreIndependent) {
    std::vector<int> concurrent(4);
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < concurrent.size(); ++i) {
        threads.emplace_back(
            [&concurrent, i] { concurrent[i] = countRefined(40 + static_cast<std::uint32_t>(i), 300); });
    }
    threads.clear();
    for (std::size_t i = 0; i < concurrent.size(); ++i) {
        EXPECT_EQ(concurrent[i], countRefined(40 + static_cast<std::uint32_t>(i), 300));
    }
}

// Random bytes in the arrays, and random counts and rules; the arrays are long enough for all counts.
TEST(Fuzz, randomBytesGiveResultsOrErrors) {
    Random random(51);
    std::vector<std::uint32_t> bytes(4096);
    for (int i = 0; i < candela_test::fuzzIterations(20000); ++i) {
        for (std::uint32_t& number : bytes)
            number = static_cast<std::uint32_t>(random() % (i % 2 == 0 ? 6 : 0xFFFFFFFFu));
        candela_cage cage{};
        cage.struct_size = sizeof(cage);
        std::uint32_t values[5];
        for (std::uint32_t& value : values) value = random() % 4;
        std::memcpy(&cage.scheme, values, sizeof(values));
        const auto some = [&] { return static_cast<std::uint32_t>(random() % 12); };
        cage.vertex_count = some();
        cage.face_count = some();
        cage.uv_count = some();
        cage.crease_count = some();
        cage.corner_count = some();
        cage.hole_count = some();
        for (auto** array : {&cage.face_sizes, &cage.face_vertices, &cage.face_uvs, &cage.crease_edges,
                             &cage.corner_vertices, &cage.holes}) {
            *array = bytes.data() + random() % 64;
        }
        for (auto** array : {&cage.positions, &cage.uvs, &cage.crease_sharpness, &cage.corner_sharpness}) {
            *array = reinterpret_cast<const float*>(bytes.data());
        }
        // A face of many corners would make the plugin read beyond any array.
        std::vector<std::uint32_t> sizes(cage.face_sizes, cage.face_sizes + cage.face_count);
        for (std::uint32_t& size : sizes) size %= 100;
        cage.face_sizes = sizes.data();
        const CallResult result = callPlugin(cage, 1);
        EXPECT_EQ(result.failures, result.status == CANDELA_OK ? 0 : 1);
    }
}

}  // namespace
}  // namespace candela
