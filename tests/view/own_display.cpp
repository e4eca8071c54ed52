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
    return display.whyNot();
}

void useHand(const std::string& words) {
    if (std::system(("xdotool " + words).c_str()) != 0)
        throw std::runtime_error("xdotool is not installed, or fails with: " + words);
}
