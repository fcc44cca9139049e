# SPDX-License-Identifier: MIT
"""The frame of a glTF 2.0 file, checked: JSON, buffers, accessors, the tree of nodes; what is left out of one, for a note; and what is refused,
with the way to go."""

import base64
import binascii
import json
import os
import struct
import urllib.parse

import numpy as np

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model import model_text
from fixel.model.sources import find_named

_CONVERT = "gltf-transform (npx @gltf-transform/cli copy in.glb out.glb) writes it without, or export it so"
_INSTANCES, _VARIANTS = "EXT_mesh_gpu_instancing", "KHR_materials_variants"
_BLENDER = "Blender (File, Import, then File, Export) writes"
_COMPRESSED = {"KHR_draco_mesh_compression": f"its meshes are compressed by Draco: {_CONVERT}",
               "EXT_meshopt_compression": f"its buffers are compressed by meshopt: {_CONVERT}",
               "KHR_meshopt_compression": f"its buffers are compressed by meshopt: {_CONVERT}"}
_REFUSED = {**_COMPRESSED, _INSTANCES: f"its meshes are placed by lists of instances: {_BLENDER} them as nodes"}
# Extensions by which a texture has an image in a format that is not read, and the command of gltf-transform that writes PNG instead.
IMAGES = {"KHR_texture_basisu": ("KTX2", "ktxdecompress"), "EXT_texture_avif": ("AVIF", "png --formats avif")}
# What may be required: what is read, and images that stand beside others.
READ = ("KHR_texture_transform", "KHR_mesh_quantization", "KHR_materials_unlit", "KHR_materials_emissive_strength",
        "KHR_materials_pbrSpecularGlossiness", "KHR_materials_transmission", "EXT_texture_webp", *IMAGES, "MSFT_texture_dds")
_HARMLESS = ("KHR_materials_", "KHR_lights_punctual", "KHR_xmp")
# What is left out with words of its own.
_TOLD = {_INSTANCES: f"meshes placed by lists of instances ({_INSTANCES}), each of which stands at its node once: {_BLENDER} them as nodes",
         _VARIANTS: f"other materials ({_VARIANTS}): the model has those that it has without; {_BLENDER} it with those that it shows"}
_LISTS = {"animations": ": the model is shown as it stands without", "cameras": "; --camera NAME takes one as the path of a model without a scene file"}


def image_text(extension):
    """What there is to say of a texture that has its image by an extension of IMAGES alone."""
    kind, command = IMAGES[extension]
    return f"its image is {kind} ({extension}), which is not read: gltf-transform (npx @gltf-transform/cli {command} in.glb out.glb) writes " \
        "the model with PNG images, or export it so"


def refuse_required(name, required):
    """Refuses a file that requires an extension that is not read."""
    for extension in required if isinstance(required, list) else [required]:
        if isinstance(extension, str) and extension in _REFUSED:
            raise ToolError(f"{name}: {extension}: {_REFUSED[extension]}")
        if not isinstance(extension, str) or not (extension in READ or extension.startswith(_HARMLESS)):
            raise ToolError(f"{name}: the model requires the extension {quoted(extension)}, which is not read; save it "
                            "without, for example without compression")


def refuse_compressed(checked, entry, where):
    """Refuses a buffer or a primitive whose values are there in compressed form alone."""
    extensions = entry.get("extensions")
    for extension, how in _COMPRESSED.items():
        if isinstance(extensions, dict) and extension in extensions:
            checked.fail(where, f"{extension}: {how}")


def _count(value):
    return len(value) if isinstance(value, list) else 0


def _morphs(checked):
    """How many parts of meshes have other shapes to change to."""
    return sum("targets" in part for mesh in checked.rows("meshes") for part in mesh.get("primitives", ()) if isinstance(part, dict))


