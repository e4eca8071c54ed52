// Memory of Vulkan devices that are CPUs. libvulkan is loaded when it is first needed, so that the library
// runs without it.

#include "gl/external_memory.h"

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace candela::gl {

namespace {

constexpr VkExternalMemoryHandleTypeFlagBits handleType = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;
constexpr const char* exportExtension = VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME;

/// Functions of an instance by name.
class Instance {
  public:
    static std::optional<Instance> create() {
        // Never closed: drivers do not expect to be unloaded.
        void* library = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
        if (library == nullptr) return std::nullopt;
        Instance instance;
        instance.procedure_ =
            reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library, "vkGetInstanceProcAddr"));
        if (instance.procedure_ == nullptr) return std::nullopt;
        VkApplicationInfo application{};
        application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
        application.pApplicationName = "candela";
        application.apiVersion = VK_API_VERSION_1_1;
        VkInstanceCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
        info.pApplicationInfo = &application;
        const auto create = instance.get<PFN_vkCreateInstance>("vkCreateInstance");
        if (create == nullptr || create(&info, nullptr, &instance.handle_) != VK_SUCCESS) return std::nullopt;
        return instance;
    }

    template <typename Function>
    Function get(const char* name) const {
        return reinterpret_cast<Function>(procedure_(handle_, name));
    }

    std::vector<VkPhysicalDevice> devices() const {
        const auto enumerate = get<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
        std::uint32_t count = 0;
        if (enumerate(handle_, &count, nullptr) != VK_SUCCESS) return {};
        std::vector<VkPhysicalDevice> devices(count);
        if (enumerate(handle_, &count, devices.data()) < VK_SUCCESS) return {};
        devices.resize(count);
        return devices;
    }

    void destroy() const { get<PFN_vkDestroyInstance>("vkDestroyInstance")(handle_, nullptr); }

  private:
    PFN_vkGetInstanceProcAddr procedure_ = nullptr;
    VkInstance handle_ = VK_NULL_HANDLE;
};

/// The UUIDs of a device that is a CPU of Vulkan 1.1.
std::optional<DeviceUuids> uuidsOfCpu(const Instance& instance, VkPhysicalDevice device) {
    VkPhysicalDeviceProperties properties{};
    instance.get<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(device, &properties);
    if (properties.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU || properties.apiVersion < VK_API_VERSION_1_1)
        return std::nullopt;
    VkPhysicalDeviceIDProperties ids{};
    ids.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ID_PROPERTIES;
    VkPhysicalDeviceProperties2 all{};
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    all.pNext = &ids;
    instance.get<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(device, &all);
    DeviceUuids uuids;
    std::copy_n(ids.deviceUUID, uuids.device.size(), uuids.device.begin());
    std::copy_n(ids.driverUUID, uuids.driver.size(), uuids.driver.begin());
    return uuids;
}

