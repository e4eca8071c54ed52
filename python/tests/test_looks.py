"""What changes how a scene looks: animated properties, variants, and cages that are added to a scene on the device."""

import numpy as np
import pytest

import candela
from conftest import square

dark = {"environment": None, "samples": 1, "width": 64, "height": 48}


def colour_of(renderer, scene, view, **options):
    return renderer.render(scene, view, **{**dark, **options}).radiance()[24, 32, :3]


def animate(scene, **channel):
    scene.animations.append(candela.Animation(properties=[candela.PropertyChannel(**channel)]))


def test_a_colour_changes_with_time(renderer, wall, ahead):
    wall.materials[0].unlit = True
    animate(wall, attribute="base_color", element=0, times=[0, 2], values=[0.2, 0.4, 0.8, 1, 0.8, 0.4, 0.2, 1])
    channel = wall.animations[0].properties[0]
    assert (channel.attribute, channel.interpolation, channel.texture) == ("base_color", "linear", "base_color")
    assert channel.times.shape == (2,) and channel.values.shape == (8,)
    for time, expected in ((0.0, (0.2, 0.4, 0.8)), (1.0, (0.5, 0.4, 0.5)), (2.0, (0.8, 0.4, 0.2)), (9.0, (0.8, 0.4, 0.2))):
        # 8 bits by the sRGB curve: half a code is 0.4 % of full scale.
        np.testing.assert_allclose(colour_of(renderer, wall, ahead, time=time), expected, atol=4e-3)
    wall.pose_properties(1.0)
    np.testing.assert_allclose(wall.materials[0].base_color, (0.5, 0.4, 0.5, 1.0), atol=1e-6)


def test_lights_nodes_and_cameras_change_with_time(renderer, wall, ahead):
    wall.add_lights([[0, 0, 1]], intensity=10.0, range=100.0)
    animate(wall, attribute="light_intensity", element=0, times=[0, 1], values=[10, 20])
    one, two = (colour_of(renderer, wall, ahead, time=time)[0] for time in (0.0, 1.0))
    assert two == pytest.approx(2.0 * one, rel=1e-5)
    wall.animations.clear()
    animate(wall, attribute="visible", element=0, interpolation="step", times=[0, 1], values=[1, 0])
    assert colour_of(renderer, wall, ahead, time=0.5)[0] > 0 and colour_of(renderer, wall, ahead, time=1.0)[0] == 0
    wall.animations.clear()
    wall.cameras.append(candela.Camera(vertical_fov=0.4, near_plane=0.1))
    animate(wall, attribute="vertical_fov", element=0, times=[0, 1], values=[0.4, 0.8])
    assert wall.view(0, time=0.5).vertical_fov == pytest.approx(0.6)


def test_a_texture_moves_with_time(renderer, wall, ahead):
    corners, triangles = square(4.0)
    wall.images.append(candela.Image(pixels=np.array([[[255, 0, 0], [0, 255, 0]]], np.uint8)))
    texture = candela.Texture(image=0, mag_filter="nearest", min_filter="nearest")
    wall.materials[0] = candela.Material(unlit=True, base_color_texture=texture)
    wall.meshes[0].uv0 = np.full((4, 2), 0.25)
    animate(wall, attribute="texture_offset", element=0, texture="base_color", interpolation="step", times=[0, 1], values=[0, 0, 0.5, 0])
    np.testing.assert_allclose(colour_of(renderer, wall, ahead, time=0.0), (1, 0, 0), atol=1e-5)
    np.testing.assert_allclose(colour_of(renderer, wall, ahead, time=1.0), (0, 1, 0), atol=1e-5)


def test_wrong_channels_name_what_is_wrong(wall):
    with pytest.raises(candela.InputError, match="PropertyChannel.attribute: expected one of 'visible', 'base_color'"):
        candela.PropertyChannel(attribute="colour")
    for channel, text in (
        ({"attribute": "metallic", "element": 5, "times": [0], "values": [0]}, "5"),
        ({"attribute": "roughness", "times": [0, 1], "values": [0]}, "value"),
        ({"attribute": "metallic", "times": [0], "values": [2]}, "metal"),
        ({"attribute": "texture_scale", "times": [0], "values": [1, 1]}, "texture"),
    ):
        scene = wall.copy()
        animate(scene, **channel)
        with pytest.raises(candela.InputError, match=text):
            scene.validate()


