# SPDX-License-Identifier: MIT
"""The models of the showcase, each of a kind that people have. All are made here, from one seed."""

from dataclasses import dataclass

import numpy as np

from fixel.report import showcase_shapes as files
from fixel.report.showcase_shapes import Gltf, image_bytes
from fixel.report.showcase_shapes import ball, box, cloth, clouds, flat, joined, lathe, mixed, noise, placed, planks, surface, tube, wheel

SEED = 2026
SCAN_FACES = 200_000
SCAN_IMAGE = 4096           # pixels of a side
SWATCHES = 16               # of the palette atlas
BUILDINGS = 40              # and materials of the gradient atlas


@dataclass(frozen=True)
class Model:
    """file: its name. what: what kind of model it is. make: writes it into a folder: make(folder, random generator). look: the
    options of its first command."""
    file: str
    what: str
    make: object
    look: str = ""

    @property
    def name(self):
        """The file's name without its ending."""
        return self.file.partition(".")[0]


# --- OBJ -------------------------------------------------------------------------------------

def _crate(folder, chance):
    (folder / "crate.png").write_bytes(image_bytes(planks(chance)))
    files.obj(folder, "crate", [("usemtl wood", box())], "newmtl wood\nKd 1 1 1\nmap_Kd crate.png\n")


def _vase(folder, _):
    profile = [(0.34, 1.0), (0.38, 0.97), (0.30, 0.93), (0.20, 0.84), (0.19, 0.76), (0.30, 0.62), (0.42, 0.45), (0.44, 0.30),
               (0.36, 0.14), (0.24, 0.05), (0.26, 0.0), (0, 0.0)]
    inside = [(0, 0.06), (0.20, 0.08), (0.40, 0.30), (0.38, 0.45), (0.26, 0.62), (0.15, 0.76), (0.16, 0.84), (0.27, 0.94), (0.34, 1.0)]
    files.obj(folder, "vase", [("", lathe([*inside, *profile[1:]], 40))])


def _colours_of_vertices(folder, _):
    points, triangles, _ = ball(1, 14, 8)
    colours = np.clip(points * 0.5 + 0.5, 0, 1)
    lines = [f"v {x:.5f} {y:.5f} {z:.5f} {r:.3f} {g:.3f} {b:.3f}" for (x, y, z), (r, g, b) in zip(points, colours)]
    lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    (folder / "rainbow.obj").write_text("\n".join(lines) + "\n")


def _photo(folder, chance):
    from PIL import Image
    side, sky = 256, clouds(chance, 256)
    picture = mixed((90, 140, 220), (240, 240, 250), sky)
    rows = np.arange(side)
    hills = (0.62 + 0.2 * noise(chance, side, 4)[0]) * side
    picture[rows[:, None] > hills] = (60, 110, 50)
    picture[(rows[:, None] - 50) ** 2 + (rows - 190) ** 2 < 600] = (255, 220, 90)
    stored = np.ascontiguousarray(picture.swapaxes(0, 1)[::-1])     # as a camera that was held upright stores it
    exif = Image.Exif()
    exif[0x0112] = 6
    (folder / "photo.jpg").write_bytes(image_bytes(stored, "JPEG", quality=90, exif=exif))
    frame = [placed(box(*size), place) for size, place in (((2.4, 0.2, 0.2), (0, -0.2, 0)), ((2.4, 0.2, 0.2), (0, 2.0, 0)),
                                                            ((0.2, 2.0, 0.2), (-1.1, 0, 0)), ((0.2, 2.0, 0.2), (1.1, 0, 0)))]
    picture_shape = (np.array([(-1, 0, 0), (1, 0, 0), (1, 2, 0), (-1, 2, 0)], dtype=float), np.array([(0, 1, 2), (0, 2, 3)]),
                     np.array([(0, 1), (1, 1), (1, 0), (0, 0)], dtype=float))
    files.obj(folder, "photo", [("usemtl frame", joined(*frame)), ("usemtl photo", picture_shape)],
              "newmtl frame\nKd 0.45 0.28 0.12\nnewmtl photo\nKd 1 1 1\nmap_Kd photo.jpg\n")


