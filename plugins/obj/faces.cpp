#include <algorithm>
#include <cmath>
#include <iterator>

#include "document.h"
#include "statement.h"

namespace candela_plugins::obj {
namespace {

std::string placeOf(const Face& face) {
    return "line " + std::to_string(face.line);
}

std::string countOf(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " is there" : " are there");
}

bool isNan(const Vec3& v) {
    return std::isnan(v.x);
}
bool isNan(const Vec2& v) {
    return std::isnan(v.x);
}

template <class T>
bool anyNan(const std::vector<T>& values) {
    return std::any_of(values.begin(), values.end(), [](const T& value) { return isNan(value); });
}

class FaceRepair {
  public:
    FaceRepair(Document& document, Surface surface)
        : document_(document),
          surface_(surface),
          hasNanUvs_(anyNan(document.uvs)),
          hasNanNormals_(anyNan(document.normals)) {}

    void run() {
        const std::size_t count = document_.faces.size();
        std::size_t kept = 0;
        std::uint32_t written = 0;
        for (std::size_t i = 0; i < count; ++i) {
            Face face = document_.faces[i];
            const std::uint32_t size = cornersOf(i);
            Corner* const corners = document_.corners.data() + face.firstCorner;
            const std::uint32_t left = repair(face, corners, size);
            if (left == 0) {
                document_.leftOutFaces.push_back(static_cast<std::uint32_t>(i));
                continue;
            }
            // The faces before are never larger than they were: nothing that is still to be read is
            // overwritten.
            std::copy(corners, corners + left, document_.corners.data() + written);
            face.firstCorner = written;
            document_.faces[kept++] = face;
            written += left;
        }
        document_.faces.resize(kept);
        document_.corners.resize(written);
        if (kept == 0 && document_.looseElements.empty() && firstFault_) throw *firstFault_;
    }

    void addNotes(const Host& host) const { notes_.add(host, ""); }

  private:
    /// Of a face that has not been reached yet.
    std::uint32_t cornersOf(std::size_t face) const { return document_.cornerCount(face); }

    /// Returns the number of corners that are left; 0 to leave out the face.
    std::uint32_t repair(const Face& face, Corner* corners, std::uint32_t size) {
        if (!hasVertices(face, corners, size)) return 0;
        if (size < 3) return tooFew(face, size);
        if (surface_ == Surface::cages) size = withoutRepeats(face, corners, size);
        if (size == 0) return 0;
        keepUvs(face, corners, size);
        keepNormals(face, corners, size);
        return size;
    }

    bool hasVertices(const Face& face, const Corner* corners, std::uint32_t size) {
        for (std::uint32_t i = 0; i < size; ++i) {
            const std::uint32_t vertex = corners[i].vertex;
            if (vertex >= document_.positions.size()) {
                leaveOut(face,
                         vertex == none ? "left out: faces with a corner that cannot be read"
                                        : "left out: faces with a vertex that is not there",
                         rangeFault(face, vertex));
                return false;
            }
            if (document_.vertexFault && isNan(document_.positions[vertex])) {
                leaveOut(face, "left out: faces with a vertex without usable coordinates",
                         document_.vertexFault->failure);
                return false;
            }
        }
        return true;
    }

    Failure rangeFault(const Face& face, std::uint32_t vertex) const {
        if (document_.faceFault && document_.faceFault->line == face.line)
            return document_.faceFault->failure;
        return {placeOf(face), "f: vertex " + std::to_string(std::uint64_t{vertex} + 1) + ", but " +
                                   countOf(document_.positions.size())};
    }

    std::uint32_t tooFew(const Face& face, std::uint32_t size) {
        leaveOut(face, "not drawn: faces of fewer than 3 corners",
                 {placeOf(face), "f: " + std::to_string(size) + " corners, but 3 or more were expected"});
        return 0;
    }

    void leaveOut(const Face& face, const char* text, const Failure& failure) {
        notes_.count(CANDELA_NOTE_MISSING, text, face.line);
        if (!firstFault_) firstFault_ = failure;
    }

    /// A cage takes no vertex twice in a face. Corners that repeat the one before shape nothing.
    std::uint32_t withoutRepeats(const Face& face, Corner* corners, std::uint32_t size) {
        const auto isSame = [](const Corner& a, const Corner& b) { return a.vertex == b.vertex; };
        auto end = std::unique(corners, corners + size, isSame);
        while (end - corners > 1 && isSame(*corners, *(end - 1))) --end;
        std::vector<std::uint32_t>& vertices = scratch_;
        vertices.clear();
        std::transform(corners, end, std::back_inserter(vertices), [](const Corner& c) { return c.vertex; });
        std::sort(vertices.begin(), vertices.end());
        if (std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end()) {
            const auto left = static_cast<std::uint32_t>(vertices.size());
            return left < 3 ? tooFew(face, left) : left;
        }
        leaveOut(face, "left out: faces that pass through a vertex twice",
                 {placeOf(face), "f: passes through a vertex twice, which no face of a cage does"});
        return 0;
    }

    void keepUvs(const Face& face, Corner* corners, std::uint32_t size) {
        const auto isUsable = [&](const Corner& corner) {
            return corner.uv < document_.uvs.size() && !(hasNanUvs_ && isNan(document_.uvs[corner.uv]));
        };
        keepAllOrNone(face, corners, size, &Corner::uv, isUsable,
                      "without texture coordinates: faces that have none for each corner");
    }

    void keepNormals(const Face& face, Corner* corners, std::uint32_t size) {
        // The normals of a cage come from its surface.
        if (surface_ == Surface::cages) return;
        const auto isUsable = [&](const Corner& corner) {
            return corner.normal < document_.normals.size() &&
                   !(hasNanNormals_ && isNan(document_.normals[corner.normal]));
        };
        keepAllOrNone(face, corners, size, &Corner::normal, isUsable,
                      "without their normals: faces that have none for each corner");
    }

    template <class IsUsable>
    void keepAllOrNone(const Face& face, Corner* corners, std::uint32_t size,
                       std::uint32_t Corner::*attribute, const IsUsable& isUsable, const char* text) {
        if (std::all_of(corners, corners + size, isUsable)) return;
        bool wasGiven = false;
        for (std::uint32_t i = 0; i < size; ++i) {
            wasGiven |= corners[i].*attribute != none;
            corners[i].*attribute = none;
        }
        if (wasGiven) notes_.count(CANDELA_NOTE_REPAIRED, text, face.line);
    }

    Document& document_;
    const Surface surface_;
    const bool hasNanUvs_, hasNanNormals_;
    LineNotes notes_;
    std::optional<Failure> firstFault_;
    std::vector<std::uint32_t> scratch_;
};

}  // namespace

void repairFaces(Document& document, Surface surface, const Host& host) {
    FaceRepair repair(document, surface);
    repair.run();
    repair.addNotes(host);
}

}  // namespace candela_plugins::obj
