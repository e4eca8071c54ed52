#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace candela::gl {

/// What Vulkan and OpenGL know a device and its driver by (GL_DEVICE_UUID_EXT and GL_DRIVER_UUID_EXT).
struct DeviceUuids {
    std::array<std::uint8_t, 16> device{}, driver{};

    bool operator==(const DeviceUuids&) const = default;
};

/// Memory of the host that is mapped into the program and that OpenGL can import.
class ExternalMemory {
  public:
    virtual ~ExternalMemory() = default;

    virtual std::byte* data() const = 0;
    virtual std::size_t size() const = 0;
    /// A new file descriptor of the memory, for glImportMemoryFdEXT; -1 where it fails.
    virtual int exportDescriptor() const = 0;
};

/// Allocates memory that an OpenGL driver imports. OpenGL itself has none to export and no way to map a
/// texture; the Vulkan device of the same driver has.
class ExternalMemoryDevice {
  public:
    virtual ~ExternalMemoryDevice() = default;

    /// Null where it fails. The device outlives it.
    virtual std::unique_ptr<ExternalMemory> allocate(std::size_t bytes) const = 0;

    /// The Vulkan device with these UUIDs, if it is a CPU that exports memory by file descriptors; else, and
    /// in a library that is built without Vulkan, null. Uses no OpenGL. The first call loads all Vulkan
    /// drivers, which takes 30 to 80 ms; what it finds is kept until the process ends.
    static const ExternalMemoryDevice* find(const DeviceUuids& uuids);
};

}  // namespace candela::gl
