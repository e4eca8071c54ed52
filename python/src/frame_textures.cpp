#include "frame.h"

#include "words.h"

#include <nanobind/stl/optional.h>

#include <algorithm>

namespace candela::python {

template <>
const Record<FrameTexture>& recordOf<FrameTexture>() {
    static const Record<FrameTexture> record =
        Record<FrameTexture>("FrameTexture")
            .field("name", &FrameTexture::name, "Such as 'radiance', 'depth', 'surface' or 'display'.")
            .field("texture", &FrameTexture::texture, "Its OpenGL name in the Renderer's context.")
            .field("target", &FrameTexture::target, "GL_TEXTURE_2D, 0x0DE1.")
            .field("internal_format", &FrameTexture::internalFormat,
                   "An OpenGL constant, such as GL_RGBA32F, 0x8814.")
            .field("width", &FrameTexture::width, "Pixels.")
            .field("height", &FrameTexture::height, "Pixels; rows go from the bottom.")
            .field("meaning", &FrameTexture::meaning, "Of its values.");
    return record;
}

template <>
struct Words<DepthConvention::Direction> {
    static constexpr WordTable<DepthConvention::Direction, 2> words{
        {{"classic", DepthConvention::Direction::classic},
         {"reversed", DepthConvention::Direction::reversed}}};
};

namespace {

nb::dict textures(const FrameHandle& self) {
    const std::vector<FrameTexture> all = reading(self, [](FrameData& frame) {
        std::vector<FrameTexture> handed = frame.frame->textures();
        if (frame.accumulates)
            *std::ranges::find(handed, "radiance", &FrameTexture::name) =
                frame.renderer->accumulator->radianceTexture();
        return handed;
    });
    nb::dict result;
    for (const FrameTexture& texture : all) result[texture.name.c_str()] = nb::cast(texture);
    return result;
}

FrameTexture displayTexture(const FrameHandle& self, const nb::kwargs& shown) {
    const DisplayTransform transform = transformOf(self, shown);
    return reading(self, [&](FrameData& frame) {
        return frame.accumulates ? frame.renderer->accumulator->displayTexture(transform)
                                 : frame.frame->displayTexture(transform);
    });
}

void display(const FrameHandle& self, std::uint32_t framebuffer, int x, int y, const nb::kwargs& shown) {
    const DisplayTransform transform = transformOf(self, shown);
    reading(self, [&](FrameData& frame) {
        const FrameTarget target{framebuffer, x, y};
        if (frame.accumulates)
            frame.renderer->accumulator->display(transform, target);
        else
            frame.frame->display(transform, target);
    });
}

void writeDepth(const FrameHandle& self, std::uint32_t framebuffer, int x, int y, nb::handle direction,
                std::optional<float> nearPlane, std::optional<float> farPlane) {
    const DepthConvention convention{Convert<DepthConvention::Direction>::from(direction, "direction"),
                                     nearPlane, farPlane};
    reading(self, [&](FrameData& frame) { frame.frame->writeDepth({framebuffer, x, y}, convention); });
}

}  // namespace

void bindFrameTextures(nb::module_& module, nb::class_<FrameHandle>& cls) {
    bindValue<FrameTexture>(module,
                            "A texture that a Frame has been drawn into, for hosts that share its context. "
                            "They read it only.");
    cls.def("textures", &textures, nb::sig("def textures(self) -> dict[str, FrameTexture]"),
            "The textures of the frame by name: 'radiance', 'depth' and the words of the G-buffer "
            "(docs/embedding.md), which with many samples are those of the last one, while 'radiance' is "
            "the mean. Their content is the frame's until its Renderer draws again.")
        .def(
            "display_texture", &displayTexture, nb::arg("shown"),
            nb::sig(kept(std::string("def display_texture(self, *, ") + shownKeywords + ") -> FrameTexture")),
            "Shows it in a texture of its size, GL_RGBA8, code values of the display. Its content is valid "
            "until the next frame or the next call that shows one.")
        .def("display", &display, nb::arg("framebuffer") = 0, nb::arg("x") = 0, nb::arg("y") = 0,
             nb::arg("shown"),
             nb::sig(kept(std::string("def display(self, framebuffer: int = 0, x: int = 0, y: int = 0, *, ") +
                          shownKeywords + ") -> None")),
             "Shows it in a framebuffer of a host's context (`Context.adopt_current`); x, y: its lower left "
             "corner.")
        .def("write_depth", &writeDepth, nb::arg("framebuffer") = 0, nb::arg("x") = 0, nb::arg("y") = 0,
             nb::kw_only(), nb::arg("direction") = "classic", nb::arg("near_plane") = nb::none(),
             nb::arg("far_plane") = nb::none(),
             nb::sig("def write_depth(self, framebuffer: int = 0, x: int = 0, y: int = 0, *, direction: "
                     "typing.Literal['classic', 'reversed'] = 'classic', near_plane: float | None = None, "
                     "far_plane: float | None = None) -> None"),
             "Writes the depth of the opaque surfaces into the depth buffer of a host's framebuffer: "
             "'classic' is 0 at the near plane and 1 at the far one, 'reversed' the other way. Planes are "
             "those of the host's projection, metres; None: those of the view. With many samples the depth "
             "is that of the last one.");
}

}  // namespace candela::python
