# SPDX-License-Identifier: MIT
"""What of a glTF file the tool does not read, for a note; and what it refuses, with the way to go."""

from fixel.base.errors import ToolError
from fixel.base.reading import quoted

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
