#pragma once

#include "gl/context_binding.h"

#include <epoxy/gl.h>

#include <array>

namespace candela::gl {

/// How many units and bindings candela's passes use; of these the guard keeps no more.
constexpr int textureUnits = 24;
constexpr int uniformBindings = 2;
constexpr int storageBindings = 8;
constexpr int imageUnits = 4;
/// How many draw buffers and viewports OpenGL 4.5 promises. Calls without an index, which candela's passes
/// make, set all of them.
constexpr int drawBuffers = 8;
constexpr int viewports = 16;

/// Begins the use of a context: sets the state that candela's passes rely on. In a host's context it also
/// keeps the state that the passes change, and puts it back at the end of the scope; no host relies on the
/// state of an owned one.
class StateGuard {
  public:
    /// Throws `Error` (environment) naming `user`, such as "Renderer", unless the context is current on this
    /// thread.
    StateGuard(const ContextBinding& binding, const char* user);
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;
    ~StateGuard();

    /// Sets the state that candela's passes rely on, once more: after a host has drawn within the scope.
    static void setDefaults();

  private:
    struct TextureUnit {
        GLint texture1d, texture2d, texture3d, textureBuffer, texture2dArray, sampler;
    };
    struct IndexedBuffer {
        GLint buffer;
        GLint64 start, size;
    };
    struct ImageUnit {
        GLint name, level, layered, layer, access, format;
    };

    struct DrawBuffer {
        GLboolean blend;
        std::array<GLboolean, 4> colorMask;
        std::array<GLint, 6> factors;
    };
    struct Viewport {
        GLboolean scissor;
        std::array<GLfloat, 4> rectangle;
        std::array<GLdouble, 2> depthRange;
        std::array<GLint, 4> scissorBox;
    };

    void keepCapabilities();
    void keepBindings();
    void keepFixedFunction();
    void keepDrawBuffers();
    void keepViewports();
    void restoreCapabilities() const;
    void restoreBindings() const;
    void restoreFixedFunction() const;
    void restoreDrawBuffers() const;
    void restoreViewports() const;

    bool restores_;
    std::array<GLboolean, 28> capabilities_{};
    GLint program_ = 0, pipeline_ = 0, vertexArray_ = 0, drawFramebuffer_ = 0, readFramebuffer_ = 0,
          activeTexture_ = 0;
    GLint arrayBuffer_ = 0, indirectBuffer_ = 0, dispatchBuffer_ = 0, packBuffer_ = 0, unpackBuffer_ = 0,
          queryBuffer_ = 0;
    GLint uniformBuffer_ = 0, storageBuffer_ = 0;
    std::array<TextureUnit, textureUnits> units_{};
    std::array<IndexedBuffer, uniformBindings> uniforms_{};
    std::array<IndexedBuffer, storageBindings> storage_{};
    std::array<ImageUnit, imageUnits> images_{};
    std::array<DrawBuffer, drawBuffers> drawBuffers_{};
    std::array<Viewport, viewports> viewports_{};
    std::array<GLfloat, 4> clearColor_{};
    std::array<GLint, 7> stencilFront_{}, stencilBack_{};
    std::array<GLint, 2> clipControl_{};
    std::array<GLint, 14> packing_{};
    GLint depthFunction_ = 0, cullFace_ = 0, frontFace_ = 0, polygonMode_ = 0, provokingVertex_ = 0;
    GLfloat lineWidth_ = 1.0f;
    GLboolean depthMask_ = GL_TRUE;
};

}  // namespace candela::gl
