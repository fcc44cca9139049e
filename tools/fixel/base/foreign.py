# SPDX-License-Identifier: MIT
"""Formats of files that are neither a scene nor a model that is read: how each is known, and the way to one that is. It needs no
package."""

import os
import re
from typing import NamedTuple

_BLENDER = "open it in Blender and export it as glTF (.glb)"
_FREECAD = "open it in FreeCAD and export it as STL or glTF"
_SLICER = "open it in a slicer or in FreeCAD and export it as STL"
_ASSIMP = "convert it by Assimp: assimp export IN OUT.glb"
_MESHLAB = "open it in MeshLab, compute a surface (Filters, Remeshing, Screened Poisson), and export it as PLY"
_TRENCHBROOM = "open the level's .map in TrenchBroom and export it (File, Export, Wavefront OBJ)"
_TILED = "it is flat: in Tiled choose File, Export As Image, and give the picture to 'fixel texture'"
_UNPACK = "unpack it, and give the model in it"
_THERE_OBJ, _THERE_STL, _THERE_GLTF = (f"export it there as {each}" for each in ("OBJ", "STL", "glTF (.glb)"))
_PNG, _GIMP, _MAGICK = "save it as PNG", "open it in GIMP and export it as PNG", "save it as PNG: magick IN OUT.png"
_OTF2BDF = "'fixel font' takes BDF, which otf2bdf writes: otf2bdf -p 12 -r 72 FONT.ttf -o FONT.bdf"
_OLD_FONT = "'fixel font' takes BDF: open it in FontForge and choose File, Generate Fonts, BDF"
_DRAWS_IMAGES = "'fixel texture' writes an image as a C header, and file in [[textures]] of a scene names one"

START = 2048            # bytes of a file that are looked at
# Sorts: an image that is not read; what may hold other formats, so that the name's ending goes before it; all else.
IMAGE, CONTAINER, OTHER = "image", "container", ""


class Foreign(NamedTuple):
    """A format. way: how one comes to a file that is read. endings: of files' names. beginning: how such files begin, a pattern of
    bytes; without one a file is known by its name alone. sort: IMAGE, CONTAINER or OTHER."""
    kind: str
    way: str
    endings: tuple = ()
    beginning: bytes = None
    sort: str = OTHER

    def way_to_model(self):
        """The way on where a scene or a model is wanted."""
        return f"{self.way}; {_DRAWS_IMAGES}" if self.sort == IMAGE else self.way


def _image(name, way, endings, beginning=None):
    return Foreign(f"an image in {name}", way, endings, beginning, IMAGE)


_XML = rb"\s*(?:<\?xml[^>]*>\s*)?(?:<!--[^>]*-->\s*)*(?:<!DOCTYPE[^>]*>\s*)?"
_ANY = rb"[\x00-\xff]"