def notes(checked):
    """({kind: a note}, notes) of what is left out: of what a program of the tools may make something of, and of the rest."""
    name, found, kinds = checked.name, [], {}
    for key, what in _LISTS.items():
        if _count(checked.data.get(key)):
            kinds[key] = f"{name}: left out {key} ({_count(checked.data[key]):,}){what}"
    if _morphs(checked):
        found.append(f"{name}: left out other shapes (morph targets) of parts of meshes: {_morphs(checked):,}")
    extensions = checked.data.get("extensions")
    lights = extensions.get("KHR_lights_punctual") if isinstance(extensions, dict) else None
    if isinstance(lights, dict) and _count(lights.get("lights")):
        kinds["lights"] = f"{name}: left out lights ({_count(lights['lights']):,}): the tool's own light falls on the model"
    lists = [checked.data.get(key) for key in ("extensionsUsed", "extensionsRequired")]
    used = {each for names in lists if isinstance(names, list) for each in names if isinstance(each, str)}
    found += [f"{name}: left out {_TOLD[each]}" for each in sorted(used & set(_TOLD))]
    others = sorted(used - set(READ) - set(_TOLD) - {"KHR_lights_punctual"})
    if others:
        shown = ", ".join(map(quoted, others[:6])) + (f" and {len(others) - 6:,} others" if len(others) > 6 else "")
        found.append(f"{name}: left out what the extensions {shown} say")
    return kinds, found


