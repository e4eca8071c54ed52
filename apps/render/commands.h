#pragma once

#include "options.h"

/// Reads the scene, draws its pictures and writes them. Returns the signal that ended it early, after what it
/// has done was said; 0 without one. Throws `candela::Error`; pictures finished before stay.
int renderFrames(const Options& options);

/// Prints what --list asks for, a line each, on standard output. Throws `candela::Error`.
void printList(const Options& options);

/// The lists that are of a scene: its animations, cameras, materials, variants or contents. Throws
/// `candela::Error`.
void printSceneList(const Options& options);
