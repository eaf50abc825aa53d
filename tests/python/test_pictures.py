"""Does a mesh show itself, offline, as its rays see it?"""

import base64
import re
import struct
import zlib

import numpy as np
import pytest

import plumb

TETRAHEDRON = plumb.Mesh([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def images(text):
    """The pixels of each image in a page, by what the PNG says of itself."""
    found = []
    for data in re.findall(r'src="data:image/png;base64,([^"]+)"', text):
        file, at, parts = base64.b64decode(data), 8, {}
        while at < len(file):
            length, kind = struct.unpack(">I4s", file[at:at + 8])
            parts[kind] = file[at + 8:at + 8 + length]
            assert struct.unpack(">I", file[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + parts[kind])
            at += 12 + length
        width, height = struct.unpack(">II", parts[b"IHDR"][:8])
        rows = np.frombuffer(zlib.decompress(parts[b"IDAT"]), np.uint8).reshape(height, 1 + 4 * width)
        found.append(rows[:, 1:].reshape(height, width, 4))
    return found


def test_a_notebook_shows_the_mesh():
    text = TETRAHEDRON._repr_html_()
    image, = images(text)
    seen = image[..., 3] > 0
    assert "Mesh(4 vertices, 4 faces)" in text and "http" not in text
    assert 0.05 < seen.mean() < 0.5 and not seen[0].any() and not seen[:, 0].any()
    assert (image[seen][:, 2] > image[seen][:, 0]).all()  # blue is outside
    inside_out, = images(plumb.Mesh(TETRAHEDRON.vertices, TETRAHEDRON.faces[:, ::-1])._repr_html_())
    assert (inside_out[..., 3] == image[..., 3]).all()
    assert (inside_out[seen][:, 0] > inside_out[seen][:, 2]).all()  # red is inside


@pytest.mark.parametrize("scale", [1e-300, 1e-9, 1e150, 1e300])
def test_its_size_changes_nothing(scale):
    power = 2.0 ** round(np.log2(scale))
    small, = images(plumb.Mesh(TETRAHEDRON.vertices * power, TETRAHEDRON.faces)._repr_html_())
    image, = images(TETRAHEDRON._repr_html_())
    assert (small[..., 3] == image[..., 3]).all()


def test_a_page_opens_offline(tmp_path):
    page = TETRAHEDRON.show(tmp_path / "mesh.html")
    text = page.read_text(encoding="utf-8")
    assert page == tmp_path / "mesh.html" and len(images(text)) == 3 and "http" not in text and "<script" not in text


def test_what_cannot_be_drawn_is_told(tmp_path):
    for mesh in (plumb.Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int32)),
                 plumb.Mesh(TETRAHEDRON.vertices * 4e307, TETRAHEDRON.faces)):
        assert "<img" not in mesh._repr_html_() and "Mesh(" in mesh._repr_html_()
        assert "nothing to draw" in mesh.show(tmp_path / "none.html").read_text(encoding="utf-8")