FILE_MAX = 64 << 20         # bytes, of the file and of its buffers together
NODES_MAX, DEPTH_MAX = 65_535, 1000
SPARSE_MAX = 1 << 22        # values of an accessor that has no bytes of its own
_CONVERTS = "gltf-pipeline (npx gltf-pipeline -i in.gltf -o out.glb) converts it"
_GLB_HEAD, _CHUNK_HEAD = struct.Struct("<4sII"), struct.Struct("<II")
_JSON, _BIN = 0x4E4F534A, 0x004E4942
_COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
FLOAT, UNSIGNED = 5126, (5121, 5123, 5125)
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Checked:
    """A file's JSON and its buffers. What is asked for is checked first. notes: what there is to say of other files; left_out: of parts
    that are left out."""

    def __init__(self, name, data, folder, binary, sources):
        self.name, self.data, self.folder, self.binary, self.sources = name, data, folder, binary, sources
        self.room, self.buffers, self.lists, self.notes, self.left_out = FILE_MAX, {}, {}, [], model_text.LeftOut()

    # --- values -----------------------------------------------------------------

    def fail(self, where, text):
        raise ToolError(f"{self.name}: {where}: {text}")

    def label(self, kind, number):
        """"node 3 (\"wheel\")"."""
        entry = self.data.get(kind + ("es" if kind == "mesh" else "s"), [])[number]
        name = entry.get("name") if isinstance(entry, dict) else None
        return f"{kind} {number}" + (f" ({quoted(name)})" if isinstance(name, str) and name else "")

    def rows(self, key):
        """A list of tables at the top, checked when it is first asked for."""
        if key not in self.lists:
            value = self.data.get(key, [])
            if not isinstance(value, list) or not all(isinstance(each, dict) for each in value):
                self.fail(key, "must be a list of objects: the file is damaged")
            self.lists[key] = value
        return self.lists[key]

    def whole(self, table, key, where, default=None, most=1 << 31):
        """A whole number 0..most."""
        value = table.get(key, default)
        if value is None:
            self.fail(where, f"{key} is missing: the file is damaged")
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= most:
            self.fail(where, f"{key} is {quoted(value)}; it must be a whole number from 0 to {most:,}")
        return value

    def entry(self, kind, table, key, where):
        """(number, entry) of another list that a table names by number."""
        rows = self.rows(kind)
        number = self.whole(table, key, where)
        if number >= len(rows):
            self.fail(where, f"{key} {number} does not exist; there are {len(rows)}")
        return number, rows[number]

    # --- bytes ------------------------------------------------------------------

    def _embedded(self, uri, where):
        """The bytes that a URI holds itself; None if it names a file."""
        if not isinstance(uri, str):
            self.fail(where, "uri is no text: the file is damaged")
        if not uri.startswith("data:"):
            return None
        head, comma, text = uri.partition(",")
        if not comma or not head.endswith(";base64"):
            self.fail(where, "its data: is not in base64; save the model as GLB")
        text = "".join(urllib.parse.unquote(text).split()).rstrip("=")      # as browsers take it: without padding too
        try:
            return base64.b64decode(text + "=" * (-len(text) % 4), validate=True)
        except (binascii.Error, ValueError):
            self.fail(where, "its base64 is damaged; save the model anew")

    def _find(self, uri, where):
        """(the file that a URI names, or None where there is none; its name)."""
        name = urllib.parse.unquote(uri)
        if "://" in name or "\0" in name:
            self.fail(where, f"{quoted(name)} is not a file in the model's folder; put it there")
        file, said = find_named(self.folder, name)
        self.notes += [f"{self.name}: {where}: {said}"] if said else []
        return file, name

    def _beside(self, uri, where):
        """The file that a URI names."""
        file, name = self._find(uri, where)
        if file is None:
            self.fail(where, f"there is no file {quoted(name)}; the path is taken from the model's folder")
        return file

    def _fetch(self, uri, where):
        """The bytes of a buffer's URI."""
        blob = self._embedded(uri, where)
        return self.sources.read(self._beside(uri, where), max(self.room, 0), "simplify the model") if blob is None else blob

    def image(self, number):
        """The texture_image.Texture of an image; None, and a note, where it cannot be read or is in a file that is not there."""
        return self.sources.image(lambda: self._image(number), self.notes)

    def _image(self, number):
        entry, where = self.rows("images")[number], self.label("image", number)
        place = f"{self.name}: {where}"
        if "bufferView" in entry:
            return self.sources.image_of_bytes(self.view(entry, where)[0], place)
        blob = self._embedded(entry.get("uri"), where)
        if blob is None:
            file, name = self._find(entry["uri"], where)
            return self.sources.image_named(file, name, place)
        return self.sources.image_of_bytes(blob, place)

    def buffer(self, number):
        """The bytes of a buffer, at least as many as it promises."""
        if number not in self.buffers:
            where, entry = self.label("buffer", number), self.rows("buffers")[number]
            wanted = self.whole(entry, "byteLength", where, most=1 << 40)
            if "uri" not in entry:
                refuse_compressed(self, entry, where)
            if "uri" not in entry and (number or self.binary is None):
                self.fail(where, "it names no file, and the file has no such part: it is damaged")
            blob = self._fetch(entry["uri"], where) if "uri" in entry else self.binary
            if len(blob) < wanted:
                self.fail(where, f"{wanted:,} bytes are promised and {len(blob):,} are there: the file is damaged")
            self.room -= len(blob)
            if self.room < 0:
                self.fail(where, f"the buffers have more than the limit of {FILE_MAX:,} bytes; simplify the model")
            self.buffers[number] = memoryview(blob)[:wanted]    # whose slices are no copies
        return self.buffers[number]

    def view(self, table, where):
        """(bytes, stride or 0) of a buffer view."""
        _, view = self.entry("bufferViews", table, "bufferView", where)
        number, _ = self.entry("buffers", view, "buffer", where)
        blob = self.buffer(number)
        start, length = self.whole(view, "byteOffset", where, 0), self.whole(view, "byteLength", where)
        if start + length > len(blob):
            self.fail(where, f"its buffer view reaches {start + length - len(blob):,} bytes past the buffer")
        return blob[start:start + length], self.whole(view, "byteStride", where, 0, 252)

    def _layout(self, table, kinds, components, where):
        """(type of a number, how many a value has, how many values) of an accessor."""
        kind, component = table.get("type"), table.get("componentType")
        if kind not in kinds or component not in components:
            self.fail(where, f"values of type {quoted(kind)} and component {quoted(component)} are not read here")
        return np.dtype(_COMPONENTS[component]), _WIDTHS[kind], self.whole(table, "count", where)

    def _array(self, table, numbers_of, width, count, where):
        """Values in a buffer view, a row each; without a view zeros."""
        if "bufferView" not in table:
            if count > SPARSE_MAX:
                self.fail(where, f"{count:,} values without bytes are more than the limit of {SPARSE_MAX:,}")
            return np.zeros((count, width), numbers_of)
        blob, stride = self.view(table, where)
        size = numbers_of.itemsize * width
        start, stride = self.whole(table, "byteOffset", where, 0), stride or size
        if stride < size or (count and start + (count - 1) * stride + size > len(blob)):
            self.fail(where, f"{count:,} values do not fit its {len(blob):,} bytes: the file is damaged")
        return np.ndarray((count, width), numbers_of, blob, start, (stride, numbers_of.itemsize)) if count else \
            np.zeros((0, width), numbers_of)

    def _replaced(self, values, sparse, where):
        """Values of which a sparse accessor replaces some."""
        places = sparse.get("indices") if isinstance(sparse, dict) else None
        if not isinstance(places, dict) or not isinstance(sparse.get("values"), dict):
            self.fail(where, "sparse has no indices or no values: the file is damaged")
        count, component = self.whole(sparse, "count", where), places.get("componentType")
        if component not in UNSIGNED or "bufferView" not in places or "bufferView" not in sparse["values"]:
            self.fail(where, "sparse has indices that are not read: the file is damaged")
        rows = self._array(places, np.dtype(_COMPONENTS[component]), 1, count, where)[:, 0].astype(np.int64)
        if count and rows.max() >= len(values):
            self.fail(where, f"sparse replaces value {rows.max():,} of {len(values):,}: the file is damaged")
        changed = values.copy()
        changed[rows] = self._array(sparse["values"], values.dtype, values.shape[1], count, where)
        return changed

    def _entry_of(self, number, where):
        """An entry of accessors."""
        rows = self.rows("accessors")
        if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < len(rows):
            self.fail(where, f"accessor {quoted(number)} does not exist; there are {len(rows)}")
        return rows[number]

    def count(self, number, where):
        """How many values an accessor has."""
        return self.whole(self._entry_of(number, where), "count", where)

    def accessor(self, number, where, kinds, components, is_part=False):
        """The values of an accessor as a numpy array, a row each; normalised ones as doubles. is_part: whole numbers are normalised, whether
        the file says so or not."""
        table, where = self._entry_of(number, where), f"{where}: accessor {number}"
        numbers_of, width, count = self._layout(table, kinds, components, where)
        values = self._array(table, numbers_of, width, count, where)
        if "sparse" in table:
            values = self._replaced(values, table["sparse"], where)
        if (is_part or table.get("normalized") is True) and numbers_of.kind != "f":
            return np.maximum(values / float(np.iinfo(numbers_of).max), -1.0)
        return values.astype(float) if numbers_of.kind == "f" else values.astype(np.int64)


