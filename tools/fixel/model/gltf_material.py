# SPDX-License-Identifier: MIT
"""Materials of glTF: base colour, image with its transform and its wrapping, alpha modes, unlit and emissive ones; and sums of light, of
base colours and emissive ones.

An emissive material whose base is black, and an unlit one, has its colour whatever the light. Of other emissive
materials colour and image are added to the base. What is not read is counted, and told once."""

import dataclasses
import math

import numpy as np

from fixel.model import gltf_check, model_text
from fixel.model.surface import Material, WHITE

_STEPS = 4096           # of light between none and all
_ROWS = 64              # of an image at a time


def srgb(linear):
    """A part 0..1 of light as 0..255 of a screen."""
    linear = min(max(linear, 0.0), 1.0)
    return round(255 * (12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055))


def _linear(screen):
    """The inverse of srgb."""
    part = screen / 255
    return part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4


_LIGHT = np.array([_linear(screen) for screen in range(256)], dtype=np.float32)
_SCREEN = np.array([srgb(step / (_STEPS - 1)) for step in range(_STEPS)], dtype=np.uint8)


def _light(pixels, factor):
    """The light of rows of pixels, times a factor; pixels None: white."""
    return np.asarray(factor, dtype=np.float32) * (1 if pixels is None else _LIGHT[pixels[..., :3]])


def added(base, factor, other, glow):
    """The image base times factor, and the image other times glow added. Either image may be None, which is white; not both. The alpha is
    that of base. An image that is black adds nothing."""
    if other is not None and base is not None and not other.pixels[..., :3].any():
        other, glow = None, (0.0, 0.0, 0.0)

    def make():
        size = [max(getattr(image, side) for image in (base, other) if image is not None) for side in ("width", "height")]
        one, two = (image and image.scaled(*size) for image in (base, other))
        made = np.full((size[1], size[0], 4), 255, dtype=np.uint8)
        for row in range(0, size[1], _ROWS):
            rows = slice(row, row + _ROWS)
            light = sum(_light(None if image is None else image[rows], part) for image, part in ((one, factor), (two, glow)))
            made[rows, :, :3] = _SCREEN[(np.clip(light, 0, 1) * (_STEPS - 1)).round().astype(int)]
        if one is not None:
            made[..., 3] = one[..., 3]
        return made
    first = base if base is not None else other
    return first.once(("added", tuple(factor), other and id(other), tuple(glow)), make)


_TRANSFORM, _UNLIT = "KHR_texture_transform", "KHR_materials_unlit"
_STRENGTH, _GLOSS = "KHR_materials_emissive_strength", "KHR_materials_pbrSpecularGlossiness"
_GLASS, _GLASS_MAP = "KHR_materials_transmission", "transmissionTexture"
GLASS_MOST = 0.75       # of light: of what a material lets through, so much is; the rest is what shows of the glass itself
_WEBP = "EXT_texture_webp"
_REPEAT, _CLAMP, _MIRROR = 10497, 33071, 33648
_TILED_MAX = 8192       # pixels along a side of an image that is stored several times
_ROUNDING = 1e-5        # of an image: so far beyond it a coordinate is on its edge
_LEFT_OUT = {"normalTexture": "normal maps", "occlusionTexture": "occlusion maps"}
_METAL = "metallicRoughnessTexture"


def _name(entry, number):
    """A material's name, or its number."""
    name = entry.get("name")
    return name if isinstance(name, str) else str(number)


@dataclasses.dataclass
class Read:
    """A material, the number of its texture coordinates, a matrix of 2x3 that they go through or None, and how the image
    goes on beyond its left and right, its upper and lower edge."""
    material: Material
    coordinates: int = 0
    matrix: object = None
    wraps: tuple = (_REPEAT, _REPEAT)


