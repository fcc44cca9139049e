/* SPDX-License-Identifier: MIT */
/* A frame that has begun, drawn in another workspace, as another core would: the same pixels. */
#include <string.h>

#include "demand.h"
#include "draw.h"

static void misuse(fxl_workspace *workspace, const fxl_renderer *renderer, uint8_t *memory,
                   size_t least)
{
    static const fxl_renderer none;
    const size_t size = least + 64;
    DEMAND(fxl_workspace_size(NULL) == 0 && fxl_workspace_size(&none) == 0);
    DEMAND(fxl_workspace_init(NULL, renderer, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_workspace_init(workspace, NULL, memory, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_workspace_init(workspace, renderer, NULL, size) == FXL_E_ARGUMENT);
    DEMAND(fxl_workspace_init(workspace, renderer, memory + 4, size) == FXL_E_ALIGNMENT);
    DEMAND(fxl_workspace_init(workspace, &none, memory, size) == FXL_E_ORDER);
    DEMAND(least == 0 ||
           fxl_workspace_init(workspace, renderer, memory, least - 1) == FXL_E_CAPACITY);
}

void draw_in_another(const fxl_renderer *renderer, const uint8_t *whole, uint8_t background,
                     fuzz_input *in)
{
    static fxl_workspace workspace;
    const fxl_lens *lens = &renderer->frame.view.lens;
    const size_t least = fxl_workspace_size(renderer), size = least + fuzz_below(in, 4096);
    const size_t pixels = (size_t)lens->width * lens->height;
    uint8_t *memory = malloc(size + 64), *again = malloc(pixels);
    DEMAND(memory != NULL && again != NULL);
    misuse(&workspace, renderer, memory, least);
    DEMAND(fxl_workspace_init(&workspace, renderer, memory, size) == FXL_OK);
    const uint16_t cut = (uint16_t)fuzz_below(in, lens->height);
    const fxl_band bands[] = {
        {.pixels = again, .width = lens->width, .stride = lens->width, .rows = cut},
        {.pixels = again + (size_t)cut * lens->width,
         .width = lens->width,
         .stride = lens->width,
         .first_row = cut,
         .rows = (uint16_t)(lens->height - cut)},
    };
    for (uint32_t i = cut == 0 ? 1 : 0; i < 2; i++) {
        fxl_fill_band(&bands[i], background);
        DEMAND(fxl_frame_draw_with(renderer, &workspace, &bands[i]) == FXL_OK);
    }
    DEMAND(memcmp(whole, again, pixels) == 0);
    free(memory);
    free(again);
}
