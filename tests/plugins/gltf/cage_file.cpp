#include "cage_file.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace candela_test {
namespace {

struct CubeVertices {
    std::vector<float> positions, normals, uvs;
    std::vector<std::uint8_t> indices;
};

/// The normal of face `face` is along one axis; its corners are counter-clockwise seen from outside.
void addFace(CubeVertices& cube, int face) {
    const int axis = face / 2, first = (axis + 1) % 3, second = (axis + 2) % 3;
    const float side = face % 2 == 0 ? 1.0f : -1.0f;
    constexpr float around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (const auto& [a, b] : around) {
        glm::vec3 position, normal(0.0f);
        position[axis] = normal[axis] = side;
        position[first] = a * side;  // Mirrored with the side to keep the winding.
        position[second] = b;
        cube.positions.insert(cube.positions.end(), {position.x, position.y, position.z});
        cube.normals.insert(cube.normals.end(), {normal.x, normal.y, normal.z});
        cube.uvs.insert(cube.uvs.end(), {static_cast<float>(face) + (a + 1) / 4, (b + 1) / 4});
    }
    const int base = 4 * face;
    for (const int corner : {0, 1, 2, 0, 2, 3}) {
        cube.indices.push_back(static_cast<std::uint8_t>(base + corner));
    }
}

}  // namespace

std::string facesMember(Faces faces) {
    return faces == Faces::triangles ? "" : R"(,"extensions":{"FB_ngon_encoding":{}})";
}

void addCageMesh(GltfFile& file, const std::string& primitives, const std::string& settings,
                 const std::string& more) {
    file.add("meshes", R"({"name":"cage","primitives":[)" + primitives +
                           R"(],"extras":{"candela_subdivision":)" + settings + "}" +
                           (more.empty() ? "" : ",") + more + "}");
    file.add("nodes", R"({"mesh":0})");
}

GltfFile cubeFile(const std::string& settings, Faces faces) {
    CubeVertices cube;
    for (int face = 0; face < 6; ++face) addFace(cube, face);
    GltfFile file;
    file.addData<float>("VEC3", cube.positions);
    file.addData<float>("VEC3", cube.normals);
    file.addData<float>("VEC2", cube.uvs);
    file.addData<std::uint8_t>("SCALAR", cube.indices);
    addCageMesh(
        file,
        R"({"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3)" + facesMember(faces) + "}",
        settings);
    return file;
}

void addSquareCage(GltfFile& file, const SquareMembers& more) {
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int indices = file.addData<std::uint8_t>("SCALAR", {0, 1, 2, 0, 2, 3});
    addCageMesh(file,
                R"({"attributes":{"POSITION":0)" + more.attributes + R"(},"indices":)" +
                    std::to_string(indices) + facesMember(Faces::ngonEncoding) + more.members + "}",
                "{}", more.mesh);
}

candela::Cage cageOf(const GltfFile& file) {
    return load(file).scene.cages.at(0);
}

std::uint32_t vertexAt(const candela::Cage& cage, glm::vec3 position) {
    const auto found = std::find(cage.positions.begin(), cage.positions.end(), position);
    EXPECT_NE(found, cage.positions.end()) << position.x << ' ' << position.y << ' ' << position.z;
    return static_cast<std::uint32_t>(found - cage.positions.begin());
}

}  // namespace candela_test
