#include "setup.h"

#include <candela/version.h>

#include <epoxy/gl.h>
#include <sys/utsname.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <thread>

namespace {

/// The processor's name as the kernel tells it; empty where it does not.
std::string cpuName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != line.npos) return line.substr(colon + 2);
    }
    return "";
}

std::string systemName() {
    utsname names{};
    if (uname(&names) != 0) return "";
    return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

}  // namespace

std::string setupJson(const BenchOptions& options) {
    const nlohmann::ordered_json setup{
        {"version", CANDELA_VERSION},
        {"cpu", cpuName()},
        {"cores", std::thread::hardware_concurrency()},
        {"system", systemName()},
        {"opengl", reinterpret_cast<const char*>(glGetString(GL_VERSION))},
        {"brdf", candela::toString(options.brdf)},
        {"view", options.view.value_or("")},
    };
    return setup.dump();
}
