#pragma once

#include "options.h"

/// Reads the scene, draws its frames and writes them. Throws `candela::Error`; frames finished before stay.
void renderFrames(const Options& options);

/// Prints what --list asks for, a line each, on standard output. Throws `candela::Error`.
void printList(const Options& options);

/// The lists that are of a scene: its animations, cameras, materials, variants or contents. Throws
/// `candela::Error`.
void printSceneList(const Options& options);
