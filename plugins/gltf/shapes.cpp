#include "shapes.h"

#include <climits>

namespace candela_gltf {
namespace {

// Integers up to here are exact in double precision, and sums of a few of them do not overflow 64 bits.
constexpr double maxInteger = 9007199254740992.0;
// A little over pi / 2, since single-precision exporters round upwards.
constexpr double halfPi = 1.570797;
constexpr std::size_t anyNumber = 0;

Property number(const char* name, double least = -FLT_MAX, double most = FLT_MAX) {
    return {.name = name, .kind = Kind::number, .least = least, .most = most};
}

Property positive(const char* name) {
    return {.name = name, .kind = Kind::number, .least = 0.0, .minBound = Bound::excluded};
}

Property numbers(const char* name, std::size_t length, double least = -FLT_MAX, double most = FLT_MAX) {
    return {.name = name, .kind = Kind::numbers, .least = least, .most = most, .length = length};
}

Property integer(const char* name, double least = 0.0, double most = INT_MAX) {
    return {.name = name, .kind = Kind::integer, .least = least, .most = most};
}

Property size(const char* name, double least = 0.0) {
    return integer(name, least, maxInteger);
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

Property object(const char* name, const Shape& shape) {
    return {.name = name, .kind = Kind::object, .shape = &shape};
}

Property list(const char* name, const Shape& shape) {
    return {.name = name, .kind = Kind::list, .shape = &shape};
}

Property required(Property property) {
    property.need = Need::required;
    return property;
}

const Shape asset{"asset", {required(text("version")), text("minVersion")}};

const Shape buffer{"buffer", {text("name"), text("uri"), required(size("byteLength", 1))}};
const Shape bufferView{"bufferView",
                       {text("name"), required(index("buffer", Target::buffers)), size("byteOffset"),
                        required(size("byteLength", 1)), integer("byteStride", 4, 252)}};

const Shape sparseIndices{"indices",
                          {required(index("bufferView", Target::bufferViews)), integer("byteOffset"),
                           required(integer("componentType"))}};
const Shape sparseValues{"values",
                         {required(index("bufferView", Target::bufferViews)), integer("byteOffset")}};
const Shape sparse{"sparse",
                   {required(integer("count", 1)), required(object("indices", sparseIndices)),
                    required(object("values", sparseValues))}};
const Shape accessor{
    "accessor",
    {text("name"), index("bufferView", Target::bufferViews), size("byteOffset"),
     required(integer("componentType")), flag("normalized"), required(integer("count", 1, 4294967294.0)),
     required(text("type")), object("sparse", sparse)}};

const Shape image{"image", {text("name"), text("uri"), index("bufferView", Target::bufferViews)}};
const Shape sampler{
    "sampler",
    {text("name"), integer("magFilter"), integer("minFilter"), integer("wrapS"), integer("wrapT")}};
const Shape texture{"texture",
                    {text("name"), index("sampler", Target::samplers), index("source", Target::images)}};

const Shape textureTransform{
    "KHR_texture_transform",
    {numbers("offset", 2), number("rotation"), numbers("scale", 2), integer("texCoord")}};
const Shape textureExtensions{"", {object("KHR_texture_transform", textureTransform)}};
const Property textureIndex = required(index("index", Target::textures));
const Property textureSet = integer("texCoord");
const Property textureInfo = object("extensions", textureExtensions);
const Shape baseColorTexture{"baseColorTexture", {textureIndex, textureSet, textureInfo}};
const Shape metallicRoughnessTexture{"metallicRoughnessTexture", {textureIndex, textureSet, textureInfo}};
const Shape emissiveTexture{"emissiveTexture", {textureIndex, textureSet, textureInfo}};
const Shape normalTexture{"normalTexture", {textureIndex, textureSet, textureInfo, number("scale")}};
const Shape occlusionTexture{"occlusionTexture",
                             {textureIndex, textureSet, textureInfo, number("strength", 0, 1)}};

const Shape metallicRoughness{
    "pbrMetallicRoughness",
    {numbers("baseColorFactor", 4, 0, 1), object("baseColorTexture", baseColorTexture),
     number("metallicFactor", 0, 1), number("roughnessFactor", 0, 1),
     object("metallicRoughnessTexture", metallicRoughnessTexture)}};
const Shape emissiveStrength{"KHR_materials_emissive_strength", {number("emissiveStrength", 0)}};
const Shape unlit{"KHR_materials_unlit", {}};
const Shape materialExtensions{
    "", {object("KHR_materials_emissive_strength", emissiveStrength), object("KHR_materials_unlit", unlit)}};
// emissiveFactor: the specification says 0 to 1, but files from before KHR_materials_emissive_strength exceed
// it, and nothing is lost by taking them.
const Shape material{
    "material",
    {text("name"), object("pbrMetallicRoughness", metallicRoughness), object("normalTexture", normalTexture),
     object("occlusionTexture", occlusionTexture), object("emissiveTexture", emissiveTexture),
     numbers("emissiveFactor", 3, 0), text("alphaMode"), number("alphaCutoff", 0), flag("doubleSided"),
     object("extensions", materialExtensions)}};

const Shape attributes{"attribute",
                       {{.name = "POSITION"},
                        {.name = "NORMAL"},
                        {.name = "TANGENT"},
                        {.name = "TEXCOORD_0"},
                        {.name = "TEXCOORD_1"},
                        {.name = "COLOR_0"}},
                       {"JOINTS_", "WEIGHTS_"}};
const Shape targetAttributes{"attribute", {{.name = "POSITION"}}};
const Shape ngonEncoding{"FB_ngon_encoding", {}};
const Shape primitiveExtensions{"", {object("FB_ngon_encoding", ngonEncoding)}};
const Shape primitive{
    "primitive",
    {required(
         {.name = "attributes", .kind = Kind::indexMap, .target = Target::accessors, .shape = &attributes}),
     index("indices", Target::accessors),
     index("material", Target::materials),
     integer("mode", 0, 6),
     {.name = "targets", .kind = Kind::indexMaps, .target = Target::accessors, .shape = &targetAttributes},
     object("extensions", primitiveExtensions)}};
const Shape mesh{"mesh",
                 {text("name"), required(list("primitives", primitive)), numbers("weights", anyNumber)}};
const Shape skin{"skin",
                 {text("name"), required(indices("joints", Target::nodes)),
                  index("inverseBindMatrices", Target::accessors)}};

const Shape nodeLight{"KHR_lights_punctual", {required(index("light", Target::lights))}};
const Shape nodeExtensions{"", {object("KHR_lights_punctual", nodeLight)}};
const Shape node{"node",
                 {text("name"), index("camera", Target::cameras), index("mesh", Target::meshes),
                  indices("children", Target::nodes), numbers("matrix", 16), numbers("translation", 3),
                  numbers("rotation", 4), numbers("scale", 3), index("skin", Target::skins),
                  numbers("weights", anyNumber), object("extensions", nodeExtensions)}};
const Shape scene{"scene", {text("name"), indices("nodes", Target::nodes)}};

const Shape perspective{"perspective", {required(positive("yfov")), required(positive("znear"))}};
const Shape orthographic{"orthographic",
                         {required(number("xmag")), required(number("ymag")), required(number("zfar")),
                          required(number("znear"))}};
const Shape camera{"camera",
                   {text("name"), required(text("type")), object("perspective", perspective),
                    object("orthographic", orthographic)}};

const Shape spot{"spot", {number("innerConeAngle", 0, halfPi), number("outerConeAngle", 0, halfPi)}};
const Shape light{"light",
                  {text("name"), required(text("type")), numbers("color", 3, 0), number("intensity", 0),
                   positive("range"), object("spot", spot)}};
const Shape lights{"KHR_lights_punctual", {list("lights", light)}};
const Shape documentExtensions{"", {object("KHR_lights_punctual", lights)}};

const Shape channelTarget{"target", {index("node", Target::nodes), required(text("path"))}};
const Shape channel{"channel", {required(integer("sampler")), required(object("target", channelTarget))}};
const Shape animationSampler{"sampler",
                             {required(index("input", Target::accessors)),
                              required(index("output", Target::accessors)), text("interpolation")}};
const Shape animation{
    "animation",
    {text("name"), required(list("channels", channel)), required(list("samplers", animationSampler))}};

const Shape document{
    "",
    {required(object("asset", asset)), list("buffers", buffer), list("bufferViews", bufferView),
     list("accessors", accessor), list("images", image), list("samplers", sampler), list("textures", texture),
     list("materials", material), list("meshes", mesh), list("skins", skin), list("nodes", node),
     list("scenes", scene), index("scene", Target::scenes), list("cameras", camera),
     list("animations", animation), object("extensions", documentExtensions)}};

}  // namespace

const Shape& documentShape() {
    return document;
}

}  // namespace candela_gltf
