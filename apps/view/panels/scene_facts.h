#pragma once

#include <candela/scene.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What each node of a scene carries, in a word such as "mesh" or "camera"; "mesh, light" where there is
/// more, and nothing for a mere group.
std::vector<std::string> kindsOfNodes(const candela::Scene& scene);

/// The materials of what `node` shows, each once, in the order in which they are met.
std::vector<std::uint32_t> materialsOfNode(const candela::Scene& scene, std::uint32_t node);

/// The time of the last key of the scene's animations, in seconds; 0 where there are none.
double lastKeyTime(const candela::Scene& scene);
