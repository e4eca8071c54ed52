#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "compressed_files.h"
#include "image_files.h"
#include "loading.h"
#include "pointer_file.h"
#include "support/fuzz_iterations.h"

namespace candela_test {
namespace {

using Random = std::mt19937;

/// A small file that uses most of what the importer reads.
GltfFile fullFile() {
    GltfFile file = triangleFile(R"("material":0)");
    file.addData<float>("VEC2", {0, 0, 1, 0, 0, 1});
    file.addData<std::uint8_t>("VEC4", std::vector<std::uint8_t>(12, 255), R"("normalized":true)");
    file.addData<std::uint16_t>("SCALAR", {0, 1, 2});
    const std::string indexView = std::to_string(file.addView({0, 2}));
    const std::string valueView = std::to_string(file.addView(Bytes(16)));
    file.addAccessor(2, "VEC2", 5126, 3,
                     R"("sparse":{"count":2,"indices":{"bufferView":)" + indexView +
                         R"(,"componentType":5121},"values":{"bufferView":)" + valueView + "}}");
    file.add("meshes", R"({"name":"rich","primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,
        "TEXCOORD_1":5,"COLOR_0":3},"indices":4,"material":0},{"attributes":{"POSITION":0},"mode":5}]})");
    const std::string png = std::to_string(file.addView(makePng(2, 2, 1, 2, 3, 4)));
    file.add("images", R"({"bufferView":)" + png + R"(,"mimeType":"image/png"})");
    file.add("images", R"({"uri":"data:image/jpeg;base64,)" + base64(makeGreyJpeg()) + "\"}");
    file.add("samplers", R"({"wrapS":33071,"minFilter":9728})");
    file.add("textures", R"({"source":0,"sampler":0})");
    file.add("textures", R"({"source":1})");
    file.add("materials", R"({"name":"m","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0,1],
        "baseColorTexture":{"index":0}},"normalTexture":{"index":1,"scale":2,"extensions":
        {"KHR_texture_transform":{"offset":[1,2],"rotation":1,"scale":[2,2]}}},"alphaMode":"MASK"})");
    file.add("cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":0.1}})");
    file.set("extensions",
             R"({"KHR_lights_punctual":{"lights":[{"type":"spot","spot":{"innerConeAngle":0.1},
                "extras":{"castsShadow":0,"radius":0.5}}]},"EXT_lights_image_based":{"lights":[{"name":"i",
                "intensity":2,"rotation":[0,0,0,1],"specularImages":[[0,0,0,0,0,0]]}]}})");
    file.add("nodes", R"({"mesh":1,"children":[2,3],"rotation":[0,0,0,1],"extras":{"castsShadow":1}})");
    file.add("nodes", R"({"camera":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1]})");
    file.add("nodes", R"({"extensions":{"KHR_lights_punctual":{"light":0}}})");
    file.add("scenes", R"({"nodes":[0,1],"extensions":{"EXT_lights_image_based":{"light":0}}})");
    file.addData<float>("SCALAR", {0, 1});
    file.addData<float>("VEC3", {0, 0, 0, 1, 1, 1});
    file.add("animations", R"({"samplers":[{"input":6,"output":7}],
                               "channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}]})");
    return file;
}

