"""draw.py FOLDER: draws small pictures with the installed Python package, whose plugins lie below FOLDER."""

import pathlib
import sys
import tempfile

import numpy as np

import candela

folder = pathlib.Path(sys.argv[1]).resolve()
plugins = {pathlib.Path(report.file).stem: report for report in candela.PluginRegistry().reports}
for name in ("plaza", "gltf", "obj", "opensubdiv", "decoders"):
    report = plugins[f"candela-{name}"]
    assert report.state == "loaded", (name, report.detail)
    assert folder in pathlib.Path(report.file).resolve().parents, report.file

scene = candela.load("plaza:16")
with candela.Renderer() as renderer, tempfile.TemporaryDirectory() as written:
    frame = renderer.render(scene, width=64, height=36, samples=2, aovs=["depth"])
    picture, depth = frame.rgb(), frame["depth"]
    assert picture.shape == (36, 64, 3) and picture.dtype == np.uint8 and picture.std() > 1.0
    assert depth.shape == (36, 64) and depth.max() > 0.0
    frame.save(f"{written}/plaza.png")
    assert pathlib.Path(written, "plaza.png").read_bytes()[:4] == b"\x89PNG"

    # A cage of one quad becomes a surface by the plugin that subdivides.
    cage = candela.Scene()
    cage.cages.append(candela.Cage(positions=[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], face_sizes=[4],
                                   face_vertices=[0, 1, 2, 3], level=2))
    cage.nodes.append(candela.Node(cage=0))
    uploaded = renderer.upload(cage, environment=candela.Environment.studio())
    renderer.render(uploaded, candela.look_at((0, 0, 3), (0, 0, 0)), width=64, height=36, samples=1)
    assert uploaded.report()["cage_levels"] == (2, 2)
print(f"draws with candela {candela.version} of {pathlib.Path(candela.__file__).parent}")