/// The index of a type of memory that the host maps and that needs no flushes.
std::optional<std::uint32_t> hostMemoryType(const Instance& instance, VkPhysicalDevice device) {
    constexpr VkMemoryPropertyFlags wanted =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkPhysicalDeviceMemoryProperties memory{};
    instance.get<PFN_vkGetPhysicalDeviceMemoryProperties>("vkGetPhysicalDeviceMemoryProperties")(device,
                                                                                                 &memory);
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i)
        if ((memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    return std::nullopt;
}

bool canExport(const Instance& instance, VkPhysicalDevice device) {
    const auto enumerate =
        instance.get<PFN_vkEnumerateDeviceExtensionProperties>("vkEnumerateDeviceExtensionProperties");
    std::uint32_t count = 0;
    if (enumerate(device, nullptr, &count, nullptr) != VK_SUCCESS) return false;
    std::vector<VkExtensionProperties> extensions(count);
    if (enumerate(device, nullptr, &count, extensions.data()) < VK_SUCCESS) return false;
    return std::ranges::any_of(extensions, [](const VkExtensionProperties& extension) {
        return std::strcmp(extension.extensionName, exportExtension) == 0;
    });
}

VkDevice createDevice(const Instance& instance, VkPhysicalDevice physical) {
    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &exportExtension;
    VkDevice device = VK_NULL_HANDLE;
    const auto create = instance.get<PFN_vkCreateDevice>("vkCreateDevice");
    return create(physical, &info, nullptr, &device) == VK_SUCCESS ? device : VK_NULL_HANDLE;
}

/// A device and what is called on it.
struct Device {
    VkDevice handle = VK_NULL_HANDLE;
    std::uint32_t memoryType = 0;
    PFN_vkAllocateMemory allocate = nullptr;
    PFN_vkFreeMemory free = nullptr;
    PFN_vkMapMemory map = nullptr;
    PFN_vkGetMemoryFdKHR descriptor = nullptr;
};

class VulkanMemory final : public ExternalMemory {
  public:
    /// Takes the memory over.
    VulkanMemory(const Device& device, VkDeviceMemory memory, std::byte* data, std::size_t size)
        : device_(device), memory_(memory), data_(data), size_(size) {}
    ~VulkanMemory() override { device_.free(device_.handle, memory_, nullptr); }
    VulkanMemory(const VulkanMemory&) = delete;
    VulkanMemory& operator=(const VulkanMemory&) = delete;

    std::byte* data() const override { return data_; }
    std::size_t size() const override { return size_; }
    int exportDescriptor() const override {
        VkMemoryGetFdInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR;
        info.memory = memory_;
        info.handleType = handleType;
        int descriptor = -1;
        return device_.descriptor(device_.handle, &info, &descriptor) == VK_SUCCESS ? descriptor : -1;
    }

  private:
    const Device& device_;
    VkDeviceMemory memory_;
    std::byte* data_;
    std::size_t size_;
};

class VulkanMemoryDevice final : public ExternalMemoryDevice {
  public:
    explicit VulkanMemoryDevice(const Device& device) : device_(device) {}

    std::unique_ptr<ExternalMemory> allocate(std::size_t bytes) const override {
        VkExportMemoryAllocateInfo exported{};
        exported.sType = VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO;
        exported.handleTypes = handleType;
        VkMemoryAllocateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
        info.pNext = &exported;
        info.allocationSize = bytes;
        info.memoryTypeIndex = device_.memoryType;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        if (device_.allocate(device_.handle, &info, nullptr, &memory) != VK_SUCCESS) return nullptr;
        void* data = nullptr;
        if (device_.map(device_.handle, memory, 0, VK_WHOLE_SIZE, 0, &data) != VK_SUCCESS) {
            device_.free(device_.handle, memory, nullptr);
            return nullptr;
        }
        return std::make_unique<VulkanMemory>(device_, memory, static_cast<std::byte*>(data), bytes);
    }

  private:
    Device device_;
};

std::unique_ptr<ExternalMemoryDevice> open(const Instance& instance, VkPhysicalDevice physical) {
    const std::optional<std::uint32_t> memoryType = hostMemoryType(instance, physical);
    if (!memoryType || !canExport(instance, physical)) return nullptr;
    Device device{.handle = createDevice(instance, physical), .memoryType = *memoryType};
    if (device.handle == VK_NULL_HANDLE) return nullptr;
    const auto get = instance.get<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
    device.allocate = reinterpret_cast<PFN_vkAllocateMemory>(get(device.handle, "vkAllocateMemory"));
    device.free = reinterpret_cast<PFN_vkFreeMemory>(get(device.handle, "vkFreeMemory"));
    device.map = reinterpret_cast<PFN_vkMapMemory>(get(device.handle, "vkMapMemory"));
    device.descriptor = reinterpret_cast<PFN_vkGetMemoryFdKHR>(get(device.handle, "vkGetMemoryFdKHR"));
    return std::make_unique<VulkanMemoryDevice>(device);
}

std::unique_ptr<ExternalMemoryDevice> openDevice(const DeviceUuids& uuids) {
    const std::optional<Instance> instance = Instance::create();
    if (!instance) return nullptr;
    for (VkPhysicalDevice physical : instance->devices()) {
        if (uuidsOfCpu(*instance, physical) != uuids) continue;
        if (auto device = open(*instance, physical)) return device;
    }
    instance->destroy();
    return nullptr;
}

/// Never destroyed: textures may live as long as the process.
struct FoundDevices {
    std::mutex mutex;
    std::vector<std::pair<DeviceUuids, std::unique_ptr<ExternalMemoryDevice>>> devices;
};

FoundDevices& foundDevices() {
    static auto* const found = new FoundDevices;
    return *found;
}

}  // namespace

const ExternalMemoryDevice* ExternalMemoryDevice::find(const DeviceUuids& uuids) {
    FoundDevices& found = foundDevices();
    const std::lock_guard lock(found.mutex);
    for (const auto& [known, device] : found.devices)
        if (known == uuids) return device.get();
    return found.devices.emplace_back(uuids, openDevice(uuids)).second.get();
}

}  // namespace candela::gl
