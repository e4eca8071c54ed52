"""What hosts take of a frame: arrays that are read later, textures, depth, panoramas."""

import ctypes
import threading
import time

import numpy as np
import pytest

import candela
from conftest import square

GL_TEXTURE_2D, GL_FLOAT, GL_UNSIGNED_BYTE = 0x0DE1, 0x1406, 0x1401
GL_RGBA, GL_RGBA8, GL_RGBA32F = 0x1908, 0x8058, 0x8814
GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT32F = 0x1902, 0x8CAC


@pytest.fixture
def lit_wall(wall):
    wall.add_lights([[0.5, 0.3, 1.0]], intensity=5.0, radius=0.2)
    wall.add_mesh(*square(0.3, z=0.3), name="card")
    return wall


@pytest.mark.parametrize("samples", [1, 4])
def test_pictures_are_read_later(renderer, lit_wall, ahead, samples):
    """Also after the next frame, bit for bit what reading at once returns."""
    pending, expected = [], []
    for distance in (2.0, 3.0):
        view = candela.look_at((0, 0, distance), (0, 0, 0))
        frame = renderer.render(lit_wall, view, width=64, height=48, samples=samples, environment=None)
        pending += [frame.radiance_async(), frame.rgba_async(exposure=1.0), frame.rgb_async(exposure="auto")]
        expected += [frame.radiance(), frame.rgba(exposure=1.0), frame.rgb(exposure="auto")]
    for later, now in zip(reversed(pending), reversed(expected)):
        assert later.result().dtype == now.dtype
        np.testing.assert_array_equal(later.result(), now)
        assert later.result() is later.result() and later.done()
    assert not np.array_equal(expected[0], expected[3])
    with pytest.raises(candela.InputError, match="overwritten"):
        first = renderer.render(lit_wall, ahead, width=64, height=48, samples=1, environment=None)
        renderer.render(lit_wall, ahead, width=64, height=48, samples=1, environment=None)
        first.radiance_async()
    with pytest.raises(candela.InputError, match="exposure: expected stops or 'auto'"):
        renderer.render(lit_wall, ahead, width=64, height=48, samples=1, environment=None).rgb_async(exposure="high")


def test_a_pending_array_says_when_it_is_there(renderer, wall, ahead):
    pending = renderer.render(wall, ahead, width=64, height=48, samples=1, environment=None).rgba_async()
    assert repr(pending) == "<PendingArray 64x48>"
    while not pending.done():
        time.sleep(0.001)
    assert pending.result().shape == (48, 64, 4) and repr(pending) == "<PendingArray 64x48, taken>"


def test_any_thread_may_take_a_pending_array(renderer, wall, ahead):
    frame = renderer.render(wall, ahead, width=64, height=48, samples=2, environment=None)
    pending, expected, results = frame.rgb_async(), frame.rgb(), []
    threads = [threading.Thread(target=lambda: results.append(pending.result())) for _ in range(3)]
    for thread in threads:
        thread.start()
    renderer.render(wall, ahead, width=64, height=48, samples=2, environment=None)
    for thread in threads:
        thread.join()
    for result in results:
        assert result is results[0]
    np.testing.assert_array_equal(results[0], expected)


def test_asking_does_not_wait_for_a_thread_that_draws(renderer):
    scene = renderer.upload(candela.load("plaza:2000"))
    pending = renderer.render(scene, width=64, height=48, samples=1).rgba_async()
    drawing, answers = threading.Event(), []

    def ask():
        drawing.wait()
        answers.append(pending.done())
        drawing.clear()

    def progress(share):
        # The other thread asks between two samples of this picture, and gets its answer before the next.
        if share < 1.0 and not answers:
            drawing.set()
            deadline = time.monotonic() + 60.0
            while not answers and time.monotonic() < deadline:
                time.sleep(0.001)

    thread = threading.Thread(target=ask)
    thread.start()
    renderer.render(scene, width=64, height=48, samples=32, progress=progress)
    thread.join()
    assert answers == [False]
    assert pending.result().shape == (48, 64, 4) and pending.done()


def test_a_pending_array_of_a_closed_context_says_so(wall, ahead, capfd):
    with candela.Renderer() as own:
        frame = own.render(wall, ahead, width=32, height=24, samples=1, environment=None)
        taken, left = frame.radiance_async(), frame.rgb_async()
        taken.result()
    assert taken.done() and taken.result().shape == (24, 32, 4)
    for use in (left.done, left.result):
        with pytest.raises(candela.InputError, match="PendingArray is used after its context was closed"):
            use()
    del left
    assert "leaked" not in capfd.readouterr().err


