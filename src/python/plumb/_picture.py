"""Pictures of meshes, for notebooks and for pages that open offline.

Each pixel is a ray of Bvh.closest_hit, so that what is seen is what the rays hit; only the shades are rounded.
"""

import base64
import html
import os
import struct
import zlib
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ._plumb import Bvh, Mesh

OUTSIDE, INSIDE = np.array([120, 160, 205]), np.array([205, 90, 75])  # a surface that is seen from behind is red
VIEWS = {"from above": (-0.5, 0.7, -0.5), "from the right": (-1, 0, 0), "from the front": (0, 1, 0)}


def png(pixels: NDArray[np.uint8]) -> bytes:
    """The file of an image, (height, width, 4) of uint8."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    height, width = pixels.shape[:2]
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def camera(
    mesh: Mesh, direction: Sequence[float], width: int, height: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]] | None:
    """The origins of the rays of a parallel view and their direction, or None where doubles do not reach so far."""
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    middle, half = low / 2 + high / 2, high / 2 - low / 2
    size = half.max() or 1.0
    radius = size * np.linalg.norm(half / size)
    forward = np.array(direction, float) / np.linalg.norm(direction)
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    x = (np.arange(width) + 0.5 - width / 2) * (2.1 / min(width, height))
    y = (height / 2 - np.arange(height) - 0.5) * (2.1 / min(width, height))
    across = x[None, :, None] * right + y[:, None, None] * up - 1.5 * forward
    with np.errstate(over="ignore"):
        origins = (middle + radius * across).reshape(-1, 3)
    return (origins, forward) if np.isfinite(origins).all() else None


def pixels(
    mesh: Mesh, bvh: Bvh, direction: Sequence[float] = VIEWS["from above"], width: int = 360, height: int = 300
) -> NDArray[np.uint8] | None:
    """(height, width, 4) of uint8, transparent where no triangle is seen; None where there is nothing to draw."""
    if len(mesh.faces) == 0:
        return None
    seen = camera(mesh, direction, width, height)
    if seen is None:
        return None
    origins, forward = seen
    triangle = bvh.closest_hit(origins, forward)[0]
    hit = triangle >= 0
    corners = mesh.vertices[mesh.faces[triangle[hit]]]
    corners = corners / (np.abs(corners).max() or 1.0)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    normals /= np.where(lengths > 0, lengths, 1)[:, None]
    light = forward + [0.2, 0.1, -0.4]
    shade = 0.35 + 0.65 * np.abs(normals @ (light / np.linalg.norm(light)))
    colors = np.where((normals @ forward > 0)[:, None], INSIDE, OUTSIDE) * shade[:, None]
    image = np.zeros((height * width, 4), np.uint8)
    image[hit, :3] = colors
    image[hit, 3] = 255
    return image.reshape(height, width, 4)


def image_tag(image: NDArray[np.uint8], text: str) -> str:
    return f'<img alt="{html.escape(text)}" src="data:image/png;base64,{base64.b64encode(png(image)).decode()}">'


def repr_html(self: Mesh) -> str:
    """What a notebook shows: the mesh from above, as one image, and what it is."""
    image = pixels(self, Bvh(self))
    text = repr(self)
    return (image_tag(image, text) + "<br>" if image is not None else "") + f"<code>{html.escape(text)}</code>"


def show(self: Mesh, path: str | os.PathLike[str] = "mesh.html") -> Path:
    """Write one HTML page with the mesh from three sides, which opens offline.

    Parameters
    ----------
    path : str or os.PathLike, of the page; a file that is there is replaced

    Returns
    -------
    pathlib.Path, of the page
    """
    bvh, figures = Bvh(self), ""
    for name, direction in VIEWS.items():
        image = pixels(self, bvh, direction)
        if image is not None:
            figures += f"<figure>{image_tag(image, name)}<figcaption>{name}</figcaption></figure>\n"
    text = html.escape(repr(self))
    page = Path(path)
    page.write_text(f'<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>{text}</title>\n'
                    "<style>body{font-family:sans-serif}figure{display:inline-block;margin:1em}</style>\n"
                    f"<h1>{text}</h1>\n{figures or '<p>There is nothing to draw.</p>'}</html>\n", encoding="utf-8")
    return page
