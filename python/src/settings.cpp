#include "settings.h"

#include "module.h"
#include "words.h"

namespace candela::python {

SamplingSettings RenderSettings::sampling() const {
    SamplingSettings settings;
    settings.count = samples;
    settings.shutter = shutter;
    settings.framesPerSecond = framesPerSecond;
    if (fNumber) {
        settings.lens = lens;
        settings.lens->fNumber = *fNumber;
    }
    return settings;
}

namespace {

void setRegion(RenderSettings& settings, nb::handle value, const std::string& where) {
    settings.frame.region.reset();
    if (value.is_none()) return;
    std::array<double, 4> numbers;
    numbersFrom(value, numbers, where);
    const auto pixels = [&](std::size_t i) { return static_cast<int>(numbers[i]); };
    settings.frame.region =
        PictureRegion{.width = pixels(2), .height = pixels(3), .x = pixels(0), .y = pixels(1)};
}

nb::object getRegion(const RenderSettings& settings) {
    const std::optional<PictureRegion>& region = settings.frame.region;
    if (!region) return nb::none();
    return nb::make_tuple(region->x, region->y, region->width, region->height);
}

}  // namespace

template <>
const Record<RenderSettings>& recordOf<RenderSettings>() {
    using S = RenderSettings;
    static const Record<S> record =
        Record<S>("RenderSettings")
            .field(
                "width", [](S& s) -> int& { return s.frame.width; }, "Pixels, 1 or more.")
            .field(
                "height", [](S& s) -> int& { return s.frame.height; }, "Pixels, 1 or more.")
            .field("samples", &S::samples, "Samples a pixel, 1 to 65536; their mean is the picture.")
            .field(
                "shadows", [](S& s) -> Shadows& { return s.frame.shadows; }, "Whether lights cast shadows.")
            .field(
                "layers", [](S & s) -> auto& { return s.frame.layers; },
                "The largest number of layers of transparent surfaces, 0 to 64.")
            .field(
                "brdf", [](S& s) -> BrdfModel& { return s.frame.brdf; }, "The reflection model.")
            .field(
                "technique", [](S& s) -> Technique& { return s.frame.technique; },
                "How lights are brought to pixels; all give the same picture.")
            .field(
                "tile_backend", [](S& s) -> TileBackend& { return s.frame.tileBackend; },
                "What runs the technique 'tiles'.")
            .field(
                "show", [](S& s) -> DebugView& { return s.frame.debugView; },
                "The picture, or data as colours in its place.")
            .field(
                "wireframe", [](S& s) -> bool& { return s.frame.overlays.wireframe; },
                "Draws the edges of triangles over the displayed picture.")
            .field(
                "cage", [](S& s) -> bool& { return s.frame.overlays.cage; },
                "Draws the edges of subdivision cages over the displayed picture.")
            .field(
                "environment_rays", [](S & s) -> auto& { return s.frame.environmentOcclusion.rays; },
                "Rays for each pixel and sample that find how much of the environment it sees, 1 to 4096.")
            .field(
                "ao_distance", [](S& s) -> float& { return s.frame.ambientOcclusion.distance; },
                "Of the AOV ambient_occlusion: metres, over 0.")
            .field(
                "ao_rays", [](S & s) -> auto& { return s.frame.ambientOcclusion.rays; },
                "Of the AOV ambient_occlusion: for each pixel, 1 to 4096.")
            .field(
                "specular_antialiasing", [](S& s) -> bool& { return s.frame.specularAntialiasing; },
                "Widens roughness where normals vary from pixel to pixel.")
            .field(
                "point_size", [](S& s) -> float& { return s.frame.pointSize; }, "Side of a point, pixels.")
            .field(
                "line_width", [](S& s) -> float& { return s.frame.lineWidth; }, "Pixels.")
            .custom(
                "region", "tuple[int, int, int, int] | None",
                "Draws this part of a larger picture: x and y of its upper left pixel, and the width and "
                "height "
                "of the whole, pixels. Parts fit without a seam where x and the way from the lower edge are "
                "multiples of 16.",
                setRegion, getRegion)
            .field("f_number", &S::fNumber, "A thin lens of this f-number, over 0; None: a pinhole.")
            .field(
                "focus_distance", [](S& s) -> float& { return s.lens.focusDistance; },
                "Of the lens: metres along the view axis, over 0.")
            .field(
                "aperture_blades", [](S & s) -> auto& { return s.lens.blades; },
                "Of the lens: 0 (round) or 3 to 64.")
            .field(
                "sensor_height", [](S& s) -> float& { return s.lens.sensorHeight; }, "Of the lens: metres.")
            .field("shutter", &S::shutter, "How long it is open, as a share of a frame, 0 to 1: motion blur.")
            .field("frames_per_second", &S::framesPerSecond, "Of the shutter; over 0.")
            .field(
                "aov_filter", &S::aovFilter,
                "How samples of AOVs become one value: as each AOV has it, the mean, or the first sample.");
    return record;
}

void bindSettings(nb::module_& module) {
    bindValue<RenderSettings>(
        module,
        "All that determines a picture of a scene from a view. It does not change: `replace` gives "
        "a changed copy.");
}

}  // namespace candela::python
