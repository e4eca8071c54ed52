#pragma once

namespace candela::gl {

/// Names the GL commands of a scope for debuggers and traces.
class DebugGroup {
  public:
    explicit DebugGroup(const char* name);
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;
    ~DebugGroup();
};

}  // namespace candela::gl
