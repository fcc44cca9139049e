# SPDX-License-Identifier: MIT
"""tools/scene.py export: headers that any compiler takes, that hold what the scene image holds, and that
say how much memory the library wants."""

import functools
import subprocess
from types import SimpleNamespace

import pytest

from board_programs import ROOT, made
from conftest import assert_one_sentence, run_cli
from fixel.image import c_names, c_scene, c_text, image
from fixel.base.errors import ToolError
from fixel.scene import compiler, making
from model_files import build

BUILT_PROGRAMS = ("host/libfixel.a",)
CUBE = ROOT / "examples" / "cube" / "cube.obj"
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wmissing-field-initializers", "-Wredundant-decls", "-Werror"]
COMPILERS = [["gcc", "-std=c11"], ["gcc", "-std=c2x"], ["clang", "-std=c11", "-Wmissing-variable-declarations"],
             ["g++", "-std=c++11", "-Wold-style-cast"], ["g++", "-std=c++17", "-Wold-style-cast"],
             ["clang++", "-std=c++11", "-Wold-style-cast"], ["clang++", "-std=c++17", "-Wmissing-variable-declarations"]]
# Convex and sorted models, instances, layers; a mesh; beams and lit colours; a tree; clusters; placements and motions; light.
EXPORTED = {"cube": (CUBE, None), "plaza": (ROOT / "scenes" / "plaza.toml", None),
            "w3": (ROOT / "scenes" / "w3.toml", None), "beam": (ROOT / "scenes" / "beam.toml", None),
            "knot": (ROOT / "scenes" / "knot.toml", "all"), "f32": (ROOT / "scenes" / "f32.toml", None),
            "placements": (ROOT / "host_tests" / "fuzz" / "scenes" / "placements.toml", None),
            "light": (ROOT / "host_tests" / "fuzz" / "scenes" / "light.toml", None),
            "sun": (ROOT / "host_tests" / "tools" / "sun.toml", None),
            "surfaces": (ROOT / "host_tests" / "tools" / "surfaces.toml", None),
            "texels": (ROOT / "host_tests" / "fuzz" / "scenes" / "texels.toml", None),
            "billboards": (ROOT / "host_tests" / "fuzz" / "scenes" / "billboards.toml", None)}


@functools.cache
def library():
    return made("build/host/libfixel.a")


