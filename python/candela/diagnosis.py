"""What a machine offers to candela, and what to do where it offers nothing."""

from __future__ import annotations

import dataclasses
import glob
import json
import os
import platform
import subprocess
import sys
from typing import Any

from candela import _candela

_VARIABLES = (
    "CANDELA_PLUGIN_PATH",
    "CANDELA_ASSUME_GPU",
    "CANDELA_MAPPED_TARGETS",
    "OCIO",
    "CUDA_VISIBLE_DEVICES",
    "NVIDIA_VISIBLE_DEVICES",
    "NVIDIA_DRIVER_CAPABILITIES",
    "LIBGL_ALWAYS_SOFTWARE",
    "MESA_LOADER_DRIVER_OVERRIDE",
    "GALLIUM_DRIVER",
    "EGL_PLATFORM",
    "__EGL_VENDOR_LIBRARY_FILENAMES",
    "LD_LIBRARY_PATH",
)
# Drivers that need longer to answer do not answer.
_SECONDS = 60.0


@dataclasses.dataclass(frozen=True)
class Diagnosis:
    """What `diagnose` found.

    Attributes:
        text: All of it, as it is printed.
        works: Whether a context was made.
        attempts: Each way to a context that was tried, with the renderer's name or why it failed.
        renderer: GL_RENDERER of the context; empty where there is none.
        driver: GL_VENDOR and GL_VERSION of it.
        advice: What to do, a line each; empty where nothing is wrong.
    """

    text: str
    works: bool
    attempts: tuple[tuple[str, str], ...]
    renderer: str
    driver: str
    advice: tuple[str, ...]

    def __str__(self) -> str:
        return self.text


def diagnose(*, show: bool = True) -> Diagnosis:
    """Tells version, contexts, driver, plugins and colour config, and what to do where something is missing.

    Contexts are tried in a process of their own, so that a driver that crashes is found too.

    Args:
        show: Whether to print it.
    """
    found = _probe_elsewhere()
    attempts = tuple((way, outcome) for way, outcome in found.get("attempts", []))
    advice = _context_advice(found, attempts)
    lines = [
        f"candela {_candela.version}, Python {platform.python_version()}, {platform.platform()}",
        f"package: {os.path.dirname(os.path.abspath(_candela.__file__))}",
        f"threads: {_candela.thread_count()}, shadows: {'yes' if _candela.has_shadows() else 'no'}",
        "",
        "OpenGL contexts without a window, in the order of trying:",
        *(f"  {way}: {outcome}" for way, outcome in attempts),
        *([] if attempts else ["  none could be tried"]),
        *([f"  error: {found['error']}"] if "error" in found else []),
        f"used: {found['renderer']} ({found['driver']})" if "renderer" in found else "used: none",
        "",
        *_plugin_lines(advice),
        *_color_lines(advice),
        *_variable_lines(),
        "",
        *(["what to do:", *(f"  - {line}" for line in advice)] if advice else ["nothing is missing"]),
    ]
    text = "\n".join(lines)
    if show:
        print(text)
    return Diagnosis(text, "renderer" in found, attempts, found.get("renderer", ""), found.get("driver", ""), tuple(advice))


def probe() -> dict[str, Any]:
    """Makes contexts in this process: the one that candela uses, and one of each further device."""
    found: dict[str, Any] = {"attempts": []}
    try:
        context = _candela.Context()
        found["attempts"] += context.attempts
        found.update(renderer=context.renderer, driver=context.driver, software=context.is_software)
    except Exception as error:
        found["error"] = str(error)
    tried = {way for way, _ in found["attempts"]}
    for device in _candela.devices():
        way = f"EGL device {device.index} ({device.description})"
        if way in tried:
            continue
        try:
            found["attempts"].append((way, _candela.Context(device=device.index).renderer))
        except Exception as error:
            found["attempts"].append((way, str(error)))
    return found


def _probe_elsewhere() -> dict[str, Any]:
    folder = os.path.dirname(os.path.dirname(os.path.abspath(_candela.__file__)))
    paths = os.pathsep.join(filter(None, [folder, os.environ.get("PYTHONPATH")]))
    try:
        ended = subprocess.run(
            [sys.executable, "-m", "candela", "--probe"],
            env={**os.environ, "PYTHONPATH": paths},
            capture_output=True,
            text=True,
            timeout=_SECONDS,
        )
    except subprocess.TimeoutExpired:
        return {"error": f"the driver does not answer within {_SECONDS:.0f} seconds"}
    except OSError as error:
        return {"error": f"no process can be started: {error}"}
    if ended.returncode < 0:
        return {"error": f"the driver ended the process by signal {-ended.returncode}"}
    try:
        found: dict[str, Any] = json.loads(ended.stdout.splitlines()[-1])
        return found
    except (ValueError, IndexError):
        return {"error": ended.stderr.strip().splitlines()[-1] if ended.stderr.strip() else "the process said nothing"}


