#include "primitives.h"

#include <numeric>
#include <set>

#include "../common/failure.h"
#include "document.h"

namespace candela_plugins::gltf {

int accessorOf(const tinygltf::Primitive& primitive, const std::string& attribute) {
    const auto found = primitive.attributes.find(attribute);
    return found == primitive.attributes.end() ? -1 : found->second;
}

std::size_t elementCount(const Document& document, int accessor) {
    return document.model.accessors.at(static_cast<std::size_t>(accessor)).count;
}

namespace {

std::string attributeName(const std::string& element, const std::string& attribute) {
    return element + ", attribute " + attribute;
}

Encodings allowedEncodings(const Document& document, const AttributeForm& form) {
    return document.quantized ? form.quantized : form.plain;
}

void requireCount(const Document& document, int accessor, std::size_t vertices, const std::string& where) {
    requireAccessor(document, accessor, where);
    const std::size_t count = elementCount(document, accessor);
    if (count != vertices) {
        throw Failure{where, "accessor " + std::to_string(accessor) + " has " + std::to_string(count) +
                                 " elements, expected " + std::to_string(vertices)};
    }
}

}  // namespace

void checkAttribute(const Document& document, int accessor, const std::string& attribute,
                    const AttributeForm& form, std::size_t vertices, const std::string& element) {
    const std::string where = attributeName(element, attribute);
    const Encodings allowed = allowedEncodings(document, form);
    checkAccessor(document, accessor, static_cast<int>(form.components), allowed, where);
    requireCount(document, accessor, vertices, where);
}

Numbers<float> findAttribute(const Document& document, int accessor, const std::string& attribute,
                             const AttributeForm& form, std::size_t vertices, const std::string& element,
                             Finiteness finiteness) {
    const std::string where = attributeName(element, attribute);
    requireCount(document, accessor, vertices, where);
    const Encodings allowed = allowedEncodings(document, form);
    return findFloats(document, accessor, static_cast<int>(form.components), allowed, where, finiteness);
}

std::vector<float> readAttribute(const Document& document, int accessor, const std::string& attribute,
                                 const AttributeForm& form, std::size_t vertices, const std::string& element,
                                 Finiteness finiteness) {
    return findAttribute(document, accessor, attribute, form, vertices, element, finiteness).take();
}

VertexAccessors vertexAccessors(const tinygltf::Primitive& primitive) {
    VertexAccessors accessors{primitive.attributes, primitive.targets};
    accessors.attributes.erase(indicesAttribute);
    return accessors;
}

namespace {

constexpr std::uint64_t maxAbsentElements = std::uint64_t(1) << 28;

/// How many elements primitives read that the file does not hold.
class AbsentElements {
  public:
    explicit AbsentElements(const Document& document) : accessors_(document.model.accessors) {}

    std::uint64_t count(const tinygltf::Primitive& primitive) {
        const std::uint64_t all = ofAttributes(primitive.attributes) + ofTargets(primitive);
        if (all == 0 || known_.insert(vertexAccessors(primitive)).second) return all;
        return ofAccessor(accessorOf(primitive, indicesAttribute));
    }

  private:
    /// Accessors that are too large are refused when they are read.
    std::uint64_t ofAccessor(int accessor) const {
        if (accessor < 0) return 0;
        const tinygltf::Accessor& source = accessors_.at(static_cast<std::size_t>(accessor));
        return source.bufferView < 0 && source.count <= maxElementsWithoutView ? source.count : 0;
    }

    std::uint64_t ofAttributes(const std::map<std::string, int>& attributes) const {
        std::uint64_t count = 0;
        for (const auto& [name, accessor] : attributes) count += ofAccessor(accessor);
        return count;
    }

    std::size_t sizeOf(const std::map<std::string, int>& attributes) const {
        const auto position = attributes.find("POSITION");
        if (position == attributes.end()) return 0;
        return accessors_.at(static_cast<std::size_t>(position->second)).count;
    }

    /// A morph target gets an offset for each vertex, also where it is left out.
    std::uint64_t ofTargets(const tinygltf::Primitive& primitive) const {
        const std::size_t vertices = sizeOf(primitive.attributes);
        std::uint64_t count = 0;
        for (const auto& target : primitive.targets)
            count += ofAttributes(target) + (sizeOf(target) == vertices ? 0 : vertices);
        return count;
    }

