#pragma once

#include "gl/headless_context.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace candela::gl {

/// The native context, EGL's or GLX's, that is current on this thread; null when there is none.
void* currentNativeContext();

/// The context that GL objects belong to. `Context` and everything created for it share one binding, which
/// keeps a headless context alive for as long as objects of it exist.
class ContextBinding {
  public:
    /// Takes a context of candela's own, which is current.
    explicit ContextBinding(std::unique_ptr<HeadlessContext> headless);
    /// Refers to the host's context that is current on this thread.
    ContextBinding();
    ContextBinding(const ContextBinding&) = delete;
    ContextBinding& operator=(const ContextBinding&) = delete;
    ~ContextBinding();

    /// Does candela own the context? Then no host relies on its state.
    bool isOwned() const { return headless_ != nullptr; }
    /// Do both refer to one native context? A host may adopt its context more than once.
    bool isSameAs(const ContextBinding& other) const { return native_ == other.native_; }
    bool isCurrent() const { return currentNativeContext() == native_; }
    /// Throws `Error` (environment) naming `user`, such as "Renderer", unless the context is current on this
    /// thread.
    void requireCurrent(const char* user) const;
    /// Makes an owned context current; does nothing to a host's. Throws `Error` (environment) when EGL
    /// refuses.
    void makeCurrent() const;

  private:
    friend class DestructionScope;
    bool isSameContext() const;

    std::unique_ptr<HeadlessContext> headless_;
    void* native_ = nullptr;
    std::string label_;  ///< Of the marker, unique in the process.
    GLuint marker_ = 0;  ///< A buffer that tells this context from a later one at the same address.
};

/// Makes the destruction of GL objects safe: an owned context becomes current for the scope, and a host's has
/// to be current.
class DestructionScope {
  public:
    explicit DestructionScope(const ContextBinding& binding);
    DestructionScope(const DestructionScope&) = delete;
    DestructionScope& operator=(const DestructionScope&) = delete;
    ~DestructionScope();

    /// Can objects of the context be deleted?
    bool canDelete() const { return canDelete_; }

  private:
    CurrentEglContext previous_;
    bool canDelete_ = false;
    bool restore_ = false;
};

/// Says on standard error that the GL objects of `owner` could not be deleted.
void reportLeak(const char* owner);

/// Deletes an object that owns GL objects. Where its context is gone or not current, the object is leaked
/// with a message: deleting names in another context, or in none, destroys what is not ours or ends the
/// process.
template <typename T>
struct ContextDeleter {
    std::shared_ptr<const ContextBinding> binding;
    const char* owner;  ///< As the message names it, such as "Renderer".

    void operator()(T* object) const {
        const DestructionScope scope(*binding);
        if (scope.canDelete()) {
            delete object;
        } else {
            reportLeak(owner);
        }
    }
};

}  // namespace candela::gl

namespace candela {

struct Context::State {
    std::shared_ptr<gl::ContextBinding> binding;
    std::vector<ContextAttempt> attempts;
    std::string renderer, driver;
};

}  // namespace candela
