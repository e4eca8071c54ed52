"""candela renders scenes that are lit by very many lights, on GPUs and on processors alone.

    import candela

    scene = candela.load("room.glb")
    with candela.Renderer() as renderer:
        frame = renderer.render(scene, width=640, height=480, aovs=["depth", "normal"])
        frame.save("room.png")
        depth = frame["depth"]  # (480, 640) of float32, metres

Lengths are metres, angles radians, world space is right-handed with +Y up. Matrices move columns: `matrix @ point`.
Pictures are (height, width, channels) arrays, rows from the top. Errors are `candela.Error` and its subclasses; what is
not as one may expect is a `CandelaWarning`.

Any thread may call any function; calls that use one context run one after the other, and none holds the GIL while it
draws. Processes that use OpenGL are to be started by "spawn", or forked before the first Context or Renderer.
"""

from candela._candela import (
    Animation,
    AnimationChannel,
    Cage,
    Camera,
    CameraView,
    ColorConfig,
    Context,
    Corner,
    Crease,
    Device,
    Environment,
    Frame,
    GpuScene,
    Image,
    ImageHandle,
    ImportNote,
    Light,
    LightHandle,
    Material,
    MaterialHandle,
    Mesh,
    MeshHandle,
    MorphTarget,
    Node,
    NodeHandle,
    PickedSurface,
    PixelProbe,
    PluginRegistry,
    PluginReport,
    Renderer,
    RenderSettings,
    Scene,
    SceneInfo,
    Skin,
    Submesh,
    Texture,
    aov_meanings,
    aov_names,
    candela_from_lumen,
    devices,
    has_shadows,
    look_at,
    read_hdr,
    set_thread_count,
    thread_count,
    version,
    write_exr,
    write_png,
)
from candela.cameras import intrinsics, points_from_depth, pose_from, project, view_from_intrinsics
from candela.diagnosis import Diagnosis, diagnose
from candela.errors import (
    CancelledError,
    CandelaWarning,
    Error,
    InputError,
    LimitError,
    MachineError,
    UnsupportedError,
)
from candela.loading import load
from candela.meshes import from_trimesh

__version__: str = version

__all__ = [
    "__version__",
    "Animation",
    "AnimationChannel",
    "aov_meanings",
    "aov_names",
    "Cage",
    "Camera",
    "CameraView",
    "CancelledError",
    "candela_from_lumen",
    "CandelaWarning",
    "ColorConfig",
    "Context",
    "Corner",
    "Crease",
    "Device",
    "devices",
    "diagnose",
    "Diagnosis",
    "Environment",
    "Error",
    "Frame",
    "from_trimesh",
    "GpuScene",
    "has_shadows",
    "Image",
    "ImageHandle",
    "ImportNote",
    "InputError",
    "intrinsics",
    "Light",
    "LightHandle",
    "LimitError",
    "load",
    "look_at",
    "MachineError",
    "Material",
    "MaterialHandle",
    "Mesh",
    "MeshHandle",
    "MorphTarget",
    "Node",
    "NodeHandle",
    "PickedSurface",
    "PixelProbe",
    "PluginRegistry",
    "PluginReport",
    "points_from_depth",
    "pose_from",
    "project",
    "read_hdr",
    "Renderer",
    "RenderSettings",
    "Scene",
    "SceneInfo",
    "set_thread_count",
    "Skin",
    "Submesh",
    "Texture",
    "thread_count",
    "UnsupportedError",
    "view_from_intrinsics",
    "write_exr",
    "write_png",
]
