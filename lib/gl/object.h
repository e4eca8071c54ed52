#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace candela::gl {

/// Move-only owner of the name of a GL object, which `destroy` deletes.
template <void (*destroy)(GLuint)>
class Object {
  public:
    Object() = default;
    explicit Object(GLuint name) : name_(name) {}
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() {
        if (name_ != 0) destroy(name_);
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    GLuint name_ = 0;
};

}  // namespace candela::gl
