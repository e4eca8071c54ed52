#pragma once

#include "view_model.h"

#include <cstdint>
#include <exception>
#include <optional>

/// Adds an error to the model's messages, unless the last one says the same.
void addError(ViewModel& model, const char* text);

/// Runs `work`, which changes the scene or the device. What it throws becomes a message.
template <typename Work>
void tryTo(ViewModel& model, Work&& work) {
    try {
        work();
    } catch (const std::exception& error) {
        addError(model, error.what());
    }
}

/// A number that is another one for every scene that is opened. To be called in every frame that draws
/// panels.
std::uint64_t sceneNumber(const ViewModel& model);

/// What a panel keeps of the open scene from frame to frame, made anew for each scene. The window has one
/// model, and each panel a type of its own.
template <typename Kept>
Kept& keptOfScene(const ViewModel& model) {
    static std::optional<Kept> kept;
    static std::uint64_t number = 0;
    if (!kept || number != sceneNumber(model)) {
        kept.emplace();
        number = sceneNumber(model);
    }
    return *kept;
}
