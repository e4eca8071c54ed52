#pragma once

#include <epoxy/gl.h>

#include <map>
#include <string>
#include <vector>

namespace candela::test {

/// Everything about the current context that a host could notice to have changed, by name.
using GlState = std::map<std::string, std::vector<double>>;

GlState queryState();

/// The names of what differs, with both values.
std::vector<std::string> differences(const GlState& before, const GlState& after);

/// Objects of a host, bound everywhere, and every other piece of state set to what no pass of candela would
/// set. They live as long as the object.
class UnusualState {
  public:
    UnusualState();
    UnusualState(const UnusualState&) = delete;
    UnusualState& operator=(const UnusualState&) = delete;
    ~UnusualState();

  private:
    void makeObjects();
    void bindObjects() const;
    void bindUnits() const;
    void setFixedFunction() const;
    void setPerBuffer() const;

    GLuint program_ = 0, pipeline_ = 0, pipelineProgram_ = 0, vertexArray_ = 0, renderbuffer_ = 0,
           sampler_ = 0;
    GLuint framebuffers_[2]{}, textures_[8]{}, buffers_[8]{};
};

}  // namespace candela::test