def _glb(blob, name):
    """(JSON's bytes, the binary part or None) of a GLB file."""
    magic, version, length = _GLB_HEAD.unpack_from(blob)
    if version != 2:
        raise ToolError(f"{name}: a GLB file of version {version}; only 2 is read: {_CONVERTS}")
    if length > len(blob):
        raise ToolError(f"{name}: the header promises {length:,} bytes and {len(blob):,} are there: the file is damaged")
    place, parts = _GLB_HEAD.size, {}
    while place + _CHUNK_HEAD.size <= length:
        size, kind = _CHUNK_HEAD.unpack_from(blob, place)
        place += _CHUNK_HEAD.size
        if place + size > length:
            raise ToolError(f"{name}: a part promises {size:,} bytes and {length - place:,} are there: the file is damaged")
        parts.setdefault(kind, blob[place:place + size])
        place += size
    if _JSON not in parts:
        raise ToolError(f"{name}: the file has no part with JSON: it is damaged")
    return parts[_JSON], parts.get(_BIN)


def _encodable(pairs):
    """An object of JSON without the members that are null, as if they were not there. Its texts are characters: half of a pair of UTF-16,
    which JSON may name alone, is none."""
    return {key: value.encode("utf-16", "surrogatepass").decode("utf-16", "replace") if isinstance(value, str) and not value.isascii() else value
            for key, value in pairs if value is not None}


