#!/usr/bin/env python3
"""A data set: random views of random objects, with depth, normals, masks, boxes and the camera of each.

    python dataset.py -o dataset --views 1000

writes, for each view, images/N.png (colour), arrays/N.npz (depth in metres, world normals, the mask of object numbers) and
one annotations.json in COCO's form, with intrinsics and OpenCV poses. `--overlay` adds pictures with boxes and masks drawn in.
"""

from __future__ import annotations

import argparse
import json
import pathlib
import time

import numpy as np

import candela

SHAPES = ("box", "ball", "cone", "pillar")


def objects_scene(count: int, rng: np.random.Generator) -> tuple[candela.Scene, dict[int, str]]:
    """Objects on a table, and the shape of each node that is one."""
    scene = candela.Scene()
    table = candela.Material(name="table", base_color=(0.35, 0.3, 0.26), roughness=0.6)
    scene.add_mesh(candela.Mesh.plane(12.0, 12.0), material=table, name="table")

    meshes = {"box": candela.Mesh.box((1.6, 2, 1.6)), "ball": candela.Mesh.sphere(), "cone": candela.Mesh.cone(),
              "pillar": candela.Mesh.cylinder(0.6)}
    labels = {}
    for _ in range(count):
        shape = SHAPES[rng.integers(len(SHAPES))]
        size = rng.uniform(0.25, 0.7)
        turn = rng.uniform(0.0, 2.0 * np.pi)
        matrix = np.eye(4)
        matrix[:3, :3] = size * np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
        matrix[:3, 3] = (rng.uniform(-3.5, 3.5), size, rng.uniform(-3.5, 3.5))
        material = candela.Material(base_color=rng.uniform(0.1, 0.9, 3), roughness=rng.uniform(0.1, 0.9),
                                    metallic=float(rng.random() < 0.25))
        node = scene.add_mesh(meshes[shape], material=material, matrix=matrix, name=shape)
        labels[node.index] = shape
    scene.add_lights(rng.uniform((-5, 2.5, -5), (5, 5, 5), (64, 3)), intensity=rng.uniform(1.0, 5.0, 64), radius=0.1,
                     color=rng.uniform(0.5, 1.0, (64, 3)), range=9.0)
    scene.environment = candela.Environment.studio().replace(intensity=0.5)
    return scene, labels


def random_view(rng: np.random.Generator, width: int, height: int) -> candela.CameraView:
    """A camera on a dome around the table, by intrinsics and an OpenCV pose as a real one would be."""
    azimuth, elevation, distance = rng.uniform(0, 2 * np.pi), rng.uniform(0.2, 1.2), rng.uniform(5.0, 9.0)
    eye = distance * np.array([np.cos(azimuth) * np.cos(elevation), np.sin(elevation), np.sin(azimuth) * np.cos(elevation)])
    forward = rng.uniform(-0.7, 0.7, 3) * (1, 0.3, 1) + (0, 0.3, 0) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, (0, 1, 0))
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3, :3] = np.stack([right, np.cross(forward, right), forward], axis=1)
    pose[:3, 3] = eye
    focal = rng.uniform(0.9, 1.3) * width
    return candela.view_from_intrinsics(focal, focal, 0.5 * width + rng.uniform(-8, 8), 0.5 * height + rng.uniform(-8, 8),
                                        width, height, pose, convention="opencv")


def boxes_of(mask: np.ndarray) -> dict[int, tuple[int, int, int, int, int]]:
    """x, y, width, height and pixels of each number in a mask; -1 is the background."""
    found = {}
    for number in np.unique(mask[mask >= 0]):
        rows, columns = np.nonzero(mask == number)
        x, y = int(columns.min()), int(rows.min())
        found[int(number)] = (x, y, int(columns.max()) - x + 1, int(rows.max()) - y + 1, len(rows))
    return found


def draw_boxes(picture: np.ndarray, mask: np.ndarray, boxes: list[tuple[int, int, int, int]]) -> np.ndarray:
    """The picture with a tint for each object and the edges of the boxes."""
    rng = np.random.default_rng(3)
    tints = rng.integers(64, 256, (int(mask.max()) + 2, 3))
    shown = np.where((mask >= 0)[..., None], 0.55 * picture + 0.45 * tints[mask], picture).astype(np.uint8)
    for x, y, width, height in boxes:
        shown[y, x:x + width] = shown[y + height - 1, x:x + width] = (255, 255, 255)
        shown[y:y + height, x] = shown[y:y + height, x + width - 1] = (255, 255, 255)
    return shown


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("dataset"))
    parser.add_argument("--views", type=int, default=1000)
    parser.add_argument("--objects", type=int, default=24)
    parser.add_argument("--size", default="640x480", help="pixels")
    parser.add_argument("--samples", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--overlay", action="store_true", help="also write pictures with boxes and masks drawn in")
    options = parser.parse_args()
    width, height = (int(side) for side in options.size.split("x"))
    for folder in ("images", "arrays", *(["overlays"] if options.overlay else [])):
        (options.output / folder).mkdir(parents=True, exist_ok=True)

    rng = np.random.default_rng(options.seed)
    scene, labels = objects_scene(options.objects, rng)
    images: list[dict] = []
    annotations: list[dict] = []
    start = time.perf_counter()
    with candela.Renderer() as renderer:
        uploaded = renderer.upload(scene)
        for number in range(options.views):
            view = random_view(rng, width, height)
            frame = renderer.render(uploaded, view, width=width, height=height, samples=options.samples,
                                    aovs=["depth", "normal", "node_id"])
            name = f"{number:06}"
            picture = frame.rgb()
            nodes = frame["node_id"].astype(np.int32) - 1  # 0 is the background
            mask = np.where(np.isin(nodes, list(labels)), nodes, -1)
            candela.write_png(options.output / "images" / f"{name}.png", picture)
            np.savez_compressed(options.output / "arrays" / f"{name}.npz", depth=frame["depth"], mask=mask,
                                normal=frame["normal"].astype(np.float16))
            boxes = boxes_of(mask)
            if options.overlay:
                shown = draw_boxes(picture, mask, [box[:4] for box in boxes.values()])
                candela.write_png(options.output / "overlays" / f"{name}.png", shown)
            camera_to_world = np.asarray(view.world_from_camera, dtype=float) @ np.diag([1.0, -1.0, -1.0, 1.0])
            images.append({"id": number, "file_name": f"images/{name}.png", "arrays": f"arrays/{name}.npz",
                           "width": width, "height": height,
                           "intrinsics": candela.intrinsics(view, width, height).tolist(),
                           "camera_to_world_opencv": camera_to_world.tolist()})
            annotations += [{"id": len(annotations) + i, "image_id": number, "category_id": SHAPES.index(labels[node]) + 1,
                             "bbox": list(box[:4]), "area": box[4], "iscrowd": 0, "node": node}
                            for i, (node, box) in enumerate(boxes.items())]
    categories = [{"id": i + 1, "name": shape} for i, shape in enumerate(SHAPES)]
    (options.output / "annotations.json").write_text(
        json.dumps({"images": images, "annotations": annotations, "categories": categories}))
    seconds = time.perf_counter() - start
    print(f"dataset: {options.output}: {options.views} views, {len(annotations)} boxes, {options.views / seconds:.1f} views/s")


if __name__ == "__main__":
    main()
