// Every public struct is initialised by name without a warning of -Wextra about the members that are not
// named: each member has a default member initialiser. A test of source_rules_test.cpp compares this list
// with the headers.
#include <candela/candela.h>

namespace candela {

template <typename... Structs>
void use(const Structs&...) {}

void initializeScene() {
    use(Scene{.origin = {}}, Bounds{.min = {}}, PosedPoints{.points = {}}, LightScatter{.count = 1});
    use(Mesh{.influenceCount = 1}, Submesh{.indexCount = 3}, VariantMaterial{.submesh = 1},
        MorphTarget{.normalOffsets = {}}, Skin{.name = {}});
    use(Cage{.influenceCount = 1}, Crease{.vertex1 = 1}, Corner{.vertex = 1}, CageVariant{.variant = 1});
    use(Node{.castsShadow = true}, Transform{.scale = {}}, Camera{.verticalFov = 1.0f},
        CameraView{.nearPlane = 1.0f}, CameraIntrinsics{.width = 1});
    use(Light{.position = {}}, WorldLight{.position = {}}, Image{.width = 1}, Environment{.intensity = 1.0f},
        EnvironmentSettings{.intensity = 1.0f}, SkyOptions{.turbidity = 3.0}, Sky{.sun = {}});
    use(Animation{.plays = true}, TimeSpan{.first = 1.0}, AnimationChannel{.node = 1}, PropertyChannel{.element = 1});
}

void initializeMaterial() {
    use(Material{.metallic = 1.0f}, Texture{.image = 1}, Specular{.factor = 1.0f}, Clearcoat{.factor = 1.0f},
        Sheen{.roughness = 1.0f}, Anisotropy{.strength = 1.0f}, Iridescence{.factor = 1.0f},
        Transmission{.factor = 1.0f}, Volume{.thickness = 1.0f}, DiffuseTransmission{.factor = 1.0f});
    use(SurfaceLobes<float>{.metallic = 1.0f}, ExtendedLobes<float>{.f90 = 1.0f},
        SurfacePoint{.position = {}}, GBufferChannel{.filter = {}}, GBufferSurface{.normal = {}},
        GBufferTexel{.x = 1});
}

void initializeImport() {
    use(ImportNote{.count = 1}, SceneInfo{.metresPerUnit = 1.0}, ImportReport{.info = {}},
        ImportedScene{.scene = {}}, ImportOptions{.strictness = {}});
    use(PluginOption{.minimum = 1.0}, PluginReport{.subdivides = true});
    use(StencilTable{.offsets = {}}, RefinedCage{.faceSize = 4}, LimitVertices{.positions = {}},
        LimitUvs{.uvs = {}});
}

void initializeDevice() {
    use(Device{.index = 1}, ContextAttempt{.way = {}}, DeviceOptions{.softwareOnly = true});
    use(GpuSceneOptions{.rangeLoss = 0.1f}, SubdivisionSettings{.edgePixels = 1.0f}, ImageRegion{.width = 1},
        BufferRange{.name = 1}, LightRecord{.range = 1.0f}, LightReport{.lights = 1}, CageReport{.cages = 1},
        DeformationReport{.meshes = 1}, OcclusionReport{.triangles = 1}, GpuScene::NodeTransform{.local = {}},
        GpuScene::NodeVisibility{.visibility = {}});
}

void initializeFrame() {
    use(FrameSettings{.width = 1}, Overlays{.cage = true}, FrameTarget{.framebuffer = 1},
        AmbientOcclusionSettings{.rays = 1}, EnvironmentOcclusionSettings{.rays = 1},
        PictureRegion{.width = 1}, DepthConvention{.direction = {}}, HostSurfaces{.depth = 1},
        FrameStage{.width = 1}, FrameHooks{.afterGeometry = {}}, PicturePart{.x = 1});
    use(PassTime{.milliseconds = 1.0}, PairCounts{.pairsLit = 1}, ShadowCounts{.raysAsked = 1},
        LayerCounts{.layers = 1}, HdrImage{.width = 1}, Aov{.name = {}}, FrameTexture{.width = 1},
        PictureRectangle{.width = 1}, PickedSurface{.node = 1}, PixelProbe{.metallic = 1.0f},
        ExposureCounts{.surfaces = 1});
    use(AccumulatorOptions{.aovFilter = {}}, SamplingSettings{.count = 1}, Lens{.fNumber = 1.0f},
        PanoramaFaces{.size = 1}, DisplayOptions{.exposure = 1.0});
    use(Chromaticities{.red = {}}, DisplayEncoding{.gamma = 1.0}, PngOptions{.level = 1},
        ExrChannel{.type = {}}, ExrChannelType{.type = {}}, ExrOptions{.threads = 1}, ExrRational{.numerator = 1},
        ExrAttribute{.name = {}}, HdrFile{.image = {}});
}

}  // namespace candela
