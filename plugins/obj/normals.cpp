#include "normals.h"

#include <numbers>

#include "numbering.h"
#include "vectors.h"

namespace candela_obj {
namespace {

Vector newellNormal(const Document& document, std::size_t face) {
    const Corner* const corners = &document.corners[document.faces[face].firstCorner];
    const std::uint32_t count = document.cornerCount(face);
    // Relative to the first corner, for the sake of small faces far away.
    const Vector origin(document.positions[corners[0].vertex]);
    Vector sum;
    Vector before;
    for (std::uint32_t i = 1; i < count; ++i) {
        const Vector here = Vector(document.positions[corners[i].vertex]) - origin;
        sum = sum + cross(before, here);
        before = here;
    }
    return normalized(sum);
}

/// The inner angle of a polygon at `here`, 0 to 2 pi.
double angleAt(const Vector& before, const Vector& here, const Vector& after, const Vector& normal) {
    const Vector in = before - here, out = after - here;
    const double angle = std::atan2(dot(cross(out, in), normal), dot(out, in));
    return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

class Smoothing {
  public:
    explicit Smoothing(Document& document) : document_(document) {}

    void addFace(std::size_t face, std::uint32_t group) {
        const Vector normal = newellNormal(document_, face);
        const std::uint32_t count = document_.cornerCount(face);
        Corner* const corners = &document_.corners[document_.faces[face].firstCorner];
        const auto position = [&](std::uint32_t i) { return Vector(document_.positions[corners[i].vertex]); };
        for (std::uint32_t i = 0; i < count; ++i) {
            const double angle =
                angleAt(position((i + count - 1) % count), position(i), position((i + 1) % count), normal);
            const std::uint32_t number = numbering_.numberOf({corners[i].vertex, group, 0});
            if (number == sums_.size()) sums_.emplace_back();
            sums_[number] = sums_[number] + angle * normal;
            corners[i].normal = first_ + number;
        }
    }

    void finish() {
        for (const Vector& sum : sums_) document_.normals.push_back(Vec3(normalized(sum)));
    }

  private:
    Document& document_;
    Numbering numbering_;
    std::vector<Vector> sums_;
    const std::uint32_t first_ = static_cast<std::uint32_t>(document_.normals.size());
};

}  // namespace

Vec3 faceNormal(const Document& document, std::size_t face) {
    return Vec3(newellNormal(document, face));
}

void addSmoothNormals(Document& document) {
    Smoothing smoothing(document);
    for (std::size_t face = 0; face < document.faces.size(); ++face) {
        const std::uint32_t group = document.stateOf(face).smoothing;
        const bool hasNormals = document.corners[document.faces[face].firstCorner].normal != none;
        if (group != 0 && !hasNormals) smoothing.addFace(face, group);
    }
    smoothing.finish();
}

}  // namespace candela_obj
