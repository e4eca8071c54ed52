"""Scenes as values: arrays in and out, handles, and errors that name what is wrong."""

import threading

import numpy as np
import pytest

import candela
from conftest import square


def test_arrays_come_back_as_they_were_given():
    positions = np.random.default_rng(1).normal(size=(5, 3))
    mesh = candela.Mesh(positions=positions, indices=[[0, 1, 2], [2, 3, 4]], uv0=np.zeros((5, 2)))
    assert mesh.positions.dtype == np.float32 and mesh.indices.dtype == np.uint32
    np.testing.assert_array_equal(mesh.positions, positions.astype(np.float32))
    np.testing.assert_array_equal(mesh.indices, [0, 1, 2, 2, 3, 4])
    assert mesh.uv0.shape == (5, 2) and mesh.normals.shape == (0, 3)


def test_arrays_of_any_type_order_and_stride_are_taken():
    base = np.asfortranarray(np.arange(24, dtype=np.int16).reshape(8, 3))
    mesh = candela.Mesh(positions=base[::2])
    np.testing.assert_array_equal(mesh.positions, base[::2])


def test_what_is_read_is_a_copy_that_can_not_be_written():
    mesh = candela.Mesh(positions=[[0, 0, 0]])
    with pytest.raises(ValueError, match="read-only"):
        mesh.positions[0, 0] = 1.0
    with pytest.raises(ValueError, match="read-only"):
        candela.Material().base_color[0] = 0.0


@pytest.mark.parametrize(
    "make, text",
    [
        (lambda: candela.Mesh(positions=np.zeros((4, 2))), r"Mesh.positions: expected numbers of shape \(N, 3\), not an array of shape \(4, 2\)"),
        (lambda: candela.Mesh(positions="abc"), r"Mesh.positions: expected numbers of shape \(N, 3\), not 'abc'"),
        (lambda: candela.Mesh(indices=[0, 1, -1]), r"Mesh.indices: number 2 is -1, which is no index"),
        (lambda: candela.Mesh(indices=[0.5, 1, 2]), r"Mesh.indices: expected whole numbers"),
        (lambda: candela.Material(roughness="rough"), r"Material.roughness: expected a number, not 'rough'"),
        (lambda: candela.Material(alpha_mode="glass"), r"Material.alpha_mode: expected one of 'opaque', 'mask', 'blend', not 'glass'"),
        (lambda: candela.Material(double_sided=2), r"Material.double_sided: expected True or False, not 2"),
        (lambda: candela.Node(mesh=-1), r"Node.mesh: expected a whole number of 0 to 4294967295, not -1"),
        (lambda: candela.Node(mesh=2**80), r"Node.mesh: expected a whole number"),
        (lambda: candela.Node(matrix=np.eye(3)), r"Node.matrix: expected numbers of shape \(N, 4\)"),
        (lambda: candela.Light(color=(1, 1)), r"Light.color: expected 3 numbers"),
        (lambda: candela.Image(pixels=np.zeros((2, 2, 2))), r"Image.pixels: expected pixels of shape"),
        (lambda: candela.Material(base_color_texture=3), r"Material.base_color_texture: expected a Texture, not 3"),
    ],
)
def test_wrong_values_are_errors_that_name_the_attribute(make, text):
    with pytest.raises(candela.InputError, match=text):
        make()


def test_an_unknown_attribute_lists_those_there_are():
    with pytest.raises(TypeError, match="Material has no attribute 'colour'; it has name, base_color"):
        candela.Material(colour=(1, 1, 1))


def test_an_appended_element_is_that_of_the_scene():
    scene = candela.Scene()
    material = candela.Material(roughness=0.25)
    with pytest.raises(candela.InputError, match="the Material belongs to no scene yet"):
        material.index
    assert scene.materials.append(material) == 0 and material.index == 0
    material.roughness = 0.75
    assert scene.materials[0].roughness == 0.75
    assert scene.materials.append(material) == 1, "an element that belongs to a scene is copied"
    scene.materials[1].roughness = 0.5
    assert material.roughness == 0.75


