"""Pictures as arrays, with values that follow from geometry and physics."""

import numpy as np
import pytest

import candela
from conftest import square

# Most pictures here are lit by what they state alone.
dark = {"environment": None, "samples": 1, "width": 64, "height": 48}


def test_shapes_and_types(renderer, wall, ahead):
    frame = renderer.render(wall, ahead, aovs=["depth", "N"], **dark)
    assert frame.radiance().shape == (48, 64, 4) and frame.radiance().dtype == np.float32
    assert frame.rgba().shape == (48, 64, 4) and frame.rgba().dtype == np.uint8
    assert frame.rgb().shape == (48, 64, 3)
    np.testing.assert_array_equal(frame.rgb(), frame.rgba()[..., :3])
    assert frame["depth"].shape == (48, 64) and frame["normal"].shape == (48, 64, 3)
    assert set(frame.aovs) == {"Z", "N"}
    assert (frame.width, frame.height, frame.samples) == (64, 48, 1)


def test_depth_and_normals_of_a_wall(renderer, wall, ahead):
    frame = renderer.render(wall, ahead, aovs=["depth", "normal", "position"], **dark)
    # Depth is a 32-bit float of near / Z.
    np.testing.assert_allclose(frame["depth"], 2.0, rtol=1e-5)
    # Codes of 12 bits an axis.
    np.testing.assert_allclose(frame["normal"], np.broadcast_to((0, 0, 1), (48, 64, 3)), atol=1e-3)
    np.testing.assert_allclose(frame["position"][..., 2], 0.0, atol=1e-4)


@pytest.mark.parametrize("samples", [1, 16])
def test_an_unlit_surface_has_its_base_colour(renderer, ahead, samples):
    scene = candela.Scene()
    scene.add_mesh(*square(4.0), material=candela.Material(base_color=(0.2, 0.4, 0.8), unlit=True))
    frame = renderer.render(scene, ahead, **{**dark, "samples": samples})
    # The G-buffer stores 8 bits by the sRGB curve: half a code is 0.4 % of full scale.
    np.testing.assert_allclose(frame.radiance()[..., :3], np.broadcast_to((0.2, 0.4, 0.8), (48, 64, 3)), atol=4e-3)
    assert frame.samples == samples


def test_light_falls_off_with_the_square_of_the_distance(renderer, wall, ahead):
    uploaded = renderer.upload(wall, environment=None)
    middle = []
    for distance in (1.0, 2.0):
        uploaded.set_lights([[0, 0, distance]], intensity=10.0, range=100.0, casts_shadow=False)
        middle.append(renderer.render(uploaded, ahead, width=63, height=47, samples=1).radiance()[23, 31, :3])
    # The window that ends the range of 100 m takes 1e-7 of it here; radiance is in float32.
    np.testing.assert_allclose(middle[0] / middle[1], 4.0, rtol=1e-3)


def test_every_aov_that_the_table_names_can_be_read(renderer, wall, ahead):
    wall.add_lights([[0, 0, 1.5]], intensity=5.0, range=4.0)
    names = candela.aov_names()
    assert set(names) <= set(candela.aov_meanings())
    frame = renderer.render(wall, ahead, aovs=names, **dark)
    assert list(frame.aovs) == names
    for array in frame.aovs.values():
        assert array.shape[:2] == (48, 64) and array.dtype == np.float32 and np.isfinite(array).all()


def test_an_aov_that_was_not_asked_for(renderer, wall, ahead):
    np.testing.assert_allclose(renderer.render(wall, ahead, **dark)["base_color"], 0.5, atol=4e-3)
    many = renderer.render(wall, ahead, **{**dark, "samples": 4})
    with pytest.raises(candela.InputError, match=r"the AOV 'base_color' is not in a Frame of many samples"):
        many["base_color"]
    with pytest.raises(candela.InputError, match="no_such"):
        renderer.render(wall, ahead, aovs=["no_such"], **dark)


def test_a_frame_that_was_drawn_over_says_so_and_its_arrays_stay(renderer, wall, ahead):
    first = renderer.render(wall, ahead, aovs=["depth"], **dark)
    radiance = first.radiance()
    kept = radiance.copy()
    renderer.render(wall, candela.look_at((0, 0, 5), (0, 0, 0)), **dark)
    np.testing.assert_array_equal(radiance, kept)
    np.testing.assert_allclose(first["depth"], 2.0, rtol=1e-5)
    with pytest.raises(candela.InputError, match="this Frame was overwritten by a later one"):
        first.rgb()