/// A small file with a cage that has creases, n-gons, a skin, morph targets and animated weights.
GltfFile cageFile() {
    GltfFile file;
    file.set("extensionsUsed", R"(["FB_ngon_encoding"])");
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0});
    file.addData<float>("VEC2", {0, 0, 1, 0, 1, 1, 0, 1, 5, 0, 6, 0, 6, 1, 5, 1});
    file.addData<std::uint8_t>("SCALAR", {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7});
    file.addData<std::uint8_t>("VEC4", std::vector<std::uint8_t>(32, 1));
    file.addData<std::uint8_t>("VEC4", std::vector<std::uint8_t>(32, 64), R"("normalized":true)");
    file.addData<float>("VEC3", std::vector<float>(24, 0.5f));
    const std::string indexView = std::to_string(file.addView({0, 3}));
    const std::string valueView = std::to_string(file.addView(bytesOf<float>({0, 0, 1, 0, 1, 0})));
    file.addAccessor(-1, "VEC3", 5126, 8,
                     R"("sparse":{"count":2,"indices":{"bufferView":)" + indexView +
                         R"(,"componentType":5121},"values":{"bufferView":)" + valueView + "}}");
    file.addData<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1});
    file.addData<float>("SCALAR", {0, 1});
    file.addData<float>("SCALAR", {0, 1, 1, 0});
    file.add("materials", R"({"name":"m"})");
    file.add("meshes", R"({"name":"cage","primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,
        "JOINTS_0":3,"WEIGHTS_0":4},"indices":2,"material":0,"targets":[{"POSITION":5},{"POSITION":6}],
        "extensions":{"FB_ngon_encoding":{}}}],"weights":[0.5,1],"extras":{"candela_subdivision":{
        "scheme":"catmullClark","level":2,"boundaryInterpolation":"edges","creaseMethod":"chaikin",
        "faceVaryingInterpolation":"all","triangleSubdivision":"smooth",
        "creases":[[1,2,2.5],[4,5,10]],"corners":[[0,3]],"holes":[1]}}})");
    file.add("nodes", R"({"mesh":0,"skin":0,"weights":[0,1]})");
    file.add("nodes", R"({"name":"lower","children":[2]})");
    file.add("nodes", R"({"name":"upper","translation":[0,1,0]})");
    file.add("skins", R"({"joints":[1,2],"inverseBindMatrices":7})");
    file.add("animations", R"({"samplers":[{"input":8,"output":9}],
                               "channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}]})");
    return file;
}

/// A small file with all extensions of materials, and variants.
GltfFile layeredFile() {
    GltfFile file;
    addTriangle(file);
    file.addData<float>("VEC2", {0, 0, 1, 0, 0, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_3":2},"material":0,
        "extensions":{"KHR_materials_variants":{"mappings":[{"material":1,"variants":[0,1]}]}})");
    file.set("extensions", R"({"KHR_materials_variants":{"variants":[{"name":"a"},{"name":"b"}]}})");
    file.add("images", R"({"uri":"data:image/png;base64,)" + base64(makePng(2, 2, 1, 2, 3, 4)) + "\"}");
    file.add("textures", R"({"source":0})");
    file.add("materials", R"({"extensions":{"KHR_materials_ior":{"ior":1.3},
        "KHR_materials_specular":{"specularFactor":0.5,"specularColorFactor":[1,2,0]},
        "KHR_materials_clearcoat":{"clearcoatFactor":1,"clearcoatNormalTexture":{"index":0,"scale":2}},
        "KHR_materials_sheen":{"sheenColorFactor":[1,0,0],"sheenColorTexture":{"index":0,"texCoord":3}},
        "KHR_materials_anisotropy":{"anisotropyStrength":0.5,"anisotropyRotation":1},
        "KHR_materials_iridescence":{"iridescenceFactor":1,"iridescenceIor":1.5,
            "iridescenceThicknessMaximum":300},
        "KHR_materials_transmission":{"transmissionFactor":1,"transmissionTexture":{"index":0,"extensions":
            {"KHR_texture_transform":{"scale":[2,2],"texCoord":3}}}},
        "KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,"attenuationColor":[1,0,1]},
        "KHR_materials_dispersion":{"dispersion":0.1},
        "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.5,
            "diffuseTransmissionColorFactor":[1,1,0]}}})");
    file.add("materials", R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{
        "diffuseFactor":[1,0,1,1],"specularFactor":[0.5,1,0],"glossinessFactor":0.5,
        "specularGlossinessTexture":{"index":0,"texCoord":3}}}})");
    return file;
}

/// A small file whose buffer views are compressed.
GltfFile compressedFile() {
    const Grid grid = makeGrid(5);
    CompressedFile compressed;
    const auto addAttributes = [&](const std::vector<float>& numbers, const std::string& filter) {
        const int view = compressed.addView(compressAttributes(numbers.data(), 25, 12), 25, 12,
                                            R"("mode":"ATTRIBUTES","filter":")" + filter + "\"");
        return compressed.file.addAccessor(view, "VEC3", 5126, 25);
    };
    addAttributes(grid.positions, "NONE");
    addAttributes(grid.normals, "EXPONENTIAL");
    const std::size_t count = grid.indices.size();
    const int triangles =
        compressed.addView(compressTriangles(grid.indices, 25), count, 4, R"("mode":"TRIANGLES")");
    const int sequence =
        compressed.addView(compressIndices(grid.indices, 25), count, 2, R"("mode":"INDICES")");
    compressed.file.addAccessor(triangles, "SCALAR", 5125, count);
    compressed.file.addAccessor(sequence, "SCALAR", 5123, count);
    compressed.file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2)");
    compressed.file.addMeshNode(R"("attributes":{"POSITION":0},"indices":3)");
    return compressed.finish();
}

