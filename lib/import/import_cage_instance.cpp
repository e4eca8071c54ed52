#include "import/abi_import.h"

#include <utility>

namespace candela {
namespace {

AbiReader cageElement(const Scene& scene, std::uint32_t index) {
    return {"cage", index, scene.cages[index].name.c_str()};
}

void takeMorphWeights(const candela_cage_instance& pushed, const AbiReader& node, const Cage& cage,
                      const std::string& cageLabel, CageInstance& shown) {
    if (pushed.morph_weight_count == 0) return;
    if (pushed.morph_weight_count != cage.morphTargets.size())
        node.refuse(joined("morph_weight_count is ", pushed.morph_weight_count, ", but ", cageLabel, " has ",
                           cage.morphTargets.size(), " morph targets"));
    node.numbers("morph_weight", pushed.morph_weights, pushed.morph_weight_count, shown.morphWeights);
}

}  // namespace

void showCage(const candela_cage_instance& pushed, Scene& scene) {
    const AbiReader call("show_cage", std::nullopt, nullptr);
    const auto index = call.reference("node", pushed.node, scene.nodes.size());
    if (!index) call.refuse("node is -1, but a node was expected");
    Node& node = scene.nodes[*index];
    const AbiReader element("node", *index, node.name.c_str());
    const auto cageIndex = element.reference("cage", pushed.cage, scene.cages.size());
    if (!cageIndex) element.refuse("cage is -1, but a cage was expected");
    if (node.cage)
        element.refuse(joined("it shows ", cageElement(scene, node.cage->cage).label(),
                              " already, and can not show another cage"));
    const Cage& cage = scene.cages[*cageIndex];
    const std::string cageLabel = cageElement(scene, *cageIndex).label();
    CageInstance shown;
    shown.cage = *cageIndex;
    shown.skin = element.reference("skin", pushed.skin, scene.skins.size());
    takeMorphWeights(pushed, element, cage, cageLabel, shown);
    node.cage = std::move(shown);
}

}  // namespace candela
