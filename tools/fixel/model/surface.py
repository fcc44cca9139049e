# SPDX-License-Identifier: MIT
"""What a face of a model file looks like: a colour, an image over it, how much shows through."""

from dataclasses import dataclass, field, replace


WHITE = (255, 255, 255)
GREY = (200, 192, 176)      # of a material that names no colour


@dataclass
class Material:
    """colour: red, green, blue, 0..255, which an image is multiplied by. opacity: 0..1. moves: None, or what becomes of
    a face's coordinates on the image: a function of (u, v). clamp: beyond its edges the image shows them; else it
    repeats. is_unlit: light does not change the colour. is_two_sided: its faces have backs. is_clear: one may see through
    its faces."""
    name: str
    colour: tuple = GREY
    opacity: float = 1.0
    image: object = None        # a texture_image.Texture, or None
    moves: object = None
    clamp: bool = False
    is_unlit: bool = False
    is_two_sided: bool = False
    is_clear: bool = False


def mean_tint(colours):
    """The mean of the colours of a face's vertices, red, green, blue of 0..255."""
    return tuple((2 * sum(parts) + len(colours)) // (2 * len(colours)) for parts in zip(*colours))


MISSING_NOTE = "its materials are left out"
MEAN_NOTE = "the vertices have colours: each face has the mean of its corners' colours"
TINT_NOTE = "vertices of faces with an image have colours: the mean of a face's corners multiplies its image"
APART_MIN = 4       # of 255: corners whose colours differ by no more have one colour


def are_apart(corners):
    """Whether the colours of a face's corners differ by more than APART_MIN in a channel."""
    return any(max(parts) - min(parts) > APART_MIN for parts in zip(*corners))


def product(one, other):
    """A colour times another one."""
    return tuple(round(a * b / 255) for a, b in zip(one, other))


@dataclass
class Surfaces:
    """The materials of a model, and those of its faces. of_face: a material's number for each face. uvs: for each
    face (u, v) of each corner, u to the right and v downward, 1 across the image; None where there are none. tints: for
    each face what its material's colour is multiplied by: the mean colour of its vertices; None where they have none.
    corners: for each face the colours of its vertices, where they are apart, else None; [] where no face has such.
    has_materials: whether the file names materials or images; else the faces have no colours but their tints."""
    materials: list = field(default_factory=list)
    of_face: list = field(default_factory=list)
    uvs: list = field(default_factory=list)
    tints: list = field(default_factory=list)
    whole: object = None        # (Surfaces, numbers of faces) that these are a part of, and share images with
    corners: list = field(default_factory=list)
    has_materials: bool = True
    _colours: list = field(default_factory=list)

    def add(self, material, uvs=None, tint=None):
        """One more face."""
        self.of_face.append(material)
        self.uvs.append(uvs)
        self.tints.append(tint)

    def part(self, faces, shares):
        """The surfaces of some faces. shares: whether their images are those of all faces."""
        return Surfaces(self.materials, [self.of_face[face] for face in faces], [self.uvs[face] for face in faces],
                        [self.tints[face] for face in faces], (self, faces) if shares else None,
                        [self.corners[face] for face in faces] if self.corners else [], self.has_materials)

    def has_tints(self):
        """Whether faces or vertices have colours of their own."""
        return not self.has_materials or bool(self.corners) or any(self.tints)

    def without_tints(self):
        """The same without the colours of faces and vertices; None where the file has no others."""
        return replace(self, tints=[None] * len(self.of_face), corners=[], _colours=[]) if self.has_materials else None

    def give_corners(self, colours):
        """Gives the faces the colours of their vertices. colours: those of each face in turn, or None."""
        found = [each if each and None not in each and are_apart(each) else None for each in colours]
        self.corners = found if any(found) else []

    def colours_at(self, face):
        """The colours at a face's corners, without an image; None where it has one colour."""
        own = self.corners[face] if self.corners else None
        return own and [product(self.materials[self.of_face[face]].colour, each) for each in own]

    def have_corners(self):
        """Whether a face that shows no image has colours at its corners."""
        return any(own and (self.uvs[face] is None or self.materials[self.of_face[face]].image is None)
                   for face, own in enumerate(self.corners))

    def have_tinted_images(self):
        """Whether a face that shows an image has colours at its corners."""
        return any(own and self.uvs[face] is not None and self.materials[self.of_face[face]].image is not None
                   for face, own in enumerate(self.corners))

    def own_colour(self, face):
        """The colour of a face without its image."""
        colour, tint = self.materials[self.of_face[face]].colour, self.tints[face]
        return colour if tint is None else product(colour, tint)

    def colours(self):
        """The colour of each face, red, green and blue: with an image the mean of what lies on it. Computed once."""
        if len(self._colours) != len(self.of_face):
            self._colours = list(map(self.own_colour, range(len(self.of_face))))
            for (image, clamp), faces in self._with_images().items():
                means = image.means([self.uvs[face] for face in faces], clamp)
                for face, mean in zip(faces, means):
                    self._colours[face] = product(mean, self._colours[face])
        return self._colours

    def _with_images(self):
        """{(image, whether it clamps): faces that it lies on}."""
        found = {}
        for face, number in enumerate(self.of_face):
            image = self.materials[number].image
            if image is not None and self.uvs[face] is not None:
                found.setdefault((image, self.materials[number].clamp), []).append(face)
        return found

    def are_unlit(self):
        """Whether light changes the colour of no face."""
        return all(self.materials[number].is_unlit for number in set(self.of_face))

    def with_backs(self, is_open):
        """The numbers of faces whose backs may be seen. is_open: whether the model is."""
        wanted = {number for number, each in enumerate(self.materials) if each.is_two_sided and (is_open or each.is_clear)}
        return {face for face, number in enumerate(self.of_face) if number in wanted}

    def kind_of(self, face):
        """What two faces have in common that may become one."""
        return self.of_face[face], self.colours()[face]
