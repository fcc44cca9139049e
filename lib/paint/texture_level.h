/* SPDX-License-Identifier: MIT */
/* The levels of a texture: which one a face takes, and where it is. Internal. */
#ifndef FXL_TEXTURE_LEVEL_H
#define FXL_TEXTURE_LEVEL_H

#include "../math/arith.h"
#include "paint.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Among the flags of a level: its texels are FXL_TEXTURE_565. */
#define FXL_LEVEL_565 0x80u

/* The same, in frames of 16 bits a pixel: a texel is looked up in fxl_paint.in_beam. */
#define FXL_LEVEL_IN_BEAM 0x40u

/* The log of a side of a level: one less a level, and at least least. */
static inline uint32_t fxl_level_log(uint32_t log, uint32_t level, uint32_t least)
{
    return log > level + least ? log - level : least;
}

/* The log of the least width of a level: a row of 4 bits a texel has two texels. */
static inline uint32_t fxl_level_least(const fxl_texture *texture)
{
    return texture->format == FXL_TEXTURE_4 ? 1 : 0;
}

/* How large a texel of a face is on the screen: at the least depth of the face, texels times the
 * cube of depth, divided by pixels, are the texels a pixel. texels: twice the area of three corners
 * in the texture. */
typedef struct {
    uint64_t texels;
    fxl_real depth, pixels;
} fxl_texel_density;

/* Twice the area of three corners in a texture, in units of 2^-32 texel. */
uint64_t fxl_texel_area(int32_t (*values)[3]);

/* From the gradients of a face, which say how three corners lie. depth: the least depth of the face,
 * in the unit of those corners. False where it is not in front of the eye, or the corners are in a
 * plane with the eye. Error: 2^-26 of the texels a pixel. */
bool fxl_texel_density_find(int64_t depth, const fxl_view *view, const fxl_gradients *gradients,
                            fxl_texel_density *density);

/* Chooses the level of a face's texture and makes u and v texels of that level. It is the level l
 * of which 4^l is at most twice the texels a pixel, by area; level 0 where a density is null. */
uint8_t fxl_texture_level_choose(const fxl_texture *texture, const fxl_texel_density *density,
                                 fxl_gradients *gradients);

/* place sampling: the masks of a level */
/* The level of a texture that has these texels and sides. */
static inline void fxl_texture_level_set(const fxl_texture *texture, const uint8_t *texels,
                                         uint32_t log_width, uint32_t log_height,
                                         fxl_texture_level *level)
{
    const bool is_565 = texture->format == FXL_TEXTURE_565;
    level->texels = texels;
    level->colours = texture->format == FXL_TEXTURE_4 ? texture->colours : NULL;
    level->columns_less_1 = (1u << log_width) - 1u;
    level->rows_less_1 = (1u << log_height) - 1u;
    level->log_width = (uint8_t)log_width;
    level->flags = (uint8_t)(texture->flags | (is_565 ? FXL_LEVEL_565 : 0u));
    level->key = texture->key;
}

/* Finds a level of a texture. Requires one that it has. */
void fxl_texture_level_find(const fxl_texture *texture, uint32_t number, fxl_texture_level *level);

#ifdef __cplusplus
}
#endif

#endif
