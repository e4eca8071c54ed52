#include "own_display.h"

#include "virtual_display.h"

#include <cstdlib>
#include <stdexcept>

const std::string& takeOwnDisplay() {
    static const candela::test::VirtualDisplay display = [] {
        unsetenv("DISPLAY");
        unsetenv("WAYLAND_DISPLAY");
        return candela::test::VirtualDisplay();
    }();
    return display.unavailableReason();
}

void sendInput(const std::string& arguments) {
    // Its answer comes after the server has handled all before it. "type" takes the rest of its line as text.
    const bool types = arguments.starts_with("type");
    const std::string sync = types ? "" : " getmouselocation > /dev/null";
    if (std::system(("xdotool " + arguments + sync).c_str()) != 0)
        throw std::runtime_error("xdotool is not installed, or fails with: " + arguments);
}