def compiled(folder, text, *options, compiler=("gcc", "-std=c11"), name="main.c"):
    """A program of this text, linked with the library."""
    (folder / name).write_text(text, encoding="utf-8")
    done = subprocess.run([*compiler, *WARNINGS, name, "-I", ROOT / "lib" / "include", *options, library(), "-o", "main"],
                          cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder / "main"


def printed(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


@pytest.fixture(scope="module", params=EXPORTED, name="exported")
def fixture_exported(request, tmp_path_factory):
    """A scene's header, made from a .toml or .obj, and its image."""
    name, folder = request.param, tmp_path_factory.mktemp(request.param)
    file, layers = EXPORTED[name]
    scene, _ = compiler.compile_scene(str(file), None, None, layers, "program")
    (folder / "scene.fxls").write_bytes(image.pack(scene))
    frames = len(scene.path) if scene.path_kind == image.POSES else None
    making.export(str(file), str(folder / "scene.h"), name, frames, None, layers)
    return SimpleNamespace(name=name, folder=folder, scene=scene, frames=frames)


# Every table of the header against the same table of the image.
SAME = """
#include <stdio.h>
#include <string.h>
#include <fixel/all.h>
#include "scene.h"
#define JOIN(a, b)  JOINED(a, b)
#define JOINED(a, b) a##b
#define OF(what)    JOIN(NAME, what)
static _Alignas(8) unsigned char bytes[1 << 22];
static int failed;
static void compare(const char *what, const void *a, const void *b, size_t size)
{
    if ((a == NULL) != (b == NULL) || (a != NULL && memcmp(a, b, size) != 0)) {
        printf("%s differ\\n", what);
        failed = 1;
    }
}
#define TABLE(table, count) \\
    if (scene->count != image.scene.count) { printf(#count " differs\\n"); failed = 1; } \\
    else { compare(#table, scene->table, image.scene.table, scene->count * sizeof *scene->table); }
/* Member by member: the bytes between members hold anything. */
#define SAME_LENS(one, other) \\
    if (lens.one != image.lens.one || lens.other != image.lens.other) { printf("lens: " #one ", " #other " differ\\n"); failed = 1; }
int main(int argc, char **argv)
{
    const fxl_scene *scene = &OF(_scene);
    fxl_scene_image image;
    fxl_lens lens;
    FILE *file = fopen(argv[argc - 1], "rb");
    if (file == NULL || fxl_scene_open(bytes, fread(bytes, 1, sizeof bytes, file), &image, NULL) != FXL_OK) { return 2; }
    TABLE(vertices, vertex_count) TABLE(indices, index_count) TABLE(faces, face_count)
    TABLE(models, model_count) TABLE(instances, instance_count) TABLE(face_bounds, face_bounds_count)
    TABLE(bsp_nodes, bsp_node_count) TABLE(beams, beam_count) TABLE(clusters, cluster_count)
    if (scene->cluster_code != image.scene.cluster_code) { return 7; }
    if (scene->placement_code != image.scene.placement_code || scene->first_turned != image.scene.first_turned) { return 8; }
    if (scene->placements != NULL) { compare("placements", scene->placements, image.scene.placements,
        (scene->instance_count - scene->first_turned) * sizeof *scene->placements); }
#ifdef MOTION
    const fxl_motion_set *set = &OF(_motion);
    if (set->motion_count != image.motion.motion_count || set->key_count != image.motion.key_count) { return 9; }
    compare("motions", set->motions, image.motion.motions, set->motion_count * sizeof *set->motions);
    compare("motion keys", set->keys, image.motion.keys, set->key_count * sizeof *set->keys);
#else
    if (image.motion.motion_count != 0) { return 10; }
#endif
#ifdef LIGHT
    fxl_light_settings light;
    fxl_light_settings_of(&image.light, &light);
    compare("ramp", OF(_ramp), light.ramp, sizeof OF(_ramp));
    light.ramp = OF(_ramp);
    compare("light", &OF(_light), &light, offsetof(fxl_light_settings, dark) + sizeof light.dark);
#else
    if (image.light.base != NULL) { return 11; }
#endif
#ifdef SURFACES
    static fxl_texture textures[64];
    fxl_surface_set set_of_image;
    const fxl_surface_set *ours = &OF(_surfaces), *theirs = &set_of_image;
    if (fxl_surfaces_open(&image, textures, 64, &set_of_image, NULL) != FXL_OK) { return 12; }
    if (fxl_surfaces_check(ours, scene, image.pixel_bits, NULL) != FXL_OK) { return 13; }
    if (ours->texture_count != theirs->texture_count || ours->surface_count != theirs->surface_count ||
        ours->face_count != theirs->face_count || ours->normal_count != theirs->normal_count || ours->corner_count != theirs->corner_count ||
        ours->blend_first != theirs->blend_first || ours->blend_count != theirs->blend_count) { return 14; }
    compare("surfaces", ours->surfaces, theirs->surfaces, ours->surface_count * sizeof *ours->surfaces);
    compare("mapped faces", ours->faces, theirs->faces, ours->face_count * sizeof *ours->faces);
    compare("corners", ours->corners, theirs->corners, ours->corner_count * sizeof *ours->corners);
    compare("face map", ours->face_map, theirs->face_map, scene->face_count * sizeof *ours->face_map);
    if (ours->blend_count > 0) { compare("blend", ours->blend, theirs->blend, 256 * ours->blend_count); }
    for (uint32_t i = 0; i < ours->texture_count; i++) {
        fxl_texture one = ours->textures[i], other = theirs->textures[i];
        compare("texels", one.texels, other.texels, (size_t)1 << (one.log_width + one.log_height + (one.format == FXL_TEXTURE_565)) >> (one.format == FXL_TEXTURE_4));
        if (one.colours != NULL) { compare("colours", one.colours, other.colours, 16); }
        one.texels = other.texels;
        one.colours = other.colours;
        compare("texture", &one, &other, sizeof one);
    }
#else
    if (image.surfaces.face_map != NULL) { return 15; }
#endif
#ifdef BILLBOARDS
    static fxl_sprite sprites[8];
    static fxl_billboard boards[8];
    fxl_billboard_set boards_of_image;
    const fxl_billboard_set *shown = &OF(_billboards);
    if (fxl_billboards_open(&image, sprites, boards, 8, &boards_of_image, NULL) != FXL_OK) { return 16; }
    if (fxl_billboards_check(shown, scene, NULL) != FXL_OK || shown->count != boards_of_image.count) { return 17; }
    compare("billboard map", shown->model_map, boards_of_image.model_map, scene->model_count * sizeof *shown->model_map);
    for (uint32_t i = 0; i < shown->count; i++) {
        const fxl_billboard *one = &shown->billboards[i];
        const fxl_sprite *sprite = one->sprite, *other = &sprites[i];
        if (one->width != boards[i].width || one->height != boards[i].height || one->anchor_x != boards[i].anchor_x ||
            one->anchor_y != boards[i].anchor_y || sprite->width != other->width || sprite->height != other->height ||
            sprite->bits != other->bits || sprite->key != other->key) { return 18; }
        compare("sprite", sprite->pixels, other->pixels, ((size_t)sprite->width * sprite->bits + 7) / 8 * sprite->height);
        if (sprite->bits != 8) { compare("sprite colours", sprite->colours, other->colours, (size_t)1 << sprite->bits); }
    }
#else
    if (image.billboards.model_map != NULL) { return 19; }
#endif
    compare("lit", scene->lit, image.scene.lit, 256);
    if (scene->draw_list_needed != image.scene.draw_list_needed || scene->bsp_instance != image.scene.bsp_instance) { return 3; }
    compare("palette", OF(_palette), image.palette, sizeof OF(_palette));
    const fxl_config *view = &OF(_config);
    if (fxl_lens_from_fov(view->width, view->height, view->fov, view->near_z, view->far_z, view->inset, &lens)) { return 4; }
    SAME_LENS(width, height) SAME_LENS(focal, inset) SAME_LENS(near_z, far_z) SAME_LENS(centre_x, centre_y)
    SAME_LENS(off_centre, off_centre)
    if (view->background != image.background) { return 5; }
#ifdef PATH
    if (image.frame_count != PATH) { return 6; }
    compare("start", &OF(_start), image.poses, sizeof *image.poses);
    compare("path", OF(_path), image.poses, sizeof OF(_path));
#else
    compare("start", &OF(_start), &image.start.pose, sizeof image.start.pose);
#endif
    return failed;
}
"""


def looks_of(scene):
    """What its programs are told of a scene's faces."""
    return (["-DSURFACES"] if scene.surfaces else []) + (["-DBILLBOARDS"] if scene.billboards else []) + \
        [f"-DTARGET={'fxl_rgb565' if scene.pixel_bits == 16 else 'fxl_palette'}"]


def test_a_header_holds_what_the_image_holds(exported):
    path = [f"-DPATH={exported.name.upper()}_FRAMES"] if exported.frames else []
    parts = (["-DMOTION"] if exported.scene.motions else []) + (["-DLIGHT"] if exported.scene.light else [])
    parts += looks_of(exported.scene)
    program = compiled(exported.folder, SAME, f"-DNAME={exported.name}", *path, *parts)
    done = subprocess.run([program, exported.folder / "scene.fxls"], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "")


@pytest.mark.parametrize("compiler", COMPILERS, ids=lambda command: "-".join(command[:2]))
def test_a_header_compiles_without_a_warning_where_nothing_of_it_is_used(exported, compiler):
    used = f"extern const fxl_scene *scene;\nconst fxl_scene *scene = &{exported.name}_scene;\n"
    declared = f"#define {exported.name.upper()}_SCENE_DECLARE\n"
    for number, text in enumerate(['#include "scene.h"\n', f'#include "scene.h"\n{used}', f'{declared}#include "scene.h"\n{used}']):
        source = exported.folder / f"unit{number}.{'cpp' if '++' in compiler[0] else 'c'}"
        source.write_text(text, encoding="utf-8")
        done = subprocess.run([*compiler, *WARNINGS, "-fsyntax-only", source, "-I", ROOT / "lib" / "include"],
                              capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


# A table's place, as one file of a program sees it.
PLACES = """
#include <stdio.h>
#include "cube_scene.h"
#ifdef __cplusplus
extern "C"
#endif
void places_N(void);
void places_N(void)
{
    printf("%p %p %p\\n", FXL_CAST(const void *, &cube_scene), FXL_CAST(const void *, cube_scene.vertices),
           FXL_CAST(const void *, cube_palette));
}
"""
PLACES_MAIN = "void places_0(void); void places_1(void); void places_2(void);\n" \
              "int main(void) { places_0(); places_1(); places_2(); return 0; }\n"


def linked_places(folder, declare, *options):
    """The program of three files, two in C and one in C++, which all include the header; how often it holds the palette.
    declare: with the tables in the first file alone."""
    making.export(str(CUBE), str(folder / "cube_scene.h"), "cube")
    scene, _ = compiler.compile_scene(str(CUBE), framed="program")
    (folder / "main.c").write_text(PLACES_MAIN, encoding="utf-8")
    objects = []
    for number, command in enumerate((["gcc", "-std=c11"], ["g++", "-std=c++17"], ["gcc", "-std=c11"])):
        source = folder / f"places{number}.{'cc' if command[0] == 'g++' else 'c'}"
        alone = "#define CUBE_SCENE_DECLARE\n" if declare and number else ""
        source.write_text(alone + PLACES.replace("_N(", f"_{number}("), encoding="utf-8")
        objects.append(source.with_suffix(".o"))
        subprocess.run([*command, *WARNINGS, *options, f"-I{ROOT / 'lib' / 'include'}", "-c", source, "-o", objects[-1]], check=True)
    subprocess.run(["gcc", "main.c", *objects, *options, "-Wl,--gc-sections", library(), "-o", "main"], cwd=folder, check=True)
    colours = b"".join(bytes(colour) for colour in scene.palette[:7])
    return folder / "main", (folder / "main").read_bytes().count(colours)


@pytest.mark.parametrize("declare, options", [(False, ["-fdata-sections"]), (True, [])], ids=["linker", "declarations"])
def test_several_files_share_the_tables(tmp_path, declare, options):
    program, copies = linked_places(tmp_path, declare, *options)
    lines = printed(program).splitlines()
    assert len(lines) == 3 and len(set(lines)) == 1 and copies == 1


def test_without_sections_the_linker_keeps_what_no_file_uses(tmp_path):
    """Why docs/hello.md names -fdata-sections, or the declarations."""
    assert linked_places(tmp_path, False)[1] == 3


def test_the_tables_may_follow_the_declarations(tmp_path):
    making.export(str(CUBE), str(tmp_path / "cube_scene.h"), "cube")
    text = '#define CUBE_SCENE_DECLARE\n#include "cube_scene.h"\n#undef CUBE_SCENE_DECLARE\n#include "cube_scene.h"\n' \
           '#include "cube_scene.h"\nint main(void) { return cube_scene.face_count != 6; }\n'
    assert subprocess.run([compiled(tmp_path, text)], check=False).returncode == 0


def test_output_is_the_same_each_time_and_names_no_folder(tmp_path):
    for name in ("a.h", "b.h"):
        making.export(str(CUBE), str(tmp_path / name), "cube")
    text = (tmp_path / "a.h").read_text(encoding="utf-8")
    assert text == (tmp_path / "b.h").read_text(encoding="utf-8")
    assert "tools/scene.py from cube.obj:" in text.splitlines()[0] and str(ROOT) not in text
    assert max(map(len, text.splitlines())) <= 100


def test_a_scene_image_gives_the_same_tables(tmp_path):
    making.build(str(ROOT / "scenes" / "knot.toml"), str(tmp_path / "knot.fxls"), layers="all")
    making.export(str(tmp_path / "knot.fxls"), str(tmp_path / "image.h"))
    making.export(str(ROOT / "scenes" / "knot.toml"), str(tmp_path / "toml.h"), layers="all")
    scene, _ = compiler.compile_scene(str(ROOT / "scenes" / "knot.toml"), layers="all")
    names = "\n".join([*c_names.text(scene, "knot"), ""])     # which an image does not have
    read = [(tmp_path / name).read_text(encoding="utf-8") for name in ("image.h", "toml.h")]
    assert "knot.fxls" in read[0] and read[0].replace("knot.fxls", "knot.toml") == read[1].replace(names, "")


def test_an_obj_is_seen_whole_by_the_eye_of_the_first_program(tmp_path):
    scene, _ = compiler.compile_scene(str(CUBE), framed="program")
    assert scene.objects[0].centre == (0, 0, 0)
    assert 131068 <= image.radius_of(scene.models[0].vertices) <= 131072


def test_what_was_written_says_whether_a_path_is_in_it(tmp_path):
    assert run_cli("build", CUBE, "-o", tmp_path / "cube.fxls").returncode == 0
    done = run_cli("export", "--c", tmp_path / "cube.fxls", "-o", tmp_path / "i.h")
    assert done.stderr.endswith("no path\n") and "--frames" not in done.stderr     # it takes none
    for words, told in (([], "no path (--frames adds one)"), (["--frames", 12], "12 frames")):
        done = run_cli("export", "--c", CUBE, "-o", tmp_path / "x.h", *words)
        assert done.stderr.endswith(f"1 object, {told}\n") and ("_path" in (tmp_path / "x.h").read_text(encoding="utf-8")) == bool(words)


@pytest.mark.parametrize("arguments, words", [
    (["missing.obj"], ["missing.obj"]),
    ([ROOT / "README.md"], ["README.md", ".toml"]),
    ([ROOT / "scenes" / "tiny.toml", "--frames", "4"], ["tiny.toml", "poses", "leave out --frames"]),
    ([CUBE, "--frames", "0"], ["--frames 0"]),
    ([CUBE, "--screen", "5000x1"], ["5000x1"]),
])
def test_nothing_is_written_where_something_is_wrong(tmp_path, arguments, words):
    done = run_cli("export", "--c", *arguments, "-o", tmp_path / "x.h")
    assert_one_sentence(done, *words)
    assert not list(tmp_path.iterdir())


def test_a_scene_image_has_its_screen_already(tmp_path):
    making.build(str(CUBE), str(tmp_path / "cube.fxls"))
    done = run_cli("export", "--c", tmp_path / "cube.fxls", "-o", tmp_path / "x.h", "--screen", "64x28")
    assert_one_sentence(done, "cube.fxls", "--screen", "already")
    (tmp_path / "cube.fxls").write_bytes(b"FXLS")
    done = run_cli("export", "--c", tmp_path / "cube.fxls", "-o", tmp_path / "x.h")
    assert_one_sentence(done, "cube.fxls", "bytes")


def test_a_place_where_nothing_can_be_written_is_told(tmp_path):
    (tmp_path / "x.h").mkdir()
    done = run_cli("export", "--c", CUBE, "-o", tmp_path / "x.h")
    assert_one_sentence(done, "x.h", "cannot be written")


def test_a_build_that_cannot_draw_the_scene_is_refused_by_the_compiler(tmp_path):
    making.export(str(ROOT / "scenes" / "plaza.toml"), str(tmp_path / "scene.h"), "plaza")
    (tmp_path / "main.c").write_text('#include "scene.h"\n', encoding="utf-8")
    done = subprocess.run(["gcc", "-fsyntax-only", "main.c", "-I", ROOT / "lib" / "include", "-DFXL_POLYGON_CAPACITY=12"],
                          cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode != 0 and "FXL_POLYGON_CAPACITY must be at least 32" in done.stderr


def test_a_scene_without_a_path_is_seen_from_all_sides(tmp_path):
    boxes = '[[objects]]\nsolid = "box"\nposition = [30, 2, 3]\n[[objects]]\nsolid = "sphere"\nscale = 9\nsize = 2\n'
    (tmp_path / "scene.toml").write_text(boxes, encoding="utf-8")
    made, notes = compiler.compile_scene(str(tmp_path / "scene.toml"), 12)
    image.unpack(image.pack(made))
    assert made.frames == 12 and made.start == made.path[0] and len({pose[3] for pose in made.path}) == 12
    assert any("no path is given: a circle about the scene, in 12 frames" in note for note in notes)
    assert compiler.compile_scene(str(tmp_path / "scene.toml"))[0].frames == 60
    for text, words in ((boxes.replace("30, 2, 3", "8000, 2, 3"), "would leave -8191..8191"),):
        (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
        with pytest.raises(ToolError, match=words):
            compiler.compile_scene(str(tmp_path / "scene.toml"))
    (tmp_path / "scene.toml").write_text("[view]\nfar = 20\n" + boxes, encoding="utf-8")
    assert any("view.far = " in note for note in compiler.compile_scene(str(tmp_path / "scene.toml"))[1])


def test_a_header_has_the_bounds_of_each_face_of_a_sorted_model(tmp_path):
    """A face of the unit box that is twice as large is 1 unit from the middle, in 2^-46."""
    box = '[[objects]]\nsolid = "box"\nposition = [0, 0, 5]\n'
    scene = build(tmp_path, box + box + 'kind = "sorted"\nscale = 2\n' + box + 'kind = "sorted"\nscale = 3\n')
    tables = c_scene._Tables(scene, "it")
    assert [model.count("FXL_MODEL_SORTED") for model in tables.models] == [0, 1, 1]
    assert [model.rstrip("}").split(", ")[-1] for model in tables.models] == ["0", "0", "6"]
    heights = [bounds.partition("u, 0x")[2].partition("u,")[0] for bounds in tables.bounds]
    assert heights == 6 * ["00004000"] + 6 * ["00006000"]


def test_a_comment_is_broken_between_words_where_it_is_too_long():
    assert c_text.comment("a short one") == ["/* a short one */"]
    words = " ".join(["word"] * 60)
    made = c_text.comment(words)
    assert all(len(line) <= c_text.WIDTH for line in made) and all(len(line) > c_text.WIDTH - 6 for line in made[:-1])
    assert " ".join(line.removeprefix("/*").removeprefix(" *").strip() for line in made) == f"{words} */"
    assert c_text.comment("x" * 200) == ["/*", f" * {'x' * 200}", " * */"]


def test_items_of_a_table_fill_the_lines():
    assert c_text.lines(["1", "22", "333"]) == ["    1, 22, 333"]
    made = c_text.lines([f"{number:>4}" for number in range(1000)])
    assert all(c_text.WIDTH - 6 < len(line) <= c_text.WIDTH for line in made[:-1])
    assert [int(item) for item in " ".join(made).split(",")] == list(range(1000))
    assert c_text.lines(["a" * (c_text.WIDTH - 5), "b", "c" * 200, "d"]) == \
        [f"    {'a' * (c_text.WIDTH - 5)},", "    b,", f"    {'c' * 200},", "    d"]
    assert len(c_text.lines(["a" * (c_text.WIDTH - 7), "b"])) == 1 and len(c_text.lines(["a" * (c_text.WIDTH - 6), "b"])) == 2