class Materials:
    """The materials of a file, each read when a part asks for it."""

    def __init__(self, checked):
        self.checked, self.found, self.images, self.variants = checked, {}, {}, {}
        self.left_out = model_text.LeftOut()

    # --- parts of a material -----------------------------------------------------

    def _table(self, table, key, where):
        """An object in an object, an empty one without it."""
        value = table.get(key, {})
        if not isinstance(value, dict):
            self.checked.fail(where, f"{key} is no object: the file is damaged")
        return value

    def _numbers(self, table, key, default, where):
        return gltf_check.numbers(self.checked, table, key, len(default), where) if key in table else list(default)

    def _extension(self, table, name, where):
        """An extension of an object, None without it."""
        extensions = self._table(table, "extensions", where)
        return self._table(extensions, name, where) if name in extensions else None

    def _image(self, texture, where):
        """The image of an entry of textures."""
        source = texture
        if "source" not in texture:
            source, others = self._extension(texture, _WEBP, where), self._table(texture, "extensions", where)
            known = next(filter(others.__contains__, gltf_check.IMAGES), None)
            if source is None and known:
                return self.checked.sources.image(lambda: self.checked.fail(where, gltf_check.image_text(known)), self.checked.notes)
            if source is None:
                self.left_out.add("images of formats that are not read" + (f" ({', '.join(sorted(others))[:60]})" if others else ""), where)
                return None
        number, _ = self.checked.entry("images", source, "source", where)
        if number not in self.images:
            self.images[number] = self.checked.image(number)
        return self.images[number]

    def _wraps(self, texture, where):
        if "sampler" not in texture:
            return _REPEAT, _REPEAT
        _, sampler = self.checked.entry("samplers", texture, "sampler", where)
        found = tuple(self.checked.whole(sampler, key, where, _REPEAT) for key in ("wrapS", "wrapT"))
        for each in found:
            if each not in (_REPEAT, _CLAMP, _MIRROR):
                self.checked.fail(where, f"its sampler wraps by {each}, which glTF has not: the file is damaged")
        return found

    def _matrix(self, info, where):
        """(matrix or None, number of the coordinates or None) of a texture's transform."""
        transform = self._extension(info, _TRANSFORM, where)
        if transform is None:
            return None, None
        (right, down), (wide, high) = (self._numbers(transform, key, default, where) for key, default in
                                       (("offset", (0, 0)), ("scale", (1, 1))))
        turn, = gltf_check.numbers(self.checked, {"rotation": [transform.get("rotation", 0)]}, "rotation", 1, where)
        sine, cosine = math.sin(turn), math.cos(turn)
        matrix = np.array([[cosine * wide, sine * high, right], [-sine * wide, cosine * high, down]])
        coordinates = self.checked.whole(transform, "texCoord", where, 0, 7) if "texCoord" in transform else None
        return (None if (matrix == np.eye(2, 3)).all() else matrix), coordinates

    def _texture(self, info, where):
        """(image, number of the coordinates, matrix, wraps) of a texture that a material names."""
        _, texture = self.checked.entry("textures", info, "index", where)
        matrix, coordinates = self._matrix(info, where)
        if coordinates is None:
            coordinates = self.checked.whole(info, "texCoord", where, 0, 7)
        return self._image(texture, where), coordinates, matrix, self._wraps(texture, where)

    def _base(self, entry, where):
        """(factor of red, green, blue and alpha, the texture's table or None)."""
        gloss = self._extension(entry, _GLOSS, where)
        base = self._table(entry, "pbrMetallicRoughness", where)
        if gloss is not None and "baseColorTexture" not in base:
            return self._numbers(gloss, "diffuseFactor", (1, 1, 1, 1), where), \
                self._table(gloss, "diffuseTexture", where) if "diffuseTexture" in gloss else None
        return self._numbers(base, "baseColorFactor", (1, 1, 1, 1), where), \
            self._table(base, "baseColorTexture", where) if "baseColorTexture" in base else None

    def _emissive(self, entry, where):
        """(red, green, blue of light, the texture's table or None)."""
        factor = self._numbers(entry, "emissiveFactor", (0, 0, 0), where)
        more = self._extension(entry, _STRENGTH, where) or {}
        strength, = gltf_check.numbers(self.checked, {"emissiveStrength": [more.get("emissiveStrength", 1)]}, "emissiveStrength", 1,
                                       where)
        return [part * strength for part in factor], \
            self._table(entry, "emissiveTexture", where) if "emissiveTexture" in entry and any(factor) else None

    def _with_glow(self, factor, texture, glow, other, where):
        """(factor, the texture) of a material whose emissive colours are added to its own. texture, other: the textures of its own
        colours and of the emissive ones, as _texture answers them, or None."""
        if texture is None and other is None:
            return [min(1, a + b) for a, b in zip(factor, glow)] + [factor[3]], None
        shines = other and other[0]
        if other and shines is None:        # its image is not there, or is not read
            return factor, texture
        if texture and other and not self._lie_alike(texture, other):
            self.left_out.add("emissive images that do not lie as the others do", where)
            return factor, texture
        image = texture and texture[0]
        if image is None and shines is None:
            return [min(1, a + b) for a, b in zip(factor, glow)] + [factor[3]], None
        return [1, 1, 1, factor[3]], (added(image, factor[:3], shines, glow), *(texture or other)[1:])

    def _let_through(self, entry, where):
        """What part of the light a material lets through, 0..GLASS_MOST."""
        glass = self._extension(entry, _GLASS, where) or {}
        if _GLASS_MAP in glass:
            self.left_out.add("maps of transmission", where)
        factor, = gltf_check.numbers(self.checked, {"transmissionFactor": [glass.get("transmissionFactor", 0)]}, "transmissionFactor", 1, where)
        return GLASS_MOST * min(max(factor, 0.0), 1.0)

    @staticmethod
    def _lie_alike(one, other):
        """Whether two textures have the same coordinates, matrix and wraps."""
        first, second = (np.eye(2, 3) if each[2] is None else each[2] for each in (one, other))
        return one[1] == other[1] and one[3] == other[3] and np.array_equal(first, second)

    @staticmethod
    def _with_alpha(image, mode, factor, cutoff):
        """An image as an alpha mode shows it."""
        if image is None or mode == "BLEND":
            return image
        return image.with_alpha(None if mode == "OPAQUE" else math.inf if factor <= 0 else cutoff / factor)

    def _read(self, entry, number, where):
        """The Read of an entry of materials."""
        factor, texture = self._base(entry, where)
        glow, glow_texture = self._emissive(entry, where)
        for key, what in _LEFT_OUT.items():
            if key in entry:
                self.left_out.add(what, where)
        if _METAL in self._table(entry, "pbrMetallicRoughness", where):
            self.left_out.add("metallic and roughness maps", where)
        mode = entry.get("alphaMode", "OPAQUE")
        if mode not in ("OPAQUE", "MASK", "BLEND"):
            self.checked.fail(where, f"alphaMode {gltf_check.quoted(mode)} is none of OPAQUE, MASK and BLEND: the file is damaged")
        keeps_colour = self._extension(entry, _UNLIT, where) is not None
        if any(glow) and not keeps_colour and not any(factor[:3]):
            factor, texture, glow, keeps_colour = [*glow, factor[3]], glow_texture, (0, 0, 0), True
        found = self._texture(texture, where) if texture is not None else None
        if any(glow) and not keeps_colour:
            other = None if glow_texture is None else self._texture(glow_texture, where)
            factor, found = self._with_glow(factor, found, glow, other, where)
        image, *rest = found or (None,)
        cutoff, = gltf_check.numbers(self.checked, {"alphaCutoff": [entry.get("alphaCutoff", 0.5)]}, "alphaCutoff", 1, where)
        opacity = {"OPAQUE": 1.0, "BLEND": min(max(factor[3], 0.0), 1.0), "MASK": 0.0 if image is None and factor[3] < cutoff else 1.0}[mode]
        if mode == "BLEND" and image is not None and image.is_translucent():
            alpha = image.one_alpha()
            if alpha is None:
                self.left_out.add("an image's alpha between clear and opaque: from a half on it is opaque", where)
            else:
                image, opacity = image.with_alpha(alpha / 510), opacity * alpha / 255
        through = self._let_through(entry, where)
        material = Material(_name(entry, number), tuple(map(srgb, factor[:3])), opacity * (1 - through), self._with_alpha(image, mode, factor[3], cutoff),
                            is_unlit=keeps_colour, is_two_sided=entry.get("doubleSided") is True, is_clear=mode != "OPAQUE" or through > 0)
        return Read(material, *rest)

    # --- what parts ask for ------------------------------------------------------

    def get(self, part, where):
        """The Read of a part's material."""
        if "material" not in part:
            return self.found.setdefault(None, Read(Material("none", WHITE)))
        number, entry = self.checked.entry("materials", part, "material", where)
        if number not in self.found:
            self.found[number] = self._read(entry, number, self.checked.label("material", number))
        return self.found[number]

    def _variant(self, material, **changes):
        """A material with changes, the same object for the same ones."""
        key = id(material), *changes.items()
        if key not in self.variants:
            self.variants[key] = dataclasses.replace(material, **changes)
        return self.variants[key]

    def wrapped(self, read, uvs, where):
        """(material, coordinates) of a part: transformed, and as its image goes on beyond its edges. uvs: those that faces
        use."""
        if read.matrix is not None:
            uvs = uvs @ read.matrix[:, :2].T + read.matrix[:, 2]
        low, high = uvs.min(axis=0), uvs.max(axis=0)
        beyond = [wrap if low[axis] < -_ROUNDING or high[axis] > 1 + _ROUNDING else _REPEAT for axis, wrap in enumerate(read.wraps)]
        if beyond.count(_CLAMP) == 1:
            return self._clamped_along(read, uvs, 1 - beyond.index(_CLAMP), where)
        material = read.material
        mirrored = [wrap == _MIRROR for wrap in beyond]
        if any(mirrored):
            material = self._variant(material, image=material.image.mirrored(*mirrored))
            uvs = uvs / [2 if each else 1 for each in mirrored]
        if beyond.count(_CLAMP) == 2:
            return self._variant(material, clamp=True), uvs
        return material, uvs

    def _clamped_along(self, read, uvs, axis, where):
        """(material, coordinates) of a part whose image goes on beyond its edges along an axis, and along the other one is clamped: the
        image is stored as often as faces show it along the axis."""
        first, end = math.floor(uvs[:, axis].min() + _ROUNDING), math.ceil(uvs[:, axis].max() - _ROUNDING)
        count, material = max(end - first, 1), read.material
        if count * (material.image.width, material.image.height)[axis] > _TILED_MAX:
            self.left_out.add("clamping of an image along one side alone", where)
            return material, uvs
        image = material.image.tiled(axis, first, count, read.wraps[axis] == _MIRROR)
        places = uvs.copy()
        places[:, axis] = (uvs[:, axis] - first) / count
        return self._variant(material, image=image, clamp=True), places
