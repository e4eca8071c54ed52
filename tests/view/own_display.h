#pragma once

#include <string>

/// Gives this process (and its children) an Xvfb of its own, even where there is a display already, so that
/// pointer events of a test reach no other window. Returns why there is none; empty when $DISPLAY names one,
/// which ends with the process.
const std::string& takeOwnDisplay();

/// Sends pointer and key events: xdotool with these arguments. The display has handled them then. Throws when
/// it fails.
void sendInput(const std::string& arguments);
