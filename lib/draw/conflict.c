/* SPDX-License-Identifier: MIT */
/* The names of what does not go together, and sentences about it. A file of its own, so that a
 * program which does not ask for them does not link them. */
#include "renderer.h"

/* place pixel-format: what cannot be drawn together */
bool fxl_renderer_conflict(const fxl_renderer *renderer, const char *names[2])
{
    /* In the order of FXL_HAS_...; C++ has no designators of elements. */
    static const char *const parts[FXL_HAS_COUNT] = {
        "the order by tree", /* FXL_HAS_TREE */
        "instances that the tree cuts", /* FXL_HAS_MOVERS */
        "a depth buffer", /* FXL_HAS_DEPTH */
        "a target of the study", /* FXL_HAS_STUDY */
        "surfaces", /* FXL_HAS_SURFACES */
        "textures of RGB565", /* FXL_HAS_TEXELS_565 */
        "colours at corners", /* FXL_HAS_COLOURS */
        "billboards", /* FXL_HAS_BILLBOARDS */
        "beams", /* FXL_HAS_BEAMS */
        "outlines", /* FXL_HAS_OUTLINES */
        "outlines", /* FXL_HAS_FLAT_OUTLINES */
        "outlines", /* FXL_HAS_DEEP_OUTLINES */
        "an orthographic lens", /* FXL_HAS_ORTHOGRAPHIC */
        "a horizon", /* FXL_HAS_HORIZON */
        "surfaces and beams", /* FXL_HAS_SPLIT */
        "a clipper of the study", /* FXL_HAS_OTHER_CLIPPER */
        "lines", /* FXL_HAS_LINES */
        "a clipper of the study", /* FXL_HAS_WORLD_CLIPPER */
        "surfaces or billboards of another target", /* FXL_HAS_OTHER_PAINTER */
        "the renderer's target", /* FXL_HAS_TARGET */
    };
    if (renderer == NULL || names == NULL || renderer->target == NULL) {
        return false;
    }
    const fxl_conflict *conflict = fxl_find_conflict(renderer);
    if (conflict == NULL) {
        return false;
    }
    names[0] = parts[conflict->first];
    names[1] = parts[conflict->second];
    return true;
}

/* Each begins with the names of parts. */
static const struct {
    uint8_t first, second;
    const char *sentence;
} sentences[] = {
    {FXL_HAS_TREE, FXL_HAS_DEPTH,
     "the order by tree and a depth buffer do not go together: config.order must be "
     "&fxl_by_distance, or config.target one without a depth"},
    {FXL_HAS_STUDY, FXL_HAS_SURFACES,
     "a target of the study and surfaces do not go together: config.target must be one of "
     "target.h"},
    {FXL_HAS_STUDY, FXL_HAS_BILLBOARDS,
     "a target of the study and billboards do not go together: config.target must be one of "
     "target.h"},
    {FXL_HAS_STUDY, FXL_HAS_OUTLINES,
     "a target of the study and outlines do not go together: config.target must be one of "
     "target.h"},
    {FXL_HAS_FLAT_OUTLINES, FXL_HAS_DEPTH,
     "outlines and a depth buffer do not go together: the style's code must be "
     "&fxl_outlines_by_depth"},
    {FXL_HAS_DEEP_OUTLINES, FXL_HAS_WORLD_CLIPPER,
     "outlines and a clipper of the study do not go together: with a depth buffer the clipper must be "
     "&fxl_clipper_view"},
    {FXL_HAS_OUTLINES, FXL_HAS_BEAMS,
     "outlines and beams do not go together: detach one, by a null style or set"},
    {FXL_HAS_OUTLINES, FXL_HAS_MOVERS,
     "outlines and instances that the tree cuts do not go together: these must be on another layer "
     "than the tree's instance"},
    {FXL_HAS_TREE, FXL_HAS_LINES,
     "the order by tree and lines do not go together: config.order must be &fxl_by_distance, or the "
     "set of lines null"},
    {FXL_HAS_STUDY, FXL_HAS_LINES,
     "a target of the study and lines do not go together: config.target must be one of target.h"},
    {FXL_HAS_BEAMS, FXL_HAS_LINES,
     "beams and lines do not go together: detach one, by a null set"},
    {FXL_HAS_LINES, FXL_HAS_WORLD_CLIPPER,
     "lines and a clipper of the study do not go together: the clipper must be "
     "&fxl_clipper_view"},
    {FXL_HAS_TEXELS_565, FXL_HAS_BEAMS,
     "textures of RGB565 and beams do not go together: a beam lights colours of the palette, so "
     "textures must be of 8 or 4 bits"},
    {FXL_HAS_COLOURS, FXL_HAS_BEAMS,
     "colours at corners and beams do not go together: a beam lights colours of the palette"},
    {FXL_HAS_TREE, FXL_HAS_ORTHOGRAPHIC,
     "the order by tree and an orthographic lens do not go together: config.order must be "
     "&fxl_by_distance"},
    {FXL_HAS_ORTHOGRAPHIC, FXL_HAS_HORIZON,
     "an orthographic lens and a horizon do not go together: all its rays have one elevation; detach "
     "the horizon, by a null one"},
    {FXL_HAS_ORTHOGRAPHIC, FXL_HAS_SPLIT,
     "an orthographic lens and surfaces and beams do not go together: detach the beams, by a null set"},
    {FXL_HAS_ORTHOGRAPHIC, FXL_HAS_OTHER_CLIPPER,
     "an orthographic lens and a clipper of the study do not go together: the clipper must be "
     "&fxl_clipper_view"},
    {FXL_HAS_OTHER_PAINTER, FXL_HAS_TARGET,
     "surfaces or billboards of another target and the renderer's target do not go together: "
     "attach them by FXL_SURFACES_OF and FXL_SPRITES_OF the target of config; if textures have "
     "16-bit texels, that must be one of RGB565; colours at corners are not drawn by "
     "FXL_TEXTURES_OF"},
};

FXL_COLD const char *fxl_conflict_sentence(const fxl_renderer *renderer)
{
    const fxl_conflict *conflict =
        renderer != NULL && renderer->target != NULL ? fxl_find_conflict(renderer) : NULL;
    for (uint32_t i = 0; conflict != NULL && i < sizeof sentences / sizeof *sentences; i++) {
        if (sentences[i].first == conflict->first && sentences[i].second == conflict->second) {
            return sentences[i].sentence;
        }
    }
    return NULL;
}
