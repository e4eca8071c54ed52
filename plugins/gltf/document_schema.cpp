#include <climits>

#include "schema.h"

namespace candela_plugins::gltf {
namespace {

// Integers up to here are exact in double precision, and sums of a few of them do not overflow 64 bits.
constexpr double maxInteger = 9007199254740992.0;
// A little over pi / 2, since single-precision exporters round upwards.
constexpr double halfPi = 1.570797;
constexpr std::size_t anyNumber = 0;

Property number(const char* name, double min = -FLT_MAX, double max = FLT_MAX) {
    return {.name = name, .kind = Kind::number, .min = min, .max = max};
}

Property positive(const char* name) {
    return {.name = name, .kind = Kind::number, .min = 0.0, .minBound = Bound::excluded};
}

Property numbers(const char* name, std::size_t length, double min = -FLT_MAX, double max = FLT_MAX) {
    return {.name = name, .kind = Kind::numbers, .min = min, .max = max, .length = length};
}

/// Of a node. Larger numbers are no places: the host takes coordinates up to 1e9 in the world.
Property placement(const char* name, std::size_t length) {
    constexpr double max = 1e10;
    return {.name = name,
            .kind = Kind::numbers,
            .min = -max,
            .max = max,
            .minBound = Bound::excluded,
            .length = length};
}

Property integer(const char* name, double min = 0.0, double max = INT_MAX) {
    return {.name = name, .kind = Kind::integer, .min = min, .max = max};
}

Property size(const char* name, double min = 0.0) {
    return integer(name, min, maxInteger);
}

Property words(const char* name, std::vector<std::string_view> values) {
    return {.name = name, .kind = Kind::text, .values = std::move(values)};
}

Property flag(const char* name) {
    return {.name = name, .kind = Kind::flag};
}
Property text(const char* name) {
    return {.name = name, .kind = Kind::text};
}

Property index(const char* name, Target target) {
    return {.name = name, .kind = Kind::index, .target = target};
}

Property indices(const char* name, Target target) {
    return {.name = name, .kind = Kind::indices, .target = target};
}

Property object(const char* name, const ObjectSchema& schema) {
    return {.name = name, .kind = Kind::object, .schema = &schema};
}

Property list(const char* name, const ObjectSchema& schema) {
    return {.name = name, .kind = Kind::list, .schema = &schema};
}

Property required(Property property) {
    property.need = Need::required;
    return property;
}

/// An optional member without whose value its object cannot be used.
Property essential(Property property) {
    property.onFault = OnFault::refuseObject;
    return property;
}

Property geometry(Property property) {
    property.content = Content::geometry;
    return property;
}

const ObjectSchema asset{"asset", {required(text("version"))}};

// Stubs are what tinygltf takes, and hold as much as tells them from an element with all defaults.
const ObjectSchema buffer{.noun = "buffer",
                          .properties = {text("name"), essential(text("uri")), size("byteLength")},
                          .stub = R"({"uri":""})"};
// The largest byteStride times the largest count does not overflow 64 bits.
constexpr double maxCount = 4294967295.0;
const ObjectSchema meshoptCompression{
    "meshopt_compression",
    {required(index("buffer", Target::buffers)), essential(size("byteOffset")), required(size("byteLength")),
     required(integer("byteStride", 1)), required(integer("count", 0, maxCount)),
     required(words("mode", {"ATTRIBUTES", "TRIANGLES", "INDICES"})),
     essential(words("filter", {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"}))}};
const ObjectSchema bufferViewExtensions{"",
                                        {essential(object("EXT_meshopt_compression", meshoptCompression)),
                                         essential(object("KHR_meshopt_compression", meshoptCompression))}};
const ObjectSchema bufferView{
    .noun = "bufferView",
    .properties = {text("name"), required(index("buffer", Target::buffers)), essential(size("byteOffset")),
                   required(size("byteLength")), essential(integer("byteStride")),
                   essential(object("extensions", bufferViewExtensions))},
    .stub = R"({"buffer":0,"byteLength":0})"};

const ObjectSchema sparseIndices{"indices",
                                 {required(index("bufferView", Target::bufferViews)), integer("byteOffset"),
                                  required(integer("componentType"))}};
const ObjectSchema sparseValues{"values",
                                {required(index("bufferView", Target::bufferViews)), integer("byteOffset")}};
const ObjectSchema sparse{"sparse",
                          {required(integer("count")), required(object("indices", sparseIndices)),
                           required(object("values", sparseValues))}};
const ObjectSchema accessor{
    .noun = "accessor",
    .properties = {text("name"), essential(index("bufferView", Target::bufferViews)),
                   essential(size("byteOffset")), required(integer("componentType", 5120, 5126)),
                   flag("normalized"), required(integer("count", 0, maxCount - 1.0)),
                   required(words("type", {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"})),
                   essential(object("sparse", sparse))},
    .stub = R"({"componentType":5126,"count":0,"type":"SCALAR"})"};

const ObjectSchema image{
    .noun = "image",
    .properties = {text("name"), essential(text("uri")), essential(index("bufferView", Target::bufferViews))},
    .stub = R"({"uri":""})"};
const ObjectSchema sampler{
    "sampler",
    {text("name"), integer("magFilter"), integer("minFilter"), integer("wrapS"), integer("wrapT")}};
const ObjectSchema otherImage{"image", {required(index("source", Target::images))}};
const ObjectSchema imageExtensions{
    "", {object("EXT_texture_webp", otherImage), object("KHR_texture_basisu", otherImage)}};
const ObjectSchema texture{
    .noun = "texture",
    .properties = {text("name"), index("sampler", Target::samplers),
                   essential(index("source", Target::images)), object("extensions", imageExtensions)},
    .stub = R"({"name":""})"};

const ObjectSchema textureTransform{
    "KHR_texture_transform",
    {numbers("offset", 2), number("rotation"), numbers("scale", 2), integer("texCoord")}};
const ObjectSchema textureExtensions{"", {object("KHR_texture_transform", textureTransform)}};
/// The members of all textures of a material, and `more`.
ObjectSchema textureSchema(const char* name, std::vector<Property> more = {}) {
    std::vector<Property> properties{required(index("index", Target::textures)), integer("texCoord"),
                                     object("extensions", textureExtensions)};
    properties.insert(properties.end(), more.begin(), more.end());
    return {name, std::move(properties)};
}

const ObjectSchema baseColorTexture = textureSchema("baseColorTexture");
const ObjectSchema metallicRoughnessTexture = textureSchema("metallicRoughnessTexture");
const ObjectSchema emissiveTexture = textureSchema("emissiveTexture");
const ObjectSchema normalTexture = textureSchema("normalTexture", {number("scale")});
const ObjectSchema occlusionTexture = textureSchema("occlusionTexture", {number("strength", 0, 1)});

const ObjectSchema metallicRoughness{
    "pbrMetallicRoughness",
    {numbers("baseColorFactor", 4, 0, 1), object("baseColorTexture", baseColorTexture),
     number("metallicFactor", 0, 1), number("roughnessFactor", 0, 1),
     object("metallicRoughnessTexture", metallicRoughnessTexture)}};
const ObjectSchema emissiveStrength{"KHR_materials_emissive_strength", {number("emissiveStrength", 0)}};
const ObjectSchema unlit{"KHR_materials_unlit", {}};

const ObjectSchema ior{"KHR_materials_ior", {number("ior", 0)}};
const ObjectSchema specularTexture = textureSchema("specularTexture");
const ObjectSchema specularColorTexture = textureSchema("specularColorTexture");
const ObjectSchema specular{
    "KHR_materials_specular",
    {number("specularFactor", 0, 1), object("specularTexture", specularTexture),
     numbers("specularColorFactor", 3, 0), object("specularColorTexture", specularColorTexture)}};
const ObjectSchema clearcoatTexture = textureSchema("clearcoatTexture");
const ObjectSchema clearcoatRoughnessTexture = textureSchema("clearcoatRoughnessTexture");
const ObjectSchema clearcoatNormalTexture = textureSchema("clearcoatNormalTexture", {number("scale")});
const ObjectSchema clearcoat{
    "KHR_materials_clearcoat",
    {number("clearcoatFactor", 0, 1), object("clearcoatTexture", clearcoatTexture),
     number("clearcoatRoughnessFactor", 0, 1), object("clearcoatRoughnessTexture", clearcoatRoughnessTexture),
     object("clearcoatNormalTexture", clearcoatNormalTexture)}};
const ObjectSchema sheenColorTexture = textureSchema("sheenColorTexture");
const ObjectSchema sheenRoughnessTexture = textureSchema("sheenRoughnessTexture");
const ObjectSchema sheen{
    "KHR_materials_sheen",
    {numbers("sheenColorFactor", 3, 0, 1), object("sheenColorTexture", sheenColorTexture),
     number("sheenRoughnessFactor", 0, 1), object("sheenRoughnessTexture", sheenRoughnessTexture)}};
const ObjectSchema anisotropyTexture = textureSchema("anisotropyTexture");
const ObjectSchema anisotropy{"KHR_materials_anisotropy",
                              {number("anisotropyStrength", 0, 1), number("anisotropyRotation"),
                               object("anisotropyTexture", anisotropyTexture)}};
const ObjectSchema iridescenceTexture = textureSchema("iridescenceTexture");
const ObjectSchema iridescenceThicknessTexture = textureSchema("iridescenceThicknessTexture");
const ObjectSchema iridescence{
    "KHR_materials_iridescence",
    {number("iridescenceFactor", 0, 1), object("iridescenceTexture", iridescenceTexture),
     number("iridescenceIor", 1), number("iridescenceThicknessMinimum", 0),
     number("iridescenceThicknessMaximum", 0),
     object("iridescenceThicknessTexture", iridescenceThicknessTexture)}};
const ObjectSchema transmissionTexture = textureSchema("transmissionTexture");
const ObjectSchema transmission{
    "KHR_materials_transmission",
    {number("transmissionFactor", 0, 1), object("transmissionTexture", transmissionTexture)}};
const ObjectSchema thicknessTexture = textureSchema("thicknessTexture");
const ObjectSchema volume{"KHR_materials_volume",
                          {number("thicknessFactor", 0), object("thicknessTexture", thicknessTexture),
                           positive("attenuationDistance"), numbers("attenuationColor", 3, 0, 1)}};
const ObjectSchema dispersion{"KHR_materials_dispersion", {number("dispersion", 0)}};
const ObjectSchema diffuseTransmissionTexture = textureSchema("diffuseTransmissionTexture");
const ObjectSchema diffuseTransmissionColorTexture = textureSchema("diffuseTransmissionColorTexture");
const ObjectSchema diffuseTransmission{
    "KHR_materials_diffuse_transmission",
    {number("diffuseTransmissionFactor", 0, 1),
     object("diffuseTransmissionTexture", diffuseTransmissionTexture),
     numbers("diffuseTransmissionColorFactor", 3, 0, 1),
     object("diffuseTransmissionColorTexture", diffuseTransmissionColorTexture)}};
const ObjectSchema diffuseTexture = textureSchema("diffuseTexture");
const ObjectSchema specularGlossinessTexture = textureSchema("specularGlossinessTexture");
const ObjectSchema specularGlossiness{
    "KHR_materials_pbrSpecularGlossiness",
    {numbers("diffuseFactor", 4, 0, 1), object("diffuseTexture", diffuseTexture),
     numbers("specularFactor", 3, 0, 1), number("glossinessFactor", 0, 1),
     object("specularGlossinessTexture", specularGlossinessTexture)}};
const ObjectSchema materialExtensions{
    "",
    {object("KHR_materials_anisotropy", anisotropy), object("KHR_materials_clearcoat", clearcoat),
     object("KHR_materials_diffuse_transmission", diffuseTransmission),
     object("KHR_materials_dispersion", dispersion),
     object("KHR_materials_emissive_strength", emissiveStrength), object("KHR_materials_ior", ior),
     object("KHR_materials_iridescence", iridescence),
     object("KHR_materials_pbrSpecularGlossiness", specularGlossiness), object("KHR_materials_sheen", sheen),
     object("KHR_materials_specular", specular), object("KHR_materials_transmission", transmission),
     object("KHR_materials_unlit", unlit), object("KHR_materials_volume", volume)}};
const ObjectSchema material{
    "material",
    {text("name"), object("pbrMetallicRoughness", metallicRoughness), object("normalTexture", normalTexture),
     object("occlusionTexture", occlusionTexture), object("emissiveTexture", emissiveTexture),
     numbers("emissiveFactor", 3, 0, 1), words("alphaMode", {"OPAQUE", "MASK", "BLEND"}),
     number("alphaCutoff", 0), flag("doubleSided"), object("extensions", materialExtensions)}};

const ObjectSchema attributes{
    "attribute",
    {{.name = "POSITION"}, {.name = "NORMAL"}, {.name = "TANGENT"}, {.name = "COLOR_0"}},
    {"TEXCOORD_", "JOINTS_", "WEIGHTS_"},
    "POSITION"};
const ObjectSchema targetAttributes{"attribute",
                                    {{.name = "POSITION"}, {.name = "NORMAL"}, {.name = "TANGENT"}}};
const ObjectSchema ngonEncoding{"FB_ngon_encoding", {}};
const ObjectSchema dracoAttributes{.noun = "attributes",
                                   .properties = {integer("POSITION"), integer("NORMAL"), integer("TANGENT")},
                                   .numberedNames = {"TEXCOORD_", "COLOR_", "JOINTS_", "WEIGHTS_"}};
const ObjectSchema dracoCompression{
    "KHR_draco_mesh_compression",
    {required(index("bufferView", Target::bufferViews)), required(object("attributes", dracoAttributes))}};
const ObjectSchema variantMapping{
    .noun = "mapping",
    .properties = {required(index("material", Target::materials)), indices("variants", Target::variants)},
    .stub = R"({"material":0,"variants":[]})"};
const ObjectSchema variantMappings{"KHR_materials_variants", {list("mappings", variantMapping)}};
const ObjectSchema primitiveExtensions{"",
                                       {object("FB_ngon_encoding", ngonEncoding),
                                        essential(object("KHR_draco_mesh_compression", dracoCompression)),
                                        object("KHR_materials_variants", variantMappings)}};
const ObjectSchema primitive{.noun = "primitive",
                             .properties = {required({.name = "attributes",
                                                      .kind = Kind::indexMap,
                                                      .target = Target::accessors,
                                                      .schema = &attributes}),
                                            essential(index("indices", Target::accessors)),
                                            index("material", Target::materials),
                                            essential(integer("mode", 0, 6)),
                                            {.name = "targets",
                                             .kind = Kind::indexMaps,
                                             .target = Target::accessors,
                                             .schema = &targetAttributes},
                                            essential(object("extensions", primitiveExtensions))},
                             .stub = R"({"attributes":{}})"};
const ObjectSchema mesh{
    .noun = "mesh",
    .properties = {text("name"), required(list("primitives", primitive)), numbers("weights", anyNumber)},
    .stub = R"({"primitives":[]})"};
const ObjectSchema skin{.noun = "skin",
                        .properties = {text("name"), required(indices("joints", Target::nodes)),
                                       essential(index("inverseBindMatrices", Target::accessors))},
                        .stub = R"({"joints":[]})"};

const ObjectSchema nodeLight{"KHR_lights_punctual", {required(index("light", Target::lights))}};
const ObjectSchema instanceAttributes{"attribute",
                                      {{.name = "TRANSLATION"}, {.name = "ROTATION"}, {.name = "SCALE"}}};
const ObjectSchema instancing{"EXT_mesh_gpu_instancing",
                              {required({.name = "attributes",
                                         .kind = Kind::indexMap,
                                         .target = Target::accessors,
                                         .schema = &instanceAttributes})}};
const ObjectSchema visibility{"KHR_node_visibility", {flag("visible")}};
const ObjectSchema nodeExtensions{
    "",
    {object("EXT_mesh_gpu_instancing", instancing), object("KHR_lights_punctual", nodeLight),
     object("KHR_node_visibility", visibility)}};
const ObjectSchema node{
    "node",
    {text("name"), index("camera", Target::cameras), geometry(index("mesh", Target::meshes)),
     indices("children", Target::nodes), placement("matrix", 16), placement("translation", 3),
     numbers("rotation", 4), placement("scale", 3), index("skin", Target::skins),
     numbers("weights", anyNumber), object("extensions", nodeExtensions)}};
const ObjectSchema scene{"scene", {text("name"), geometry(indices("nodes", Target::nodes))}};

const ObjectSchema perspective{"perspective",
                               {required(positive("yfov")), positive("znear"), number("zfar")}};
const ObjectSchema orthographic{"orthographic",
                                {required(number("xmag")), required(number("ymag")), required(number("zfar")),
                                 required(number("znear"))}};
const ObjectSchema camera{
    .noun = "camera",
    .properties = {text("name"), required(words("type", {"perspective", "orthographic"})),
                   essential(object("perspective", perspective)),
                   essential(object("orthographic", orthographic))},
    .stub = R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":1,"znear":0}})"};

const ObjectSchema spot{"spot", {number("innerConeAngle", 0, halfPi), number("outerConeAngle", 0, halfPi)}};
// The maximum values that a scene takes. A range may be beyond what single precision holds: that is none.
constexpr double maxIntensity = 1e20, maxColor = 1e9;
const Property range{
    .name = "range", .kind = Kind::number, .min = 0.0, .max = DBL_MAX, .minBound = Bound::excluded};
const ObjectSchema light{
    .noun = "light",
    .properties = {text("name"), required(words("type", {"point", "spot", "directional"})),
                   numbers("color", 3, 0, maxColor), number("intensity", 0, maxIntensity), range,
                   object("spot", spot)},
    .stub = R"({"type":"point"})"};
const ObjectSchema lights{"", {list("lights", light)}};
const ObjectSchema variant{"variant", {text("name")}};
const ObjectSchema variants{"", {list("variants", variant)}};
const ObjectSchema documentExtensions{
    "", {object("KHR_lights_punctual", lights), object("KHR_materials_variants", variants)}};

const ObjectSchema animationPointer{"KHR_animation_pointer", {required(text("pointer"))}};
const ObjectSchema targetExtensions{"", {essential(object("KHR_animation_pointer", animationPointer))}};
const ObjectSchema channelTarget{"target",
                                 {index("node", Target::nodes), required(text("path")),
                                  essential(object("extensions", targetExtensions))}};
const ObjectSchema channel{
    .noun = "channel",
    .properties = {required(integer("sampler")), required(object("target", channelTarget))},
    .stub = R"({"sampler":0,"target":{"node":0,"path":""}})"};
const ObjectSchema animationSampler{
    .noun = "sampler",
    .properties = {required(index("input", Target::accessors)), required(index("output", Target::accessors)),
                   words("interpolation", {"LINEAR", "STEP", "CUBICSPLINE"})},
    .stub = R"({"input":0,"output":0})"};
const ObjectSchema animation{.noun = "animation",
                             .properties = {text("name"), required(list("channels", channel)),
                                            required(list("samplers", animationSampler))},
                             .stub = R"({"channels":[],"samplers":[]})"};

const ObjectSchema document{
    "",
    {required(object("asset", asset)), list("buffers", buffer), list("bufferViews", bufferView),
     list("accessors", accessor), list("images", image), list("samplers", sampler), list("textures", texture),
     list("materials", material), geometry(list("meshes", mesh)), list("skins", skin),
     geometry(list("nodes", node)), geometry(list("scenes", scene)), index("scene", Target::scenes),
     list("cameras", camera), list("animations", animation), object("extensions", documentExtensions)}};

}  // namespace

const ObjectSchema& documentSchema() {
    return document;
}

}  // namespace candela_plugins::gltf
