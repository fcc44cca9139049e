/* SPDX-License-Identifier: MIT */
/* Frames of 16 bits a pixel: colours beyond a palette, for textures, light and transparency.
 * docs/extras/rgb565.md. */
#ifndef FXL_RGB565_H
#define FXL_RGB565_H

#include "fixel/surfaces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A pixel: five bits of red above six of green above five of blue. The value of a colour of three
 * bytes, as docs/extras/pixels.md defines it. A constant expression. */
#define FXL_RGB565(red, green, blue) \
    FXL_CAST(uint16_t, ((red) / 8u) << 11 | ((green) / 4u) << 5 | (blue) / 8u)

/* A band of 16 bits a pixel. As fxl_band: stride counts pixels. */
typedef struct {
    uint16_t *pixels;
    uint16_t width;  /* 1..FXL_SCREEN_MAX */
    uint16_t stride; /* width..32767 */
    uint16_t first_row;
    uint16_t rows; /* >= 1; first_row + rows <= screen height */
} fxl_band_565;

/* The frames of a renderer that are of 16 bits a pixel, which the caller owns. Members are
 * internal. */
typedef struct {
    uint32_t dark;
} fxl_rgb565_frame;

/* Has a renderer draw frames of 16 bits a pixel, far to near. palette has 256 entries: what a
 * face's colour, and a texel of 8 or 4 bits, is. dark: what the lowest level of light leaves of a
 * colour of a lit surface, black or that of fog. The renderer keeps both pointers. From then on it
 * draws by fxl_frame_draw_rgb565 and fxl_render_rgb565. Until another visibility method is set,
 * fxl_frame_draw and fxl_render answer FXL_E_ORDER, the latter after it has cleared the pixels.
 * Surfaces that were set before stay. A frame must begin anew, and workspaces of other cores must
 * be initialised again.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer was never initialised.
 * FXL_E_ALIGNMENT: frame is not aligned, or palette to 2 bytes.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_renderer_set_rgb565(fxl_renderer *renderer, fxl_rgb565_frame *frame,
                                   const uint16_t *palette, uint16_t dark);

/* fxl_surfaces_check for frames of 16 bits a pixel: textures may be FXL_TEXTURE_565, surfaces may
 * be FXL_SURFACE_ADD, and FXL_SURFACE_BLEND needs no table.
 * FXL_E_ALIGNMENT: also the texels of such a texture at an odd address. */
fxl_status fxl_surfaces_check_rgb565(const fxl_surface_set *set, const fxl_scene *scene,
                                     fxl_scene_fault *fault);

/* fxl_renderer_set_surfaces for a renderer whose frames are of 16 bits a pixel: the visibility
 * method stays. By another method, set later, the faces are drawn in their own colours.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: fxl_renderer_set_rgb565 comes first.
 * The statuses of fxl_surfaces_check_rgb565.
 * With each of these statuses: nothing is changed but refused_calls. */
fxl_status fxl_renderer_set_surfaces_rgb565(fxl_renderer *renderer, fxl_surfaces *surfaces,
                                            const fxl_surface_set *set);

/* fxl_frame_draw for a band of 16 bits a pixel. Exact: a pixel is a function of its face, place,
 * level of light and what is beneath (docs/extras/rgb565.md, section 2), so bands change none.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: no frame has begun; the renderer does not draw 16 bits a pixel.
 * FXL_E_RANGE: a band that is not one of the screen.
 * FXL_E_ALIGNMENT: pixels are not aligned.
 * With each of these statuses: band untouched, counted in refused_calls. */
fxl_status fxl_frame_draw_rgb565(fxl_renderer *renderer, const fxl_band_565 *band);

/* The same in a workspace that fxl_workspace_init made after fxl_renderer_set_rgb565, so that
 * several cores may each draw another band. */
fxl_status fxl_frame_draw_rgb565_with(const fxl_renderer *renderer, fxl_workspace *workspace,
                                      const fxl_band_565 *band);

/* fxl_render for frames of 16 bits a pixel: clears to the background's palette entry, then draws.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_ORDER: the renderer does not draw 16 bits a pixel.
 * FXL_E_RANGE: eye or stride is out of range.
 * FXL_E_ALIGNMENT: pixels are not aligned.
 * With each of these statuses: pixels untouched, counted in refused_calls. */
fxl_status fxl_render_rgb565(fxl_renderer *renderer, const fxl_pose *eye, uint16_t *pixels,
                             uint16_t stride);

/* Sets every pixel of a band. What is between width and stride is untouched. Requires a band as
 * described above. */
void fxl_fill_rgb565(const fxl_band_565 *band, uint16_t colour);

/* Swaps the two bytes of every pixel of a band: so displays on SPI take it, the byte with red
 * first, from a little-endian core. The band is for sending then, not for drawing on. Requires
 * a band as described above. */
void fxl_swap_rgb565(const fxl_band_565 *band);

#ifdef __cplusplus
}
#endif

#endif
