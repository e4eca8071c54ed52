#include "render/gbuffer/target_memory.h"

#include "gl/mapped_texture.h"

#include <chrono>
#include <cstdlib>
#include <string_view>

namespace candela {

namespace {

constexpr int firstMappedFrame = 3;

bool isTurnedOff() {
    const char* value = std::getenv("CANDELA_MAPPED_TARGETS");
    return value != nullptr && std::string_view(value) == "0";
}

}  // namespace

TargetMemory::TargetMemory(bool isSoftware) {
    if (isSoftware && !isTurnedOff()) uuids_ = gl::importingDevice();
}

const gl::ExternalMemoryDevice* TargetMemory::countFrame() {
    if (!uuids_ || (frames_ < firstMappedFrame && ++frames_ < firstMappedFrame)) return nullptr;
    if (!found_.valid()) {
        found_ = std::async(std::launch::async, [uuids = *uuids_] {
                     return gl::ExternalMemoryDevice::find(uuids);
                 }).share();
    }
    return found_.wait_for(std::chrono::seconds(0)) == std::future_status::ready ? found_.get() : nullptr;
}

const gl::ExternalMemoryDevice* TargetMemory::device() const {
    return found_.valid() ? found_.get() : nullptr;
}

}  // namespace candela