    const std::vector<tinygltf::Accessor>& accessors_;
    std::set<VertexAccessors> known_;
};

}  // namespace

void limitAbsentElements(Document& document) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < document.model.meshes.size(); ++i) {
        const tinygltf::Mesh& mesh = document.model.meshes[i];
        AbsentElements absent(document);
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            const std::uint64_t count = absent.count(mesh.primitives[p]);
            if (count <= maxAbsentElements - sum) {
                sum += count;
                continue;
            }
            const std::string element =
                elementName("mesh", i, mesh.name) + ", primitive " + std::to_string(p);
            document.faults.emplace(
                element, Failure{element, "reads " + std::to_string(count) +
                                              " elements that the file does not hold, expected at most " +
                                              std::to_string(maxAbsentElements) + " in all primitives"});
        }
    }
}

Numbers<std::uint32_t> findCorners(const Document& document, const tinygltf::Primitive& primitive,
                                   std::uint32_t vertices, const std::string& element) {
    const int accessor = accessorOf(primitive, indicesAttribute);
    if (accessor >= 0) return findIndices(document, accessor, element + ", indices");
    std::vector<std::uint32_t> corners(vertices);
    std::iota(corners.begin(), corners.end(), 0u);
    return Numbers(std::move(corners));
}

void requireCornersBelow(std::uint32_t vertices, std::span<const std::uint32_t> corners,
                         const std::string& element) {
    const std::string where = element + ", indices";
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] < vertices) continue;
        throw Failure{where, "index " + std::to_string(corners[i]) + " at position " + std::to_string(i) +
                                 ", but the primitive has " + std::to_string(vertices) + " vertices"};
    }
}

namespace {

std::vector<std::uint32_t> fromStrip(const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve((corners.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        // Every other triangle of a strip has the opposite winding.
        const std::size_t odd = i % 2;
        triangles.insert(triangles.end(), {corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    }
    return triangles;
}

std::vector<std::uint32_t> fromFan(const std::vector<std::uint32_t>& corners) {
    std::vector<std::uint32_t> triangles;
    triangles.reserve((corners.size() - 2) * 3);
    for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
        triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    }
    return triangles;
}

}  // namespace

bool hasTriangles(int mode) {
    return mode >= TINYGLTF_MODE_TRIANGLES;
}

std::vector<std::uint32_t> triangulate(int mode, std::vector<std::uint32_t> corners,
                                       const std::string& element) {
    const std::string count = "has " + std::to_string(corners.size()) + " corners, expected ";
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        if (corners.size() % 3 != 0) throw Failure{element, count + "a multiple of 3"};
        return corners;
    }
    if (corners.size() < 3) throw Failure{element, count + "3 or more"};
    return mode == TINYGLTF_MODE_TRIANGLE_STRIP ? fromStrip(corners) : fromFan(corners);
}

Polygons polygonsOfTriangles(std::vector<std::uint32_t> triangles) {
    Polygons polygons;
    polygons.sizes.assign(triangles.size() / 3, 3u);
    polygons.corners = std::move(triangles);
    return polygons;
}

Polygons recoverPolygons(const std::vector<std::uint32_t>& triangles, const std::string& element) {
    Polygons polygons;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const bool continues = i > 0 && triangles[i] == triangles[i - 3];
        if (!continues) {
            polygons.sizes.push_back(3);
            polygons.corners.insert(polygons.corners.end(), &triangles[i], &triangles[i] + 3);
            continue;
        }
        if (triangles[i + 1] != triangles[i - 1]) {
            throw Failure{
                element + ", FB_ngon_encoding",
                "triangle " + std::to_string(i / 3) + " begins at vertex " + std::to_string(triangles[i]) +
                    " like the one before, and continues with vertex " + std::to_string(triangles[i + 1]) +
                    ", expected " + std::to_string(triangles[i - 1])};
        }
        ++polygons.sizes.back();
        polygons.corners.push_back(triangles[i + 2]);
    }
    return polygons;
}

}  // namespace candela_plugins::gltf
