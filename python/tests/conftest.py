import numpy as np
import pytest

import candela


@pytest.fixture(scope="session")
def renderer():
    """One for all tests: each makes its own scene."""
    with candela.Renderer() as shared:
        yield shared


def square(size=1.0, z=0.0):
    """A square around the z axis that faces +Z: positions and triangles."""
    half = 0.5 * size
    corners = np.array([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]])
    return corners, np.array([[0, 1, 2], [0, 2, 3]])


@pytest.fixture
def wall():
    """A matte square of 4 m at z = 0, of base colour 0.5."""
    scene = candela.Scene()
    scene.add_mesh(*square(4.0), material=candela.Material(name="paint", base_color=(0.5, 0.5, 0.5)), name="wall")
    return scene


@pytest.fixture
def ahead():
    """From 2 m in front of the wall, straight at it."""
    return candela.look_at(eye=(0, 0, 2), target=(0, 0, 0))
