# SPDX-License-Identifier: MIT
"""Clusters of faces: made by the tool as scene files ask, kept in images, and drawn."""

from dataclasses import replace
from fractions import Fraction
import json
import random
import struct

import pytest

from fixel.check import frame_hashes
from conftest import CHECKOUT, run_cli
from fixel.board import dump
from fixel.image import image, image_cluster
from fixel.model import clusters
from fixel.scene import making, toml_scene
from fixel.base.errors import ToolError
from fixel.board.programs import run_program
# place field: images that are broken, for the tools
from scene_sections import entry_at, replaced, section
from test_scene_image import patched

BUILT_PROGRAMS = ("host/frames", "host/judge")
GLOBE = """
[[objects]]
solid = "sphere"
sides = 16
rings = 12
scale = 4
kind = "sorted"
clusters = true
colours = ["red", "green", "blue"]

[path]
keys = [{ position = [0, 1, -3] }]
"""
WALL = """
[[objects]]
solid = "floor"
cells = [9, 9]
scale = 8
kind = "sorted"
two_sided = true
clusters = true
[path]
keys = [{ position = [0, 1, -3] }]
"""
F32 = CHECKOUT / "scenes" / "f32.toml"


def made_of(tmp_path, text):
    file = tmp_path / "scene.toml"
    file.write_text(text)
    return toml_scene.compile_file(str(file))[0]


def refused(blob, status):
    with pytest.raises(ToolError, match=f"^{status}:"):
        image.unpack(blob)


def faces_by_cluster(model):
    """[(cluster, its faces)]"""
    found, first = [], 0
    for cluster in model.clusters:
        found.append((cluster, model.faces[first:first + cluster.face_count]))
        first += cluster.face_count
    assert first == len(model.faces)
    return found


def key(model, face):
    """A face by what it is, not by its number."""
    return face.normal, tuple(model.vertices[corner] for corner in face.corners), face.colour


@pytest.mark.parametrize("text", [GLOBE, WALL])
def test_faces_keep_their_colours_and_come_in_runs(tmp_path, text):
    model, = made_of(tmp_path, text).models
    plain, = made_of(tmp_path, text.replace("clusters = true\n", "")).models
    assert not plain.clusters and plain.vertices == model.vertices
    assert sorted(key(model, face) for face in model.faces) == sorted(key(plain, face) for face in plain.faces)
    assert all(16 <= cluster.face_count <= 32 for cluster in model.clusters) and len(model.clusters) > 4
    numbers = {key(plain, face): number for number, face in enumerate(plain.faces)}
    for _, faces in faces_by_cluster(model):
        own = [numbers[key(model, face)] for face in faces]
        assert own == sorted(own)


def test_a_model_of_few_faces_is_one_cluster(tmp_path):
    model, = made_of(tmp_path, GLOBE.replace("sides = 16\nrings = 12", "sides = 4\nrings = 4")).models
    assert [cluster.face_count for cluster in model.clusters] == [len(model.faces)]


def test_spheres_hold_their_faces_and_no_more_than_need_be(tmp_path):
    model, = made_of(tmp_path, GLOBE).models
    for cluster, faces in faces_by_cluster(model):
        squares = [sum((a - b) ** 2 for a, b in zip(model.vertices[corner], cluster.centre))
                   for face in faces for corner in face.corners]
        assert (cluster.radius - 1) ** 2 < max(squares) <= cluster.radius ** 2


def in_cone(cluster, eye):
    """By the definition, exactly."""
    u = [a - e for a, e in zip(cluster.apex, eye)]
    along = Fraction(image_cluster.dot(u, cluster.axis), 1 << 30)
    return any(cluster.axis) and along >= 0 and \
        along ** 2 >= Fraction(cluster.cutoff, 1 << 32) * image_cluster.dot(u, u)


@pytest.mark.parametrize("text", [GLOBE, WALL])
def test_no_eye_in_a_cone_sees_a_front(tmp_path, text):
    """formats 1.8l."""
    model, = made_of(tmp_path, text).models
    chance, seen = random.Random(3), 0
    for cluster, faces in faces_by_cluster(model):
        assert any(cluster.axis)
        for _ in range(200):
            size = chance.choice((1 << 18, 1 << 20, 1 << 26))
            eye = [c + chance.randint(-size, size) for c in cluster.apex]
            if in_cone(cluster, eye):
                seen += 1
                for face in faces:
                    first = model.vertices[face.corners[0]]
                    assert image_cluster.dot(face.normal, [e - v for e, v in zip(eye, first)]) <= 0
    assert seen > 100


def test_the_sides_of_a_wall_are_in_different_clusters(tmp_path):
    model, = made_of(tmp_path, WALL).models
    for cluster, faces in faces_by_cluster(model):
        assert len({face.normal for face in faces}) == 1
        assert cluster.axis == faces[0].normal


def test_faces_that_look_all_ways_have_no_cone(tmp_path):
    model, = made_of(tmp_path, GLOBE.replace("sides = 16\nrings = 12", "sides = 4\nrings = 4")).models
    cluster, = model.clusters
    assert (cluster.axis, cluster.cutoff, cluster.apex) == ((0, 0, 0), 0, (0, 0, 0))


def test_places_at_one_point_go_by_number():
    places = clusters._split(clusters._places([(0, 0, 0), (9, 0, 0), (0, 9, 0)],   # pylint: disable=protected-access
                                              [image.Face((0, 0, 1 << 30), (0, 1, 2), 1)] * 100))
    assert [number for group in places for number in group] == list(range(100))