GltfFile dracoGrid() {
    const Grid grid = makeGrid(5);
    GltfFile file = dracoFile(compressGrid(grid, 5), 25, grid.indices.size());
    const std::string view = std::to_string(file.addView(compressGrid(grid, 10)));
    file.addMeshNode(R"("attributes":{"POSITION":0},"indices":2,"extensions":{"KHR_draco_mesh_compression":)"
                     R"({"bufferView":)" +
                     view + R"(,"attributes":{"POSITION":0}}})");
    return file;
}

std::size_t below(Random& random, std::size_t limit) {
    return random() % limit;
}

/// Replaces one run of digits of the text by an edge-case number.
void replaceNumber(Bytes& bytes, Random& random) {
    static const std::string numbers[] = {"-1",
                                          "0",
                                          "1",
                                          "2",
                                          "255",
                                          "65536",
                                          "1e9",
                                          "2147483647",
                                          "2147483648",
                                          "4294967295",
                                          "0.5",
                                          "1e38",
                                          "-1e39",
                                          "9007199254740993",
                                          "18446744073709551615",
                                          "null"};
    std::size_t begin = below(random, bytes.size());
    const auto isDigit = [&](std::size_t i) { return bytes[i] >= '0' && bytes[i] <= '9'; };
    while (begin < bytes.size() && !isDigit(begin)) ++begin;
    std::size_t end = begin;
    while (end < bytes.size() && isDigit(end)) ++end;
    const std::string& number = numbers[below(random, std::size(numbers))];
    const auto at = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
    bytes.insert(bytes.erase(at, bytes.begin() + static_cast<std::ptrdiff_t>(end)), number.begin(),
                 number.end());
}

void mutate(Bytes& bytes, Random& random) {
    if (bytes.empty()) return;
    const std::size_t at = below(random, bytes.size());
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(random, 6)) {
        case 0:
            bytes[at] = static_cast<std::uint8_t>(random());
            break;
        case 1:
            bytes[at] ^= static_cast<std::uint8_t>(1u << below(random, 8));
            break;
        case 2:
            bytes.erase(place, place + static_cast<std::ptrdiff_t>(
                                           below(random, std::min<std::size_t>(16, bytes.size() - at) + 1)));
            break;
        case 3: {
            const Bytes copy(place, place + static_cast<std::ptrdiff_t>(below(
                                                random, std::min<std::size_t>(32, bytes.size() - at) + 1)));
            const auto target = static_cast<std::ptrdiff_t>(below(random, bytes.size()));
            bytes.insert(bytes.begin() + target, copy.begin(), copy.end());
            break;
        }
        default:
            replaceNumber(bytes, random);
            break;
    }
}

struct Outcome {
    int accepted = 0, rejected = 0;
};

/// Loads many mutations of `original`. Each gives a scene or an `Error`, in bounded time.
Outcome fuzz(const Bytes& original, const std::string& fileName, int rounds) {
    const TemporaryFolder folder;
    Outcome outcome;
    for (int round = 0; round < rounds; ++round) {
        Random random(static_cast<Random::result_type>(round));
        Bytes bytes = original;
        for (std::size_t i = 0, count = 1 + below(random, 3); i < count; ++i) mutate(bytes, random);
        const std::string path = folder.write(fileName, bytes);
        const auto start = std::chrono::steady_clock::now();
        try {
            loadPath(path);
            ++outcome.accepted;
        } catch (const candela::Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
            ++outcome.rejected;
        }
        // A file of a few kilobytes takes about a millisecond; a minute is a hang on any machine.
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1)) << "round " << round;
    }
    return outcome;
}

void expectBothOutcomes(const Outcome& outcome, int rounds) {
    EXPECT_EQ(outcome.accepted + outcome.rejected, rounds);
    // The mutations have to exercise both outcomes.
    EXPECT_GT(outcome.accepted, rounds / 50);
    EXPECT_GT(outcome.rejected, rounds / 50);
}

