#pragma once

#include <compare>
#include <cstdint>

namespace candela {

struct Cage;
struct Image;
struct Light;
struct Material;
struct Mesh;
struct Node;

/// Names an element of a `GpuScene`. The elements of the scene that it was made from have the handles of
/// their indices, so that an index may stand for a handle. A place that has become free by a removal is given
/// to a new element, whose handle has a higher generation: the handle of the removed one is stale, and
/// functions that are given it throw `Error` (badInput) that says so.
template <typename Element>
struct Handle {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;

    constexpr Handle() = default;
    constexpr Handle(std::uint32_t elementIndex, std::uint32_t elementGeneration = 0)
        : index(elementIndex), generation(elementGeneration) {}

    auto operator<=>(const Handle&) const = default;
};

using CageHandle = Handle<Cage>;
using ImageHandle = Handle<Image>;
using LightHandle = Handle<Light>;
using MaterialHandle = Handle<Material>;
using MeshHandle = Handle<Mesh>;
using NodeHandle = Handle<Node>;

}  // namespace candela
