#pragma once

#include <candela/context.h>

#include <cstdint>
#include <optional>
#include <string>

/// --device.
struct DeviceOption {
    candela::DeviceOptions options;
    bool takesTurns = false;  ///< "auto": processes share the GPUs of the machine.
};

/// "software", "auto" or the number of a device. Throws `UsageError` that names `option`.
DeviceOption parseDevice(const std::string& option, const std::string& text);

/// `given`, or what the environment variable CANDELA_DEVICE says, or the default. Throws `UsageError` that
/// names the variable.
DeviceOption chooseDevice(const std::optional<DeviceOption>& given);

/// Creates the context that `device` asks for. Of "auto" it is on GPU number turn modulo their count, or the
/// next one that works; the default device where none does. The turn is the slot of GNU parallel
/// (PARALLEL_JOBSLOT), else `shard`, else the number of the process. Throws as
/// `candela::Context::createHeadless`.
candela::Context createContext(const DeviceOption& device, std::optional<std::uint64_t> shard = {});