def _plugin_lines(advice: list[str]) -> list[str]:
    try:
        reports = _candela.default_plugins().reports
    except Exception as error:
        advice.append(f"plugins: {error}")
        return [f"plugins: {error}"]
    lines = ["plugins:"]
    for report in reports:
        takes = [f".{ending}" for ending in report.extensions] + [f"{scheme}:N" for scheme in report.schemes]
        takes += ["refines cages"] if report.subdivides else []
        takes += ["decodes images"] if report.decodes_images else []
        state = f"{report.name} {report.version}: {', '.join(takes)}" if report.state == "loaded" else report.state
        lines.append(f"  {report.file}: {state}{': ' + report.detail if report.detail else ''}")
        if report.state not in ("loaded", "a duplicate", "duplicate"):
            advice.append(f"{report.file}: {report.detail or report.state}")
    if not any(report.state == "loaded" for report in reports):
        lines.append("  none")
        advice.append("no plugin was found: files can not be read; name their folder in CANDELA_PLUGIN_PATH")
    return lines


def _color_lines(advice: list[str]) -> list[str]:
    try:
        config = _candela.ColorConfig.choose()
    except Exception as error:
        advice.append(f"the OpenColorIO config of $OCIO can not be used; unset OCIO for the built-in one: {error}")
        return [f"colour: {error}"]
    display = config.default_display
    return [f"colour: OpenColorIO config {config.source}, working space {config.working_space}, display {display}, view "
            f"{config.default_view(display)}"]


def _variable_lines() -> list[str]:
    set_ones = [f"  {name}={os.environ[name]}" for name in _VARIABLES if name in os.environ]
    return ["environment variables that matter:", *set_ones] if set_ones else []


def _vendor_files() -> list[str]:
    return sorted(glob.glob("/usr/share/glvnd/egl_vendor.d/*.json") + glob.glob("/etc/glvnd/egl_vendor.d/*.json"))


def _context_advice(found: dict[str, Any], attempts: tuple[tuple[str, str], ...]) -> list[str]:
    advice = []
    vendors = " ".join(os.path.basename(each).lower() for each in _vendor_files())
    has_nvidia = os.path.exists("/dev/nvidiactl")
    render_nodes = glob.glob("/dev/dri/renderD*")
    closed_nodes = [node for node in render_nodes if not os.access(node, os.R_OK | os.W_OK)]
    if "renderer" not in found:
        advice.append("no context could be made: install Mesa's EGL and its software renderer (Debian: apt install libegl1 "
                      "libegl-mesa0 libgl1-mesa-dri; conda brings libraries of its own, which LD_LIBRARY_PATH may put first)")
    uses_gpu = "renderer" in found and not found.get("software", False)
    if has_nvidia and "nvidia" not in vendors and not uses_gpu:
        advice.append("an NVIDIA GPU is there, but EGL does not know its driver: install libEGL_nvidia (Debian: apt install "
                      "libnvidia-egl-gbm1 nvidia-egl-icd; in a container set NVIDIA_DRIVER_CAPABILITIES=all, and look for "
                      "10_nvidia.json in /usr/share/glvnd/egl_vendor.d)")
    if closed_nodes and not uses_gpu:
        advice.append(f"this user may not use {', '.join(closed_nodes)}: add it to the group that owns it (usermod -aG render "
                      "USER), or give the device to the container (docker run --device /dev/dri)")
    if os.environ.get("LIBGL_ALWAYS_SOFTWARE") and (render_nodes or has_nvidia):
        advice.append("LIBGL_ALWAYS_SOFTWARE keeps Mesa from using the GPU: unset it")
    if "renderer" in found and not uses_gpu and not advice:
        failed = [way for way, outcome in attempts if outcome != found["renderer"]]
        if failed and (render_nodes or has_nvidia):
            advice.append("pictures are drawn by the processor; the lines above tell why each GPU was not used")
    return advice
