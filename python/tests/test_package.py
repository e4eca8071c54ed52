"""The package: stubs, docstrings, and examples that run."""

import ast
import pathlib
import re
import subprocess
import sys
import types

import numpy as np
import pytest

import candela
from conftest import square

PACKAGE = pathlib.Path(candela.__file__).parent
TREE = pathlib.Path(__file__).resolve().parent.parent.parent
EXAMPLES = TREE / "python" / "examples"


def run_example(name, *arguments):
    ended = subprocess.run([sys.executable, EXAMPLES / name, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


def test_the_stub_has_every_public_name():
    text = (PACKAGE / "_candela.pyi").read_text()
    assert "std::" not in text, "a type of C++ that was not converted"
    stub = ast.parse(text)
    names = {node.name for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    compiled = {name for name in candela.__all__ if getattr(getattr(candela, name), "__module__", "") == "candela._candela"}
    assert compiled and compiled <= names
    assert (PACKAGE / "py.typed").exists()
    # In the body of a class such an attribute would hide the decorator.
    for each in ast.walk(stub):
        if isinstance(each, ast.ClassDef):
            assert "property" not in {member.name for member in each.body if isinstance(member, ast.FunctionDef)}, each.name


def test_everything_public_is_documented():
    for name in candela.__all__:
        member = getattr(candela, name)
        if name == "__version__":
            continue
        assert member.__doc__, name
        if isinstance(member, type) and member.__module__.startswith("candela"):
            for attribute, value in vars(member).items():
                if not attribute.startswith("_") and (callable(value) or isinstance(value, property)):
                    assert value.__doc__, f"{name}.{attribute}"


def python_blocks(page):
    return re.findall(r"```python\n(.*?)```", (TREE / page).read_text(), re.DOTALL)


def test_the_programs_of_the_documents_run(renderer, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    positions, triangles = square()
    given = {
        "positions": positions, "triangles": triangles, "matrix": np.eye(4), "trajectory": [np.zeros((3, 3)), np.ones((3, 3))],
        "fx": 300.0, "fy": 300.0, "cx": 320.0, "cy": 240.0, "width": 640, "height": 480, "pose": np.eye(4), "points": positions,
        "view": candela.look_at((0, 0, 3), (0, 0, 0)), "times": [0.0, 0.5], "encode": np.mean,
        "host": types.SimpleNamespace(sample=lambda texture, width, height: None),
    }
    for page in ("README.md", "docs/python.md"):
        names = {**given}
        for block in python_blocks(page):
            exec(block.replace("room.glb", "plaza:64"), names)
            assert (tmp_path / "room.png").exists()
            names["renderer"] = renderer  # that of the first block is closed


def test_the_version_is_that_of_the_project():
    assert candela.__version__.count(".") == 2


def test_example_light_study(tmp_path):
    sheet = tmp_path / "sheet.png"
    pytest.importorskip("matplotlib")
    text = run_example("light_study.py", "-o", sheet, "--lights", 2000, "--size", "96x60", "--samples", 1)
    assert "12 pictures of 2,000 lights" in text and sheet.stat().st_size > 10_000


@pytest.mark.skipif("node_id" not in candela.aov_names(), reason="the library has no AOV node_id")
def test_example_dataset(tmp_path):
    import json

    run_example("dataset.py", "-o", tmp_path, "--views", 3, "--size", "160x120", "--samples", 2, "--overlay")
    told = json.loads((tmp_path / "annotations.json").read_text())
    assert len(told["images"]) == 3 and len(told["annotations"]) > 3
    for image in told["images"]:
        arrays = np.load(tmp_path / image["arrays"])
        assert arrays["depth"].shape == (120, 160) and arrays["normal"].shape == (120, 160, 3)
        boxes = [each for each in told["annotations"] if each["image_id"] == image["id"]]
        assert {each["node"] for each in boxes} == set(np.unique(arrays["mask"])) - {-1}
        for each in boxes:
            x, y, width, height = each["bbox"]
            inside = arrays["mask"][y:y + height, x:x + width] == each["node"]
            # All of the object's pixels lie within its box, and touch each side of it.
            assert inside.sum() == (arrays["mask"] == each["node"]).sum() == each["area"]
            assert inside[0].any() and inside[-1].any() and inside[:, 0].any() and inside[:, -1].any()
            assert (arrays["depth"][y:y + height, x:x + width][inside] > 0.0).all()
