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

Property integer(const char* name, double min = 0.0, double max = INT_MAX) {
    return {.name = name, .kind = Kind::integer, .min = min, .max = max};
}

Property size(const char* name, double min = 0.0) {
    return integer(name, min, maxInteger);
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

const ObjectSchema asset{"asset", {required(text("version")), text("minVersion")}};

const ObjectSchema buffer{"buffer", {text("name"), text("uri"), required(size("byteLength", 1))}};
const ObjectSchema bufferView{"bufferView",
                              {text("name"), required(index("buffer", Target::buffers)), size("byteOffset"),
                               required(size("byteLength", 1)), integer("byteStride", 4, 252)}};

const ObjectSchema sparseIndices{"indices",
                                 {required(index("bufferView", Target::bufferViews)), integer("byteOffset"),
                                  required(integer("componentType"))}};
const ObjectSchema sparseValues{"values",
                                {required(index("bufferView", Target::bufferViews)), integer("byteOffset")}};
const ObjectSchema sparse{"sparse",
                          {required(integer("count", 1)), required(object("indices", sparseIndices)),
                           required(object("values", sparseValues))}};
const ObjectSchema accessor{
    "accessor",
    {text("name"), index("bufferView", Target::bufferViews), size("byteOffset"),
     required(integer("componentType")), flag("normalized"), required(integer("count", 1, 4294967294.0)),
     required(text("type")), object("sparse", sparse)}};

const ObjectSchema image{"image", {text("name"), text("uri"), index("bufferView", Target::bufferViews)}};
const ObjectSchema sampler{
    "sampler",
    {text("name"), integer("magFilter"), integer("minFilter"), integer("wrapS"), integer("wrapT")}};
const ObjectSchema texture{
    "texture", {text("name"), index("sampler", Target::samplers), index("source", Target::images)}};

const ObjectSchema textureTransform{
    "KHR_texture_transform",
    {numbers("offset", 2), number("rotation"), numbers("scale", 2), integer("texCoord")}};
const ObjectSchema textureExtensions{"", {object("KHR_texture_transform", textureTransform)}};
const Property textureIndex = required(index("index", Target::textures));
const Property textureSet = integer("texCoord");
const Property textureInfo = object("extensions", textureExtensions);
const ObjectSchema baseColorTexture{"baseColorTexture", {textureIndex, textureSet, textureInfo}};
const ObjectSchema metallicRoughnessTexture{"metallicRoughnessTexture",
                                            {textureIndex, textureSet, textureInfo}};
const ObjectSchema emissiveTexture{"emissiveTexture", {textureIndex, textureSet, textureInfo}};
const ObjectSchema normalTexture{"normalTexture", {textureIndex, textureSet, textureInfo, number("scale")}};
const ObjectSchema occlusionTexture{"occlusionTexture",
                                    {textureIndex, textureSet, textureInfo, number("strength", 0, 1)}};

const ObjectSchema metallicRoughness{
    "pbrMetallicRoughness",
    {numbers("baseColorFactor", 4, 0, 1), object("baseColorTexture", baseColorTexture),
     number("metallicFactor", 0, 1), number("roughnessFactor", 0, 1),
     object("metallicRoughnessTexture", metallicRoughnessTexture)}};
const ObjectSchema emissiveStrength{"KHR_materials_emissive_strength", {number("emissiveStrength", 0)}};
const ObjectSchema unlit{"KHR_materials_unlit", {}};
const ObjectSchema materialExtensions{
    "", {object("KHR_materials_emissive_strength", emissiveStrength), object("KHR_materials_unlit", unlit)}};
// emissiveFactor: the specification says 0 to 1, but files from before KHR_materials_emissive_strength exceed
// it, and larger values are valid here.
const ObjectSchema material{
    "material",
    {text("name"), object("pbrMetallicRoughness", metallicRoughness), object("normalTexture", normalTexture),
     object("occlusionTexture", occlusionTexture), object("emissiveTexture", emissiveTexture),
     numbers("emissiveFactor", 3, 0), text("alphaMode"), number("alphaCutoff", 0), flag("doubleSided"),
     object("extensions", materialExtensions)}};

const ObjectSchema attributes{"attribute",
                              {{.name = "POSITION"},
                               {.name = "NORMAL"},
                               {.name = "TANGENT"},
                               {.name = "TEXCOORD_0"},
                               {.name = "TEXCOORD_1"},
                               {.name = "COLOR_0"}},
                              {"JOINTS_", "WEIGHTS_"}};
const ObjectSchema targetAttributes{"attribute", {{.name = "POSITION"}}};
const ObjectSchema ngonEncoding{"FB_ngon_encoding", {}};
const ObjectSchema primitiveExtensions{"", {object("FB_ngon_encoding", ngonEncoding)}};
const ObjectSchema primitive{
    "primitive",
    {required(
         {.name = "attributes", .kind = Kind::indexMap, .target = Target::accessors, .schema = &attributes}),
     index("indices", Target::accessors),
     index("material", Target::materials),
     integer("mode", 0, 6),
     {.name = "targets", .kind = Kind::indexMaps, .target = Target::accessors, .schema = &targetAttributes},
     object("extensions", primitiveExtensions)}};
const ObjectSchema mesh{
    "mesh", {text("name"), required(list("primitives", primitive)), numbers("weights", anyNumber)}};
const ObjectSchema skin{"skin",
                        {text("name"), required(indices("joints", Target::nodes)),
                         index("inverseBindMatrices", Target::accessors)}};

const ObjectSchema nodeLight{"KHR_lights_punctual", {required(index("light", Target::lights))}};
const ObjectSchema nodeExtensions{"", {object("KHR_lights_punctual", nodeLight)}};
const ObjectSchema node{"node",
                        {text("name"), index("camera", Target::cameras), index("mesh", Target::meshes),
                         indices("children", Target::nodes), numbers("matrix", 16), numbers("translation", 3),
                         numbers("rotation", 4), numbers("scale", 3), index("skin", Target::skins),
                         numbers("weights", anyNumber), object("extensions", nodeExtensions)}};
const ObjectSchema scene{"scene", {text("name"), indices("nodes", Target::nodes)}};

const ObjectSchema perspective{"perspective", {required(positive("yfov")), required(positive("znear"))}};
const ObjectSchema orthographic{"orthographic",
                                {required(number("xmag")), required(number("ymag")), required(number("zfar")),
                                 required(number("znear"))}};
const ObjectSchema camera{"camera",
                          {text("name"), required(text("type")), object("perspective", perspective),
                           object("orthographic", orthographic)}};

const ObjectSchema spot{"spot", {number("innerConeAngle", 0, halfPi), number("outerConeAngle", 0, halfPi)}};
const ObjectSchema light{"light",
                         {text("name"), required(text("type")), numbers("color", 3, 0),
                          number("intensity", 0), positive("range"), object("spot", spot)}};
const ObjectSchema lights{"KHR_lights_punctual", {list("lights", light)}};
const ObjectSchema documentExtensions{"", {object("KHR_lights_punctual", lights)}};

const ObjectSchema channelTarget{"target", {index("node", Target::nodes), required(text("path"))}};
const ObjectSchema channel{"channel",
                           {required(integer("sampler")), required(object("target", channelTarget))}};
const ObjectSchema animationSampler{"sampler",
                                    {required(index("input", Target::accessors)),
                                     required(index("output", Target::accessors)), text("interpolation")}};
const ObjectSchema animation{
    "animation",
    {text("name"), required(list("channels", channel)), required(list("samplers", animationSampler))}};

const ObjectSchema document{
    "",
    {required(object("asset", asset)), list("buffers", buffer), list("bufferViews", bufferView),
     list("accessors", accessor), list("images", image), list("samplers", sampler), list("textures", texture),
     list("materials", material), list("meshes", mesh), list("skins", skin), list("nodes", node),
     list("scenes", scene), index("scene", Target::scenes), list("cameras", camera),
     list("animations", animation), object("extensions", documentExtensions)}};

}  // namespace

const ObjectSchema& documentSchema() {
    return document;
}

}  // namespace candela_plugins::gltf
