#pragma once

#include "gl/external_memory.h"

#include <future>
#include <optional>

namespace candela {

/// Finds the device in whose memory a renderer's targets can be mapped, so that lighting on the CPU reads
/// them in place. That takes longer than a frame and is done once in a process, on another thread, from the
/// third frame on: who draws less gains nothing from it.
class TargetMemory {
  public:
    /// In the current context. Devices that are not software keep their targets to themselves.
    explicit TargetMemory(bool isSoftware);

    /// Counts a frame that is lit on the CPU. Null until the device is found, and where there is none.
    const gl::ExternalMemoryDevice* countFrame();
    /// Waits for the device, if it is being looked for.
    const gl::ExternalMemoryDevice* device() const;

  private:
    std::optional<gl::DeviceUuids> uuids_;  ///< Without: the driver imports nothing.
    int frames_ = 0;
    std::shared_future<const gl::ExternalMemoryDevice*> found_;
};

}  // namespace candela