@pytest.mark.parametrize("samples", [1, 4])
def test_textures_are_described(renderer, lit_wall, ahead, samples):
    frame = renderer.render(lit_wall, ahead, width=64, height=48, samples=samples, environment=None)
    textures = frame.textures()
    assert {"radiance", "depth", "surface"} <= set(textures)
    for name, texture in textures.items():
        assert texture.name == name and texture.texture > 0 and texture.target == GL_TEXTURE_2D
        assert (texture.width, texture.height) == (64, 48) and texture.meaning
    assert textures["radiance"].internal_format == GL_RGBA32F
    assert textures["depth"].internal_format == GL_DEPTH_COMPONENT32F
    assert len({texture.texture for texture in textures.values()}) == len(textures)
    shown = frame.display_texture(exposure=1.0)
    assert (shown.name, shown.internal_format, shown.width) == ("display", GL_RGBA8, 64)
    renderer.render(lit_wall, ahead, width=64, height=48, samples=1, environment=None)
    for use in (frame.textures, frame.display_texture, frame.write_depth):
        with pytest.raises(candela.InputError, match="overwritten"):
            use()


class Host:
    """A program with an OpenGL context of its own, by EGL without a surface."""

    def __init__(self):
        self.egl, self.gl = ctypes.CDLL("libEGL.so.1"), ctypes.CDLL("libGL.so.1")
        egl, pointer = self.egl, ctypes.c_void_p
        for name in ("eglGetPlatformDisplay", "eglCreateContext", "eglGetProcAddress"):
            getattr(egl, name).restype = pointer
        # EGL_PLATFORM_SURFACELESS_MESA
        self.display = pointer(egl.eglGetPlatformDisplay(0x31DD, None, None))
        configs, count = (pointer * 1)(), ctypes.c_int()
        # EGL_SURFACE_TYPE 0, EGL_RENDERABLE_TYPE EGL_OPENGL_BIT, EGL_NONE
        wanted = (ctypes.c_int * 5)(0x3033, 0, 0x3040, 0x0008, 0x3038)
        if not egl.eglInitialize(self.display, None, None) or not egl.eglBindAPI(0x30A2):
            pytest.skip("EGL has no display without a surface")
        if not egl.eglChooseConfig(self.display, wanted, configs, 1, ctypes.byref(count)) or count.value == 0:
            pytest.skip("EGL has no config without a surface")
        # EGL_CONTEXT_MAJOR_VERSION 4, MINOR 5, EGL_CONTEXT_OPENGL_PROFILE_MASK core
        version = (ctypes.c_int * 7)(0x3098, 4, 0x30FB, 5, 0x30FD, 1, 0x3038)
        self.context = pointer(egl.eglCreateContext(self.display, pointer(configs[0]), None, version))
        if not self.context or not egl.eglMakeCurrent(self.display, None, None, self.context):
            pytest.skip("EGL makes no context of OpenGL 4.5 without a surface")

    def call(self, name, *arguments):
        self.egl.eglGetProcAddress.argtypes = [ctypes.c_char_p]
        return ctypes.CFUNCTYPE(None)(self.egl.eglGetProcAddress(name.encode()))(*arguments)

    def pixels(self, texture, format, type, dtype, channels):
        """What the texture holds, rows from the top."""
        values = np.empty((texture.height, texture.width, channels), dtype)
        self.call("glGetTextureImage", ctypes.c_uint(texture.texture), 0, format, type, values.nbytes,
                  ctypes.c_void_p(values.ctypes.data))
        return values[::-1]

    def close(self):
        self.egl.eglMakeCurrent(self.display, None, None, None)
        self.egl.eglDestroyContext(self.display, self.context)


@pytest.fixture
def host():
    made = Host()
    yield made
    made.close()


