"""Cameras as computer vision has them: intrinsics, poses, and points between pixels and space."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from candela._candela import CameraView
from candela.errors import InputError

Convention = Literal["opengl", "opencv"]

# Turns a camera's axes: OpenCV looks along +Z with +Y down, OpenGL along -Z with +Y up.
_FLIP = np.diag([1.0, -1.0, -1.0, 1.0])


def pose_from(pose: ArrayLike, convention: Convention = "opencv", *, world_to_camera: bool = False) -> NDArray[np.float64]:
    """The world-from-camera matrix of a CameraView, (4, 4).

    Args:
        pose: (4, 4) or (3, 4): rotation and translation, metres.
        convention: The axes of the camera: "opengl" looks along -Z with +Y up, as candela, pyrender, Blender and NeRF
            data sets do; "opencv" along +Z with +Y down, as OpenCV, COLMAP and Open3D do.
        world_to_camera: Whether `pose` takes points of the world to the camera, as OpenCV's extrinsics do, and not the
            camera to the world.
    """
    matrix: NDArray[np.float64] = np.asarray(pose, dtype=np.float64)
    if matrix.shape == (3, 4):
        matrix = np.vstack([matrix, [0.0, 0.0, 0.0, 1.0]])
    if matrix.shape != (4, 4):
        raise InputError(f"pose: expected a matrix of shape (4, 4) or (3, 4), not {matrix.shape}")
    rotation = matrix[:3, :3]
    # Float32 poses of long chains of multiplications are this far from a rotation.
    if not np.allclose(rotation @ rotation.T, np.eye(3), atol=1e-3) or np.linalg.det(rotation) < 0.0:
        raise InputError("pose: its upper left 3 x 3 part is no rotation")
    if convention not in ("opengl", "opencv"):
        raise InputError(f"convention: expected 'opengl' or 'opencv', not {convention!r}")
    if world_to_camera:
        matrix = np.asarray(np.linalg.inv(matrix), dtype=np.float64)
    return matrix @ _FLIP if convention == "opencv" else matrix


def view_from_intrinsics(
    fx: float,
    fy: float,
    cx: float,
    cy: float,
    width: int,
    height: int,
    pose: ArrayLike | None = None,
    *,
    convention: Convention = "opencv",
    world_to_camera: bool = False,
    pixel_center: float = 0.5,
    near: float = 0.01,
    far: float | None = None,
) -> CameraView:
    """The view of a pinhole camera, for pictures of `width` x `height` pixels.

    Args:
        fx, fy: Focal lengths, pixels.
        cx, cy: Principal point, pixels from the upper left.
        pose: See `pose_from`; None is the world's origin.
        convention, world_to_camera: See `pose_from`.
        pixel_center: The coordinate of the middle of the first pixel: 0.5 where (0, 0) is the corner of the picture
            (COLMAP, pyrender), 0.0 where it is the middle of the first pixel (OpenCV's calibration).
        near, far: Metres along the view axis; far None is infinity.

    Lens distortion is no part of a pinhole camera: undistort pictures first.
    """
    values = np.array([fx, fy, cx, cy, width, height], dtype=np.float64)
    if not np.all(np.isfinite(values)) or fx <= 0.0 or fy <= 0.0 or width < 1 or height < 1:
        raise InputError("intrinsics: focal lengths have to be over 0, sides 1 pixel or more, and all finite")
    # From the coordinates in which the picture's corner is (0, 0).
    corner = 0.5 - pixel_center
    matrix = np.eye(4) if pose is None else np.asarray(pose)
    return CameraView(
        world_from_camera=pose_from(matrix, convention, world_to_camera=world_to_camera),
        vertical_fov=2.0 * math.atan(0.5 * height / fy),
        near_plane=near,
        far_plane=far,
        aspect=None if math.isclose(fx, fy, rel_tol=1e-6) else (width / fx) / (height / fy),
        shift=((0.5 * width - (cx + corner)) / width, ((cy + corner) - 0.5 * height) / height),
    )


def intrinsics(view: CameraView, width: int, height: int, *, pixel_center: float = 0.5) -> NDArray[np.float64]:
    """The matrix [[fx, 0, cx], [0, fy, cy], [0, 0, 1]] of a perspective view, pixels: the reverse of
    `view_from_intrinsics`."""
    if view.orthographic_height is not None:
        raise InputError("intrinsics: the view is orthographic")
    half_height = math.tan(0.5 * view.vertical_fov)
    half_width = half_height * (width / height if view.aspect is None else view.aspect)
    corner = 0.5 - pixel_center
    cx = (0.5 - float(view.shift[0])) * width - corner
    cy = (0.5 + float(view.shift[1])) * height - corner
    return np.array([[0.5 * width / half_width, 0.0, cx], [0.0, 0.5 * height / half_height, cy], [0.0, 0.0, 1.0]])


def project(
    view: CameraView, points: ArrayLike, width: int, height: int, *, pixel_center: float = 0.5
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where world-space points, (N, 3), lie in a picture: pixels (N, 2), x to the right and y down, and their distances
    along the view axis, metres, (N,). Points behind the camera have a distance of 0 or less and no pixel (NaN)."""
    world = np.atleast_2d(np.asarray(points, dtype=np.float64))
    camera = (world - view.eye) @ np.asarray(view.world_from_camera, dtype=np.float64)[:3, :3]
    depth = -camera[:, 2]
    matrix = intrinsics(view, width, height, pixel_center=pixel_center)
    with np.errstate(divide="ignore", invalid="ignore"):
        x = matrix[0, 0] * camera[:, 0] / depth + matrix[0, 2]
        y = -matrix[1, 1] * camera[:, 1] / depth + matrix[1, 2]
    pixels = np.stack([x, y], axis=1)
    pixels[depth <= 0.0] = np.nan
    return pixels, depth


def points_from_depth(view: CameraView, depth: ArrayLike) -> NDArray[np.float32]:
    """The world-space points of a depth picture, (height, width, 3) from (height, width), metres; NaN on the background,
    where the depth is 0."""
    distance = np.asarray(depth, dtype=np.float64)
    height, width = distance.shape
    matrix = intrinsics(view, width, height)
    x = (np.arange(width) + 0.5 - matrix[0, 2]) / matrix[0, 0]
    y = -(np.arange(height) + 0.5 - matrix[1, 2]) / matrix[1, 1]
    camera = np.stack(
        [x[None, :] * distance, y[:, None] * distance, -distance], axis=-1
    )
    world = camera @ np.asarray(view.world_from_camera, dtype=np.float64)[:3, :3].T + view.eye
    world[distance <= 0.0] = np.nan
    return world.astype(np.float32)
