#include "cameras.h"

#include <numbers>

namespace candela_gltf {
namespace {

void pushPerspective(const tinygltf::Camera& source, const std::string& element, const tinygltf::Node& node,
                     std::int32_t nodeIndex, const Host& host) {
    if (source.perspective.yfov <= 0.0) throw Failure{element, "\"perspective\" is missing"};
    if (source.perspective.yfov >= std::numbers::pi) {
        throw Failure{element,
                      "yfov is " + std::to_string(source.perspective.yfov) + ", expected less than pi"};
    }
    candela_camera camera{};
    camera.struct_size = sizeof camera;
    camera.name = source.name.empty() ? node.name.c_str() : source.name.c_str();
    camera.vertical_fov = static_cast<float>(source.perspective.yfov);
    camera.near_plane = static_cast<float>(source.perspective.znear);
    camera.node = nodeIndex;
    host.add(camera);
}

}  // namespace

void pushCameras(const Document& document, const std::vector<DrawnNode>& drawn,
                 const std::vector<std::int32_t>& nodes, const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto index = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& node = document.model.nodes[index];
        if (node.camera < 0) continue;
        const auto cameraIndex = static_cast<std::size_t>(node.camera);
        const tinygltf::Camera& camera = document.model.cameras.at(cameraIndex);
        const std::string element = elementName("camera", cameraIndex, camera.name);
        if (camera.type == "orthographic") {
            host.note(element + " is orthographic: left out");
            continue;
        }
        pushPerspective(camera, element, node, nodes[index], host);
    }
}

}  // namespace candela_gltf
