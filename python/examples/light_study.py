#!/usr/bin/env python3
"""A light study: one street, 10,000 lights in twelve arrangements of the same luminous flux, as a contact sheet.

    python light_study.py -o light_study.png

The scene is uploaded once; `GpuScene.set_lights` replaces the lights from an array of positions for each picture.
"""

from __future__ import annotations

import argparse
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import candela

STREET = 60.0  # metres a side


def street(rng: np.random.Generator) -> candela.Scene:
    """Blocks of houses on a plain, in grey, so that all colour is that of the lights."""
    scene = candela.Scene()
    ground = candela.Material(name="ground", base_color=(0.5, 0.5, 0.5), roughness=0.7)
    houses = candela.Material(name="houses", base_color=(0.7, 0.7, 0.7), roughness=0.5)
    scene.add_mesh(candela.Mesh.plane(STREET, STREET), material=ground, name="ground")
    first = scene.add_mesh(candela.Mesh.box(), material=houses, name="house")
    shared = first.mesh
    lots = [(x, z) for x in np.arange(-24, 25, 8.0) for z in np.arange(-24, 25, 8.0)]
    for index, (x, z) in enumerate(lots):
        size = np.array([rng.uniform(2.5, 4.5), rng.uniform(1.5, 7.0), rng.uniform(2.5, 4.5)])
        place = (x, 0.5 * size[1], z)
        if index == 0:
            first.scale, first.translation = size, place
        else:
            scene.nodes.append(candela.Node(name=f"house {index}", mesh=shared, scale=size, translation=place))
    return scene


def arrangements(count: int, rng: np.random.Generator) -> dict[str, np.ndarray]:
    """Places on the ground, (count, 2): x and z, metres."""
    half = 0.48 * STREET
    side = int(np.ceil(np.sqrt(count)))
    line = np.linspace(-half, half, side)
    grid = np.stack(np.meshgrid(line, line), axis=-1).reshape(-1, 2)[:count]
    angle = np.arange(count) * np.pi * (3.0 - np.sqrt(5.0))
    spiral = half * np.sqrt((np.arange(count) + 0.5) / count)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    streets = rng.uniform(-half, half, (count, 2))
    lanes = np.round((streets[:, 0] + 4.0) / 8.0) * 8.0 - 4.0
    streets[:, 0] = lanes + rng.normal(0.0, 0.35, count)
    clusters = rng.uniform(-half, half, (24, 2))[rng.integers(0, 24, count)] + rng.normal(0.0, 1.6, (count, 2))
    return {"grid": grid, "spiral": spiral, "streets": streets, "clusters": clusters}


def colors_of(places: np.ndarray) -> np.ndarray:
    """From warm in the middle to cold at the border, linear Rec.709, (N, 3)."""
    share = np.clip(np.linalg.norm(places, axis=1) / (0.55 * STREET), 0.0, 1.0)[:, None]
    return (1.0 - share) * np.array([1.0, 0.42, 0.1]) + share * np.array([0.1, 0.35, 1.0])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", "--output", default="light_study.png")
    parser.add_argument("--lights", type=int, default=10_000)
    parser.add_argument("--lumen", type=float, default=60_000.0, help="of all lights together")
    parser.add_argument("--size", default="480x300", help="of each picture, pixels")
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--dpi", type=int, default=110)
    options = parser.parse_args()
    width, height = (int(side) for side in options.size.split("x"))

    rng = np.random.default_rng(7)
    heights = (0.3, 1.2, 5.0)
    intensity = candela.candela_from_lumen(options.lumen / options.lights)
    view = candela.look_at(eye=(19, 19, 27), target=(-1, 0, 1), vertical_fov=np.radians(46))
    figure, axes = plt.subplots(len(heights), 4, figsize=(16, 9), facecolor="#101014")

    with candela.Renderer() as renderer:
        scene = renderer.upload(street(rng), environment=None)
        for column, (name, places) in enumerate(arrangements(options.lights, rng).items()):
            for row, meters in enumerate(heights):
                positions = np.insert(places, 1, meters, axis=1)
                scene.set_lights(positions, intensity=intensity, color=colors_of(places), range=6.0)
                start = time.perf_counter()
                frame = renderer.render(scene, view, width=width, height=height, samples=options.samples)
                picture = frame.rgb(exposure=0.5, view="ACES 1.0 SDR")
                seconds = time.perf_counter() - start
                luminance = frame.radiance()[..., :3] @ renderer.color.luminance_weights
                axis = axes[row, column]
                axis.imshow(picture)
                axis.set_axis_off()
                axis.set_title(f"{name}, {meters} m: mean {luminance.mean():.3f}, {seconds:.1f} s", color="#d0d0d8", fontsize=10)

    figure.suptitle(f"{options.lights:,} lights, {options.lumen:,.0f} lm in all", color="white", fontsize=14)
    figure.tight_layout(h_pad=0.8)
    figure.savefig(options.output, dpi=options.dpi)
    print(f"light_study: {options.output}: {len(heights) * 4} pictures of {options.lights:,} lights")


if __name__ == "__main__":
    main()
