"""Files: pictures that are written and read, and scenes that are loaded with what there is to know of them."""

import struct
import warnings
import zlib

import numpy as np
import pytest

import candela

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"


def read_png(path):
    """The pixels of an 8-bit PNG with or without alpha, by the format's own description (no interlace)."""
    data = path.read_bytes()
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    channels = {2: 3, 6: 4}[kind]
    assert depth == 8
    at, packed = 8, b""
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + size] if name == b"IDAT" else b""
        at += size + 12
    stride = channels * width
    rows = np.frombuffer(zlib.decompress(packed), np.uint8).reshape(height, 1 + stride)
    result = np.zeros((height, stride), np.uint8)
    for y, (filtered, row) in enumerate(zip(rows[:, 0], rows[:, 1:].astype(int))):
        above = result[y - 1].astype(int) if y else np.zeros(stride, int)
        line = np.zeros(stride, int)
        for x in range(stride):
            left, corner = (line[x - channels], above[x - channels]) if x >= channels else (0, 0)
            distances = [abs(above[x] - corner), abs(left - corner), abs(left + above[x] - 2 * corner)]
            paeth = (left, above[x], corner)[int(np.argmin(distances))]
            line[x] = (row[x] + (0, left, above[x], (left + above[x]) // 2, paeth)[filtered]) & 255
        result[y] = line
    return result.reshape(height, width, channels)


def test_png_has_the_pixels_that_were_given(tmp_path):
    pixels = np.random.default_rng(4).integers(0, 256, (7, 9, 3), dtype=np.uint8)
    candela.write_png(tmp_path / "a.png", pixels)
    read = read_png(tmp_path / "a.png")
    np.testing.assert_array_equal(read[..., :3], pixels)
    assert (read[..., 3:] == 255).all()
    candela.write_png(tmp_path / "grey.png", pixels[..., 0])
    np.testing.assert_array_equal(read_png(tmp_path / "grey.png")[..., 2], pixels[..., 0])
    with pytest.raises(candela.InputError, match="write_png: expected pixels"):
        candela.write_png(tmp_path / "b.png", pixels.astype(float))


def test_exr_comes_back(tmp_path):
    picture = np.random.default_rng(5).random((6, 8, 3)).astype(np.float32)
    candela.write_exr(tmp_path / "a.exr", {"": picture, "depth": picture[..., 0], "N": picture}, {"made by": "a test"})
    np.testing.assert_array_equal(candela.read_hdr(tmp_path / "a.exr")[..., :3], picture)
    header = (tmp_path / "a.exr").read_bytes()[:2000]
    for name in (b"R\0", b"depth\0", b"N.B\0", b"made by\0"):
        assert name in header
    with pytest.raises(candela.InputError, match="the shape of the arrays before it"):
        candela.write_exr(tmp_path / "b.exr", {"a": picture, "b": picture[1:]})


def test_frames_are_saved(renderer, wall, ahead, tmp_path):
    frame = renderer.render(wall, ahead, width=48, height=32, samples=4, aovs=["depth"], environment=candela.Environment.studio())
    frame.save(tmp_path / "a.png")
    np.testing.assert_array_equal(read_png(tmp_path / "a.png")[..., :3], frame.rgb())
    frame.save(tmp_path / "a.exr")
    np.testing.assert_array_equal(candela.read_hdr(tmp_path / "a.exr")[..., :3], frame.radiance()[..., :3])
    assert b"Z\0" in (tmp_path / "a.exr").read_bytes()[:2000]
    with pytest.raises(candela.InputError, match="a.jpg: a picture is saved as .png or .exr"):
        frame.save(tmp_path / "a.jpg")
    with pytest.raises(candela.MachineError, match="missing"):
        frame.save(tmp_path / "missing" / "a.png")
    with pytest.raises(candela.InputError, match="scene-linear"):
        frame.save(tmp_path / "a.exr", exposure=1.0)


def test_a_dark_picture_is_saved_with_a_warning(renderer, wall, ahead, tmp_path):
    frame = renderer.render(wall, ahead, width=48, height=32, samples=1, environment=None)
    with pytest.warns(candela.CandelaWarning, match="next to nothing in view is lit"):
        frame.save(tmp_path / "a.png")


def test_procedural_scenes_are_loaded():
    scene = candela.load("plaza:256")
    assert len(scene.lights) == 256 and scene.plugin == "plaza" and scene.source == "plaza:256"
    assert scene.has_light() and scene.triangle_count() > 256


def test_losses_are_warnings_errors_or_nothing(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text(TRIANGLE + "mtllib missing.mtl\nusemtl paint\nf 1 2 3\n")
    with pytest.warns(candela.CandelaWarning, match="missing.mtl"):
        scene = candela.load(path)
    assert len(scene.meshes) == 1 and scene.notes[0].kind == "missing" and "missing.mtl" in str(scene.notes[0])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        candela.load(path, notes="ignore")
    with pytest.raises(candela.InputError, match="missing.mtl"):
        candela.load(path, notes="error")


def test_files_that_can_not_be_loaded(tmp_path):
    with pytest.raises(candela.MachineError, match="none.glb") as raised:
        candela.load(tmp_path / "none.glb")
    assert raised.value.path == str(tmp_path / "none.glb") and isinstance(raised.value, candela.Error)
    (tmp_path / "a.glb").write_bytes(b"no glTF")
    with pytest.raises(candela.InputError, match="a.glb"):
        candela.load(tmp_path / "a.glb")
    with pytest.raises(candela.Error, match="txt"):
        candela.load("a.txt")


def test_loading_is_cancelled(tmp_path):
    shares = []
    candela.load("plaza:100", progress=shares.append)
    assert shares and all(0.0 <= share <= 1.0 for share in shares)
    with pytest.raises(candela.CancelledError):
        candela.load("plaza:100", progress=lambda share: False)


def test_animations_are_selected():
    with pytest.raises(candela.InputError, match="no animation 'run'; there are: "):
        candela.load("crowd:2", animation="run")
    assert not any(each.plays for each in candela.load("crowd:2", animation="none").animations)
    assert [each.plays for each in candela.load("crowd:2").animations][:1] == [True]


def test_errors_are_pickled():
    import pickle

    error = pickle.loads(pickle.dumps(candela.LimitError("too large", "a.png")))
    assert type(error) is candela.LimitError and str(error) == "too large" and error.path == "a.png"