def _parse(text, name):
    def refuse(word):
        raise ToolError(f"{name}: its JSON has the value {word}, which is not a number of JSON: save the model again")
    try:
        text, encoding = model_text.without_mark(bytes(text))
        # Some programs fill the part up with zeros instead of spaces.
        data = json.loads(text.decode(encoding).rstrip("\0"), parse_constant=refuse, object_pairs_hook=_encodable)
    except RecursionError:
        raise ToolError(f"{name}: its JSON is nested deeper than any model's") from None
    except json.JSONDecodeError as error:
        raise ToolError(f"{name}:{error.lineno}: not JSON: {reading.shortened(error.msg)}") from None
    except ValueError:
        raise ToolError(f"{name}: its JSON is not UTF-8 text, or has a number of thousands of digits") from None
    if not isinstance(data, dict):
        raise ToolError(f"{name}: this is not a glTF file: its JSON is no object")
    return data


def open_file(path, name, sources):
    """A Checked of a .gltf or .glb, of which nothing but the frame is checked."""
    blob = sources.read(path, FILE_MAX, "simplify the model")
    if not blob:
        raise ToolError(f"{name}: the file is empty")
    text, binary = _glb(blob, name) if blob[:4] == b"glTF" and len(blob) >= _GLB_HEAD.size else (blob, None)
    data = _parse(text, name)
    asset = data.get("asset")
    version = asset.get("version") if isinstance(asset, dict) else None
    if not isinstance(version, str) or not version.startswith("2."):
        which = "that names no version" if version is None else f"of version {quoted(version)}"
        raise ToolError(f"{name}: asset: a glTF file {which}; only 2.0 is read: {_CONVERTS}")
    refuse_required(name, data.get("extensionsRequired", []))
    return Checked(name, data, os.path.dirname(path), binary, sources)


def numbers(checked, table, key, count, where):
    """A list of finite numbers."""
    value = table[key]
    if not isinstance(value, list) or len(value) != count or \
            not all(isinstance(each, (int, float)) and not isinstance(each, bool) and
                    abs(each) <= 1e12 for each in value):
        checked.fail(where, f"{key} must be {count} numbers within 1e12: the file is damaged")
    return [float(each) for each in value]


def walk(checked):
    """[(number, parent or None)] of the nodes of the scene, parents first. A node that is reached twice is refused."""
    nodes, scenes = checked.rows("nodes"), checked.rows("scenes")
    if len(nodes) > NODES_MAX:
        checked.fail("nodes", f"{len(nodes):,} are more than the limit of {NODES_MAX:,}; join them")
    if scenes:
        chosen = checked.whole(checked.data, "scene", "scene", 0)
        if chosen >= len(scenes):
            checked.fail("scene", f"{chosen} does not exist; there are {len(scenes)}")
        if len(scenes) > 1:
            checked.notes.append(f"{checked.name}: {checked.label('scene', chosen)} is shown: left out {len(scenes) - 1:,} other scenes")
        roots = scenes[chosen].get("nodes", [])
    else:
        roots = list(range(len(nodes)))
        roots = sorted(set(roots) - {each for node in nodes for each in _children(checked, node, "nodes")})
    found, seen = [], set()
    pending = [(number, None, 1) for number in reversed(_children(checked, {"children": roots}, "scene"))]
    while pending:
        number, parent, depth = pending.pop()
        if number >= len(nodes):
            checked.fail("nodes" if parent is None else checked.label("node", parent),
                         f"node {number} does not exist; there are {len(nodes)}")
        if number in seen:
            checked.fail(checked.label("node", number), "it stands below itself or below two nodes, a cycle or a knot; "
                         "give each node one parent")
        if depth > DEPTH_MAX:
            checked.fail(checked.label("node", number), f"it stands more than {DEPTH_MAX:,} nodes deep; flatten the model")
        seen.add(number)
        found.append((number, parent))
        pending += [(child, number, depth + 1) for child in
                    reversed(_children(checked, nodes[number], checked.label("node", number)))]
    return found


def _children(checked, node, where):
    children = node.get("children", [])
    if not isinstance(children, list) or not all(isinstance(each, int) and not isinstance(each, bool) and each >= 0
                                                 for each in children):
        checked.fail(where, "children must be a list of numbers of nodes: the file is damaged")
    return children
