"""Scenes from files, with what a user should know of them as warnings."""

from __future__ import annotations

import os
import warnings
from typing import Callable, Literal

from candela._candela import PluginRegistry, Scene, import_scene
from candela.errors import CandelaWarning, InputError


def load(
    uri: str | os.PathLike[str],
    *,
    notes: Literal["warn", "ignore", "error"] = "warn",
    animation: int | str | None = "first",
    variant: int | str | None = None,
    sun: bool = True,
    plugins: PluginRegistry | None = None,
    progress: Callable[[float], object] | None = None,
) -> Scene:
    """Reads a scene through the plugin that takes its file name ending or its scheme.

    Args:
        uri: A file, such as "room.glb" or "chair.obj", or a procedural scene, such as "plaza:4096".
        notes: What becomes of parts that are broken or beyond what candela draws. "warn": the rest is drawn, and each
            kind of loss is a CandelaWarning; "ignore": the same without warnings; "error": InputError. `Scene.notes` has
            all of them.
        animation: The one that plays, by index or name; "first", "all" or "none".
        variant: The look of the scene, by index or name (glTF's KHR_materials_variants).
        sun: Whether the sun in the picture of an environment becomes a directional light, which casts sharp shadows.
        plugins: None stands for those beside the library and of $CANDELA_PLUGIN_PATH.
        progress: Called with the share done, 0 to 1; returning False cancels.

    Raises:
        InputError: The file is not what it has to be, with the element at fault.
        MachineError: It can not be read.
    """
    if notes not in ("warn", "ignore", "error"):
        raise InputError(f"notes: expected 'warn', 'ignore' or 'error', not {notes!r}")
    scene = import_scene(os.fspath(uri), plugins, notes == "error", progress)
    if notes == "warn":
        for note in scene.notes:
            if note.kind != "information":
                warnings.warn(f"{scene.source}: {note}", CandelaWarning, stacklevel=2)
    _select_animation(scene, animation)
    if variant is not None:
        scene.select_variant(variant)
    if sun and scene.environment is not None:
        rest, light = scene.environment.without_sun()
        if light is not None:
            scene.environment = rest
            scene.lights.append(light)
    return scene


def _select_animation(scene: Scene, animation: int | str | None) -> None:
    names = [each.name for each in scene.animations]
    if animation in ("first", None):
        playing = {0}
    elif animation == "all":
        playing = set(range(len(names)))
    elif animation == "none":
        playing = set()
    elif animation in names:
        playing = {names.index(animation)}
    elif isinstance(animation, int) and 0 <= animation < len(names):
        playing = {animation}
    else:
        there_are = ", ".join(f"{i} {name!r}" for i, name in enumerate(names)) or "the scene has none"
        raise InputError(f"no animation {animation!r}; there are: {there_are}", scene.source)
    for index, each in enumerate(scene.animations):
        if each.plays != (index in playing):
            each.plays = index in playing
