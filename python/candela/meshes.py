"""Scenes of trimesh as scenes of candela."""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from candela._candela import Camera, Image, Light, Material, Node, Scene, Texture
from candela.errors import InputError


def from_trimesh(source: Any, *, smooth: bool = True) -> Scene:
    """A Scene from a `trimesh.Scene`, a `Trimesh`, a `PointCloud` or a `Path3D`.

    Nodes keep their names and transforms, geometry that several nodes show is one mesh, and materials, textures, vertex
    and face colours become those of candela: colours of trimesh are sRGB-encoded. Lights and the camera of the scene come
    too, if they were made.

    Args:
        source: What trimesh has loaded or made.
        smooth: Whether meshes get the vertex normals that trimesh has, or flat faces.
    """
    trimesh = _trimesh()
    if not isinstance(source, trimesh.Scene) and not hasattr(source, "vertices"):
        raise InputError(f"from_trimesh: expected a Scene or a geometry of trimesh, not a {type(source).__name__}")
    scene = source if isinstance(source, trimesh.Scene) else trimesh.Scene([source])
    return _Conversion(trimesh, scene, smooth).scene


_ALPHA_MODES: dict[Any, Literal["opaque", "mask", "blend"]] = {"MASK": "mask", "BLEND": "blend"}


def _trimesh() -> Any:
    try:
        import trimesh
    except ImportError as error:
        raise InputError("from_trimesh needs the package trimesh: pip install trimesh") from error
    return trimesh


def _linear(color: Any) -> NDArray[np.float64]:
    """Linear colour from sRGB code values of 0 to 255; alpha stays a share."""
    values = np.asarray(color, dtype=np.float64) / 255.0
    rgb = values[..., :3]
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return np.concatenate([linear, values[..., 3:]], axis=-1)


