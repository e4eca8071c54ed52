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
    if (std::system(("xdotool " + arguments).c_str()) != 0)
        throw std::runtime_error("xdotool is not installed, or fails with: " + arguments);
}
