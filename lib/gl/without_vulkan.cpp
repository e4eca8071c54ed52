// What a library that is built without the headers of Vulkan has in place of lib/gl/vulkan_memory.cpp.

#include "gl/external_memory.h"

namespace candela::gl {

const ExternalMemoryDevice* ExternalMemoryDevice::find(const DeviceUuids&) {
    return nullptr;
}

}  // namespace candela::gl
