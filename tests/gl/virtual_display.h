#pragma once

#include <string>

#include <sys/types.h>

namespace candela::test {

/// An X display for tests of windows: that of the environment if there is one, else an Xvfb of its own, which
/// ends with the object.
class VirtualDisplay {
  public:
    VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;
    ~VirtualDisplay();

    /// Why there is no display; empty when there is one, which $DISPLAY then names.
    const std::string& unavailableReason() const { return unavailableReason_; }

  private:
    std::string start();

    pid_t server_ = -1;
    std::string unavailableReason_;
};

}  // namespace candela::test