def _greys(folder, chance):
    heights = clouds(chance, 64, 3, 3)
    greys = (heights / heights.max() * 65535).astype(np.uint16)
    (folder / "relief.png").write_bytes(image_bytes(greys))
    sample = np.pad(heights, ((0, 1), (0, 1)), mode="wrap")

    def function(u, v):
        return u * 3 - 1.5, sample[np.rint(v * 32).astype(int) * 2, np.rint(u * 32).astype(int) * 2] * 1.2, v * 3 - 1.5
    files.obj(folder, "relief", [("usemtl ground", surface(function, 32, 32))], "newmtl ground\nKd 0.9 1 0.8\nmap_Kd relief.png\n")


def _from_windows(folder, chance):
    (folder / "Brick.PNG").write_bytes(image_bytes(mixed((150, 70, 50), (190, 110, 80), clouds(chance, 64, 8, 2))))
    walls, roof = box(2, 1.2, 1.4), (np.array([(-1.1, 1.2, 0.8), (1.1, 1.2, 0.8), (1.1, 2, 0), (-1.1, 2, 0), (1.1, 1.2, -0.8), (-1.1, 1.2, -0.8)]),
                                     np.array([(0, 1, 2), (0, 2, 3), (4, 5, 3), (4, 3, 2), (1, 4, 2), (5, 0, 3), (0, 5, 4), (0, 4, 1)]),
                                     np.zeros((6, 2)))
    door = placed(box(0.4, 0.7, 0.06), (0, 0, 0.7))
    materials = ("newmtl wall\r\nKd 1 1 1\r\nTr 0\r\nmap_Kd \"C:\\Users\\me\\Textures\\brick.png\"\r\nnewmtl roof\r\nKd 0.5 0.15 0.1\r\n"
                 "Tr 0\r\nnewmtl door\r\nKd 0.2 0.35 0.2\r\nTr 0\r\n")
    files.obj(folder, "house", [("o walls\nusemtl wall", walls), ("o roof\nusemtl roof", roof), ("o door\nusemtl door", door)], materials,
              "\ufeff# written on another computer\n")