def test_images_hold_clusters_beside_beams(tmp_path):
    scene = made_of(tmp_path, GLOBE)
    blob = image.pack(scene)
    assert section(blob, "clusters")[1] > 0
    assert image.unpack(blob) == scene
    plain = image.pack(made_of(tmp_path, GLOBE.replace("clusters = true\n", "")))
    assert section(plain, "clusters") == (0, 0)
    lit = made_of(tmp_path, GLOBE + '[[beams]]\ndirection = [0, -1, 0]\nwindow = [[0, 5, 0], [1, 5, 0], [0, 5, 1]]\n')
    assert image.unpack(image.pack(lit)) == lit and lit.beams


def test_damaged_clusters_are_refused(tmp_path):
    scene = made_of(tmp_path, GLOBE)
    blob = image.pack(scene)
    (offset, count), at = section(blob, "clusters"), entry_at(blob, "clusters")
    models, _ = section(blob, "models")
    cluster = scene.models[0].clusters[0]
    refused(patched(blob, at + 8, struct.pack("<I", 0)), "count")
    refused(replaced(blob, clusters=blob[offset:offset + 48 * (count - 1)]), "index")
    refused(patched(blob, at + 4, struct.pack("<I", len(blob))), "offset")
    refused(patched(blob, models + 18, b"\2\0"), "index")
    refused(patched(blob, models + 18, b"\0\0"), "count")
    refused(patched(blob, offset + 46, b"\1"), "reserved")
    refused(patched(blob, offset + 44, b"\0\0"), "count")
    refused(patched(blob, offset + 12, struct.pack("<i", cluster.radius - 1)), "radius")
    refused(patched(blob, offset + 12, struct.pack("<i", -1)), "range")
    refused(patched(blob, offset, struct.pack("<i", 1 << 29)), "range")
    refused(patched(blob, offset + 16, struct.pack("<i", cluster.axis[0] ^ 1 << 20)), "normal")
    refused(patched(blob, offset + 16, bytes(12)), "reserved")
    refused(patched(blob, offset + 28, struct.pack("<I", cluster.cutoff - 1)), "cluster")
    refused(patched(blob, offset + 32, struct.pack("<i", 1 << 30)), "range")
    ahead = [c + (a >> 16) for c, a in zip(cluster.apex, cluster.axis)]
    refused(patched(blob, offset + 32, struct.pack("<3i", *ahead)), "cluster")


def test_the_model_of_a_tree_has_no_clusters(tmp_path):
    file, out = tmp_path / "scene.toml", tmp_path / "scene.fxls"
    file.write_text(GLOBE)
    assert run_cli("build", str(file), "-o", str(out), "--tree", "all").returncode == 0
    scene = image.load(str(out))
    assert scene.tree and not scene.models[0].clusters


def test_info_counts_clusters(tmp_path):
    file, out = tmp_path / "scene.toml", tmp_path / "scene.fxls"
    file.write_text(GLOBE)
    assert run_cli("build", str(file), "-o", str(out)).returncode == 0
    said = json.loads(run_cli("info", str(out), "--json").stdout)
    assert said["clusters"] == len(made_of(tmp_path, GLOBE).models[0].clusters)
    assert f"clusters {said['clusters']} of faces" in run_cli("info", str(out)).stdout


def test_a_convex_model_is_refused(tmp_path):
    with pytest.raises(ToolError, match="convex"):
        made_of(tmp_path, GLOBE.replace('kind = "sorted"\n', ""))


def test_a_terrain_draws_the_same_pixels_without_clusters(build, tmp_path):
    """No two of its faces are exactly as far away where they overlap."""
    scene, _ = toml_scene.compile_file(str(F32))
    text = F32.read_text(encoding="utf-8")
    assert "clusters = true\n" in text
    plain = replace(scene, models=[replace(scene.models[0], clusters=[])])
    drawn = []
    for made in (scene, plain):
        (tmp_path / "scene.fxls").write_bytes(image.pack(made))
        drawn.append(frame_hashes.drawn_by_host(tmp_path / "scene.fxls", build, tmp_path))
    for one, other in zip(drawn[0].frames, drawn[1].frames, strict=True):
        assert (one.pixels == other.pixels).all()
        for name in ("in", "drawn", "clipped", "degenerate", "refused"):
            assert one.counters[name] == other.counters[name]
        assert one.counters["backfacing"] <= other.counters["backfacing"]


@pytest.mark.parametrize("file", ["scenes/f32.toml", "host_tests/fuzz/scenes/clusters.toml"])
def test_the_reference_renderer_counts_the_same(build, tmp_path, file):
    """It applies the sphere test to clusters by its definition, in double."""
    scene, frames, twin = (tmp_path / name for name in ("scene.fxls", "frames.fxld", "double.fxld"))
    making.build(str(CHECKOUT / file), str(scene))
    run_program([build / "host" / "frames", scene, frames])
    run_program([build / "host" / "judge", scene, frames, "--json", tmp_path / "report.json", "--twin", twin])
    ours, theirs = dump.read_dump(frames).frames, dump.read_dump(twin).frames
    assert [frame.counters["outside"] for frame in ours] == [frame.counters["outside"] for frame in theirs]
    for name in ("in", "backfacing", "degenerate", "refused", "drawn", "clipped"):
        assert [frame.counters[name] for frame in ours] == [frame.counters[name] for frame in theirs]
    assert json.loads((tmp_path / "report.json").read_text())["pixels_unexplained"] == 0