def test_every_property_has_the_range_of_its_attribute(wall):
    """All words are taken, and what is beyond the range is not."""
    words = candela.PropertyChannel.attribute.__doc__
    assert "attribute" in words
    wall.materials[0].base_color_texture = candela.Texture(image=0)
    wall.images.append(candela.Image(pixels=np.zeros((1, 1), np.uint8)))
    wall.meshes[0].uv0 = np.zeros((4, 2))
    wall.lights.append(candela.Light(type="spot", range=3.0))
    wall.cameras.append(candela.Camera(near_plane=0.1, far_plane=10.0))
    material = ["base_color", "metallic", "roughness", "emission", "emission_strength", "normal_scale", "occlusion_strength",
                "alpha_cutoff", "ior", "specular", "specular_color", "clearcoat", "clearcoat_roughness", "clearcoat_normal_scale",
                "sheen_color", "sheen_roughness", "anisotropy", "anisotropy_rotation", "iridescence", "iridescence_ior",
                "iridescence_min_thickness", "iridescence_max_thickness", "transmission", "thickness", "attenuation_distance",
                "attenuation_color", "dispersion", "diffuse_transmission", "diffuse_transmission_color"]
    for name in material:
        value = np.ravel(getattr(wall.materials[0], name))
        if name == "attenuation_distance":
            value = [1.0]
        animate(wall, attribute=name, element=0, times=[0], values=value)
    for name, value in (("texture_offset", [0, 0]), ("texture_rotation", [0]), ("texture_scale", [1, 1]), ("light_color", [1, 1, 1]),
                        ("light_intensity", [1]), ("light_range", [1]), ("inner_cone_angle", [0.1]), ("outer_cone_angle", [0.5]),
                        ("light_position", [1, 2, 3]), ("vertical_fov", [0.5]), ("near_plane", [0.1]), ("far_plane", [10])):
        animate(wall, attribute=name, element=0, times=[0], values=value)
    wall.validate()
    assert len(wall.animations) == 41


def test_variants_are_looks_of_a_scene(renderer, wall, ahead):
    wall.materials[0].unlit = True
    node = wall.nodes["wall"]
    assert wall.add_variant("red", {node: candela.Material(name="red", base_color=(1, 0, 0), unlit=True)}) == 0
    assert wall.add_variant("green", {wall.meshes[0]: candela.Material(name="green", base_color=(0, 1, 0), unlit=True)}) == 1
    assert wall.add_variant("as it is") == 2
    assert wall.variants == ("red", "green", "as it is") and len(wall.materials) == 3
    assert wall.meshes[0].variant_materials == (
        candela.VariantMaterial(submesh=0, material=0),
        candela.VariantMaterial(submesh=0, variant=0, material=1),
        candela.VariantMaterial(submesh=0, variant=1, material=2),
    )
    wall.validate()
    for variant, expected in (("red", (1, 0, 0)), (1, (0, 1, 0)), ("as it is", (0.5,) * 3), ("green", (0, 1, 0)), (None, (0.5,) * 3)):
        wall.select_variant(variant)
        np.testing.assert_allclose(colour_of(renderer, wall, ahead), expected, atol=4e-3)
    for wrong in ("blue", 3):
        with pytest.raises(candela.InputError):
            wall.select_variant(wrong)


def test_variants_of_submeshes_and_of_cages(renderer):
    scene = candela.Scene()
    for name, color in (("a", (1, 0, 0)), ("b", (0, 1, 0)), ("c", (0, 0, 1))):
        scene.materials.append(candela.Material(name=name, base_color=color, unlit=True))
    corners, triangles = square(4.0)
    scene.add_mesh(corners, triangles)
    scene.meshes[0].submeshes = [candela.Submesh(first_index=0, index_count=3, material=0),
                                 candela.Submesh(first_index=3, index_count=3, material=0)]
    scene.variants = ["other"]
    scene.meshes[0].variant_materials = [candela.VariantMaterial(submesh=1, material=0),
                                         candela.VariantMaterial(submesh=1, variant=0, material=1)]
    scene.cages.append(candela.Cage(positions=corners, face_sizes=[4], face_vertices=[0, 1, 2, 3], face_materials=[0], scheme="bilinear"))
    scene.nodes.append(candela.Node(cage=0, visible=False))
    scene.validate()
    scene.select_variant("other")
    assert [each.material for each in scene.meshes[0].submeshes] == [0, 1] and scene.cages[0].face_materials == (0,)
    index = scene.add_variant("third", {scene.cages[0]: 2})
    assert scene.cages[0].variants == (candela.CageVariant(face_materials=[0]), candela.CageVariant(variant=index, face_materials=[2]))
    scene.validate()
    scene.select_variant(index)
    assert scene.cages[0].face_materials == (2,) and [each.material for each in scene.meshes[0].submeshes] == [0, 0]
    scene.nodes.append(candela.Node())
    for key, text in (("wall", "a Node, a Mesh or a Cage"), (candela.Mesh(), "is not one of this scene"),
                      (scene.nodes[2], "shows neither a mesh nor a cage")):
        before = scene.variants
        with pytest.raises(candela.InputError, match=text):
            scene.add_variant("wrong", {key: 0})
        assert scene.variants == before


