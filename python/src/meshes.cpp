#include "module.h"
#include "scene_data.h"
#include "words.h"

#include <nanobind/ndarray.h>

#include <candela/geometry.h>
#include <candela/shapes.h>

namespace candela::python {

template <>
struct Convert<Submesh> : ConvertClass<Submesh> {};
template <>
struct Convert<MorphTarget> : ConvertClass<MorphTarget> {};
template <>
struct Convert<Crease> : ConvertClass<Crease> {};
template <>
struct Convert<Corner> : ConvertClass<Corner> {};
template <>
struct Convert<VariantMaterial> : ConvertClass<VariantMaterial> {};
template <>
struct Convert<CageVariant> : ConvertClass<CageVariant> {};

namespace {

template <typename T>
void setPixels(Image& image, const nb::object& array, PixelFormat format) {
    const auto view = nb::cast<nb::ndarray<const T, nb::c_contig, nb::device::cpu>>(array);
    image.height = static_cast<std::uint32_t>(view.shape(0));
    image.width = static_cast<std::uint32_t>(view.shape(1));
    image.format = format;
    image.pixels.resize(view.size() * sizeof(T));
    std::memcpy(image.pixels.data(), view.data(), image.pixels.size());
}

// (H, W), (H, W, 1), (H, W, 3) and (H, W, 4) of uint8, uint16 or floats.
void setPixels(Image& image, nb::handle value, const std::string& where) {
    const nb::module_ numpy = nb::module_::import_("numpy");
    nb::object array = numpy.attr("asarray")(value);
    const std::string type = nb::str(nb::object(array.attr("dtype"))).c_str();
    const std::string expected =
        "pixels of shape (height, width), (height, width, 3) or (height, width, 4) of uint8, uint16 or "
        "float32";
    if (nb::cast<int>(array.attr("ndim")) == 2)
        array = array.attr("__getitem__")(nb::make_tuple(nb::ellipsis(), nb::none()));
    if (nb::cast<int>(array.attr("ndim")) != 3) failConversion(where, expected, value);
    const auto channels = nb::cast<std::size_t>(array.attr("shape").attr("__getitem__")(2));
    const bool isFloat = type.starts_with("float");
    if ((channels != 1 && channels != 3 && channels != 4) ||
        (!isFloat && type != "uint8" && type != "uint16"))
        failConversion(where, expected, value);
    if (channels == 1) array = numpy.attr("repeat")(array, 3, 2);
    if (channels != 4) {
        const nb::object shape = nb::make_tuple(array.attr("shape").attr("__getitem__")(0),
                                                array.attr("shape").attr("__getitem__")(1), 1);
        const int opaque = isFloat ? 1 : type == "uint8" ? 255 : 65535;
        array = numpy.attr("concatenate")(
            nb::make_tuple(array, numpy.attr("full")(shape, opaque, array.attr("dtype"))), 2);
    }
    array = numpy.attr("ascontiguousarray")(array, nb::arg("dtype") = isFloat ? "float32" : type.c_str());
    if (isFloat) return setPixels<float>(image, array, PixelFormat::rgba32f);
    if (type == "uint8") return setPixels<std::uint8_t>(image, array, PixelFormat::rgba8);
    setPixels<std::uint16_t>(image, array, PixelFormat::rgba16);
}

nb::object pixelsOf(const Image& image) {
    auto* bytes = new std::vector<std::byte>(image.pixels);
    bytes->reserve(1);
    const nb::capsule owner(bytes, [](void* p) noexcept { delete static_cast<std::vector<std::byte>*>(p); });
    const std::size_t width = image.pixels.empty() ? 0 : image.width;
    const std::array<std::size_t, 3> shape{image.pixels.empty() ? 0 : image.height, width, 4};
    void* data = bytes->data();
    if (image.format == PixelFormat::rgba8)
        return nb::cast(nb::ndarray<nb::numpy, const std::uint8_t>(data, 3, shape.data(), owner));
    if (image.format == PixelFormat::rgba16)
        return nb::cast(nb::ndarray<nb::numpy, const std::uint16_t>(data, 3, shape.data(), owner));
    return nb::cast(nb::ndarray<nb::numpy, const float>(data, 3, shape.data(), owner));
}

void setVertexColors(Mesh& mesh, nb::handle value, const std::string& where) {
    const nb::object array = nb::module_::import_("numpy").attr("asarray")(value);
    if (nb::cast<int>(array.attr("ndim")) == 2 &&
        nb::cast<int>(nb::object(array.attr("shape").attr("__getitem__")(1))) == 3) {
        const std::vector<glm::vec3> colors = vectorsFrom<3>(value, where);
        mesh.colors.clear();
        for (const glm::vec3& color : colors) mesh.colors.emplace_back(color, 1.0f);
        return;
    }
    mesh.colors = vectorsFrom<4>(value, where);
}

// Any shape: triangles are (M, 3), lines (M, 2), points (M,).
void setIndices(Mesh& mesh, nb::handle value, const std::string& where) {
    const nb::object array = nb::module_::import_("numpy").attr("asarray")(value);
    mesh.indices = indicesFrom(array.attr("reshape")(-1), 0, where);
}

}  // namespace

template <>
const Record<Image>& recordOf<Image>() {
    static const Record<Image> record =
        Record<Image>("Image")
            .field("name", &Image::name, "The image's name.")
            .custom(
                "pixels", "numpy.typing.NDArray[numpy.generic]",
                "(height, width, 4) of uint8, uint16 or float32, rows from the top. Also takes (height, "
                "width) and (height, width, 3). Whether colour is sRGB-encoded follows from the use.",
                [](Image& image, nb::handle value, const std::string& where) {
                    setPixels(image, value, where);
                },
                pixelsOf);
    return record;
}

template <>
const Record<Submesh>& recordOf<Submesh>() {
    static const Record<Submesh> record =
        Record<Submesh>("Submesh")
            .field("first_index", &Submesh::firstIndex, "The first of its indices in `Mesh.indices`.")
            .field("index_count", &Submesh::indexCount, "How many: 3 for each triangle.")
            .field("material", &Submesh::material, "Index into `Scene.materials`; None: a default material.")
            .field("topology", &Submesh::topology, "What the indices are.");
    return record;
}

template <>
const Record<VariantMaterial>& recordOf<VariantMaterial>() {
    static const Record<VariantMaterial> record =
        Record<VariantMaterial>("VariantMaterial")
            .field("submesh", &VariantMaterial::submesh, "Index into `Mesh.submeshes`.")
            .field("variant", &VariantMaterial::variant, "Index into `Scene.variants`; None: without one.")
            .field("material", &VariantMaterial::material,
                   "Index into `Scene.materials`; None: a default material.");
    return record;
}

template <>
const Record<CageVariant>& recordOf<CageVariant>() {
    static const Record<CageVariant> record =
        Record<CageVariant>("CageVariant")
            .field("variant", &CageVariant::variant, "Index into `Scene.variants`; None: without one.")
            .field("face_materials", &CageVariant::faceMaterials, "As `Cage.face_materials`.");
    return record;
}

template <>
const Record<MorphTarget>& recordOf<MorphTarget>() {
    static const Record<MorphTarget> record =
        Record<MorphTarget>("MorphTarget")
            .field("offsets", &MorphTarget::offsets, "Of the positions, metres, (N, 3).")
            .field("normal_offsets", &MorphTarget::normalOffsets, "Of the normals, (N, 3) or empty.")
            .field("tangent_offsets", &MorphTarget::tangentOffsets, "Of the tangents, (N, 3) or empty.");
    return record;
}

template <>
const Record<Mesh>& recordOf<Mesh>() {
    static const Record<Mesh> record =
        Record<Mesh>("Mesh")
            .field("name", &Mesh::name, "The mesh's name.")
            .field("positions", &Mesh::positions, "Metres, (N, 3).")
            .field("normals", &Mesh::normals, "Unit length, (N, 3).")
            .field("tangents", &Mesh::tangents, "Unit direction and the bitangent's sign, (N, 4) or empty.")
            .field("uv0", &Mesh::uv0,
                   "Texture coordinates, (0, 0) is the upper left of an image: (N, 2) or empty.")
            .field("uv1", &Mesh::uv1, "The second set, (N, 2) or empty.")
            .field("further_uvs", &Mesh::furtherUvs, "The sets from 2 on, (N, 2) each; 16 at most.")
            .custom("colors", floatArray,
                    "Linear Rec.709 and alpha, which multiply the base colour: (N, 4), (N, 3) or empty.",
                    setVertexColors,
                    [](const Mesh& mesh) { return Convert<std::vector<glm::vec4>>::to(mesh.colors); })
            .custom("indices", indexArray,
                    "Of vertices: three for each triangle, counter-clockwise from the front. Takes any "
                    "shape, as (M, 3).",
                    setIndices,
                    [](const Mesh& mesh) { return Convert<std::vector<std::uint32_t>>::to(mesh.indices); })
            .field("submeshes", &Mesh::submeshes,
                   "Ranges of the indices with a material each; empty: all are triangles with the default "
                   "material.")
            .field("variant_materials", &Mesh::variantMaterials,
                   "Of submeshes that have other materials in variants, with the one without a variant; "
                   "`Scene.add_variant` adds them.")
            .field("influence_count", &Mesh::influenceCount, "Joints for each vertex; 0: no skin moves it.")
            .field("joints", &Mesh::joints, "Indices into `Skin.joints`, influence_count for each vertex.")
            .field("joint_weights", &Mesh::jointWeights, "Of sum 1 for each vertex.")
            .field("morph_targets", &Mesh::morphTargets, "What `Node.morph_weights` weigh.");
    return record;
}

template <>
const Record<Crease>& recordOf<Crease>() {
    static const Record<Crease> record =
        Record<Crease>("Crease")
            .field("vertex0", &Crease::vertex0, "One end of the edge.")
            .field("vertex1", &Crease::vertex1, "The other end.")
            .field("sharpness", &Crease::sharpness, "0 or more; from 10 on infinitely sharp.");
    return record;
}

template <>
const Record<Corner>& recordOf<Corner>() {
    static const Record<Corner> record = Record<Corner>("Corner")
                                             .field("vertex", &Corner::vertex, "The sharp vertex.")
                                             .field("sharpness", &Corner::sharpness, "0 or more.");
    return record;
}

template <>
const Record<Cage>& recordOf<Cage>() {
    static const Record<Cage> record =
        Record<Cage>("Cage")
            .field("name", &Cage::name, "The cage's name.")
            .field("scheme", &Cage::scheme, "How it is subdivided; 'loop' takes triangles only.")
            .field("boundary_interpolation", &Cage::boundaryInterpolation,
                   "How the surface ends where the cage does.")
            .field("face_varying_interpolation", &Cage::faceVaryingInterpolation,
                   "Where texture coordinates are linear, by OpenSubdiv's names.")
            .field("crease_method", &Cage::creaseMethod, "How sharpness falls from level to level.")
            .field("triangle_subdivision", &Cage::triangleSubdivision,
                   "The weights of triangles in 'catmull_clark'.")
            .field("positions", &Cage::positions, "Metres, (N, 3).")
            .field("face_sizes", &Cage::faceSizes, "Corners of each face, 3 or more, (F,).")
            .field("face_vertices", &Cage::faceVertices, "Vertices of the corners, face after face.")
            .field("uvs", &Cage::uvs, "Texture coordinates, (U, 2) or empty.")
            .field("face_uvs", &Cage::faceUvs, "Index into `uvs` for each corner.")
            .field("creases", &Cage::creases, "Sharp edges.")
            .field("corners", &Cage::corners, "Sharp vertices.")
            .field("holes", &Cage::holes, "Faces without a surface.")
            .field("face_materials", &Cage::faceMaterials,
                   "Index into `Scene.materials` or None for each face; empty: none.")
            .field("variants", &Cage::variants,
                   "Where faces have other materials in variants, with those without a variant; "
                   "`Scene.add_variant` adds them.")
            .field("level", &Cage::level, "Refine to this level, 1 to 8; None: by the size on the screen.")
            .field("influence_count", &Cage::influenceCount, "Joints for each vertex; 0: no skin moves it.")
            .field("joints", &Cage::joints, "Indices into `Skin.joints`, influence_count for each vertex.")
            .field("joint_weights", &Cage::jointWeights, "Of sum 1 for each vertex.")
            .field("morph_targets", &Cage::morphTargets, "What `Node.morph_weights` weigh.");
    return record;
}

template <>
const Record<Skin>& recordOf<Skin>() {
    static const Record<Skin> record =
        Record<Skin>("Skin")
            .field("name", &Skin::name, "The skin's name.")
            .field("joints", &Skin::joints, "Indices into `Scene.nodes`.")
            .field("inverse_bind_matrices", &Skin::inverseBindMatrices, "One for each joint, (J, 4, 4).");
    return record;
}

namespace {

Element<Mesh> ownMesh(Mesh mesh) {
    return {nullptr, 0, std::make_shared<Mesh>(std::move(mesh))};
}

void bindShapes(nb::class_<Element<Mesh>>& cls) {
    cls.def_static(
           "sphere",
           [](float radius, std::uint32_t segments, std::uint32_t rings) {
               return ownMesh(sphereMesh(radius, segments, rings));
           },
           nb::arg("radius") = 1.0f, nb::arg("segments") = 64, nb::arg("rings") = 32,
           "A sphere around the origin, whose poles lie on Y; metres.")
        .def_static(
            "box", [](nb::object size) { return ownMesh(boxMesh(Convert<glm::vec3>::from(size, "size"))); },
            nb::arg("size") = nb::make_tuple(1, 1, 1),
            nb::sig("def box(size: numpy.typing.ArrayLike = (1, 1, 1)) -> Mesh"),
            "A box around the origin, of these lengths along X, Y and Z, metres.")
        .def_static(
            "plane",
            [](float width, float depth, std::uint32_t parts) {
                return ownMesh(planeMesh(width, depth, parts));
            },
            nb::arg("width") = 1.0f, nb::arg("depth") = 1.0f, nb::arg("parts") = 1,
            "A rectangle that faces +Y, `width` along X and `depth` along Z, metres.")
        .def_static(
            "disc", [](float radius, std::uint32_t segments) { return ownMesh(discMesh(radius, segments)); },
            nb::arg("radius") = 1.0f, nb::arg("segments") = 64, "A disc that faces +Y; metres.")
        .def_static(
            "cylinder",
            [](float radius, float height, std::uint32_t segments) {
                return ownMesh(cylinderMesh(radius, height, segments));
            },
            nb::arg("radius") = 1.0f, nb::arg("height") = 2.0f, nb::arg("segments") = 64,
            "A closed cylinder along Y around the origin; metres.")
        .def_static(
            "cone",
            [](float radius, float height, std::uint32_t segments) {
                return ownMesh(coneMesh(radius, height, segments));
            },
            nb::arg("radius") = 1.0f, nb::arg("height") = 2.0f, nb::arg("segments") = 64,
            "A closed cone along Y around the origin, whose tip is above; metres.")
        .def_static(
            "torus",
            [](float radius, float tube, std::uint32_t segments, std::uint32_t tubeSegments) {
                return ownMesh(torusMesh(radius, tube, segments, tubeSegments));
            },
            nb::arg("radius") = 1.0f, nb::arg("tube_radius") = 0.25f, nb::arg("segments") = 64,
            nb::arg("tube_segments") = 32, "A ring about Y; metres.")
        .def(
            "compute_normals",
            [](const Element<Mesh>& self, float creaseAngle) { computeNormals(self.edit(), creaseAngle); },
            nb::arg("crease_angle") = 0.698f,
            "Replaces the normals: triangles that meet at less than `crease_angle`, radians, get smooth "
            "ones. 0 is flat, pi smooth everywhere. Vertices whose corners differ are split.")
        .def(
            "compute_tangents",
            [](const Element<Mesh>& self, std::uint32_t uvSet) { computeTangents(self.edit(), uvSet); },
            nb::arg("uv_set") = 0,
            "Replaces the tangents by those of MikkTSpace, as normal textures need them.");
}

}  // namespace

void bindMeshes(nb::module_& module) {
    bindElement<Image>(module, "A picture that materials refer to.");
    bindValue<Submesh>(module, "A range of a mesh's indices that is drawn with one material.");
    bindValue<VariantMaterial>(module, "The material of a submesh in a variant of the scene.");
    bindValue<CageVariant>(module, "The materials of the faces of a cage in a variant of the scene.");
    bindValue<MorphTarget>(module, "Moves every vertex of a mesh or a cage by its weight times the offsets.");
    auto mesh = bindElement<Mesh>(
        module,
        "Indexed triangles, lines and points. Arrays that are read are copies and do not change: assign a "
        "whole array to change one.");
    bindShapes(mesh);
    bindValue<Crease>(module, "A sharp edge of a cage.");
    bindValue<Corner>(module, "A sharp vertex of a cage.");
    bindElement<Cage>(module, "The control polyhedron of a subdivision surface.");
    bindElement<Skin>(module, "The joints that move meshes and cages.");
}

}  // namespace candela::python
