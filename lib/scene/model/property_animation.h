#pragma once

#include <candela/scene.h>

#include <glm/vec4.hpp>

#include <cstdint>
#include <map>
#include <vector>

namespace candela {

/// What the properties of an element type are of.
template <typename Element>
inline constexpr AnimatedElement kindOf = AnimatedElement::node;
template <>
inline constexpr AnimatedElement kindOf<Material> = AnimatedElement::material;
template <>
inline constexpr AnimatedElement kindOf<Light> = AnimatedElement::light;
template <>
inline constexpr AnimatedElement kindOf<Camera> = AnimatedElement::camera;

/// The elements of a scene of the type `Element`: nodes, materials, lights or cameras.
template <typename Element>
const std::vector<Element>& elementsOf(const Scene& scene);

/// The value of a channel at `time` (seconds), within the range of its property; what the value does not have
/// is 0. The channel keeps the rules of `PropertyChannel`.
glm::vec4 sampleProperty(const PropertyChannel& channel, double time);

/// Sets the property of a channel, which the element has, to a value. After the last one `settle` is due.
void setProperty(const PropertyChannel& channel, const glm::vec4& value, Node& node);
void setProperty(const PropertyChannel& channel, const glm::vec4& value, Material& material);
void setProperty(const PropertyChannel& channel, const glm::vec4& value, Light& light);
void setProperty(const PropertyChannel& channel, const glm::vec4& value, Camera& camera);

/// Brings numbers that limit each other to what `validate` allows, as splines and channels that do not know
/// each other may leave them: the emission strength and the intensity give way to 1e20 of the product with
/// the colour, the inner cone angle to the outer one, and the far plane to the near one.
void settle(Node& node);
void settle(Material& material);
void settle(Light& light);
void settle(Camera& camera);

/// The elements that animations which play change, as of `time`, by index. Where two channels change the same
/// property, the later one in the scene applies. Throws `Error` (badInput) when a channel does not fit its
/// element. `Element` is `Node`, `Material`, `Light` or `Camera`.
template <typename Element>
std::map<std::uint32_t, Element> posedElements(const Scene& scene, double time);

/// For each node whether it is visible at `time`: it and all nodes above it are. Parents precede their
/// children. Throws as `posedElements`.
std::vector<bool> visibleNodes(const Scene& scene, double time);

}  // namespace candela
