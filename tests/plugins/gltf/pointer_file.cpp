#include "pointer_file.h"

#include <nlohmann/json.hpp>

namespace candela_test {
namespace {

using Json = nlohmann::json;

/// A texture with a transform.
const char* const texture = R"({"index":0,"extensions":{"KHR_texture_transform":{"rotation":0.25}}})";

/// A material with every texture and every extension, whose enclosing objects are all there.
std::string materialOfEverything() {
    Json textured = Json::parse(texture), scaled = textured, strong = textured;
    scaled["scale"] = 0.5;
    strong["strength"] = 0.5;
    Json material;
    material["pbrMetallicRoughness"] = {{"baseColorTexture", textured},
                                        {"metallicRoughnessTexture", textured}};
    material["normalTexture"] = scaled;
    material["occlusionTexture"] = strong;
    material["emissiveTexture"] = textured;
    material["emissiveFactor"] = {0.5, 0.5, 0.5};
    material["alphaMode"] = "MASK";
    Json& extensions = material["extensions"];
    extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", 2}};
    extensions["KHR_materials_ior"] = Json::object();
    extensions["KHR_materials_specular"] = {{"specularTexture", textured},
                                            {"specularColorTexture", textured}};
    extensions["KHR_materials_clearcoat"] = {{"clearcoatTexture", textured},
                                             {"clearcoatRoughnessTexture", textured},
                                             {"clearcoatNormalTexture", scaled}};
    extensions["KHR_materials_sheen"] = {{"sheenColorTexture", textured},
                                         {"sheenRoughnessTexture", textured}};
    extensions["KHR_materials_anisotropy"] = {{"anisotropyTexture", textured}};
    extensions["KHR_materials_iridescence"] = {{"iridescenceTexture", textured},
                                               {"iridescenceThicknessTexture", textured}};
    extensions["KHR_materials_transmission"] = {{"transmissionTexture", textured}};
    extensions["KHR_materials_volume"] = {{"thicknessTexture", textured}};
    extensions["KHR_materials_dispersion"] = Json::object();
    extensions["KHR_materials_diffuse_transmission"] = {{"diffuseTransmissionTexture", textured},
                                                        {"diffuseTransmissionColorTexture", textured}};
    return material.dump();
}

}  // namespace

GltfFile fileOfEverything() {
    GltfFile file;
    addTriangle(file);
    file.addData<float>("VEC2", {0, 0, 1, 0, 0, 1});
    file.addData<float>("VEC3", std::vector<float>(9, 0.5f));
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"material":0,
        "targets":[{"POSITION":3},{"POSITION":3}]}],"weights":[0.5,0.25]})");
    const std::string png =
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==";
    file.add("images", R"({"uri":"data:image/png;base64,)" + png + "\"}");
    file.add("textures", R"({"source":0})");
    file.add("materials", materialOfEverything());
    file.set("extensions", R"({"KHR_lights_punctual":{"lights":[{"type":"spot","range":5,"spot":{}},
                                                                 {"type":"directional"}]}})");
    file.add("cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":0.1,"zfar":100}})");
    file.add("cameras", R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":9}})");
    file.add("nodes", R"({"mesh":0,"extensions":{"KHR_node_visibility":{}}})");
    file.add("nodes", R"({"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}})");
    file.add("nodes", R"({"camera":1,"extensions":{"KHR_lights_punctual":{"light":1}}})");
    file.add("nodes", R"({"mesh":0,"weights":[0,1]})");
    return file;
}