def test_meshes_have_many_sets_of_texture_coordinates(renderer, ahead):
    scene = candela.Scene()
    corners, triangles = square(4.0)
    scene.images.append(candela.Image(pixels=np.array([[[255, 0, 0], [0, 255, 0]]], np.uint8)))
    texture = candela.Texture(image=0, uv_set=3, mag_filter="nearest", min_filter="nearest")
    scene.add_mesh(corners, triangles, material=candela.Material(unlit=True, base_color_texture=texture))
    scene.meshes[0].further_uvs = [np.zeros((4, 2)), np.full((4, 2), 0.75)]
    assert len(scene.meshes[0].further_uvs) == 2 and scene.meshes[0].further_uvs[1].shape == (4, 2)
    np.testing.assert_allclose(colour_of(renderer, scene, ahead), (0, 1, 0), atol=1e-5)


def test_cages_are_added_replaced_and_removed(renderer, wall, ahead):
    wall.materials[0].unlit = True
    uploaded = renderer.upload(wall, environment=None)
    corners, _ = square(4.0, z=0.5)
    quad = {"face_sizes": [4], "face_vertices": [0, 1, 2, 3], "scheme": "bilinear", "level": 1}
    cage = uploaded.add_cage(candela.Cage(positions=corners, **quad))
    node = uploaded.add_node(candela.Node(cage=cage.index))
    size = {"width": 64, "height": 48, "samples": 1}
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 1.5, rtol=1e-5)
    report = uploaded.report()
    assert (report["cages"], report["cage_levels"], report["deformed_meshes"]) == (1, (1, 1), 0)
    uploaded.replace_cage(cage, candela.Cage(positions=corners + (0, 0, 0.5), **quad))
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 1.0, rtol=1e-5)
    uploaded.set_cage_points(node, corners)
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 1.5, rtol=1e-5)
    with pytest.raises(candela.InputError):
        uploaded.remove_cage(cage)
    uploaded.remove_node(node)
    uploaded.remove_cage(cage)
    np.testing.assert_allclose(renderer.render(uploaded, ahead, **size)["depth"][24, 32], 2.0, rtol=1e-5)
    with pytest.raises(candela.InputError):
        uploaded.replace_cage(cage, candela.Cage(positions=corners, **quad))


def test_motion_is_that_of_nodes_since_the_poses_that_were_kept(renderer, wall, ahead):
    uploaded = renderer.upload(wall, environment=None)
    uploaded.keep_poses()
    moved = np.eye(4)
    moved[0, 3] = 0.1
    uploaded.set_transform(0, moved)
    frame = renderer.render(uploaded, ahead, width=64, height=48, samples=1, aovs=["motion"])
    # 0.1 m to the right at 2 m, with a focal length of 24 / tan(22.5 degrees) pixels.
    np.testing.assert_allclose(frame["motion"][24, 32], (0.1 / 2.0 * 24 / np.tan(np.pi / 8), 0), atol=1e-3)


def test_a_mesh_that_is_added_may_be_deformed(renderer, wall, ahead):
    wall.nodes.append(candela.Node(name="joint"))
    wall.skins.append(candela.Skin(joints=[1], inverse_bind_matrices=[np.eye(4)]))
    wall.materials[0].unlit = True
    uploaded = renderer.upload(wall, environment=None)
    corners, triangles = square(4.0)
    mesh = uploaded.add_mesh(candela.Mesh(
        positions=corners, normals=np.tile((0.0, 0, 1), (4, 1)), indices=triangles, influence_count=1, joints=[0, 0, 0, 0],
        joint_weights=[1, 1, 1, 1], morph_targets=[candela.MorphTarget(offsets=np.tile((0.0, 0, 1), (4, 1)))]))
    uploaded.add_node(candela.Node(mesh=mesh.index, skin=0, morph_weights=[0.25]))
    lifted = np.eye(4)
    lifted[2, 3] = 0.5
    uploaded.set_transform(1, lifted)
    frame = renderer.render(uploaded, ahead, width=64, height=48, samples=1)
    np.testing.assert_allclose(frame["depth"][24, 32], 2.0 - 0.25 - 0.5, rtol=1e-5)
    assert uploaded.report()["deformed_meshes"] == 1