# Of beginnings the first that fits counts.
FORMATS = (
    # models and scenes of programs
    Foreign("an FBX file", _BLENDER, (".fbx",), rb"Kaydara FBX Binary|\s*; FBX"),
    Foreign("a file of Blender", _BLENDER, (".blend", ".blend1"), rb"BLENDER[-_]?[v0-9]|\x28\xb5\x2f\xfd"),
    Foreign("a Collada file", _BLENDER, (".dae",), _XML + rb"<COLLADA"),
    Foreign("a file of 3D Studio", _ASSIMP, (".3ds",), rb"MM" + _ANY + rb"{4}(?:\x02\x00\x0a\x00\x00\x00|==)"),
    Foreign("a USD file", _BLENDER, (".usd", ".usdz", ".usdc", ".usda"), rb"PXR-USDC|#usda|PK\x03\x04" + _ANY + rb"{0,200}\.usd[ac]"),
    Foreign("a VRML file", _BLENDER, (".wrl", ".vrml"), rb"#VRML"),
    Foreign("an X3D file", _BLENDER, (".x3d", ".x3dv"), rb"#X3D|" + _XML + rb"<X3D"),
    Foreign("an Alembic file", _BLENDER, (".abc",), rb"Ogawa"),
    Foreign("a VRM file, which is a GLB file,", "rename it to .glb", (".vrm",)),
    Foreign("a file of Blockbench", "open it in Blockbench and choose File, Export, Export glTF Model", (".bbmodel",),
            rb"\s*\{\s*\"meta\"\s*:\s*\{\s*\"(?:format_version|model_format|creation_time)\""),
    Foreign("a file of 3ds Max", _THERE_OBJ, (".max",)),
    Foreign("a scene in text of 3ds Max", "export it there as OBJ, or " + _ASSIMP, (), rb"\*3DSMAX_ASCIIEXPORT"),
    Foreign("a file of Cinema 4D", _THERE_GLTF, (".c4d",), rb"QC4DC4D|XC4DC4D"),
    Foreign("a file of Maya", _THERE_OBJ, (".ma", ".mb"), rb"//Maya ASCII|FOR4" + _ANY + rb"{4}Maya|FOR8" + _ANY + rb"{12}Maya"),
    Foreign("a file of ZBrush", _THERE_OBJ, (".ztl", ".zpr")),
    Foreign("a file of Modo", _THERE_OBJ, (".lxo",), rb"FORM" + _ANY + rb"{4}LXO"),
    Foreign("a file of LightWave", _ASSIMP, (".lwo", ".lws"), rb"FORM" + _ANY + rb"{4}LW[LO]|LWSC"),
    Foreign("a file of SketchUp", "export it there as OBJ or STL", (".skp",), rb"\xff\xfe\xff\x0eS\x00k\x00e\x00t\x00c\x00h\x00U\x00p"),
    Foreign("a file of DirectX", _ASSIMP, (".x",), rb"xof 0"),
    Foreign("a file of AC3D", _ASSIMP, (".ac",), rb"AC3D"),
    Foreign("a file of Blitz3D", _ASSIMP, (".b3d",), rb"BB3D"),
    Foreign("a file of MilkShape 3D", _ASSIMP, (".ms3d",), rb"MS3D000000"),
    Foreign("a file of trueSpace", _ASSIMP, (".cob",), rb"Caligari "),
    Foreign("a file of MikuMikuDance", _BLENDER + ", by the add-on MMD Tools", (".pmx", ".pmd"), rb"PMX |Pmd"),
    Foreign("a motion without a model (BVH)", "give the character's model as glTF with its animation", (".bvh",), rb"HIERARCHY"),
    Foreign("a mesh of Ogre", _ASSIMP, (".mesh",), rb"\x00\x10\[MeshSerializer|" + _XML + rb"<mesh>"),
    Foreign("an OFF file", "open it in MeshLab and export it as PLY", (".off",), rb"(?:ST)?(?:C)?(?:N)?OFF\s"),
    Foreign("a mesh compressed by Draco", "decompress it: draco_decoder -i IN.drc -o OUT.ply", (".drc",), rb"DRACO"),
    # games: models and levels
    Foreign("a model of Quake", _ASSIMP, (".md2", ".md3", ".md4", ".mdc"), rb"IDP[23]"),
    Foreign("a model of Quake or Half-Life", _ASSIMP, (".mdl",), rb"IDPO|IDS[TQ]"),
    Foreign("a model of Doom 3", _ASSIMP, (".md5mesh", ".md5anim"), rb"MD5Version"),
    Foreign("an Inter-Quake model", _ASSIMP, (".iqm", ".iqe"), rb"INTERQUAKEMODEL|# Inter-Quake Export"),
    Foreign("a model of Valve's Source (SMD)", _ASSIMP, (".smd", ".vta"), rb"version 1\s+nodes"),
    Foreign("a compiled level of Quake or Half-Life", _TRENCHBROOM, (".bsp",), rb"[IVR]BSP|BSP2|[\x1d\x1e]\x00\x00\x00"),
    Foreign("a level of Quake or Half-Life", _TRENCHBROOM, (".map",),
            rb"(?:\s*//[^\r\n]*[\r\n])*\s*\{\s*(?://[^\r\n]*\s*)?\"(?:classname|spawnflags|mapversion|wad|_tb_\w+)\"\s+\""),
    Foreign("a level of Hammer", "export it there as DXF, and open that in Blender and export it as glTF (.glb)", (".vmf", ".rmf"), rb"versioninfo\s*\{"),
    Foreign("an archive of Doom or Quake (WAD)", "take the level out of it, as OBJ, by a program for WADs such as SLADE", (".wad",), rb"[PI]WAD|WAD[23]"),
    Foreign("a map of tiles of Tiled", _TILED, (".tmx", ".tsx", ".tmj", ".tsj"),
            _XML + rb"<(?:map|tileset) |\s*\{\s*\"(?:compressionlevel|columns)\"\s*:"),
    Foreign("a map of tiles of LDtk", "it is flat: in LDtk let the project save PNG images, and give one to 'fixel texture'", (".ldtk", ".ldtkl"),
            rb"\s*\{\s*\"__header__\"\s*:\s*\{\s*\"fileType\"\s*:\s*\"LDtk"),
    Foreign("a scene of Godot", "open it there and choose Scene, Export As, glTF 2.0 Scene", (".tscn", ".scn", ".escn"), rb"\[gd_(?:scene|resource)|RSRC"),
    Foreign("a file of Unity", "export it there as glTF, by the package UnityGLTF", (".unity", ".prefab", ".unitypackage"), rb"%YAML 1\.1\s+%TAG !u!"),
    Foreign("a file of Unreal Engine", "export it there as glTF (Asset Actions, Export)", (".uasset", ".umap"), rb"\xc1\x83\x2a\x9e"),
    Foreign("a place of Roblox", "export it in Roblox Studio as OBJ (Export Selection)", (".rbxl", ".rbxm", ".rbxlx", ".rbxmx"), rb"<roblox"),
    Foreign("a part of a Minecraft world", "export it by Mineways as OBJ", (".schem", ".schematic", ".litematic", ".mca", ".nbt", ".mcworld")),
    Foreign("a file of MagicaVoxel", _THERE_OBJ, (".vox",), rb"VOX " + _ANY + rb"\x00\x00\x00"),
    Foreign("a file of Goxel", _THERE_GLTF, (".gox",), rb"GOX "),
    Foreign("a file of Qubicle", _THERE_OBJ, (".qb", ".qbt", ".qbcl")),
    # CAD, printing, scanning
    Foreign("a 3MF file", _SLICER, (".3mf",), rb"PK\x03\x04" + _ANY + rb"*3D/"),
    Foreign("a file of FreeCAD", _FREECAD, (".fcstd",), rb"PK\x03\x04" + _ANY + rb"{0,60}Document\.xml"),
    Foreign("an IFC file of a building", "open it in FreeCAD, or in Blender with Bonsai, and export it as glTF (.glb)", (".ifc",),
            rb"ISO-10303-21;" + _ANY + rb"*FILE_SCHEMA *\( *\( *'IFC"),
    Foreign("a STEP file", _FREECAD, (".step", ".stp", ".stpz"), rb"ISO-10303-21"),
    Foreign("an IGES file", _FREECAD, (".igs", ".iges"), rb" {72}S      1"),
    Foreign("a DXF file", _FREECAD, (".dxf",), rb"AutoCAD Binary DXF|\s*0\s+SECTION\s"),
    Foreign("a DWG file", "convert it to DXF (by LibreDWG: dwg2dxf IN.dwg), open that in FreeCAD and export it as STL or glTF", (".dwg",), rb"AC10[0-9]{2}"),
    Foreign("a BREP file", _FREECAD, (".brep", ".brp"), rb"(?:DBRep_DrawableShape|CASCADE Topology)"),
    Foreign("a file of Parasolid, ACIS or JT", "export it as STEP where it comes from, open that in FreeCAD and export it as STL or glTF",
            (".x_t", ".x_b", ".sat", ".sab", ".jt")),
    Foreign("a file of SolidWorks", _THERE_STL, (".sldprt", ".sldasm")),
    Foreign("a file of Inventor", _THERE_STL, (".ipt", ".iam")),
    Foreign("a file of Fusion", _THERE_STL, (".f3d", ".f3z")),
    Foreign("a file of Rhino", "export it there as OBJ or STL", (".3dm",), rb"3D Geometry File Format"),
    Foreign("a program of OpenSCAD", "write it as STL: openscad IN.scad -o OUT.stl", (".scad",)),
    Foreign("a board of KiCad", "write it as GLB: kicad-cli pcb export glb IN.kicad_pcb", (".kicad_pcb",), rb"\(kicad_pcb"),
    Foreign("an AMF file", _SLICER, (".amf",), _XML + rb"<amf"),
    Foreign("a file of commands for a printer (G-code)", "give the STL or 3MF that it was sliced from; 3MF: " + _SLICER, (".gcode", ".bgcode"),
            rb"GCDE|; (?:generated|thumbnail) "),
    Foreign("a cloud of points", _MESHLAB, (".las", ".laz", ".e57", ".pcd", ".xyz", ".pts", ".ptx"), rb"LASF|ASTM-E57|# \.PCD"),
    Foreign("a cloud of splats", "it has no faces: give a mesh", (".splat", ".spz", ".ksplat")),
    # fonts, before images
    Foreign("a font in BDF", "'fixel font' writes it as a C header", (".bdf",), rb"STARTFONT "),
    Foreign("a TrueType or OpenType font", _OTF2BDF, (".ttf", ".otf", ".ttc"), rb"\x00\x01\x00\x00\x00|true\x00|OTTO|ttcf"),
    Foreign("a font of the web", "decompress it (woff2_decompress, or fonttools ttLib.woff2 decompress). " + _OTF2BDF, (".woff", ".woff2"), rb"wOF[F2]"),
    Foreign("a bitmap font in PCF", "'fixel font' takes BDF, which pcf2bdf writes: pcf2bdf -o OUT.bdf IN.pcf", (".pcf",), rb"\x01fcp"),
    Foreign("a font of BMFont", _OLD_FONT, (".fnt",), rb"info face=|BMF\x03"),
    Foreign("a font of a console or of Windows", _OLD_FONT, (".psf", ".psfu", ".fon", ".sfd"), rb"\x72\xb5\x4a\x86|\x36\x04[\x00-\x0f]|SplineFontDB"),
    # images
    Foreign("an image", _DRAWS_IMAGES, (".png", ".jpg", ".jpeg", ".bmp", ".gif", ".webp", ".tga", ".ppm", ".pgm", ".pbm"),
            rb"\x89PNG|\xff\xd8\xff|GIF8|BM" + _ANY + rb"{4}\x00\x00\x00\x00|RIFF" + _ANY + rb"{4}WEBP|P[1-6]\s+[0-9#]"),
    _image("DDS", _MAGICK, (".dds",), rb"DDS "),
    _image("KTX", _PNG + "; of a glTF file: npx @gltf-transform/cli ktxdecompress in.glb out.glb", (".ktx", ".ktx2", ".basis"), rb"\xabKTX "),
    _image("TIFF", _MAGICK, (".tif", ".tiff"), rb"II[*+]\x00|MM\x00[*+]"),
    _image("PSD", _GIMP, (".psd", ".psb"), rb"8BPS"),
    _image("OpenEXR", _MAGICK, (".exr",), rb"\x76\x2f\x31\x01"),
    _image("Radiance HDR", _MAGICK, (".hdr", ".rgbe"), rb"#\?R(?:ADIANCE|GBE)"),
    _image("AVIF", _MAGICK, (".avif", ".avifs"), _ANY + rb"{4}ftyp(?:" + _ANY + rb"{4}){0,12}avi[fs]"),
    _image("HEIC", _MAGICK, (".heic", ".heif"), _ANY + rb"{4}ftyp(?:hei[cxms]|hev[cxms]|mif1|msf1)"),
    _image("JPEG XL", _MAGICK, (".jxl",), rb"\xff\x0a|\x00\x00\x00\x0cJXL "),
    _image("JPEG 2000", _MAGICK, (".jp2", ".j2k", ".jpx", ".jpf"), rb"\x00\x00\x00\x0cjP|\xff\x4f\xff\x51"),
    _image("QOI", _MAGICK, (".qoi",), rb"qoif"),
    _image("ICO", _MAGICK, (".ico", ".cur"), rb"\x00\x00[\x01\x02]\x00[\x01-\xff]\x00"),
    _image("PCX", _MAGICK, (".pcx",), rb"\x0a\x05\x01[\x01\x02\x04\x08]"),
    _image("SVG", "draw it as PNG: inkscape IN.svg -o OUT.png", (".svg", ".svgz"), _XML + rb"<svg[\s>]"),
    _image("a file of Aseprite", "export it there as PNG (aseprite -b IN.aseprite --save-as OUT.png)", (".aseprite", ".ase"), _ANY + rb"{4}\xe0\xa5"),
    _image("a file of GIMP", _GIMP, (".xcf",), rb"gimp xcf"),
    _image("a file of Krita", "open it in Krita and export it as PNG", (".kra",), rb"PK\x03\x04" + _ANY + rb"{26}mimetypeapplication/x-krita"),
    _image("a file of a painting program", "export it there as PNG", (".clip", ".procreate", ".afphoto", ".afdesign", ".ai", ".sai", ".mdp", ".pdn")),
    # what is neither
    Foreign("the materials of an OBJ file", "give the .obj that names them", (".mtl",), rb"(?:\s|#[^\r\n]*[\r\n])*newmtl[ \t]"),
    Foreign("the buffers of a glTF file", "give the .gltf that names them", (".bin",)),
    Foreign("a scene image, which is compiled already", "'fixel run' and 'fixel info' take it", (".fxls",), rb"FXLS"),
    Foreign("a frame dump", "'fixel pictures' and 'fixel compare' take it", (".fxld",), rb"FXLD"),
    Foreign("a document", "give a model, or save its picture as PNG for 'fixel texture'", (".pdf", ".eps", ".ps"), rb"%PDF|%!PS"),
    Foreign("a sound or a film", "give a model or a scene", (".wav", ".ogg", ".mp3", ".flac", ".mp4", ".mov", ".webm", ".avi", ".mkv"),
            rb"RIFF" + _ANY + rb"{4}(?:WAVE|AVI )|OggS|ID3|fLaC|" + _ANY + rb"{4}ftyp(?:isom|mp4[12]|qt  )|\x1a\x45\xdf\xa3"),
    Foreign("an archive", _UNPACK, (".zip", ".7z", ".rar", ".gz", ".tar", ".tgz", ".bz2", ".xz", ".zst"),
            rb"PK\x03\x04|7z\xbc\xaf\x27\x1c|Rar!|\x1f\x8b\x08|BZh[1-9]|\xfd7zXZ", CONTAINER),
    Foreign("a file of 3ds Max, SolidWorks or another program of Windows", "export it there as STL or OBJ", (),
            rb"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", CONTAINER),
    Foreign("a pointer of Git LFS, not the file", "fetch the file itself, as by git lfs pull", (), rb"version https://git-lfs"),
    Foreign("a web page, not the file", "download the file itself", (".html", ".htm"), rb"(?i)\s*<(?:!DOCTYPE )?html"),
)
_BY_ENDING = {ending: each for each in FORMATS for ending in each.endings}
_BY_BEGINNING = [(re.compile(each.beginning), each) for each in FORMATS if each.beginning]


def by_ending(path):
    """The Foreign of a file's name; None where its ending is of none."""
    return _BY_ENDING.get(os.path.splitext(os.fspath(path))[1].lower())


def by_beginning(start):
    """The Foreign of a file's first bytes; None where they are of none."""
    return next((each for pattern, each in _BY_BEGINNING if pattern.match(start)), None)
