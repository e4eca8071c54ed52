// Prints the reports of a registry with the default folders, one a line: "STATE NAME FILE".
#include <candela/error.h>
#include <candela/plugin_registry.h>

#include <iostream>

int main() {
    try {
        const candela::PluginRegistry registry;
        for (const candela::PluginReport& report : registry.reports())
            std::cout << toString(report.state) << ' ' << report.name << ' ' << report.file.string() << '\n';
        return 0;
    } catch (const candela::Error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