const int rounds = fuzzIterations<int>(3000);

Bytes asBytes(const std::string& text) {
    return {text.begin(), text.end()};
}

/// A small file with a pointer to every property that animations may change.
GltfFile pointerFile() {
    GltfFile file = fileOfEverything();
    for (const Pointed& pointed : everyProperty()) animate(file, pointed);
    const int times = file.addData<float>("SCALAR", {0, 1});
    animate(file, "/nodes/0/extensions/KHR_node_visibility/visible", times,
            file.addData<std::uint8_t>("SCALAR", {0, 1}), "STEP");
    animate(file, "/nodes/1/translation", times, file.addData<float>("VEC3", {0, 0, 0, 1, 1, 1}));
    animate(file, "/meshes/0/weights/1", times, file.addData<float>("SCALAR", {0, 1}));
    return file;
}

TEST(Fuzz, unmodifiedFilesAreAccepted) {
    EXPECT_EQ(errorOf(fullFile()), "");
    EXPECT_EQ(errorOf(pointerFile()), "");
    EXPECT_EQ(errorOfGlb(fullFile().glb()), "");
    EXPECT_EQ(errorOf(cageFile()), "");
    EXPECT_EQ(errorOf(layeredFile()), "");
    EXPECT_EQ(errorOf(compressedFile()), "");
    EXPECT_EQ(errorOfGlb(dracoGrid().glb()), "");
}

TEST(Fuzz, gltf) {
    expectBothOutcomes(fuzz(asBytes(fullFile().text()), "a.gltf", rounds), rounds);
}

TEST(Fuzz, glb) {
    expectBothOutcomes(fuzz(fullFile().glb(), "a.glb", rounds), rounds);
}

TEST(Fuzz, cageInGltf) {
    expectBothOutcomes(fuzz(asBytes(cageFile().text()), "a.gltf", rounds), rounds);
}

TEST(Fuzz, cageInGlb) {
    expectBothOutcomes(fuzz(cageFile().glb(), "a.glb", rounds), rounds);
}

TEST(Fuzz, layersAndVariants) {
    expectBothOutcomes(fuzz(asBytes(layeredFile().text()), "a.gltf", rounds / 3), rounds / 3);
}

TEST(Fuzz, animationPointers) {
    expectBothOutcomes(fuzz(asBytes(pointerFile().text()), "a.gltf", rounds / 3), rounds / 3);
}

TEST(Fuzz, compressedViews) {
    expectBothOutcomes(fuzz(asBytes(compressedFile().text()), "a.gltf", rounds), rounds);
}

TEST(Fuzz, dracoStreams) {
    expectBothOutcomes(fuzz(dracoGrid().glb(), "a.glb", rounds), rounds);
}

/// Mutations of an image either decode to the size in their header or are left out with a note that names the
/// image.
void fuzzImage(const Bytes& original, int imageRounds) {
    for (int round = 0; round < imageRounds; ++round) {
        Random random(static_cast<Random::result_type>(round));
        Bytes bytes = original;
        mutate(bytes, random);
        GltfFile file;
        file.add("images", R"({"uri":"data:;base64,)" + base64(bytes) + "\"}");
        file.add("textures", R"({"source":0})");
        file.add("materials", R"({"emissiveTexture":{"index":0}})");
        const candela::ImportedScene imported = load(file);
        EXPECT_EQ(imported.scene.images.empty(), hasNote(imported, "image 0: "));
        for (const candela::Image& image : imported.scene.images)
            EXPECT_EQ(image.pixels.size(), std::size_t(image.width) * image.height * texelSize(image.format));
    }
}

TEST(Fuzz, png) {
    fuzzImage(makePng(5, 4, 1, 2, 3, 4), rounds / 3);
}

TEST(Fuzz, webp) {
    fuzzImage(makeWebp(std::vector<std::uint8_t>(5 * 4 * 4, 99), 5, 4), rounds / 3);
}

TEST(Fuzz, ktx2) {
    for (const char* file : {etc1sFile, uastcFile}) fuzzImage(fromBase64(file), rounds / 3);
}

TEST(Fuzz, jpeg) {
    fuzzImage(makeGreyJpeg(), rounds / 3);
}

}  // namespace
}  // namespace candela_test
