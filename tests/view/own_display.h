#pragma once

#include <string>

/// Gives this process (and those it starts) an Xvfb of its own, even where there is a display already: what
/// a test does with the pointer must meet no other window. Returns why there is none; empty when $DISPLAY
/// names one, which ends with the process.
const std::string& takeOwnDisplay();

/// Moves pointer and keys as a user does: xdotool with these words. Throws when it fails.
void useHand(const std::string& words);