std::vector<Pointed> everyProperty() {
    const std::string material = "/materials/0", extension = material + "/extensions/KHR_materials_";
    const std::string light = "/extensions/KHR_lights_punctual/lights/0";
    std::vector<Pointed> all{
        {material + "/pbrMetallicRoughness/baseColorFactor", {0.1f, 0.2f, 0.3f, 0.4f}},
        {material + "/pbrMetallicRoughness/metallicFactor", {0.1f}},
        {material + "/pbrMetallicRoughness/roughnessFactor", {0.2f}},
        {material + "/emissiveFactor", {0.3f, 0.2f, 1}},
        {material + "/alphaCutoff", {0.75f}},
        {material + "/normalTexture/scale", {-2}},
        {material + "/occlusionTexture/strength", {0.125f}},
        {extension + "emissive_strength/emissiveStrength", {50}},
        {extension + "ior/ior", {2.25f}},
        {extension + "specular/specularFactor", {0.1f}},
        {extension + "specular/specularColorFactor", {2, 1, 0.5f}},
        {extension + "clearcoat/clearcoatFactor", {0.3f}},
        {extension + "clearcoat/clearcoatRoughnessFactor", {0.4f}},
        {extension + "clearcoat/clearcoatNormalTexture/scale", {3}},
        {extension + "sheen/sheenColorFactor", {0.1f, 0.2f, 0.3f}},
        {extension + "sheen/sheenRoughnessFactor", {0.6f}},
        {extension + "anisotropy/anisotropyStrength", {0.7f}},
        {extension + "anisotropy/anisotropyRotation", {-4}},
        {extension + "iridescence/iridescenceFactor", {0.8f}},
        {extension + "iridescence/iridescenceIor", {1.75f}},
        {extension + "iridescence/iridescenceThicknessMinimum", {50}},
        {extension + "iridescence/iridescenceThicknessMaximum", {500}},
        {extension + "transmission/transmissionFactor", {0.9f}},
        {extension + "volume/thicknessFactor", {1.5f}},
        {extension + "volume/attenuationDistance", {2.5f}},
        {extension + "volume/attenuationColor", {0.5f, 0.25f, 0.125f}},
        {extension + "dispersion/dispersion", {0.3f}},
        {extension + "diffuse_transmission/diffuseTransmissionFactor", {0.35f}},
        {extension + "diffuse_transmission/diffuseTransmissionColorFactor", {0.15f, 0.25f, 0.35f}},
        {light + "/color", {0.5f, 2, 0.25f}},
        {light + "/intensity", {70}},
        {light + "/range", {7}},
        {light + "/spot/innerConeAngle", {0.125f}},
        {light + "/spot/outerConeAngle", {1.25f}},
        {"/extensions/KHR_lights_punctual/lights/1/intensity", {3}},
        {"/cameras/0/perspective/yfov", {0.5f}},
        {"/cameras/0/perspective/znear", {0.25f}},
        {"/cameras/0/perspective/zfar", {50}},
        {"/cameras/1/orthographic/ymag", {4}},
        {"/cameras/1/orthographic/znear", {0.5f}},
        {"/cameras/1/orthographic/zfar", {8}},
    };
    float number = 1.0f;
    for (const char* place :
         {"/pbrMetallicRoughness/baseColorTexture", "/pbrMetallicRoughness/metallicRoughnessTexture",
          "/normalTexture", "/emissiveTexture", "/occlusionTexture",
          "/extensions/KHR_materials_specular/specularTexture",
          "/extensions/KHR_materials_specular/specularColorTexture",
          "/extensions/KHR_materials_clearcoat/clearcoatTexture",
          "/extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture",
          "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture",
          "/extensions/KHR_materials_sheen/sheenColorTexture",
          "/extensions/KHR_materials_sheen/sheenRoughnessTexture",
          "/extensions/KHR_materials_anisotropy/anisotropyTexture",
          "/extensions/KHR_materials_iridescence/iridescenceTexture",
          "/extensions/KHR_materials_iridescence/iridescenceThicknessTexture",
          "/extensions/KHR_materials_transmission/transmissionTexture",
          "/extensions/KHR_materials_volume/thicknessTexture",
          "/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionTexture",
          "/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorTexture"}) {
        const std::string transform = material + place + "/extensions/KHR_texture_transform/";
        all.push_back({transform + "offset", {number, -number}});
        all.push_back({transform + "rotation", {0.5f * number}});
        all.push_back({transform + "scale", {2.0f * number, 0.25f * number}});
        number += 1.0f;
    }
    return all;
}

std::string typeOf(std::size_t components) {
    return components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
}

std::string channelTo(const std::string& pointer, int sampler) {
    const Json channel{
        {"sampler", sampler},
        {"target",
         {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}};
    return channel.dump();
}

void animate(GltfFile& file, const std::string& pointer, int times, int output,
             const std::string& interpolation) {
    file.add("animations", R"({"samplers":[{"input":)" + std::to_string(times) + R"(,"output":)" +
                               std::to_string(output) + R"(,"interpolation":")" + interpolation +
                               R"("}],"channels":[)" + channelTo(pointer, 0) + "]}");
}

void animate(GltfFile& file, const Pointed& pointed) {
    const int times = file.addData<float>("SCALAR", {0});
    animate(file, pointed.pointer, times, file.addData<float>(typeOf(pointed.value.size()), pointed.value));
}

}  // namespace candela_test