def test_a_scene_is_uploaded_again_when_it_has_changed(renderer, wall, ahead):
    wall.materials[0].unlit = True
    assert abs(renderer.render(wall, ahead, **dark).radiance()[24, 32, 0] - 0.5) < 4e-3
    wall.materials[0].base_color = (0.25, 0.25, 0.25)
    assert abs(renderer.render(wall, ahead, **dark).radiance()[24, 32, 0] - 0.25) < 4e-3


def test_edits_of_an_uploaded_scene(renderer, wall, ahead):
    wall.materials[0].unlit = True
    uploaded = renderer.upload(wall, environment=None)
    size = {"width": 64, "height": 48, "samples": 1}
    uploaded.set_material(0, candela.Material(base_color=(1, 0, 0), unlit=True))
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size).radiance()[24, 32, :3], (1, 0, 0), atol=4e-3)
    uploaded.set_transform(0, [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 1]])
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 3.0, rtol=1e-5)
    uploaded.set_visible(0, False)
    assert (renderer.render(uploaded, ahead, **size).radiance() == 0).all()
    with pytest.raises(candela.InputError, match="node 5"):
        uploaded.set_visible(5, False)
    assert uploaded.report()["triangles"] == 2


def test_elements_are_added_replaced_and_removed(renderer, wall, ahead):
    wall.materials[0].unlit = True
    uploaded = renderer.upload(wall, environment=None)
    size = {"width": 64, "height": 48, "samples": 1}
    paint = uploaded.add_material(candela.Material(base_color=(0, 1, 0), unlit=True))
    corners, triangles = square(4.0, z=0.5)
    mesh = candela.Mesh(positions=corners, normals=np.tile((0.0, 0, 1), (4, 1)), indices=triangles,
                        submeshes=[candela.Submesh(index_count=6, material=paint.index)])
    shape = uploaded.add_mesh(mesh)
    node = uploaded.add_node(candela.Node(mesh=shape.index))
    frame = renderer.render(uploaded, ahead, **size)
    np.testing.assert_allclose(frame["depth"][24, 32], 1.5, rtol=1e-5)
    np.testing.assert_allclose(frame.radiance()[24, 32, :3], (0, 1, 0), atol=4e-3)
    uploaded.set_positions(shape, corners + (0, 0, 0.5))
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 1.0, rtol=1e-5)
    away = np.eye(4)
    away[2, 3] = -1.0
    uploaded.set_transforms([wall.nodes[0], node], [away, away])
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 2.0, rtol=1e-5)
    uploaded.set_visibilities([0, node], [True, False])
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 3.0, rtol=1e-5)
    uploaded.remove_node(node)
    uploaded.remove_mesh(shape)
    with pytest.raises(candela.InputError):
        uploaded.set_visible(node, True)
    with pytest.raises(candela.InputError, match=r"\(2, 4, 4\), one for each node"):
        uploaded.set_transforms([0, 0], np.eye(4))
    with pytest.raises(candela.InputError, match="an index or a NodeHandle, or a Node of the scene, not an object of type MeshHandle"):
        uploaded.set_visible(shape, True)


def test_lights_of_an_uploaded_scene(renderer, wall, ahead):
    wall.add_lights([[0, 0, 1]], intensity=10.0, range=100.0)
    uploaded = renderer.upload(wall, environment=None)
    size = {"width": 63, "height": 47, "samples": 1}
    one = renderer.render(uploaded, ahead, **size).radiance()[23, 31, 0]
    added = uploaded.add_light(candela.Light(position=(0, 0, 1), intensity=10.0, range=100.0))
    two = renderer.render(uploaded, ahead, **size).radiance()[23, 31, 0]
    uploaded.set_light(0, candela.Light(position=(0, 0, 1), intensity=20.0, range=100.0))
    uploaded.remove_light(added)
    brighter = renderer.render(uploaded, ahead, **size).radiance()[23, 31, 0]
    np.testing.assert_allclose([two, brighter], 2.0 * one, rtol=1e-5)