class _Conversion:
    def __init__(self, trimesh: Any, source: Any, smooth: bool) -> None:
        self.trimesh, self.smooth, self.scene = trimesh, smooth, Scene()
        self.meshes: dict[str, int | None] = {}
        self.materials: dict[int, int] = {}
        self.images: dict[int, int] = {}
        self.geometry = source.geometry
        self._add_nodes(source.graph)
        if source.has_camera:
            self._add_camera(source)
        for light in getattr(source, "_lights", None) or []:
            self._add_light(light, source.graph)

    def _add_nodes(self, graph: Any) -> None:
        """The tree of the graph, parents before children."""
        indices: dict[str, int] = {}
        children: dict[str, list[tuple[str, dict[str, Any]]]] = {}
        for parent, child, data in graph.to_edgelist():
            children.setdefault(parent, []).append((child, data))
        waiting: list[tuple[str, str | None, dict[str, Any]]] = [(graph.base_frame, None, {})]
        while waiting:
            name, parent, data = waiting.pop(0)
            node = Node(name=str(name), parent=None if parent is None else indices[parent])
            if "matrix" in data:
                node.matrix = np.asarray(data["matrix"], dtype=np.float64)
            geometry = data.get("geometry")
            if geometry is not None:
                node.mesh = self._mesh(geometry)
            indices[name] = self.scene.nodes.append(node)
            waiting += [(child, name, edge) for child, edge in children.get(name, [])]

    def _mesh(self, name: str) -> int | None:
        if name not in self.meshes:
            before = len(self.scene.meshes)
            self._add_geometry(name, self.geometry[name])
            self.meshes[name] = before if len(self.scene.meshes) > before else None
        return self.meshes[name]

    def _add_geometry(self, name: str, geometry: Any) -> None:
        holder = Scene()
        if isinstance(geometry, self.trimesh.Trimesh):
            self._add_triangles(holder, name, geometry)
        elif isinstance(geometry, self.trimesh.PointCloud):
            colors = getattr(geometry, "colors", None)
            has_colors = colors is not None and len(colors) == len(geometry.vertices)
            holder.add_mesh(
                geometry.vertices, topology="points", name=name, colors=_linear(colors) if has_colors else None
            )
        elif hasattr(geometry, "entities"):
            self._add_lines(holder, name, geometry)
        else:
            raise InputError(f"from_trimesh: geometry '{name}' is a {type(geometry).__name__}, which can not be drawn")
        for mesh in holder.meshes:
            self.scene.meshes.append(mesh)

    def _add_lines(self, holder: Scene, name: str, path: Any) -> None:
        positions: list[Any] = []
        indices: list[list[int]] = []
        for entity in path.entities:
            first = len(positions)
            points = np.asarray(entity.discrete(path.vertices), dtype=np.float64)
            points = np.pad(points, ((0, 0), (0, 3 - points.shape[1])))
            positions.extend(points)
            indices.extend([first + i, first + i + 1] for i in range(len(points) - 1))
        if indices:
            holder.add_mesh(positions, indices, topology="lines", name=name)

    def _add_triangles(self, holder: Scene, name: str, mesh: Any) -> None:
        if len(mesh.faces) == 0:
            return
        visual, uvs, colors = mesh.visual, None, None
        vertices, faces = np.asarray(mesh.vertices), np.asarray(mesh.faces)
        normals = np.asarray(mesh.vertex_normals) if self.smooth else None
        crease_angle = math.pi if self.smooth else 0.0
        material = None
        if visual.kind == "texture":
            material = self._material(visual.material, mesh)
            if visual.uv is not None and len(visual.uv) == len(vertices):
                # trimesh has (0, 0) at the lower left of an image.
                uvs = np.asarray(visual.uv, dtype=np.float64) * (1.0, -1.0) + (0.0, 1.0)
        elif visual.kind == "vertex":
            colors = _linear(visual.vertex_colors)
        elif visual.kind == "face":
            # A corner of each face is a vertex of its own, so that colours end at edges.
            colors = _linear(np.repeat(visual.face_colors, 3, axis=0))
            normals = normals[faces.reshape(-1)] if normals is not None else None
            vertices, faces = vertices[faces.reshape(-1)], np.arange(faces.size).reshape(-1, 3)
        if material is None:
            material = self._default_material(colors)
        if normals is not None:
            lengths = np.linalg.norm(normals, axis=1, keepdims=True)
            normals = np.where(lengths > 1e-6, normals / np.maximum(lengths, 1e-6), (0.0, 1.0, 0.0))
        holder.add_mesh(
            vertices, faces, normals=normals, crease_angle=crease_angle, uvs=uvs, colors=colors, material=material, name=name
        )

    def _default_material(self, colors: Any) -> int:
        """That of meshes without one: grey, or white where colours multiply it."""
        has_alpha = colors is not None and bool(np.any(colors[:, 3] < 1.0))
        grey = 1.0 if colors is not None else 0.4
        key = -1 - (2 * (colors is not None) + has_alpha)
        if key not in self.materials:
            material = Material(base_color=(grey, grey, grey), roughness=0.6, double_sided=True)
            if has_alpha:
                material.alpha_mode = "blend"
            self.materials[key] = self.scene.materials.append(material)
        return self.materials[key]

    def _material(self, source: Any, mesh: Any) -> int:
        if id(source) not in self.materials:
            is_pbr = isinstance(source, self.trimesh.visual.material.PBRMaterial)
            material = self._pbr(source) if is_pbr else self._simple(source)
            self.materials[id(source)] = self.scene.materials.append(material)
        return self.materials[id(source)]

    def _pbr(self, source: Any) -> Material:
        def number(value: Any, default: float) -> float:
            return default if value is None else float(value)

        material = Material(
            name=source.name or "",
            metallic=number(source.metallicFactor, 1.0 if source.metallicRoughnessTexture is not None else 0.0),
            roughness=number(source.roughnessFactor, 1.0),
            base_color_texture=self._texture(source.baseColorTexture),
            metallic_roughness_texture=self._texture(source.metallicRoughnessTexture),
            normal_texture=self._texture(source.normalTexture),
            occlusion_texture=self._texture(source.occlusionTexture),
            emission_texture=self._texture(source.emissiveTexture),
            alpha_mode=_ALPHA_MODES.get(source.alphaMode, "opaque"),
            alpha_cutoff=number(source.alphaCutoff, 0.5),
            double_sided=bool(source.doubleSided),
        )
        if source.baseColorFactor is not None:
            # trimesh has glTF's linear factor as code values of 0 to 255, which are not sRGB-encoded.
            material.base_color = np.asarray(source.baseColorFactor, dtype=np.float64) / 255.0
        if source.emissiveFactor is not None:
            material.emission = np.asarray(source.emissiveFactor, dtype=np.float64)
        return material

    def _simple(self, source: Any) -> Material:
        image = getattr(source, "image", None)
        # Blinn-Phong's exponent n has the width of GGX with alpha = sqrt(2 / (n + 2)), which is roughness squared.
        glossiness = max(float(getattr(source, "glossiness", 1.0) or 0.0), 0.0)
        color = (1.0, 1.0, 1.0, 1.0) if image is not None else _linear(source.diffuse)
        return Material(
            name=source.name or "",
            base_color=color,
            roughness=min(math.sqrt(math.sqrt(2.0 / (glossiness + 2.0))), 1.0),
            base_color_texture=self._texture(image),
            alpha_mode="blend" if color[3] < 1.0 else "opaque",
            double_sided=True,
        )

    def _texture(self, image: Any) -> Texture | None:
        if image is None:
            return None
        if id(image) not in self.images:
            mode = "RGBA" if "A" in image.getbands() or image.mode == "P" else "RGB"
            pixels = np.asarray(image.convert(mode))
            self.images[id(image)] = self.scene.images.append(Image(name=getattr(image, "filename", "") or "", pixels=pixels))
        return Texture(image=self.images[id(image)])

    def _node_named(self, name: str) -> int | None:
        return next((i for i, node in enumerate(self.scene.nodes) if node.name == name), None)

    def _add_camera(self, source: Any) -> None:
        camera = source.camera
        self.scene.cameras.append(
            Camera(
                name=camera.name or "camera",
                vertical_fov=math.radians(float(camera.fov[1])),
                node=self._node_named(camera.name),
            )
        )

    def _add_light(self, source: Any, graph: Any) -> None:
        kinds = self.trimesh.scene.lighting
        light = Light(
            name=source.name or "",
            color=_linear(source.color)[:3],
            intensity=float(source.intensity),
            node=self._node_named(source.name),
        )
        if isinstance(source, kinds.DirectionalLight):
            light.type = "directional"
        elif isinstance(source, kinds.SpotLight):
            light.type = "spot"
            light.inner_cone_angle = float(source.innerConeAngle)
            light.outer_cone_angle = float(source.outerConeAngle)
        if getattr(source, "radius", None) is not None and math.isfinite(float(source.radius)):
            light.range = float(source.radius)  # What trimesh calls radius is the cutoff of KHR_lights_punctual.
        self.scene.lights.append(light)
