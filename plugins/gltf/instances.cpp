#include "instances.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "accessor.h"
#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

constexpr Encoding rotationEncodings[] = {float32, int8Normalized, int16Normalized};

/// Reads the attributes of one node.
class InstanceReader {
  public:
    InstanceReader(const Document& document, const tinygltf::Value& attributes, std::string element,
                   const Host& host)
        : document_(document), attributes_(attributes), element_(std::move(element)), host_(host) {}

    template <std::size_t components>
    void read(const char* attribute, Encodings encodings, std::array<float, components> Placement::*member) {
        if (!attributes_.Has(attribute)) return;
        const int accessor = attributes_.Get(attribute).GetNumberAsInt();
        const std::string where = element_ + ", attribute " + attribute;
        host_.leavesOut([&] {
            requireCount(accessor, where);
            const std::vector<float> numbers =
                readFloats(document_, accessor, static_cast<int>(components), encodings, where);
            instances_.resize(numbers.size() / components);
            for (std::size_t i = 0; i < instances_.size(); ++i)
                std::copy_n(&numbers[i * components], components, (instances_[i].*member).begin());
        });
    }

    std::vector<Placement> take() {
        if (instances_.empty()) instances_.emplace_back();
        return std::move(instances_);
    }

  private:
    /// All attributes have as many elements as the first. Instances that the file does not hold are few.
    void requireCount(int accessor, const std::string& where) const {
        constexpr std::size_t maxWithoutView = 65536;
        const std::size_t count = elementCount(document_, accessor);
        const bool isAbsent = document_.model.accessors.at(static_cast<std::size_t>(accessor)).bufferView < 0;
        if (isAbsent && count > maxWithoutView) {
            throw Failure{where, "accessor " + std::to_string(accessor) + " has no bufferView and " +
                                     std::to_string(count) + " elements, expected at most " +
                                     std::to_string(maxWithoutView)};
        }
        if (instances_.empty() || count == instances_.size()) return;
        throw Failure{where, "accessor " + std::to_string(accessor) + " has " + std::to_string(count) +
                                 " elements, expected " + std::to_string(instances_.size())};
    }

    const Document& document_;
    const tinygltf::Value& attributes_;
    std::string element_;
    const Host& host_;
    std::vector<Placement> instances_;
};

/// Quantised rotations are not quite of unit length. One of length 0 is no rotation.
void normalizeRotations(std::vector<Placement>& instances) {
    for (Placement& instance : instances) {
        double square = 0.0;
        for (const float number : instance.rotation) square += double{number} * number;
        if (square == 0.0) instance.rotation = Placement().rotation;
        if (square == 0.0) continue;
        for (float& number : instance.rotation) number = static_cast<float>(number / std::sqrt(square));
    }
}

}  // namespace

std::optional<std::vector<Placement>> instancesOf(const Document& document, std::size_t node,
                                                  const Host& host) {
    const tinygltf::Node& source = document.model.nodes[node];
    const auto extension = source.extensions.find("EXT_mesh_gpu_instancing");
    if (extension == source.extensions.end() || source.mesh < 0) return std::nullopt;
    const std::string element = elementName("node", node, source.name) + ", EXT_mesh_gpu_instancing";
    InstanceReader reader(document, extension->second.Get("attributes"), element, host);
    reader.read("TRANSLATION", onlyFloat, &Placement::translation);
    reader.read("ROTATION", rotationEncodings, &Placement::rotation);
    reader.read("SCALE", onlyFloat, &Placement::scale);
    std::vector<Placement> instances = reader.take();
    normalizeRotations(instances);
    return instances;
}

}  // namespace candela_plugins::gltf
