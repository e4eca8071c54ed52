"""Scenes of trimesh: geometry, colours, textures, nodes, cameras and lights."""

import math

import numpy as np
import pytest

import candela

trimesh = pytest.importorskip("trimesh")
Image = pytest.importorskip("PIL.Image")


def test_a_mesh_is_drawn_where_it_is(renderer):
    mesh = trimesh.creation.box(extents=(1, 2, 3))
    mesh.apply_translation((5, 0, 0))
    scene = candela.from_trimesh(mesh)
    np.testing.assert_allclose(scene.bounds(), mesh.bounds, atol=1e-6)
    assert scene.triangle_count() == len(mesh.faces)
    view = candela.look_at((5, 0, 6.5), (5, 0, 0))
    frame = renderer.render(scene, view, width=32, height=24, samples=1, environment=None)
    np.testing.assert_allclose(frame["depth"][12, 16], 5.0, rtol=1e-5)


def test_nodes_share_meshes_and_keep_their_places():
    source = trimesh.Scene()
    ball = trimesh.creation.icosphere(subdivisions=1)
    source.add_geometry(ball, node_name="a", geom_name="ball", transform=trimesh.transformations.translation_matrix((1, 2, 3)))
    source.add_geometry(trimesh.creation.box(), node_name="b", parent_node_name="a",
                        transform=trimesh.transformations.rotation_matrix(0.5, (0, 1, 0)))
    source.graph.update(frame_from="world", frame_to="c", geometry="ball", matrix=np.eye(4))
    scene = candela.from_trimesh(source)
    assert len(scene.meshes) == 2 and scene.nodes["a"].mesh == scene.nodes["c"].mesh
    assert scene.nodes["b"].parent == scene.nodes["a"].index
    world = scene.world_transforms()
    for name in "abc":
        np.testing.assert_allclose(world[scene.nodes[name].index], source.graph.get(name)[0], atol=1e-6)
    scene.validate()


def test_vertex_colours_are_decoded_from_srgb(renderer):
    mesh = trimesh.creation.box(extents=(2, 2, 2))
    mesh.visual.vertex_colors = np.tile((188, 188, 188, 255), (len(mesh.vertices), 1))
    scene = candela.from_trimesh(mesh, smooth=False)
    frame = renderer.render(scene, candela.look_at((0, 0, 4), (0, 0, 0)), width=32, height=24, samples=1, environment=None)
    # sRGB code 188 is 0.503; the G-buffer stores 8 bits.
    np.testing.assert_allclose(frame["base_color"][12, 16], 0.503, atol=5e-3)


def test_face_colours_end_at_edges(renderer):
    mesh = trimesh.creation.box(extents=(2, 2, 2))
    front = mesh.face_normals[:, 2] > 0.9
    mesh.visual.face_colors = np.where(front[:, None], (255, 0, 0, 255), (0, 0, 255, 255))
    frame = renderer.render(candela.from_trimesh(mesh), candela.look_at((0, 0, 4), (0, 0, 0)), width=32, height=24,
                            samples=1, environment=None)
    np.testing.assert_allclose(frame["base_color"][12, 16], (1, 0, 0), atol=5e-3)


@pytest.mark.parametrize("pbr", [True, False])
def test_textures_are_the_right_way_up(renderer, pbr):
    pixels = np.zeros((8, 8, 3), np.uint8)
    pixels[:4] = (255, 0, 0)  # the upper half
    pixels[4:] = (0, 0, 255)
    image = Image.fromarray(pixels)
    material = (trimesh.visual.material.PBRMaterial(baseColorTexture=image, roughnessFactor=0.5) if pbr
                else trimesh.visual.material.SimpleMaterial(image=image))
    visual = trimesh.visual.TextureVisuals(uv=[[0, 0], [1, 0], [1, 1], [0, 1]], material=material)
    mesh = trimesh.Trimesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]], visual=visual, process=False)
    frame = renderer.render(candela.from_trimesh(mesh), candela.look_at((0, 0, 2), (0, 0, 0)), width=32, height=24,
                            samples=1, environment=None)
    np.testing.assert_allclose(frame["base_color"][6, 16], (1, 0, 0), atol=5e-3)
    np.testing.assert_allclose(frame["base_color"][18, 16], (0, 0, 1), atol=5e-3)


def test_points_and_lines(renderer):
    points = trimesh.PointCloud([[0, 0, 0], [0.5, 0, 0]], colors=[[255, 0, 0, 255], [0, 255, 0, 255]])
    frame = renderer.render(candela.from_trimesh(points), candela.look_at((0, 0, 2), (0, 0, 0)), width=33, height=25,
                            samples=1, point_size=5.0, environment=None)
    np.testing.assert_allclose(frame.radiance()[12, 16, :3], (1, 0, 0), atol=5e-3)
    path = trimesh.path.Path3D([trimesh.path.entities.Line([0, 1])], vertices=np.array([[-1.0, 0, 0], [1, 0, 0]]), process=False)
    frame = renderer.render(candela.from_trimesh(path), candela.look_at((0, 0, 2), (0, 0, 0)), width=33, height=25,
                            samples=1, line_width=3.0, environment=None)
    assert frame.radiance()[12, 16, 3] == 1.0 and frame.radiance()[2, 16, 3] == 0.0


def test_cameras_and_lights_come_too():
    source = trimesh.Scene([trimesh.creation.box()])
    source.camera = trimesh.scene.Camera(name="eye", fov=(60, 45))
    source.camera_transform = trimesh.transformations.translation_matrix((0, 0, 4))
    source.lights = [trimesh.scene.lighting.PointLight(name="lamp", color=(255, 0, 0, 255), intensity=7.0)]
    source.graph["lamp"] = trimesh.transformations.translation_matrix((0, 3, 0))
    scene = candela.from_trimesh(source)
    view = scene.view()
    np.testing.assert_allclose(view.eye, (0, 0, 4), atol=1e-6)
    assert view.vertical_fov == pytest.approx(math.radians(45), rel=1e-6)
    lamp = scene.lights[0]
    assert lamp.intensity == 7.0 and lamp.color.tolist() == [1, 0, 0] and scene.nodes[lamp.node].name == "lamp"


def test_what_is_no_geometry_says_so():
    with pytest.raises(candela.InputError, match="expected a Scene or a geometry of trimesh, not a str"):
        candela.from_trimesh("a box")