def test_node_ids_and_picks(renderer, wall, ahead):
    wall.add_mesh(*square(0.5, z=0.5), material=candela.Material(), name="card")
    frame = renderer.render(wall, ahead, aovs=["node_id", "material_id"], **dark)
    # 0 is the background: ids are indices and 1.
    assert frame["node_id"][24, 32] == 2 and frame["node_id"][1, 1] == 1 and frame["material_id"][24, 32] == 2
    card, whole = frame.pick(32, 24), frame.pick(0, 0, 64, 48)
    assert [each.node for each in card] == [1] and abs(card[0].depth - 1.5) < 1e-4
    assert [each.node for each in whole] == [0, 1] and whole[1].pixels == (frame["node_id"] == 2).sum()


def test_motion_is_that_of_the_camera(renderer, wall, ahead):
    before = candela.look_at((0.1, 0, 2), (0.1, 0, 0))
    motion = renderer.render(wall, ahead, aovs=["motion"], previous_camera=before, **dark)["motion"]
    # The wall moves to the right: 0.1 m at 2 m with a focal length of 24 / tan(22.5 degrees) pixels.
    np.testing.assert_allclose(motion[24, 32], (0.1 / 2.0 * 24 / np.tan(np.pi / 8), 0), atol=1e-3)


def test_a_picture_is_drawn_in_parts(renderer, wall, ahead):
    wall.add_lights([[0.4, 0.2, 0.7]], intensity=3.0)
    whole = renderer.render(wall, ahead, **{**dark, "width": 64, "height": 64}).radiance()
    part = renderer.render(wall, ahead, region=(32, 16, 64, 64), **{**dark, "width": 32, "height": 48}).radiance()
    # The same to the rounding of the projection, which moves a pixel by some millionths.
    np.testing.assert_allclose(part, whole[16:, 32:], rtol=1e-3, atol=1e-5)


def test_samples_are_added_to_a_frame(renderer, wall, ahead):
    wall.add_lights([[0.5, 0.3, 1.0]], intensity=5.0, radius=0.2)
    wall.add_mesh(*square(0.3, z=0.3), name="blocker")
    whole = renderer.render(wall, ahead, aovs=["depth"], **{**dark, "samples": 32}).radiance()
    frame = renderer.render(wall, ahead, aovs=["depth"], **{**dark, "samples": 8})
    assert frame.add_samples(24) is frame and frame.samples == 32
    # The same samples in other groups: sums of floats in another order.
    np.testing.assert_allclose(frame.radiance(), whole, rtol=1e-4, atol=1e-6)
    with pytest.raises(candela.InputError, match="count of samples"):
        frame.add_samples(65536)


def test_exposure_in_stops_and_automatic(renderer, wall, ahead):
    wall.materials[0].unlit = True
    wall.materials[0].base_color = (0.02, 0.02, 0.02)
    frame = renderer.render(wall, ahead, **dark)
    plain = frame.rgb()[24, 32, 0]
    assert frame.rgb(exposure=2.0)[24, 32, 0] > plain
    # From 0.02 to mid-grey, 0.18. 8 bits in sRGB are 3 % apart at 0.02.
    assert abs(frame.auto_exposure() - np.log2(0.18 / 0.02)) < 0.1
    # sRGB of 0.18 is code 118; dither adds half a code.
    assert abs(int(frame.rgb(exposure="auto")[24, 32, 0]) - 118) <= 3
    with pytest.raises(candela.InputError, match="exposure: expected stops or 'auto', not 'high'"):
        frame.rgb(exposure="high")
    with pytest.raises(candela.InputError, match="no-such-view"):
        frame.rgb(view="no-such-view")


def test_notes_tell_what_is_wrong_with_a_picture(renderer, wall, ahead):
    assert "lit" in renderer.render(wall, ahead, **dark).notes()[0]
    away = candela.look_at((0, 0, 2), (0, 0, 4))
    assert "in view" in renderer.render(wall, away, **dark).notes()[0]


def test_a_scene_without_light_gets_a_studio_with_a_warning(renderer, wall, ahead):
    with pytest.warns(candela.CandelaWarning, match="a studio lights it"):
        frame = renderer.render(wall, ahead, width=32, height=24, samples=1)
    assert frame.radiance()[12, 16, 0] > 0.05


