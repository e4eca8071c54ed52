#pragma once

#include <epoxy/gl.h>

#include <map>
#include <string>
#include <vector>

namespace candela::test {

/// The state of the current context, by name.
using GlState = std::map<std::string, std::vector<double>>;

GlState queryState();

/// The names of the differing state, with both values.
std::vector<std::string> differences(const GlState& before, const GlState& after);

/// Binds objects of a host everywhere, and sets every other piece of state to a value that no pass of candela
/// sets. The objects live as long as this one.
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
