#include "render/culling/filter_view.h"

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

/// The sum of the absolute terms of a product: what rounding is relative to.
double termsOf(const glm::dvec4& row, const glm::dvec4& reach) {
    return glm::dot(glm::abs(row), reach);
}

/// The point that three rows send to 0, the centre of projection: the minors of the matrix, signed so that
/// the doubled area of a triangle on the screen, times the w of its corners, is the dot product of its
/// doubled area vector and the way from this point to a corner.
glm::dvec4 eyeOf(const glm::dvec4 (&rows)[3]) {
    glm::dvec4 eye;
    for (int i = 0; i < 4; ++i) {
        glm::dmat3 minor;
        for (int k = 0; k < 3; ++k)
            for (int column = 0; column < 3; ++column)
                minor[k][column] = rows[k][column < i ? column : column + 1];
        eye[i] = glm::determinant(minor) * (i % 2 == 0 ? -1.0 : 1.0);
    }
    return eye;
}

/// Of window coordinates.
int subpixelBits() {
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return bits;
}

}  // namespace

FilterCamera::FilterCamera(const layout::FrameUniforms& frame)
    : width_(static_cast<float>(frame.size.x)),
      height_(static_cast<float>(frame.size.y)),
      // A rasteriser rounds to the nearest: by half of this. The rest is for what the viewport transform
      // rounds.
      snapping_(std::ldexp(1.0f, -subpixelBits())) {
    const glm::dmat4 clip = glm::transpose(glm::dmat4(frame.clipFromWorld));
    toScreen_[0] = 0.5 * frame.size.x * (clip[0] + clip[3]);
    toScreen_[1] = 0.5 * frame.size.y * (clip[1] + clip[3]);
    toScreen_[2] = clip[3];
    const bool orthographic = frame.depthRange.w != 0.0f;
    nearDepth_ = orthographic ? -std::numeric_limits<float>::infinity() : frame.eye.w;
}

layout::FilterView FilterCamera::view(std::span<const glm::vec4> worldRows, const BoundingSphere& sphere,
                                      float facing) const {
    // The device computes two products of four terms each, and rounds 8 times half a unit in the last place
    // of the largest sum of terms. The filter rounds the matrix and one product, 5 times. Clipping at the
    // near plane rounds 4 times.
    constexpr double unit = 20.0 / 16777216.0;
    const glm::dvec4 local(glm::dvec3(glm::abs(sphere.center)) + static_cast<double>(sphere.radius), 1.0);
    glm::dvec4 world[3], reach(1.0), rows[3];
    for (int i = 0; i < 3; ++i) {
        world[i] = glm::dvec4(worldRows[static_cast<std::size_t>(i)]);
        reach[i] = termsOf(world[i], local);
    }
    layout::FilterView view{};
    for (int k = 0; k < 3; ++k) {
        const glm::dvec4& to = toScreen_[k];
        rows[k] = to.x * world[0] + to.y * world[1] + to.z * world[2] + glm::dvec4(0, 0, 0, to.w);
        for (int i = 0; i < 4; ++i) view.rows[k][i] = static_cast<float>(rows[k][i]);
    }
    const double depthError = unit * termsOf(toScreen_[2], reach);
    // The device computes x and w before they are added, and y alike.
    view.screenError =
        static_cast<float>(std::max(unit * termsOf(toScreen_[0], reach) + width_ * depthError,
                                    unit * termsOf(toScreen_[1], reach) + height_ * depthError));
    view.depthError = static_cast<float>(depthError);
    view.nearDepth = nearDepth_;
    view.width = width_;
    view.height = height_;
    view.snapping = snapping_;
    view.facing = facing;
    const glm::dvec4 eye = eyeOf(rows);
    for (int i = 0; i < 4; ++i) view.eye[i] = static_cast<float>(eye[i]);
    const glm::dvec4 parts = glm::abs(eye) + std::abs(eye.w) * glm::dvec4(glm::dvec3(local), 0.0);
    view.eyeError = static_cast<float>(1.0e-6 * (parts.x + parts.y + parts.z));
    const glm::dvec3 x(rows[0]), y(rows[1]), w(rows[2]);
    view.xx = static_cast<float>(glm::dot(x, x));
    view.xy = static_cast<float>(glm::dot(x, y));
    view.xw = static_cast<float>(glm::dot(x, w));
    view.yy = static_cast<float>(glm::dot(y, y));
    view.yw = static_cast<float>(glm::dot(y, w));
    view.ww = static_cast<float>(glm::dot(w, w));
    view.lengthW = static_cast<float>(glm::length(w));
    return view;
}

}  // namespace candela