def _scan(folder, chance):
    bumps = [(chance.normal(size=3), chance.uniform(2, 7), chance.uniform(0, 6.3)) for _ in range(24)]

    def function(u, v):
        a, b = np.pi * v, 2 * np.pi * np.where(u == 1, 0, u)
        x, y, z = np.sin(a) * np.sin(b), np.cos(a), np.sin(a) * np.cos(b)
        r = 1 + 0.1 * np.exp(-((y - 0.9) ** 2) * 9) - 0.15 * np.exp(-((y + 0.45) ** 2) * 12)
        for way, often, shift in bumps:
            r = r + 0.012 * np.sin(often * (x * way[0] + y * way[1] + z * way[2]) + shift)
        r = r + 0.22 * np.exp(-((x) ** 2 + (y - 0.05) ** 2) * 30) * (z > 0)    # a nose
        return r * x * 0.85, r * y * 1.15, r * z * 0.9
    side = SCAN_IMAGE
    small = 512
    base = mixed((120, 92, 70), (222, 190, 150), clouds(chance, small, 4, 5))
    image = np.kron(base, np.ones((side // small, side // small, 1), dtype=np.uint8))
    y, x = np.mgrid[:side, :side] / side
    for centre in (0.08, 0.92):
        image[(x - centre) ** 2 * 4 + (y - 0.38) ** 2 * 3 < 0.0016] = (245, 240, 230)
        image[(x - centre) ** 2 * 4 + (y - 0.38) ** 2 * 3 < 0.0005] = (40, 60, 90)
    image[y < 0.22 + 0.02 * np.sin(40 * np.pi * x)] = (70, 45, 30)
    (folder / "scan.jpg").write_bytes(image_bytes(image, "JPEG", quality=80))
    files.obj(folder, "scan", [("usemtl skin", surface(function, 400, SCAN_FACES // 800 + 1))], "newmtl skin\nKd 1 1 1\nmap_Kd scan.jpg\n")


# --- STL and PLY -----------------------------------------------------------------------------

def _bracket(folder, _):
    """A plate of 120 x 80 mm with a round hole and an upright."""
    count, outer = 48, []
    angles = 2 * np.pi * np.arange(count) / count
    hole = np.stack([18 * np.cos(angles) - 20, 18 * np.sin(angles)], axis=1)
    for angle in angles:    # the rectangle's edge in the same direction
        way = np.array([np.cos(angle), np.sin(angle)])
        ends = np.where(way > 0, (80, 40), (-40, -40)) - 0.0
        outer.append(min((end / part for end, part in zip(ends, way) if abs(part) > 1e-9)) * way + (-20, 0))
    outer = np.array(outer)
    rings = [np.column_stack([ring[:, 0], np.full(count, y), ring[:, 1]]) for ring, y in ((outer, 0), (outer, 8), (hole, 8), (hole, 0))]
    points, triangles = np.concatenate(rings), []
    for ring in range(4):
        for i in range(count):
            a, b = ring * count + i, ring * count + (i + 1) % count
            c, d = (ring + 1) % 4 * count + (i + 1) % count, (ring + 1) % 4 * count + i
            triangles += [(a, d, c), (a, c, b)]
    corner = joined(placed(box(8, 60, 80), (56, 8, 0)), placed(box(30, 8, 12), (40, 8, 30)), placed(box(30, 8, 12), (40, 8, -30)))
    files.stl(folder, "bracket", joined((points, np.array(triangles), np.zeros((len(points), 2))), corner))


def _badge(folder, _):
    shape = placed(lathe([(0, 0.1), (0.8, 0.1), (1, 0), (0.8, -0.1), (0, -0.1)], 10), pitch=90)
    middles = shape[0][shape[1]].mean(axis=1)
    slices = (np.arctan2(middles[:, 0], middles[:, 1]) / (2 * np.pi) * 10 + 10).astype(int) % 2
    files.stl(folder, "badge", shape, np.where(slices[:, None] == 0, (28, 6, 6), (30, 27, 8)))


def _terrain(folder, chance):
    heights = np.pad(clouds(chance, 64, 3, 4), ((0, 1), (0, 1)), mode="wrap") - 0.42

    def function(u, v):
        return u * 4 - 2, np.maximum(heights[np.rint(v * 64).astype(int), np.rint(u * 64).astype(int)], 0) * 2.2, v * 4 - 2
    shape = surface(function, 64, 64)
    height = shape[0][:, 1:2]
    colours = np.select([height < 0.005, height < 0.08, height < 0.38, height < 0.6],
                        [(50, 100, 180), (220, 205, 150), (80, 140, 60), (120, 105, 90)], (245, 245, 250))
    files.ply(folder, "terrain", shape, colours)


def _gem(folder, chance):
    points, triangles, uvs = lathe([(0, 0.42), (0.45, 0.42), (0.8, 0.2), (0.8, 0.12), (0, -0.8)], 8)
    light = chance.uniform(0.55, 1, (len(triangles), 1))
    files.ply_tables(folder, "gem", (points, triangles, uvs), (np.array([90, 210, 230]) * light).astype(int))


# --- glTF ------------------------------------------------------------------------------------

def _palette(folder, chance):
    """A village whose faces have one colour each, by points of an image of 256 x 1."""
    colours = np.array([(70, 130, 60), (120, 80, 50), (40, 100, 50), (200, 60, 50), (230, 220, 200), (90, 90, 100), (240, 200, 80),
                        (60, 110, 170), (150, 60, 90), (250, 250, 250), (30, 30, 40), (180, 150, 110), (110, 170, 90), (220, 130, 60),
                        (130, 190, 220), (160, 160, 150)], dtype=np.uint8)
    image = np.repeat(colours, 256 // SWATCHES, axis=0)[None]
    made = Gltf()
    paint = made.material("palette", texture=made.texture(image_bytes(image)))

    def of(shape, swatch):
        return flat(shape, ((swatch + 0.5) / SWATCHES, 0.5))
    parts = [of(placed(box(10, 0.3, 10), (0, -0.3, 0)), 0)]
    for number in range(6):
        angle, size = number * np.pi / 3 + 0.4, chance.uniform(0.8, 1.3)
        place = (3.2 * np.cos(angle), 0, 3.2 * np.sin(angle))
        parts += [of(placed(box(1.2, size, 1.2), place), 3 + number), of(placed(lathe([(0, 0.8), (1.1, 0), (0, 0)], 4),
                                                                                  (place[0], size, place[2]), yaw=45), 9 + number)]
    for number in range(5):
        place = chance.uniform(-1.6, 1.6, 2)
        parts += [of(placed(lathe([(0, 0.5), (0.12, 0.5), (0.12, 0), (0, 0)], 6), (place[0], 0, place[1])), 1),
                  of(placed(lathe([(0, 1.3), (0.5, 0), (0, 0)], 8), (place[0], 0.4, place[1])), 2)]
    parts.append(of(placed(ball(0.5, 10, 6), (0, 0.4, 0)), 15))
    made.node("village", made.mesh("village", (joined(*parts), paint)))
    made.write(folder, "village")


def _gradient(folder, chance):
    """A city of 40 materials, all with one image of 1024 x 1024: a face has a point of it."""
    side = 1024
    y, x = np.mgrid[:side, :side] / side
    columns = chance.integers(60, 255, (8, 3))
    image = (columns[(x * 8).astype(int)] * (1 - 0.75 * y)[..., None]).astype(np.uint8)
    made = Gltf()
    texture = made.texture(image_bytes(image))
    parts = [(flat(placed(box(9, 0.2, 6), (0, -0.2, 0)), (0.06, 0.9)), made.material("ground", texture=texture))]
    for number in range(1, BUILDINGS):
        place = ((number - 1) % 8 - 3.5, 0, (number - 1) // 8 - 2)
        points, triangles, uvs = placed(box(0.7, chance.uniform(0.5, 2.6), 0.7), place)
        column = (number % 8 + 0.5) / 8
        uvs = np.repeat([(column, 0.15 + 0.12 * face) for face in range(6)], 4, axis=0)     # a shade for each side
        parts.append(((points, triangles, uvs), made.material(f"building {number}", texture=texture)))
    made.node("city", made.mesh("city", *parts))
    made.write(folder, "city")


def _car(folder, _):
    made = Gltf()
    red, dark, glass, light = (made.material(name, colour) for name, colour in (
        ("paint", (0.75, 0.05, 0.05, 1)), ("rubber", (0.03, 0.03, 0.03, 1)), ("glass", (0.35, 0.55, 0.7, 1)), ("lamp", (1, 0.9, 0.5, 1))))
    rim = made.material("rim", (0.6, 0.6, 0.65, 1))
    body = joined(placed(box(1.6, 0.5, 3.6), (0, 0.35, 0)), placed(box(1.5, 0.18, 1.0), (0, 0.85, 1.2)))
    car = made.node("body", made.mesh("body", (body, red)))
    made.node("cabin", made.mesh("cabin", (placed(box(1.4, 0.08, 1.5), (0, 1.33, -0.35)), red)), car)
    made.node("windows", made.mesh("windows", (placed(box(1.3, 0.48, 1.4), (0, 0.85, -0.35)), glass)), car)
    hub = joined(*(placed(box(0.06, 0.1, 0.5), (side * 0.14, -0.05, 0), pitch=turn) for turn in (0, 60, 120) for side in (-1, 1)))
    tyre = made.mesh("wheel", (wheel(), dark), (hub, rim))
    wheels = [made.node(f"wheel {name}", tyre, car, translation=[x, 0.35, z]) for name, x, z in (
        ("front left", -0.85, 1.15), ("front right", 0.85, 1.15), ("rear left", -0.85, -1.15), ("rear right", 0.85, -1.15))]
    lamps = joined(*(placed(box(0.3, 0.16, 0.06), (x, 0.55, 1.8)) for x in (-0.5, 0.5)))
    made.node("lamps", made.mesh("lamps", (lamps, light)), car)
    spoiler = joined(placed(box(1.5, 0.06, 0.35), (0, 1.15, -1.65)), *(placed(box(0.06, 0.3, 0.2), (x, 0.85, -1.65)) for x in (-0.6, 0.6)))
    made.node("spoiler", made.mesh("spoiler", (spoiler, dark)), car)
    made.spin({wheel_: 1 for wheel_ in wheels}, 1, (1, 0, 0))
    made.write(folder, "car")


def _character(folder, _):
    """A skin of three joints: hips, chest, head. All corners of a face hang on one."""
    made = Gltf()
    skin, shirt, trousers, eyes = (made.material(name, colour) for name, colour in (
        ("skin", (0.85, 0.6, 0.45, 1)), ("shirt", (0.15, 0.35, 0.65, 1)), ("trousers", (0.2, 0.2, 0.25, 1)), ("eyes", (0.05, 0.03, 0.02, 1))))
    heights = (0.9, 1.25, 1.75)
    parts = [(joined(*(placed(box(0.22, 0.9, 0.26), (x, 0, 0)) for x in (-0.16, 0.16)), placed(box(0.58, 0.2, 0.32), (0, 0.8, 0))), trousers, 0),
             (joined(placed(box(0.66, 0.72, 0.34), (0, 1.0, 0)), *(placed(box(0.16, 0.7, 0.2), (x, 1.0, 0)) for x in (-0.43, 0.43))), shirt, 1),
             (placed(ball(0.26, 16, 10), (0, 2.0, 0)), skin, 2),
             (joined(*(placed(box(0.06, 0.07, 0.06), (x, 2.02, 0.22)) for x in (-0.1, 0.1))), eyes, 2)]
    primitives = []
    for shape, material, joint in parts:
        count = len(shape[0])
        joints, weights = np.zeros((count, 4)), np.zeros((count, 4))
        joints[:, 0], weights[:, 0] = joint, 1
        primitives.append((shape, material, {"JOINTS_0": made.accessor(joints, "VEC4", "u1"), "WEIGHTS_0": made.accessor(weights, "VEC4")}))
    mesh = made.mesh("character", *primitives)
    made.node("character", mesh, skin=0)
    above, joints, below = None, [], 0.0
    for name, height in zip(("hips", "chest", "head"), heights):
        joints.append(made.node(name, None, above, translation=[0, height - below, 0]))
        above, below = joints[-1], height
    matrices = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1] for height in heights]
    made.data["skins"] = [{"joints": joints, "inverseBindMatrices": made.accessor(matrices, "MAT4")}]
    made.write(folder, "character")


def _mirrored(folder, _):
    """A quilt whose texture coordinates run from -0.5 to 2.5, on a sampler that mirrors; its left half is mirrored besides."""
    made = Gltf()
    fabric = made.material("fabric", texture=made.texture(image_bytes(cloth()), wrapS=33648, wrapT=33648), doubleSided=True)

    def function(u, v):
        return u * 4 - 2, 0.15 * np.sin(7 * u) * np.cos(5 * v), v * 4 - 2
    points, triangles, uvs = surface(function, 20, 20)
    uvs = np.stack([np.abs(uvs[:, 0] - 0.5) * 3 - 0.5, uvs[:, 1] * 3 - 0.5], axis=1)
    made.node("quilt", made.mesh("quilt", ((points, triangles, uvs), fabric)))
    made.write(folder, "quilt")


def _knot(folder, _):
    made, t = Gltf(), 2 * np.pi * np.arange(160) / 160
    line = np.stack([(2 + np.cos(3 * t)) * np.cos(2 * t), (2 + np.cos(3 * t)) * np.sin(2 * t), np.sin(3 * t)], axis=1)
    made.node("knot", made.mesh("knot", (tube(line, 0.4, 14), made.material("brass", (0.8, 0.6, 0.25, 1)))))
    made.write(folder, "knot")


def _glass(folder, _):
    made = Gltf()
    pane, fruit, table = made.material("glass", (0.6, 0.85, 0.9, 0.35), alphaMode="BLEND"), made.material("orange", (0.9, 0.2, 0.01, 1)), \
        made.material("table", (0.45, 0.3, 0.18, 1))
    made.node("fruit", made.mesh("fruit", (placed(ball(0.42, 24, 14), (0, 0.42, 0)), fruit), (placed(box(2.4, 0.12, 2.4), (0, -0.12, 0)), table)))
    made.node("cover", made.mesh("cover", (lathe([(0, 1.5), (0.4, 1.42), (0.68, 1.2), (0.78, 0.9), (0.8, 0)], 28), pane)))
    made.write(folder, "cover")


def _leaves(folder, chance):
    """A plant of leaves with holes: an image with alpha and a cutoff."""
    side = 128
    y, x = np.mgrid[:side, :side] / side
    image = np.zeros((side, side, 4), dtype=np.uint8)
    image[..., :3] = mixed((30, 90, 30), (130, 190, 70), noise(chance, side, 8))
    inside = np.abs(x - 0.5) < 0.32 * np.sin(np.pi * y) * (0.85 + 0.15 * np.cos(24 * np.pi * y))
    image[..., 3] = np.where(inside, 255, 0)
    image[np.abs(x - 0.5) < 0.015, :3] = (200, 220, 130)
    made = Gltf()
    leaf = made.material("leaf", texture=made.texture(image_bytes(image)), alphaMode="MASK", alphaCutoff=0.5, doubleSided=True)
    pot = made.material("pot", (0.6, 0.3, 0.2, 1))
    square = (np.array([(-0.35, 0, 0), (0.35, 0, 0), (0.35, 1.2, 0), (-0.35, 1.2, 0)]), np.array([(0, 1, 2), (0, 2, 3)]),
              np.array([(0, 1), (1, 1), (1, 0), (0, 0)], dtype=float))
    leaves = [placed(square, (0.1 * np.sin(turn), 0.5, 0.1 * np.cos(turn)), yaw=np.degrees(turn), pitch=18 + 26 * (number % 3))
              for number, turn in enumerate(np.arange(12) * 2.4)]
    made.node("plant", made.mesh("plant", (joined(*leaves), leaf),
                                 (lathe([(0, 0.5), (0.36, 0.5), (0.42, 0.55), (0.42, 0.45), (0.28, 0), (0, 0)], 20), pot)))
    made.write(folder, "plant")


def _lantern(folder, _):
    made = Gltf()
    iron = made.material("iron", (0.12, 0.12, 0.14, 1))
    flame = made.material("flame", (0, 0, 0, 1), emissiveFactor=[1, 0.75, 0.25])
    posts = [placed(box(0.08, 1, 0.08), (x, 0.1, z)) for x in (-0.4, 0.4) for z in (-0.4, 0.4)]
    made.node("lantern", made.mesh("lantern", (joined(box(1, 0.1, 1), placed(lathe([(0, 0.5), (0.75, 0), (0, 0)], 4), (0, 1.1, 0), yaw=45), *posts),
                                               iron), (placed(ball(0.28, 16, 10), (0, 0.6, 0)), flame)))
    made.write(folder, "lantern")


def _unlit(folder, chance):
    """A signboard that no light changes."""
    made = Gltf()
    y, x = np.mgrid[:128, :256]
    image = mixed((250, 240, 60), (240, 90, 40), y / 127)
    image[((x - 128) / 110) ** 2 + ((y - 64) / 50) ** 2 < 1] = (40, 40, 90)
    image[((x * 3 + y * 2) % 48 < 14) & (((x - 128) / 90) ** 2 + ((y - 64) / 38) ** 2 < 1)] = (255, 255, 255)
    sign = made.material("sign", texture=made.texture(image_bytes(image)), extensions={"KHR_materials_unlit": {}})
    post = made.material("post", (0.3, 0.3, 0.35, 1), extensions={"KHR_materials_unlit": {}})
    points, triangles, uvs = placed(box(2, 1, 0.1), (0, 1.2, 0))
    shown = np.ptp(points[triangles], axis=1)[:, 2] < 0.01      # front and back; the rim has the post's colour
    made.node("sign", made.mesh("sign", ((points, triangles[shown], uvs), sign), ((points, triangles[~shown], uvs), post),
                                (placed(box(0.1, 1.2, 0.1)), post)))
    made.write(folder, "sign", "KHR_materials_unlit")


def _quantized(folder, _):
    made = Gltf()
    head = [(0.17 * np.sin(t), 0.8 + 0.17 * np.cos(t)) for t in np.linspace(0, 2.5, 9)]
    points, triangles, uvs = lathe([(0, 0.97), *head[1:], (0.24, 0.6), (0.24, 0.56), (0.1, 0.5), (0.14, 0.3), (0.3, 0.14), (0.36, 0.1),
                                    (0.36, 0), (0, 0)], 28)
    material = made.material("ivory", (0.9, 0.86, 0.75, 1))
    mesh = made.mesh("pawn", ((points, triangles, uvs), material))
    attributes = made.data["meshes"][mesh]["primitives"][0]["attributes"]
    whole = np.rint(points * 10000).astype("<i2")
    padded = np.zeros((len(whole), 4), dtype="<i2")
    padded[:, :3] = whole
    number = made.accessor(padded, "VEC3", "<i2", min=whole.min(axis=0).tolist(), max=whole.max(axis=0).tolist())
    made.data["bufferViews"][made.data["accessors"][number]["bufferView"]]["byteStride"] = 8
    attributes["POSITION"] = number
    made.node("pawn", mesh, scale=[1e-4] * 3)
    made.write(folder, "pawn", required=("KHR_mesh_quantization",))


def _tiles(folder, chance):
    """A column and its floor, whose tiles repeat by KHR_texture_transform."""
    made = Gltf()
    y, x = np.mgrid[:64, :64]
    image = mixed((140, 150, 160), (200, 205, 210), noise(chance, 64, 8))
    image[(x < 3) | (y < 3)] = (80, 84, 90)
    texture = made.texture(image_bytes(image))
    floor, shaft = (made.material(name, texture=texture, transform={"scale": scale, "offset": [0.25, 0]})
                    for name, scale in (("floor", [6, 6]), ("shaft", [6, 4])))
    made.node("column", made.mesh("column", (placed(box(3, 0.2, 3), (0, -0.2, 0)), floor),
                                  (lathe([(0, 2.4), (0.62, 2.4), (0.5, 2.2), (0.5, 0.2), (0.62, 0)], 24), shaft)))
    made.write(folder, "column", "KHR_texture_transform")


def _planets(folder, _):
    made = Gltf()
    sun, earth, moon = (made.material(name, colour, **more) for name, colour, more in (
        ("sun", (0, 0, 0, 1), {"emissiveFactor": [1, 0.85, 0.3]}), ("earth", (0.2, 0.4, 0.8, 1), {}), ("moon", (0.7, 0.7, 0.7, 1), {})))
    centre = made.node("sun", made.mesh("sun", (ball(0.8, 20, 12), sun)))
    planet = made.node("earth", made.mesh("earth", (ball(0.4, 18, 10), earth)), centre, translation=[2.2, 0, 0])
    made.node("moon", made.mesh("moon", (ball(0.15, 12, 8), moon)), planet, translation=[0.8, 0, 0])
    made.spin({centre: 1, planet: 3}, 2, (0, 1, 0), 24)
    made.write(folder, "planets")


MODELS = [
    Model("crate.obj", "OBJ with an image", _crate),
    Model("village.glb", "an asset pack's palette atlas, 256 x 1", _palette),
    Model("city.glb", "a gradient atlas of 1024 x 1024, 40 materials", _gradient),
    Model("scan.obj", "a scan of 200,000 faces with an image of 4096 x 4096", _scan, "--simplify 5000"),
    Model("bracket.stl", "STL in millimetres", _bracket),
    Model("badge.stl", "binary STL with colours of triangles", _badge),
    Model("car.glb", "a car of 9 nodes, whose wheels turn", _car),
    Model("character.glb", "a skin of 3 joints", _character),
    Model("quilt.glb", "mirrored texture coordinates beyond 0..1", _mirrored),
    Model("terrain.ply", "binary PLY with colours of vertices", _terrain),
    Model("gem.ply", "text PLY with colours of faces, a cut stone", _gem, "--flat"),
    Model("rainbow.obj", "OBJ with colours of vertices", _colours_of_vertices),
    Model("vase.obj", "OBJ of one smooth surface, no materials", _vase),
    Model("knot.glb", "a smooth tube that hides itself", _knot),
    Model("cover.glb", "glass over fruit: alphaMode BLEND", _glass),
    Model("plant.glb", "leaves cut out of an image: alphaMode MASK", _leaves),
    Model("lantern.glb", "an emissive flame in an iron lantern", _lantern),
    Model("sign.glb", "KHR_materials_unlit", _unlit),
    Model("pawn.glb", "KHR_mesh_quantization", _quantized),
    Model("column.glb", "KHR_texture_transform", _tiles),
    Model("photo.obj", "a photograph that its Exif turns upright", _photo),
    Model("relief.obj", "an image of greys of 16 bits", _greys),
    Model("planets.glb", "animated nodes, one on the other", _planets),
    Model("house.obj", "OBJ and MTL as another computer wrote them: paths, quotes, Tr, a byte order mark", _from_windows),
]


def write(model, folder):
    """Writes a model; answers its file. What is random comes from the seed and the model's place in the list."""
    model.make(folder, np.random.default_rng([SEED, MODELS.index(model)]))
    return folder / model.file
