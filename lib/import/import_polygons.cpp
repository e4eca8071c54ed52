#include "import/import_polygons.h"

#include "scene/geometry/triangulate.h"

#include <candela/error.h>

#include <algorithm>
#include <limits>

namespace candela {

PushedPolygons::PushedPolygons(const candela_mesh& pushed, const AbiReader& element) : element_(element) {
    starts_.reserve(std::size_t{pushed.face_count} + 1);
    std::uint64_t end = 0;
    for (std::uint32_t face = 0; face < pushed.face_count; ++face) {
        const std::uint32_t size = pushed.face_sizes[face];
        if (size < 3)
            element.refuse(joined("face ", face, " has ", size, " corners, but 3 or more were expected"));
        starts_.push_back(static_cast<std::uint32_t>(end));
        end += size;
        // Beyond this `end` would not fit `starts_`.
        if (end > pushed.index_count) break;
    }
    if (end != pushed.index_count)
        element.refuse(joined("its face_sizes add up to ", end > pushed.index_count ? "more than " : "",
                              std::min<std::uint64_t>(end, pushed.index_count), ", but index_count is ",
                              pushed.index_count));
    starts_.push_back(pushed.index_count);
    if (3 * (end - 2 * std::uint64_t{pushed.face_count}) > std::numeric_limits<std::uint32_t>::max())
        throw Error(ErrorKind::limit, "",
                    element.label() + ": cut into triangles it has more indices than 32 bits can count");
}

void PushedPolygons::cut(Mesh& mesh) const {
    const auto faces = static_cast<std::uint32_t>(starts_.size() - 1);
    std::vector<std::uint32_t> cut, triangles;
    std::vector<glm::vec3> corners;
    cut.reserve(indexOf(faces));
    for (std::uint32_t face = 0; face < faces; ++face) {
        const std::uint32_t* vertices = mesh.indices.data() + starts_[face];
        corners.clear();
        triangles.clear();
        for (std::uint32_t i = 0; i < starts_[face + 1] - starts_[face]; ++i)
            corners.push_back(mesh.positions[vertices[i]]);
        triangulate(corners, triangles);
        for (const std::uint32_t corner : triangles) cut.push_back(vertices[corner]);
    }
    mesh.indices = std::move(cut);
}

// A face of n corners is n - 2 triangles.
std::uint32_t PushedPolygons::indexOf(std::uint32_t face) const {
    return 3 * (starts_[face] - 2 * face);
}

std::uint32_t PushedPolygons::faceBeginningAt(std::uint64_t corner, const std::string& what) const {
    const auto after = std::upper_bound(starts_.begin(), starts_.end(), corner);
    const auto face = static_cast<std::uint32_t>(after - starts_.begin() - 1);
    if (starts_[face] != corner)
        element_.refuse(joined(what, corner, ", which is within face ", face, ", but a border was expected"));
    return face;
}

Submesh PushedPolygons::translated(const Submesh& run, const std::string& label) const {
    const std::uint64_t end = std::uint64_t{run.firstIndex} + run.indexCount;
    if (end > starts_.back())
        element_.refuse(
            joined(label, " ends at index ", end, ", but there are ", starts_.back(), " indices"));
    const std::uint32_t first = indexOf(faceBeginningAt(run.firstIndex, label + " begins at index "));
    const std::uint32_t last = indexOf(faceBeginningAt(end, label + " ends at index "));
    return {first, last - first, run.material};
}

}  // namespace candela
