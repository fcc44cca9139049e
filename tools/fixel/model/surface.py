# SPDX-License-Identifier: MIT
"""What a face of a model file looks like: a colour, an image over it, how much shows through."""

from dataclasses import dataclass, field


@dataclass
class Material:
    """colour: red, green, blue, 0..255, which an image is multiplied by. opacity: 0..1."""
    name: str
    colour: tuple = (200, 192, 176)
    opacity: float = 1.0
    image: object = None        # a texture_image.Texture, or None


@dataclass
class Surfaces:
    """The materials of a model, and those of its faces. of_face: a material's number for each face. uvs: for each
    face (u, v) of each corner, u to the right and v downward, 1 across the image; None where there are none."""
    materials: list = field(default_factory=list)
    of_face: list = field(default_factory=list)
    uvs: list = field(default_factory=list)
    _colours: list = field(default_factory=list)

    def add(self, material, uvs=None):
        """One more face."""
        self.of_face.append(material)
        self.uvs.append(uvs)

    def part(self, faces):
        """The surfaces of some faces."""
        return Surfaces(self.materials, [self.of_face[face] for face in faces], [self.uvs[face] for face in faces])

    def colours(self):
        """The colour of each face, red, green and blue: with an image the mean of what lies on it. Computed once."""
        if len(self._colours) != len(self.of_face):
            self._colours = [self.materials[number].colour for number in self.of_face]
            for image, faces in self._with_images().items():
                means = image.means([self.uvs[face] for face in faces])
                for face, mean in zip(faces, means):
                    self._colours[face] = tuple(round(a * b / 255) for a, b in zip(mean, self._colours[face]))
        return self._colours

    def _with_images(self):
        """{image: faces that it lies on}."""
        found = {}
        for face, number in enumerate(self.of_face):
            image = self.materials[number].image
            if image is not None and self.uvs[face] is not None:
                found.setdefault(image, []).append(face)
        return found

    def kind_of(self, face):
        """What two faces have in common that may become one."""
        return self.of_face[face], self.colours()[face]