@pytest.mark.parametrize("samples", [1, 4])
def test_a_host_reads_the_textures_of_its_context(host, lit_wall, ahead, samples):
    with candela.Renderer(candela.Context.adopt_current()) as own:
        frame = own.render(lit_wall, ahead, width=64, height=48, samples=samples, aovs=["depth"], aov_filter="first",
                           environment=None)
        textures = frame.textures()
        radiance = host.pixels(textures["radiance"], GL_RGBA, GL_FLOAT, np.float32, 4)
        # Alpha of the texture of one sample is the coverage of transparent layers alone.
        channels = 3 if samples == 1 else 4
        np.testing.assert_array_equal(radiance[..., :channels], frame.radiance()[..., :channels])
        assert radiance[..., :3].max() > 0.1
        shown = host.pixels(frame.display_texture(exposure=1.0), GL_RGBA, GL_UNSIGNED_BYTE, np.uint8, 4)
        np.testing.assert_array_equal(shown, frame.rgba(exposure=1.0))
        depth = host.pixels(textures["depth"], GL_DEPTH_COMPONENT, GL_FLOAT, np.float32, 1)[..., 0]
        # Reversed: near / Z. Samples of many are moved within the pixel, on a wall at right angles to the view.
        card = frame["depth"] < 1.8
        near = frame.camera.near_plane
        inside = slice(2, 46)
        np.testing.assert_allclose(depth[inside, 2:10], near / 2.0, rtol=1e-5)
        assert card[24, 32] and abs(depth[24, 32] - near / 1.7) < 1e-5


def test_a_host_gets_the_picture_and_its_depth(host, lit_wall, ahead):
    width, height = 64, 48
    names = (ctypes.c_uint * 3)()
    host.call("glCreateTextures", GL_TEXTURE_2D, 2, names)
    host.call("glTextureStorage2D", names[0], 1, GL_RGBA8, width, height)
    host.call("glTextureStorage2D", names[1], 1, GL_DEPTH_COMPONENT32F, width, height)
    framebuffer = ctypes.c_uint()
    host.call("glCreateFramebuffers", 1, ctypes.byref(framebuffer))
    host.call("glNamedFramebufferTexture", framebuffer, 0x8CE0, names[0], 0)  # GL_COLOR_ATTACHMENT0
    host.call("glNamedFramebufferTexture", framebuffer, 0x8D00, names[1], 0)  # GL_DEPTH_ATTACHMENT
    color = candela.FrameTexture(texture=names[0], width=width, height=height)
    depth = candela.FrameTexture(texture=names[1], width=width, height=height)
    with candela.Renderer(candela.Context.adopt_current()) as own:
        frame = own.render(lit_wall, ahead, width=width, height=height, samples=1, environment=None)
        frame.display(framebuffer.value)
        np.testing.assert_array_equal(host.pixels(color, GL_RGBA, GL_UNSIGNED_BYTE, np.uint8, 4), frame.rgba())
        near, far = 0.1, 10.0
        frame.write_depth(framebuffer.value, near_plane=near, far_plane=far)
        written = host.pixels(depth, GL_DEPTH_COMPONENT, GL_FLOAT, np.float32, 1)[..., 0]
        # The classic depth of a perspective projection: far / (far - near) (1 - near / z).
        np.testing.assert_allclose(written[24, 10], far / (far - near) * (1 - near / 2.0), atol=1e-5)
        np.testing.assert_allclose(written[24, 32], far / (far - near) * (1 - near / 1.7), atol=1e-5)
        frame.write_depth(framebuffer.value, direction="reversed", near_plane=near, far_plane=far)
        turned = host.pixels(depth, GL_DEPTH_COMPONENT, GL_FLOAT, np.float32, 1)[..., 0]
        np.testing.assert_allclose(turned, 1.0 - written, atol=1e-5)
        for arguments, text in (({"framebuffer": 77}, "framebuffer"), ({"near_plane": -1.0}, "plane"),
                                ({"direction": "up"}, "direction: expected one of 'classic', 'reversed'")):
            with pytest.raises(candela.InputError, match=text):
                frame.write_depth(**{"framebuffer": framebuffer.value, **arguments})


def room(size=2.0):
    """A cube seen from inside, whose walls +X, -X, +Y, -Y, +Z and -Z have colours of their own."""
    scene = candela.Scene()
    colors = {(1, 0, 0): (1, 0, 0), (-1, 0, 0): (0, 1, 1), (0, 1, 0): (0, 1, 0), (0, -1, 0): (1, 0, 1), (0, 0, 1): (0, 0, 1),
              (0, 0, -1): (1, 1, 0)}
    for normal, color in colors.items():
        corners, triangles = square(size, z=-0.5 * size)
        axis = np.abs(normal).argmax()
        # Turns the square, which faces +Z from -Z, to stand at `normal` and face the middle.
        back = -np.array(normal, float)
        up = np.array((0, 1, 0) if axis != 1 else (1, 0, 0), float)
        basis = np.stack([np.cross(up, back), up, back], axis=1)
        scene.add_mesh(corners @ basis.T, triangles, material=candela.Material(base_color=color, unlit=True))
    return scene, colors