def test_elements_are_found_by_index_and_name():
    scene = candela.Scene()
    for name in ("a", "b", "c"):
        scene.nodes.append(candela.Node(name=name))
    assert scene.nodes["b"].index == 1 and scene.nodes[-1].name == "c" and len(scene.nodes) == 3
    assert [node.name for node in scene.nodes] == ["a", "b", "c"] and repr(scene.nodes) == "<NodeList of 3>"
    with pytest.raises(KeyError, match="the scene has no Node 'd'"):
        scene.nodes["d"]
    with pytest.raises(IndexError, match="Node 3 of 3"):
        scene.nodes[3]


def test_lists_are_extended_and_replaced():
    scene = candela.Scene()
    scene.nodes.extend(candela.Node(name=name) for name in "ab")
    scene.nodes = [scene.nodes[1], candela.Node(name="c")]
    assert [node.name for node in scene.nodes] == ["b", "c"]
    scene.nodes[0] = scene.nodes[1]
    assert scene.nodes[0].name == "c"


def test_a_handle_to_an_element_that_is_gone_says_so():
    scene = candela.Scene()
    scene.lights.append(light := candela.Light())
    scene.lights.clear()
    with pytest.raises(candela.InputError, match="Light 0 is no longer in its scene"):
        light.intensity


def test_values_do_not_change_and_replace_copies():
    texture = candela.Texture(image=2, scale=(2, 3))
    with pytest.raises(AttributeError):
        texture.image = 1
    changed = texture.replace(image=1)
    assert (texture.image, changed.image) == (2, 1) and changed.scale.tolist() == [2, 3]
    assert changed != texture and changed.replace(image=2) == texture
    assert repr(changed) == "Texture(image=1, scale=[2.0, 3.0])"


def test_nodes_have_a_matrix_or_parts_of_a_transform():
    node = candela.Node(translation=(1, 2, 3), rotation=(0, 0, np.sqrt(0.5), np.sqrt(0.5)), scale=(2, 2, 2))
    # A turn by 90 degrees about +Z takes +X to +Y. Float32 rounds at 1e-7.
    np.testing.assert_allclose(node.matrix @ (1, 0, 0, 1), (1, 4, 3, 1), atol=1e-6)
    node.matrix = np.diag([3.0, 1.0, 1.0, 1.0])
    assert node.translation is None
    node.translation = (1, 0, 0)
    np.testing.assert_array_equal(node.matrix[:3, 3], (1, 0, 0))


