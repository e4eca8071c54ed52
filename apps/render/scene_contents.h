#pragma once

#include <candela/import.h>
#include <candela/scene.h>

#include <cstdint>
#include <string>
#include <vector>

/// A kind of element, and how many of it a scene has.
struct ContentCount {
    const char* name;  ///< "meshes".
    std::uint64_t count = 0;
};

/// Meshes, cages, nodes, images, cameras, animations and variants, also those of which there are none.
std::vector<ContentCount> contentCounts(const candela::Scene& scene);

/// The materials that have a lobe, a medium or another way to be drawn, by its name ("clearcoat"); without
/// those that none has.
std::vector<ContentCount> materialKinds(const candela::Scene& scene);

/// What a kind of notes is about: "missing", "repaired" or "information".
const char* toString(candela::NoteKind kind);