@pytest.mark.parametrize("samples", [1, 2])
def test_a_panorama_shows_every_direction_where_it_belongs(renderer, samples):
    scene, colors = room()
    view = candela.look_at((0, 0, 0), (0, 0, -1), near_plane=0.01)
    width = 128
    shares = []
    picture = renderer.render_panorama(scene, view, width=width, samples=samples, environment=None, progress=shares.append)
    assert picture.shape == (64, 128, 4) and picture.dtype == np.float32
    assert len(shares) == 6 and shares[-1] == 1.0 and shares == sorted(shares)
    x, y = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(64) + 0.5) / 64)
    longitude, latitude = 2 * np.pi * (x - 0.5), np.pi * (0.5 - y)
    direction = np.stack([np.cos(latitude) * np.sin(longitude), np.sin(latitude), -np.cos(latitude) * np.cos(longitude)], -1)
    wall = np.abs(direction).argmax(-1)
    sign = np.sign(np.take_along_axis(direction, wall[..., None], -1))[..., 0]
    expected = np.zeros((64, 128, 3))
    for normal, color in colors.items():
        axis = np.abs(normal).argmax()
        expected[(wall == axis) & (sign == normal[axis])] = color
    # Pixels within two of an edge of the room mix two walls.
    largest, middle = np.sort(np.abs(direction), -1)[..., 2], np.sort(np.abs(direction), -1)[..., 1]
    inside = largest - middle > 2 * 2 * np.pi / width
    assert inside.mean() > 0.6
    # 8 bits by the sRGB curve in the G-buffer hold 0 and 1 exactly.
    np.testing.assert_allclose(picture[inside][:, :3], expected[inside], atol=1e-5)
    np.testing.assert_allclose(picture[..., 3], 1.0, atol=1e-5)


def test_a_panorama_is_shown_as_frames_are(renderer, lit_wall, ahead):
    frame = renderer.render(lit_wall, ahead, width=64, height=48, samples=1, environment=None)
    shown = renderer.color.display_picture(frame.radiance(), exposure=1.0)
    assert shown.shape == (48, 64, 4) and shown.dtype == np.uint8
    # On software devices the same code shows both; on GPUs a baked transform is a code off.
    np.testing.assert_allclose(shown.astype(int), frame.rgba(exposure=1.0).astype(int), atol=1)
    np.testing.assert_array_equal(renderer.color.display_picture(frame.radiance()[..., :3])[..., 3], 255)
    np.testing.assert_array_equal(renderer.color.display_picture(frame.radiance(), exposure="auto"),
                                  renderer.color.display_picture(frame.radiance(), exposure=frame.auto_exposure()))
    with pytest.raises(candela.InputError, match=r"radiance: expected numbers of shape \(height, width, 4\)"):
        renderer.color.display_picture(np.zeros((4, 4)))


def test_a_panorama_names_what_it_does_not_take(renderer, wall, ahead):
    for options, error, text in (
        ({"height": 64}, TypeError, "render_panorama has no option 'height'"),
        ({"aovs": ["Z"]}, TypeError, "render_panorama has no option 'aovs'"),
        ({"widht": 64}, TypeError, "RenderSettings has no attribute 'widht'"),
        ({"width": 63}, candela.InputError, "63"),
        ({"width": 2}, candela.InputError, "2"),
        ({"settings": candela.RenderSettings(show="normals")}, candela.InputError, "show data"),
        ({"samples": 4, "progress": lambda share: False}, candela.CancelledError, "cancelled"),
    ):
        with pytest.raises(error, match=text):
            renderer.render_panorama(wall, ahead, **{"width": 64, "environment": None, "samples": 1, **options})
    flat = ahead.replace(orthographic_height=2.0)
    with pytest.raises(candela.InputError, match="perspective"):
        renderer.render_panorama(wall, flat, width=64, environment=None, samples=1)