def test_world_matrices_and_boxes_follow_the_hierarchy(wall):
    child = wall.add_mesh(*square(2.0), matrix=np.array([[1, 0, 0, 10], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), parent=0)
    wall.nodes[0].translation = (0, 5, 0)
    np.testing.assert_array_equal(wall.world_transforms()[child.index][:3, 3], (10, 5, 0))
    np.testing.assert_array_equal(wall.bounds(), [[-2, 3, 0], [11, 7, 0]])
    np.testing.assert_array_equal(wall.node_bounds(child.index), [[9, 4, 0], [11, 6, 0]])
    assert candela.Scene().bounds() is None


def test_validate_names_the_element(wall):
    wall.nodes[0].mesh = 7
    with pytest.raises(candela.InputError, match="node 0.*mesh"):
        wall.validate()


def test_normals_are_made_where_none_are_given():
    scene = candela.Scene()
    # Two triangles that meet at a right angle along the y axis.
    positions = [[0, 0, 0], [0, 1, 0], [1, 0, 0], [0, 0, -1]]
    triangles = [[0, 2, 1], [0, 1, 3]]
    scene.add_mesh(positions, triangles, crease_angle=0.0)
    flat = scene.meshes[0]
    assert flat.normals.shape == (6, 3)
    np.testing.assert_allclose(flat.normals[:3], np.tile((0, 0, 1), (3, 1)), atol=1e-6)
    scene.add_mesh(positions, triangles, crease_angle=np.pi)
    shared = scene.meshes[1].normals[0]
    assert abs(np.linalg.norm(shared) - 1.0) < 1e-6, "float32 rounds at 1e-7"
    # Both faces have a right angle at this corner, and count alike.
    np.testing.assert_allclose(np.abs(shared), (np.sqrt(0.5), 0, np.sqrt(0.5)), atol=1e-6)
    scene.add_mesh(positions, triangles)
    assert scene.meshes[2].normals.shape == (6, 3), "an edge of 90 degrees stays sharp"


def test_shapes_and_whole_meshes():
    scene = candela.Scene()
    for mesh in (candela.Mesh.sphere(2.0), candela.Mesh.box((2, 4, 6)), candela.Mesh.plane(3, 5), candela.Mesh.disc(2.0),
                 candela.Mesh.cylinder(1.0, 4.0), candela.Mesh.cone(1.0, 4.0), candela.Mesh.torus(2.0, 0.5)):
        scene.add_mesh(mesh, material=candela.Material(), name="shape")
        np.testing.assert_allclose(np.linalg.norm(scene.meshes[-1].normals, axis=1), 1.0, atol=1e-5)
    np.testing.assert_array_equal(scene.node_bounds(1), [[-1, -2, -3], [1, 2, 3]])
    np.testing.assert_allclose(scene.node_bounds(0), [[-2] * 3, [2] * 3], atol=0.02)
    scene.validate()
    with pytest.raises(candela.InputError, match="radius"):
        candela.Mesh.sphere(-1.0)
    with pytest.raises(candela.InputError, match="no indices beside a Mesh"):
        scene.add_mesh(candela.Mesh.box(), [[0, 1, 2]])


def test_normals_and_tangents_are_computed():
    box = candela.Mesh.box()
    box.compute_normals(np.pi)
    # At each corner of a cube three right angles meet.
    np.testing.assert_allclose(np.abs(box.normals), np.sqrt(1 / 3), atol=1e-6)
    box.compute_normals(0.0)
    box.compute_tangents()
    np.testing.assert_allclose(np.sum(box.tangents[:, :3] * box.normals, axis=1), 0.0, atol=1e-6)


def test_images_have_the_type_of_their_pixels():
    grey = np.arange(6, dtype=np.uint8).reshape(2, 3)
    pixels = candela.Image(pixels=grey).pixels
    assert pixels.shape == (2, 3, 4) and pixels.dtype == np.uint8
    assert (pixels[..., :3] == grey[..., None]).all() and (pixels[..., 3] == 255).all()
    assert candela.Image(pixels=np.zeros((2, 3, 3), np.uint16)).pixels.dtype == np.uint16
    assert candela.Image(pixels=np.zeros((2, 3, 4))).pixels.dtype == np.float32


def test_lights_from_arrays():
    scene = candela.Scene()
    positions = np.random.default_rng(2).normal(size=(1000, 3))
    intensity = np.linspace(1, 2, 1000)
    scene.add_lights(positions, intensity=intensity, color=(1, 0.5, 0), range=3.0, casts_shadow=False)
    light = scene.lights[999]
    assert len(scene.lights) == 1000 and light.intensity == 2.0 and light.range == 3.0 and not light.casts_shadow
    np.testing.assert_array_equal(light.position, positions[999].astype(np.float32))
    scene.add_lights(None, type="directional", direction=[[0, -2, 0], [1, 0, 0]])
    np.testing.assert_array_equal(scene.lights[1000].direction, (0, -1, 0))
    for arguments, text in (
        ({"intensity": [1, 2, 3]}, "intensity of lights: expected a number, or 1000 numbers"),
        ({"color": np.ones((3, 3))}, r"color of lights: expected \(3,\), or \(1000, 3\)"),
        ({"direction": (0, 0, 0)}, "direction of lights: a direction has no length"),
    ):
        with pytest.raises(candela.InputError, match=text):
            scene.add_lights(positions, **arguments)
    with pytest.raises(candela.InputError, match="only directional lights have no positions"):
        scene.add_lights(None)
    with pytest.raises(TypeError, match="lights have no 'colour'"):
        scene.add_lights(positions, colour=(1, 1, 1))


def test_a_scene_is_not_changed_while_it_is_read(renderer):
    """Another thread that changes a scene in the middle of its upload gets an error, and the upload is whole."""
    scene = candela.load("plaza:20000")
    errors, stop = [], threading.Event()

    def change():
        while not stop.is_set():
            try:
                scene.lights[0].intensity = 1.0
            except candela.InputError as error:
                errors.append(str(error))

    thread = threading.Thread(target=change)
    thread.start()
    try:
        for _ in range(20):
            renderer.upload(scene)
            if errors:
                break
    finally:
        stop.set()
        thread.join()
    assert errors and "while another thread" in errors[0]


def test_a_copy_is_independent(wall):
    other = wall.copy()
    other.nodes[0].name = "other"
    assert wall.nodes[0].name == "wall"
