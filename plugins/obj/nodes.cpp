#include "nodes.h"

#include <algorithm>

namespace candela_obj {

std::int32_t pushNode(const std::string& name, std::int32_t mesh, const Host& host) {
    candela_node node{};
    node.struct_size = sizeof node;
    node.name = name.c_str();
    node.parent = -1;
    node.rotation[3] = 1.0f;
    std::fill_n(node.scale, 3, 1.0f);
    node.mesh = mesh;
    return host.add(node);
}

}  // namespace candela_obj
