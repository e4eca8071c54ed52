#include "gl/egl.h"

namespace candela {

std::vector<Device> listDevices() {
    std::vector<Device> devices;
    for (const gl::EglDevice& device : gl::enumerateEglDevices()) devices.push_back(device.device);
    return devices;
}

}  // namespace candela
