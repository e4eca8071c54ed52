#include "device_option.h"

#include "parse.h"
#include "program.h"

#include <candela/error.h>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <vector>

namespace {

/// The slots of GNU parallel count from 1.
std::optional<std::uint64_t> parallelSlot() {
    const char* text = std::getenv("PARALLEL_JOBSLOT");
    if (text == nullptr) return std::nullopt;
    const std::string_view digits(text);
    std::uint64_t slot = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), slot);
    if (error != std::errc{} || end != digits.data() + digits.size() || slot == 0) return std::nullopt;
    return slot - 1;
}

std::uint64_t turnOf(std::optional<std::uint64_t> shard) {
    if (const auto slot = parallelSlot()) return *slot;
    return shard.value_or(static_cast<std::uint64_t>(getpid()));
}

/// The numbers of the GPUs, beginning with that of the turn.
std::vector<int> gpusFrom(std::uint64_t turn) {
    std::vector<int> gpus;
    for (const candela::Device& device : candela::listDevices())
        if (!device.software) gpus.push_back(device.index);
    if (!gpus.empty())
        std::ranges::rotate(gpus, gpus.begin() + static_cast<std::ptrdiff_t>(turn % gpus.size()));
    return gpus;
}

}  // namespace

DeviceOption parseDevice(const std::string& option, const std::string& text) {
    if (text == "software") return {.options = {.index = std::nullopt, .softwareOnly = true}};
    if (text == "auto") return {.options = {}, .takesTurns = true};
    if (text.empty() || !std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; }))
        throw UsageError(option + " \"" + text +
                         "\": expected \"software\", \"auto\" or a number that --list devices shows");
    const auto index = parseInteger(option, text, 0, std::numeric_limits<int>::max());
    return {.options = {.index = static_cast<int>(index), .softwareOnly = false}};
}

DeviceOption chooseDevice(const std::optional<DeviceOption>& given) {
    if (given) return *given;
    const char* text = std::getenv("CANDELA_DEVICE");
    return text == nullptr || *text == '\0' ? DeviceOption{} : parseDevice("CANDELA_DEVICE", text);
}

candela::Context createContext(const DeviceOption& device, std::optional<std::uint64_t> shard) {
    if (!device.takesTurns) return candela::Context::createHeadless(device.options);
    for (const int gpu : gpusFrom(turnOf(shard))) {
        try {
            return candela::Context::createHeadless({.index = gpu, .softwareOnly = false});
        } catch (const candela::Error&) {
            continue;  // Such as a GPU that the scheduler has given to another job.
        }
    }
    return candela::Context::createHeadless();
}
