#include "commands.h"

#include <candela/color.h>
#include <candela/context.h>
#include <candela/error.h>
#include <candela/plugin_registry.h>

#include <iostream>
#include <string>
#include <vector>

namespace {

std::string joined(const std::vector<std::string>& parts, const std::string& before) {
    std::string text;
    for (const std::string& part : parts) text += " " + before + part;
    return text;
}

std::string services(const candela::PluginReport& report) {
    std::string read = joined(report.extensions, ".");
    for (const std::string& scheme : report.schemes) read += " " + scheme + ":";
    return (read.empty() ? "" : ", reads" + read) + (report.subdivides ? ", refines subdivision cages" : "") +
           (report.decodesImages ? ", decodes images" : "");
}

void printPlugins(const Options& options) {
    const candela::PluginRegistry registry(options.pluginFolders);
    for (const candela::PluginReport& report : registry.reports()) {
        std::cout << report.file.string() << ": " << candela::toString(report.state);
        if (!report.name.empty()) std::cout << ", " << report.name << " " << report.version;
        if (report.state == candela::PluginState::loaded)
            std::cout << services(report) << ", " << report.description;
        else
            std::cout << ", " << report.detail;
        std::cout << "\n";
        for (const candela::PluginOption& option : report.options)
            std::cout << "  ?" << candela::usageOf(option) << ": " << option.help << "\n";
    }
    if (registry.reports().empty()) std::cout << "no plugins found\n";
}

/// The renderer that a context on the device gets, or why there is none.
std::string tryDevice(const candela::DeviceOptions& options) {
    try {
        return candela::Context::createHeadless(options).renderer();
    } catch (const candela::Error& error) {
        return std::string("unusable: ") + error.what();
    }
}

void printDefaultAttempts() {
    try {
        const candela::Context context = candela::Context::createHeadless();
        std::cout << "without --device, in this order:\n";
        for (const candela::ContextAttempt& attempt : context.attempts())
            std::cout << "  " << attempt.way << ": " << attempt.outcome << "\n";
    } catch (const candela::Error& error) {
        std::cout << "without --device: " << error.what() << "\n";
    }
}

void printDevices() {
    const std::vector<candela::Device> devices = candela::listDevices();
    for (const candela::Device& device : devices)
        std::cout << device.index << "  " << device.description << ": "
                  << tryDevice({.index = device.index, .softwareOnly = false}) << "\n";
    if (devices.empty()) std::cout << "EGL lists no devices on this machine\n";
    printDefaultAttempts();
}

const char* markDefault(bool isDefault) {
    return isDefault ? "  (default)" : "";
}

void printDisplays(const candela::ColorConfig& config) {
    for (const std::string& display : config.displays())
        std::cout << display << markDefault(display == config.defaultDisplay()) << "\n";
}

void printViews(const candela::ColorConfig& config, const std::string& wanted) {
    const std::vector<std::string> displays = wanted.empty() ? config.displays() : std::vector{wanted};
    for (const std::string& display : displays) {
        const std::vector<std::string> views = config.views(display);
        std::cout << display << "\n";
        for (const std::string& view : views)
            std::cout << "  " << view << markDefault(view == config.defaultView(display)) << "\n";
    }
}

}  // namespace

void printList(const Options& options) {
    switch (*options.list) {
        case ListKind::plugins:
            return printPlugins(options);
        case ListKind::devices:
            return printDevices();
        case ListKind::displays:
            return printDisplays(candela::ColorConfig::choose(options.ocio));
        case ListKind::views:
            return printViews(candela::ColorConfig::choose(options.ocio), options.display.display);
        default:
            return printSceneList(options);
    }
}
