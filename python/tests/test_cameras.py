"""Intrinsics and poses: pixels land where the pinhole equation puts them."""

import numpy as np
import pytest

import candela

WIDTH, HEIGHT = 160, 120
POSE = np.array([[1, 0, 0, 0.2], [0, 1, 0, -0.1], [0, 0, 1, 3.0], [0, 0, 0, 1]])
FLIP = np.diag([1.0, -1.0, -1.0, 1.0])


def dots(points):
    """A small unlit sphere at each point, of a size of its own colour."""
    scene = candela.Scene()
    corners = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    for point in points:
        scene.add_mesh(0.1 * corners + point, faces, material=candela.Material(unlit=True))
    return scene


@pytest.mark.parametrize("focal", [(150.0, 150.0), (130.0, 170.0)])
@pytest.mark.parametrize("center", [(80.0, 60.0), (50.0, 75.0), (110.5, 40.25)])
def test_points_are_drawn_where_they_are_projected(renderer, center, focal):
    points = np.array([[0.313, 0.207, 0.0], [-0.521, -0.333, -1.0], [0.117, -0.419, 0.5]])
    view = candela.view_from_intrinsics(*focal, *center, WIDTH, HEIGHT, POSE, convention="opengl")
    # The pinhole equation by itself.
    camera = points - POSE[:3, 3]
    expected = np.array(center) + np.array([focal[0], -focal[1]]) * camera[:, :2] / -camera[:, 2:]
    pixels, depth = candela.project(view, points, WIDTH, HEIGHT)
    np.testing.assert_allclose(pixels, expected, atol=1e-4)
    np.testing.assert_allclose(depth, -camera[:, 2], rtol=1e-6)
    for point, pixel in zip(points, expected):
        frame = renderer.render(dots([point]), view, width=WIDTH, height=HEIGHT, samples=64, environment=None)
        cover = frame.radiance()[..., 3].astype(float)
        y, x = np.mgrid[:HEIGHT, :WIDTH] + 0.5
        # The centre of what is covered. Within a pixel 64 samples lie an eighth of a pixel apart.
        center_drawn = np.array([(cover * x).sum(), (cover * y).sum()]) / cover.sum()
        np.testing.assert_allclose(center_drawn, pixel, atol=0.0625)


def test_opencv_and_opengl_poses_are_one_view():
    opengl = candela.view_from_intrinsics(150, 150, 80, 60, WIDTH, HEIGHT, POSE, convention="opengl")
    opencv = candela.view_from_intrinsics(150, 150, 80, 60, WIDTH, HEIGHT, POSE @ FLIP, convention="opencv")
    extrinsics = np.linalg.inv(POSE @ FLIP)[:3]
    inverse = candela.view_from_intrinsics(150, 150, 80, 60, WIDTH, HEIGHT, extrinsics, world_to_camera=True)
    for other in (opencv, inverse):
        np.testing.assert_allclose(other.world_from_camera, opengl.world_from_camera, atol=1e-6)


def test_intrinsics_are_the_reverse():
    for pixel_center in (0.5, 0.0):
        view = candela.view_from_intrinsics(150, 140, 70, 65, WIDTH, HEIGHT, pixel_center=pixel_center)
        matrix = candela.intrinsics(view, WIDTH, HEIGHT, pixel_center=pixel_center)
        np.testing.assert_allclose(matrix, [[150, 0, 70], [0, 140, 65], [0, 0, 1]], rtol=1e-5)
    shifted = candela.view_from_intrinsics(150, 150, 69.5, 64.5, WIDTH, HEIGHT, pixel_center=0.0)
    straight = candela.view_from_intrinsics(150, 150, 70, 65, WIDTH, HEIGHT)
    np.testing.assert_allclose(shifted.shift, straight.shift, atol=1e-7)


def test_points_come_back_from_depth(renderer, wall):
    view = candela.view_from_intrinsics(150, 150, 66, 71, WIDTH, HEIGHT, POSE, convention="opengl")
    frame = renderer.render(wall, view, width=WIDTH, height=HEIGHT, samples=1, aovs=["depth", "position"], environment=None)
    points = candela.points_from_depth(view, frame["depth"])
    surface = frame["depth"] > 0.0
    assert surface.any() and np.isnan(points[~surface]).all()
    # Both are float32, at up to 4 m.
    np.testing.assert_allclose(points[surface], frame["position"][surface], atol=2e-5)


def test_points_behind_the_camera_have_no_pixel():
    pixels, depth = candela.project(candela.look_at((0, 0, 2), (0, 0, 0)), [[0, 0, 3]], WIDTH, HEIGHT)
    assert np.isnan(pixels).all() and depth[0] == pytest.approx(-1.0)


@pytest.mark.parametrize(
    "arguments, text",
    [
        ({"fx": 0.0}, "focal lengths have to be over 0"),
        ({"cx": np.nan}, "all finite"),
        ({"pose": np.diag([2.0, 1, 1, 1])}, "is no rotation"),
        ({"pose": np.eye(3)}, r"pose: expected a matrix of shape \(4, 4\) or \(3, 4\), not \(3, 3\)"),
        ({"convention": "blender"}, "expected 'opengl' or 'opencv', not 'blender'"),
    ],
)
def test_wrong_intrinsics_and_poses(arguments, text):
    given = {"fx": 100.0, "fy": 100.0, "cx": 80, "cy": 60, "width": WIDTH, "height": HEIGHT, **arguments}
    with pytest.raises(candela.InputError, match=text):
        candela.view_from_intrinsics(**given)