def test_a_frame_shows_data_as_colours(renderer, wall, ahead):
    frame = renderer.render(wall, ahead, show="normals", environment=None, width=32, height=24)
    # 0.5 + 0.5 n of (0, 0, 1), up to the packing of normals.
    np.testing.assert_allclose(frame.rgb()[12, 16], (128, 128, 255), atol=1)


def test_the_probe_of_a_pixel(renderer, wall, ahead):
    frame = renderer.render(wall, ahead, **dark)
    probe = frame.probe(32, 24)
    assert probe.node == 0 and abs(probe.depth - 2.0) < 1e-4 and abs(probe.roughness - 1.0) < 0.01
    assert renderer.render(wall, candela.look_at((0, 0, 2), (0, 0, 4)), **dark).probe(1, 1) is None
    with pytest.raises(candela.InputError):
        frame.probe(64, 0)


def test_settings_as_a_value_and_as_keywords(renderer, wall, ahead):
    settings = candela.RenderSettings(width=40, height=30, samples=2)
    frame = renderer.render(wall, ahead, settings=settings, height=20, environment=None)
    assert (frame.width, frame.height, frame.samples) == (40, 20, 2)
    for wrong, error, text in (
        ({"width": 0}, candela.InputError, "width and height"),
        ({"samples": 0}, candela.InputError, "samples"),
        ({"technique": "magic"}, candela.InputError, "RenderSettings.technique: expected one of 'auto'"),
        ({"witdh": 3}, TypeError, "RenderSettings has no attribute 'witdh'"),
        ({"aovs": "depth"}, candela.InputError, "aovs: expected a sequence of names"),
    ):
        with pytest.raises(error, match=text):
            renderer.render(wall, ahead, **wrong)


def test_cameras_of_the_scene(renderer, wall):
    wall.nodes.append(candela.Node(name="stand", translation=(0, 0, 3)))
    wall.cameras.append(candela.Camera(name="front", node=1, near_plane=0.1))
    wall.cameras.append(candela.Camera(name="other", node=1, near_plane=0.1, vertical_fov=0.3))
    for camera in (None, 0, "front", "stand"):
        frame = renderer.render(wall, camera, **dark)
        np.testing.assert_allclose(frame["depth"][24, 32], 3.0, rtol=1e-5)
        assert frame.camera.vertical_fov == pytest.approx(0.785398)
    assert renderer.render(wall, "other", **dark).camera.vertical_fov == pytest.approx(0.3)
    with pytest.raises(candela.InputError, match="no camera 'back'; there are 'front', 'other'"):
        renderer.render(wall, "back", **dark)


def test_progress_and_cancelling(renderer, wall, ahead):
    shares = []
    renderer.render(wall, ahead, **{**dark, "samples": 40}, progress=shares.append)
    assert shares == [pytest.approx(0.4), pytest.approx(0.8), 1.0]
    with pytest.raises(candela.CancelledError):
        renderer.render(wall, ahead, **{**dark, "samples": 40}, progress=lambda share: False)
    with pytest.raises(ZeroDivisionError):
        renderer.render(wall, ahead, **{**dark, "samples": 40}, progress=lambda share: 1 / 0)
    with pytest.raises(candela.InputError, match="by a callback or a signal handler"):
        renderer.render(wall, ahead, **{**dark, "samples": 40}, progress=lambda share: renderer.render(wall, ahead, **dark))


def test_animations_move_with_time(renderer, wall, ahead):
    wall.materials[0].unlit = True
    wall.animations.append(
        candela.Animation(channels=[candela.AnimationChannel(node=0, path="translation", times=[0, 1], values=[0, 0, 0, 0, 0, -2])])
    )
    for time, depth in ((0.0, 2.0), (0.5, 3.0), (1.0, 4.0)):
        frame = renderer.render(wall, ahead, time=time, **dark)
        np.testing.assert_allclose(frame["depth"][24, 32], depth, rtol=1e-5)
    # Half a frame at one frame a second about 0.5 s: the mean distance stays.
    blurred = renderer.render(wall, ahead, time=0.5, aovs=["depth"], aov_filter="average", shutter=0.5,
                              frames_per_second=1.0, **{**dark, "samples": 16})
    np.testing.assert_allclose(blurred["depth"][24, 32], 3.0, atol=0.05)
